// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ComparePanel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "common/Wording.h"
#include "results/Colours.h"

namespace studio
{
ComparePanel::ComparePanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->makeResults();
  this->ModeBox = new QComboBox;
  this->ModeBox->setObjectName(QStringLiteral("compareMode"));
  this->ModeBox->addItems({tr("Off"), tr("Side by side"), tr("Swipe"), tr("Difference in standard errors"),
                           tr("Difference in lx"), tr("Difference in %")});
  this->ModeBox->setToolTip(tr("How the shown result and the other one are shown together"));
  this->OtherBox = new QComboBox;
  this->OtherBox->setObjectName(QStringLiteral("compareWith"));
  this->OtherBox->setToolTip(tr("The result that the shown one is compared with"));
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("compareAbout"));
  this->About->setWordWrap(true);
  this->About->setMinimumHeight(4 * this->fontMetrics().lineSpacing());
  this->About->setAlignment(Qt::AlignTop);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Compare"), this->ModeBox);
  form->addRow(tr("with"), this->OtherBox);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Rename);
  buttons->addWidget(this->Delete);
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("Results; the chosen one is shown")));
  layout->addWidget(this->Results, 1);
  layout->addLayout(buttons);
  layout->addLayout(form);
  layout->addWidget(this->About);

  connect(bench, &Workbench::resultsChanged, this, &ComparePanel::list);
  connect(bench, &Workbench::runChanged, this, &ComparePanel::enable);
  connect(this->Results, &QListWidget::currentRowChanged, bench, &Workbench::show);
  connect(this->Rename, &QPushButton::clicked, this, &ComparePanel::rename);
  connect(this->Delete, &QPushButton::clicked, this, [this] { this->Bench->remove(this->Bench->shownIndex()); });
  for (QComboBox* box : {this->ModeBox, this->OtherBox})
    connect(box, qOverload<int>(&QComboBox::activated), this, [this] {
      this->describe();
      emit this->changed();
    });
  this->list();
}

void ComparePanel::makeResults()
{
  this->Results = new QListWidget;
  this->Results->setObjectName(QStringLiteral("results"));
  this->Results->setWordWrap(true);
  this->Results->setAlternatingRowColors(true);
  this->Results->setToolTip(
      tr("Results in the order of their runs. The error is the root mean square of the relative "
         "standard errors over all lit points."));
  this->Rename = new QPushButton(tr("Rename…"));
  this->Rename->setObjectName(QStringLiteral("renameResult"));
  this->Rename->setToolTip(tr("Gives the shown result a name"));
  this->Delete = new QPushButton(tr("Delete"));
  this->Delete->setObjectName(QStringLiteral("deleteResult"));
  this->Delete->setToolTip(tr("Removes the shown result"));
}

void ComparePanel::rename()
{
  bool accepted = false;
  const QString name = QInputDialog::getText(this, tr("Rename the result"), tr("Name"), QLineEdit::Normal,
                                             nameOf(*this->Bench->shown()), &accepted);
  if (accepted)
    this->Bench->rename(this->Bench->shownIndex(), name.trimmed());
}

void ComparePanel::enable()
{
  this->Rename->setEnabled(this->Bench->shown() != nullptr);
  this->Delete->setEnabled(this->Bench->canRemove(this->Bench->shownIndex()));
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
    const QString state = result->complete ? duration(result->seconds) : tr("not complete");
    this->Results->addItem(tr("%1\n%2 points · seed %3 · %4 · error %5")
                               .arg(nameOf(*result), grouped(result->quality.receivers))
                               .arg(result->settings.seed)
                               .arg(state, percent(result->quality.typical)));
    this->OtherBox->addItem(nameOf(*result));
  }
  this->Results->setCurrentRow(this->Bench->shownIndex());
  if (this->OtherBox->count() > 0)
    this->OtherBox->setCurrentIndex(std::min(other, this->OtherBox->count() - 1));
  this->enable();
  this->describe();
}

ShownPictures ComparePanel::differencePicture()
{
  const Mode mode = this->mode();
  const char* array = mode == Mode::DifferenceInErrors ? Comparison::inErrors
                      : mode == Mode::DifferenceInLux  ? Comparison::inLux
                                                       : Comparison::inPercent;
  const QString unit = mode == Mode::DifferenceInErrors ? tr("std. errors")
                       : mode == Mode::DifferenceInLux  ? QStringLiteral("lx")
                                                        : QStringLiteral("%");
  ShownPictures shown;
  shown.first.data = this->comparison().data;
  shown.first.array = QString::fromLatin1(array);
  shown.first.colours = differenceColours(colourLimit(this->Found, array));
  shown.legend = {shown.first.colours, tr("Difference"), unit, {}, {}};
  return shown;
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
