// SPDX-License-Identifier: BSD-3-Clause
#include "panels/EditPanel.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

namespace studio
{
namespace
{
constexpr int pathRole = Qt::UserRole;

const QStringList& sections()
{
  static const QStringList all{QStringLiteral("luminaires"), QStringLiteral("materials"), QStringLiteral("surfaces"),
                               QStringLiteral("receivers"), QStringLiteral("cameras")};
  return all;
}

DraftPath pathOf(const QTreeWidgetItem* item)
{
  return item ? item->data(0, pathRole).toStringList() : DraftPath();
}
}  // namespace

EditPanel::EditPanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->Tree = new QTreeWidget;
  this->Tree->setObjectName(QStringLiteral("draft"));
  this->Tree->setHeaderLabels({tr("Scene"), tr("Value")});
  this->Tree->setToolTip(tr("The scene file, in metres, lumens and degrees. Double-click a value to change it."));
  this->Tree->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  this->makeButtons();
  auto* buttons = new QGridLayout;
  buttons->addWidget(this->Luminaire, 0, 0);
  buttons->addWidget(this->Plane, 0, 1);
  buttons->addWidget(this->Move, 1, 0);
  buttons->addWidget(this->Copy, 1, 1);
  buttons->addWidget(this->Delete, 2, 0);
  buttons->addWidget(this->Save, 2, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Tree, 1);
  layout->addLayout(buttons);
  connect(bench, &Workbench::sceneChanged, this, &EditPanel::fill);
  connect(this->Tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    // Later, because the new scene replaces the items while the tree still works on this one.
    QTimer::singleShot(0, this, [this, path = pathOf(item), text = item->text(1)] { this->change(path, text); });
  });
  connect(this->Tree, &QTreeWidget::itemSelectionChanged, this, &EditPanel::enable);
  this->enable();
}

void EditPanel::makeButtons()
{
  auto button = [this](const QString& text, const QString& name, const QString& tip, auto handler) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, handler);
    return made;
  };
  this->Luminaire = button(tr("Add luminaire…"), QStringLiteral("addLuminaire"),
                           tr("Of an IES or EULUMDAT file, or of 1000 lm without one; at the place that was clicked"),
                           [this] { this->addLuminaire(); });
  this->Plane =
      button(tr("Add plane"), QStringLiteral("addPlane"),
             tr("A calculation plane 0.75 m above the floor, as large as the scene"), [this] { this->addPlane(); });
  this->Move = button(tr("Move to the click"), QStringLiteral("moveLuminaire"),
                      tr("Moves the chosen luminaire to the place that was clicked in the view"),
                      [this] { this->moveLuminaire(); });
  this->Copy = button(tr("Copy"), QStringLiteral("copyEntry"), tr("Adds a copy of the chosen entry"),
                      [this] { emit this->editAsked(withCopy(this->Bench->draft(), this->chosenEntry())); });
  this->Delete = button(tr("Delete"), QStringLiteral("deleteEntry"), tr("Removes the chosen entry"),
                        [this] { emit this->editAsked(withoutEntry(this->Bench->draft(), this->chosenEntry())); });
  this->Save = button(tr("Save the scene…"), QStringLiteral("saveScene"), tr("Writes a scene file"),
                      [this] { emit this->saveAsked(); });
}

void EditPanel::fill()
{
  const DraftPath chosen = this->chosenEntry();
  const QSignalBlocker blocker(this->Tree);
  this->Tree->clear();
  for (const QString& section : sections())
  {
    auto* top = new QTreeWidgetItem(this->Tree, {section});
    top->setFlags(Qt::ItemIsEnabled);
    const QJsonValue entries = this->Bench->draft()[section];
    const QJsonObject named = entries.toObject();
    for (const QString& name : named.keys())
      this->addItem(top, name, named[name], {section, name});
    const QJsonArray listed = entries.toArray();
    for (int i = 0; i < listed.size(); ++i)
      this->addItem(top, listed[i].toObject()[QStringLiteral("name")].toString(), listed[i],
                    {section, QString::number(i)});
    top->setExpanded(section == sections().front());
  }
  for (QTreeWidgetItemIterator it(this->Tree); *it; ++it)
    if (!chosen.isEmpty() && pathOf(*it) == chosen)
    {
      this->Tree->setCurrentItem(*it);
      (*it)->setExpanded(true);
    }
  this->enable();
}

void EditPanel::addItem(QTreeWidgetItem* parent, const QString& name, const QJsonValue& value, const DraftPath& path)
{
  auto* item = new QTreeWidgetItem(parent, {name});
  item->setData(0, pathRole, path);
  if (!value.isObject())
  {
    item->setText(1, valueText(value));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return;
  }
  const QJsonObject object = value.toObject();
  for (const QString& key : object.keys())
    this->addItem(item, key, object[key], path + DraftPath{key});
}

DraftPath EditPanel::chosenEntry() const
{
  const DraftPath path = pathOf(this->Tree->currentItem());
  return path.size() >= 2 ? path.mid(0, 2) : DraftPath();
}

void EditPanel::enable()
{
  const DraftPath entry = this->chosenEntry();
  const bool opened = this->Bench->scene() != nullptr;
  this->Luminaire->setEnabled(opened);
  this->Plane->setEnabled(opened);
  this->Save->setEnabled(opened);
  this->Copy->setEnabled(!entry.isEmpty());
  this->Delete->setEnabled(!entry.isEmpty());
  this->Move->setEnabled(this->Place && !entry.isEmpty() && entry.front() == sections().front());
}

void EditPanel::change(const DraftPath& path, const QString& text)
{
  emit this->editAsked(withValue(this->Bench->draft(), path, parsedValue(text)));
  this->fill();  // with the values as they are now, also where the change was refused
}

void EditPanel::aim(const Pick& pick)
{
  this->Place = pick.position;
  this->enable();
}

void EditPanel::addLuminaire()
{
  const QString file = QFileDialog::getOpenFileName(this, tr("A photometric file; cancel for 1000 lm without one"), {},
                                                    tr("Photometric files (*.ies *.ldt)"));
  double bounds[6];
  this->Bench->scene()->surfaces()->GetBounds(bounds);
  const Point middle(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
                     bounds[4] + 0.9 * (bounds[5] - bounds[4]));
  emit this->editAsked(withLuminaire(this->Bench->draft(), this->Place.value_or(middle), file));
}

void EditPanel::addPlane()
{
  double bounds[6];
  this->Bench->scene()->surfaces()->GetBounds(bounds);
  emit this->editAsked(withPlane(this->Bench->draft(), bounds));
}

void EditPanel::moveLuminaire()
{
  const Point& p = *this->Place;
  emit this->editAsked(withValue(this->Bench->draft(), this->chosenEntry() + DraftPath{QStringLiteral("position")},
                                 QJsonArray{p[0], p[1], p[2]}));
}
}  // namespace studio
