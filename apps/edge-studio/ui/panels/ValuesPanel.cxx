// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ValuesPanel.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "common/Wording.h"
#include "results/AuditLines.h"

namespace studio
{
namespace
{
constexpr int meanColumn = 0, leastColumn = 1, largestColumn = 2, taskColumn = 5;

QString lux(double value)
{
  return QString::number(value, 'f', value < 10 ? 2 : value < 100 ? 1 : 0);
}

QString wording(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Pass:
      return ValuesPanel::tr("pass");
    case Verdict::Fail:
      return ValuesPanel::tr("fail");
    case Verdict::Undecided:
      break;
  }
  return ValuesPanel::tr("undecided");
}

QColor colour(Verdict verdict)
{
  return verdict == Verdict::Pass   ? QColor(0x1b, 0x7f, 0x3b)
         : verdict == Verdict::Fail ? QColor(0xb0, 0x1e, 0x1e)
                                    : QColor(0x8a, 0x6d, 0x00);
}
}  // namespace

ValuesPanel::ValuesPanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->makeTable();
  this->makeRequirement();
  this->Audit = new QTreeWidget;
  this->Audit->setObjectName(QStringLiteral("audit"));
  this->Audit->setHeaderLabels({tr("Audit"), tr("What was modelled")});
  this->Audit->setRootIsDecorated(false);
  this->Audit->setWordWrap(true);
  this->Audit->setToolTip(tr("What was modelled and why; warnings come first"));
  this->Audit->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  auto* required = new QFormLayout;
  required->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  required->addRow(tr("Required of"), this->Set);
  required->addRow(tr("Ēm at least"), this->Mean);
  required->addRow(tr("U0 at least"), this->Uniformity);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Table, 2);
  layout->addLayout(required);
  layout->addWidget(this->Audit, 3);

  connect(bench, &Workbench::resultsChanged, this, &ValuesPanel::show);
  connect(bench, &Workbench::sceneChanged, this, &ValuesPanel::listSets);
  connect(bench, &Workbench::requirementsChanged, this, [this] {
    this->readRequirement();
    this->show();
  });
  connect(this->Table, &QTableWidget::cellClicked, this, &ValuesPanel::choose);
  connect(this->Set, qOverload<int>(&QComboBox::activated), this, &ValuesPanel::readRequirement);
  for (QDoubleSpinBox* box : {this->Mean, this->Uniformity})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ValuesPanel::writeRequirement);
}

void ValuesPanel::makeTable()
{
  this->Table = new QTableWidget(0, 6);
  this->Table->setObjectName(QStringLiteral("statistics"));
  this->Table->setHorizontalHeaderLabels({tr("Ēm, lx"), tr("Emin"), tr("Emax"), tr("U0"), tr("Ud"), tr("Task")});
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->Table->setToolTip(
      tr("Mean, smallest and largest illuminance, U0 = Emin/Ēm and Ud = Emin/Emax. Points inside "
         "solids or outside are left out. A click on Emin or Emax shows the place."));
}

void ValuesPanel::makeRequirement()
{
  this->Set = new QComboBox;
  this->Set->setObjectName(QStringLiteral("requiredSet"));
  this->Set->setToolTip(tr("The set of points that the task area is"));
  auto box = [](const QString& name, double most, int decimals, const QString& suffix, const QString& tip) {
    auto* made = new QDoubleSpinBox;
    made->setObjectName(name);
    made->setRange(0, most);
    made->setDecimals(decimals);
    made->setSuffix(suffix);
    made->setSpecialValueText(tr("nothing"));
    made->setKeyboardTracking(false);
    made->setToolTip(tip);
    return made;
  };
  this->Mean =
      box(QStringLiteral("requiredMean"), 1e6, 0, tr(" lx"), tr("Mean illuminance that the task requires; 0: nothing"));
  this->Mean->setSingleStep(50);
  this->Uniformity =
      box(QStringLiteral("requiredUniformity"), 1, 2, {}, tr("Uniformity U0 that the task requires; 0: nothing"));
  this->Uniformity->setSingleStep(0.1);
}

void ValuesPanel::show()
{
  const ResultPtr result = this->Bench->shown();
  this->Shown = result && !result->preview ? statisticsOf(*result) : QVector<SetStatistics>();
  this->Table->setRowCount(static_cast<int>(this->Shown.size()));
  for (int row = 0; row < this->Shown.size(); ++row)
    this->fillRow(row, this->Shown[row]);
  this->showAudit();
}

void ValuesPanel::fillRow(int row, const SetStatistics& set)
{
  auto* title = new QTableWidgetItem(set.name);
  title->setToolTip(set.invalid > 0 ? tr("%1 points, %2 left out").arg(set.points).arg(set.invalid)
                                    : tr("%1 points").arg(set.points));
  this->Table->setVerticalHeaderItem(row, title);
  const QStringList texts{lux(set.mean), lux(set.least), lux(set.largest), QString::number(set.uniformity(), 'f', 2),
                          QString::number(set.diversity(), 'f', 2)};
  for (int column = 0; column < texts.size(); ++column)
  {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    this->Table->setItem(row, column, item);
  }
  this->Table->item(row, meanColumn)->setToolTip(tr("± %1 lx at most").arg(lux(set.meanError)));
  auto* task = new QTableWidgetItem;
  if (const auto verdict = judge(set, this->Bench->requirement(set.name)))
  {
    task->setText(wording(*verdict));
    task->setForeground(colour(*verdict));
  }
  this->Table->setItem(row, taskColumn, task);
}

void ValuesPanel::listSets()
{
  this->Set->clear();
  this->Set->addItems(this->Bench->scene()->sets());
  this->readRequirement();
  this->showAudit();
}

void ValuesPanel::readRequirement()
{
  const QSignalBlocker a(this->Mean), b(this->Uniformity);
  const Requirement required = this->Bench->requirement(this->Set->currentText());
  this->Mean->setValue(required.mean);
  this->Uniformity->setValue(required.uniformity);
}

void ValuesPanel::writeRequirement()
{
  this->Bench->require(this->Set->currentText(), {this->Mean->value(), this->Uniformity->value()});
}

void ValuesPanel::showAudit()
{
  this->Audit->clear();
  if (!this->Bench->scene())
    return;
  for (const AuditLine& line : auditLines(*this->Bench->scene(), this->Bench->shown().get()))
  {
    auto* item = new QTreeWidgetItem(this->Audit, {line.subject, line.choice});
    for (int column : {0, 1})
    {
      item->setToolTip(column, line.reason);
      if (line.warning)
        item->setForeground(column, QColor(0xb0, 0x1e, 0x1e));
    }
  }
}

void ValuesPanel::choose(int row, int column)
{
  if (column == leastColumn)
    emit this->placeChosen(this->Shown[row].leastAt);
  else if (column == largestColumn)
    emit this->placeChosen(this->Shown[row].largestAt);
}
}  // namespace studio
