// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ComparePanel.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "common/Wording.h"

namespace studio
{
ComparePanel::ComparePanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->Results = new QListWidget;
  this->Results->setObjectName(QStringLiteral("results"));
  this->Results->setWordWrap(true);
  this->Results->setAlternatingRowColors(true);
  this->ModeBox = new QComboBox;
  this->ModeBox->setObjectName(QStringLiteral("compareMode"));
  this->ModeBox->addItems({tr("Off"), tr("Side by side"), tr("Swipe"), tr("Difference in standard errors")});
  this->OtherBox = new QComboBox;
  this->OtherBox->setObjectName(QStringLiteral("compareWith"));
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("compareAbout"));
  this->About->setWordWrap(true);
  this->About->setMinimumHeight(4 * this->fontMetrics().lineSpacing());
  this->About->setAlignment(Qt::AlignTop);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Compare"), this->ModeBox);
  form->addRow(tr("with"), this->OtherBox);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("Results; the chosen one is shown")));
  layout->addWidget(this->Results, 1);
  layout->addLayout(form);
  layout->addWidget(this->About);

  connect(bench, &Workbench::resultsChanged, this, &ComparePanel::list);
  connect(this->Results, &QListWidget::currentRowChanged, bench, &Workbench::show);
  for (QComboBox* box : {this->ModeBox, this->OtherBox})
    connect(box, qOverload<int>(&QComboBox::activated), this, [this] {
      this->describe();
      emit this->changed();
    });
  this->list();
}

ComparePanel::Mode ComparePanel::mode() const
{
  return this->other() ? static_cast<Mode>(this->ModeBox->currentIndex()) : Mode::Off;
}

ResultPtr ComparePanel::other() const
{
  return this->Bench->results().value(this->OtherBox->currentIndex());
}

void ComparePanel::list()
{
  const QSignalBlocker a(this->Results), b(this->OtherBox);
  const int other = std::max(0, this->OtherBox->currentIndex());
  this->Results->clear();
  this->OtherBox->clear();
  for (const ResultPtr& result : this->Bench->results())
  {
    const QString name = result->settings.describe();
    const QString state = result->complete ? duration(result->seconds) : tr("not complete");
    this->Results->addItem(tr("%1\n%2 · error %3").arg(name, state, percent(result->quality.typical)));
    this->OtherBox->addItem(name);
  }
  this->Results->setCurrentRow(this->Bench->shownIndex());
  if (this->OtherBox->count() > 0)
    this->OtherBox->setCurrentIndex(std::min(other, this->OtherBox->count() - 1));
  this->describe();
}

const Comparison& ComparePanel::comparison()
{
  if (this->First != this->Bench->shown() || this->Second != this->other())
  {
    this->First = this->Bench->shown();
    this->Second = this->other();
    this->Found = compare(*this->First, *this->Second);
  }
  return this->Found;
}

void ComparePanel::describe()
{
  this->About->clear();
  if (this->mode() == Mode::Off || !this->Bench->shown() || this->Bench->shown() == this->other())
    return;
  const Comparison& found = this->comparison();
  QString text = tr("%1 points: the shown result is %2 % %3 on average; %4 differ by more than two standard errors, "
                    "by chance 5 % would.")
                     .arg(found.receivers)
                     .arg(100 * std::abs(found.meanDifference), 0, 'g', 2)
                     .arg(found.meanDifference < 0 ? tr("lower") : tr("higher"), percent(found.beyondTwo));
  if (!found.independent)
    text += QLatin1Char('\n') + tr("The seeds are the same: the errors are not independent.");
  this->About->setText(text);
}
}  // namespace studio
