// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ShowPanel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "common/Wording.h"
#include "results/Colours.h"

namespace studio
{
namespace
{
constexpr int computeColumn = 1, showColumn = 2;

QDoubleSpinBox* rangeBox(const QString& name, const QString& tip)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setRange(-1e9, 1e9);
  box->setDecimals(3);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  return box;
}
}  // namespace

void ShowPanel::makeBoxes()
{
  this->QuantityBox = new QComboBox;
  this->QuantityBox->setObjectName(QStringLiteral("quantity"));
  for (Quantity q : quantities())
  {
    this->QuantityBox->addItem(unitOf(q).isEmpty() ? title(q) : tr("%1, %2").arg(title(q), unitOf(q)));
    this->QuantityBox->setItemData(this->QuantityBox->count() - 1, explain(q), Qt::ToolTipRole);
  }
  this->QuantityBox->setToolTip(tr("What the colours show"));
  this->ScaleBox = new QComboBox;
  this->ScaleBox->setObjectName(QStringLiteral("scale"));
  this->ScaleBox->addItems({tr("Linear"), tr("Logarithmic"), tr("Photographic")});
  this->ScaleBox->setItemData(2,
                              tr("Tone-mapped as a photograph: middle grey at the average, the upper end of the range "
                                 "white"),
                              Qt::ToolTipRole);
  this->ScaleBox->setToolTip(tr("How values become colours"));
  this->ColoursBox = new QComboBox;
  this->ColoursBox->setObjectName(QStringLiteral("colours"));
  for (const QString& map : colourMaps())
    this->ColoursBox->addItem(map);
  this->ColoursBox->setToolTip(tr("Colour map: kalos has contrast, viridis and inferno suit colour-blind readers"));
  this->Low = rangeBox(QStringLiteral("low"), tr("Lower end of the colours"));
  this->High = rangeBox(QStringLiteral("high"), tr("Upper end of the colours"));
}

void ShowPanel::makeChecks()
{
  auto check = [](const QString& text, const QString& name, const QString& tip) {
    auto* box = new QCheckBox(text);
    box->setObjectName(name);
    box->setToolTip(tip);
    return box;
  };
  this->Automatic = check(tr("Automatic range"), QStringLiteral("automatic"),
                          tr("Up to a round number above all but the highest half per cent of the values"));
  this->Smooth = check(tr("Smooth"), QStringLiteral("smooth"), tr("Interpolate between the points of a face"));
  this->Isolines = check(tr("Isolines"), QStringLiteral("isolines"), tr("Lines of equal value, with their values"));
  this->Values = check(tr("Values"), QStringLiteral("values"), tr("Writes values on calculation planes"));
  this->Edges = check(tr("Singular edges"), QStringLiteral("edges"),
                      tr("Concave edges, and dashed contacts; the brighter, the narrower the angle"));
  this->Luminaires = check(tr("Luminaires"), QStringLiteral("luminaires"), tr("With their photometric solids"));
}

ShowPanel::ShowPanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->makeBoxes();
  this->makeChecks();
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Quantity"), this->QuantityBox);
  form->addRow(tr("S&cale"), this->ScaleBox);
  form->addRow(tr("C&olours"), this->ColoursBox);
  auto* range = new QHBoxLayout;
  range->addWidget(this->Low);
  range->addWidget(this->High);
  form->addRow(QString(), this->Automatic);
  form->addRow(tr("Range"), range);
  auto* checks = new QGridLayout;
  checks->addWidget(this->Smooth, 0, 0);
  checks->addWidget(this->Isolines, 0, 1);
  checks->addWidget(this->Edges, 1, 0);
  checks->addWidget(this->Luminaires, 1, 1);
  checks->addWidget(this->Values, 2, 0);

  this->makeSets();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->addLayout(form);
  layout->addLayout(checks);
  layout->addWidget(this->Sets, 1);

  this->connectAll();
  this->read();
}

void ShowPanel::makeSets()
{
  this->Sets = new QTreeWidget;
  this->Sets->setObjectName(QStringLiteral("sets"));
  this->Sets->setHeaderLabels({tr("Points"), tr("Compute"), tr("Show")});
  this->Sets->setRootIsDecorated(false);
  this->Sets->setSelectionMode(QAbstractItemView::NoSelection);
  this->Sets->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  this->Sets->header()->setSectionResizeMode(computeColumn, QHeaderView::ResizeToContents);
  this->Sets->header()->setSectionResizeMode(showColumn, QHeaderView::ResizeToContents);
  this->Sets->header()->setStretchLastSection(false);
  this->Sets->setMinimumHeight(110);
  this->Sets->setToolTip(tr("Sets of points: what a run computes, and what the view shows"));
}

void ShowPanel::connectAll()
{
  for (QComboBox* box : {this->QuantityBox, this->ScaleBox, this->ColoursBox})
    connect(box, qOverload<int>(&QComboBox::activated), this, &ShowPanel::write);
  for (QCheckBox* box : {this->Automatic, this->Smooth, this->Isolines, this->Values, this->Edges, this->Luminaires})
    connect(box, &QCheckBox::toggled, this, &ShowPanel::write);
  for (QDoubleSpinBox* box : {this->Low, this->High})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ShowPanel::write);
  connect(this->Sets, &QTreeWidget::itemChanged, this, &ShowPanel::setToggled);
  connect(this->Bench, &Workbench::displayChanged, this, &ShowPanel::read);
  connect(this->Bench, &Workbench::resultsChanged, this, &ShowPanel::read);
  connect(this->Bench, &Workbench::sceneChanged, this, &ShowPanel::listSets);
}

void ShowPanel::read()
{
  const Display& d = this->Bench->display();
  const QSignalBlocker blockers[] = {QSignalBlocker(this->Automatic),  QSignalBlocker(this->Smooth),
                                     QSignalBlocker(this->Isolines),   QSignalBlocker(this->Edges),
                                     QSignalBlocker(this->Luminaires), QSignalBlocker(this->Low),
                                     QSignalBlocker(this->High),       QSignalBlocker(this->Values)};
  this->QuantityBox->setCurrentIndex(static_cast<int>(d.quantity));
  this->ScaleBox->setCurrentIndex(static_cast<int>(d.scale));
  this->Automatic->setChecked(d.automaticRange);
  this->Smooth->setChecked(d.smooth);
  this->Isolines->setChecked(d.isolines);
  this->Values->setChecked(d.values);
  this->ColoursBox->setCurrentText(d.colours);
  this->ColoursBox->setEnabled(d.scale != Scale::Photographic && !isSigned(d.quantity));
  this->enableQuantities();
  this->Edges->setChecked(d.edges);
  this->Luminaires->setChecked(d.luminaires);
  const auto range = rangeOf(this->Bench->onOneScale(), d);
  this->Low->setValue(range[0]);
  this->High->setValue(range[1]);
  this->Low->setEnabled(!d.automaticRange);
  this->High->setEnabled(!d.automaticRange);
}

// What the shown result does not have cannot be chosen.
void ShowPanel::enableQuantities()
{
  auto* items = qobject_cast<QStandardItemModel*>(this->QuantityBox->model());
  const ResultPtr result = this->Bench->shown();
  for (Quantity q : quantities())
    items->item(static_cast<int>(q))->setEnabled(!result || hasQuantity(*result, q));
}

void ShowPanel::write()
{
  Display d = this->Bench->display();
  const auto quantity = static_cast<Quantity>(this->QuantityBox->currentIndex());
  const bool wasAutomatic = d.automaticRange, other = quantity != d.quantity;
  d.quantity = quantity;
  d.scale = static_cast<Scale>(this->ScaleBox->currentIndex());
  d.automaticRange = this->Automatic->isChecked() || other;  // a range says nothing about another quantity
  d.smooth = this->Smooth->isChecked();
  d.isolines = this->Isolines->isChecked();
  d.values = this->Values->isChecked();
  d.colours = this->ColoursBox->currentText();
  d.edges = this->Edges->isChecked();
  d.luminaires = this->Luminaires->isChecked();
  if (!d.automaticRange)
  {
    // Leaving the automatic range starts from it; an empty one is widened at its upper end.
    d.range = wasAutomatic ? rangeOf(this->Bench->onOneScale(), this->Bench->display())
                           : std::array<double, 2>{this->Low->value(), this->High->value()};
    if (d.scale == Scale::Logarithmic && !isSigned(d.quantity) && !(d.range[0] > 0))
      d.range[0] = 1e-3 * std::max(1.0, d.range[1]);
    if (!(d.range[0] < d.range[1]))
      d.range[1] = d.range[0] + 1;
  }
  this->Bench->setDisplay(d);
  this->read();
}

void ShowPanel::listSets()
{
  const QSignalBlocker blocker(this->Sets);
  this->Sets->clear();
  const ScenePtr& scene = this->Bench->scene();
  for (const QString& name : scene->sets())
  {
    auto* item = new QTreeWidgetItem(this->Sets, {name});
    item->setCheckState(computeColumn, this->Bench->chosenSets().contains(name) ? Qt::Checked : Qt::Unchecked);
    item->setCheckState(showColumn, this->Bench->display().hidden.contains(name) ? Qt::Unchecked : Qt::Checked);
  }
}

void ShowPanel::setToggled()
{
  QStringList compute, hidden;
  for (int i = 0; i < this->Sets->topLevelItemCount(); ++i)
  {
    const QTreeWidgetItem* item = this->Sets->topLevelItem(i);
    if (item->checkState(computeColumn) == Qt::Checked)
      compute << item->text(0);
    if (item->checkState(showColumn) != Qt::Checked)
      hidden << item->text(0);
  }
  Display d = this->Bench->display();
  d.hidden = hidden;
  this->Bench->setDisplay(d);
  this->Bench->setChosenSets(compute);
}
}  // namespace studio
