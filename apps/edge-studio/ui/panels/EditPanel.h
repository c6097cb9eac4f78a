// SPDX-License-Identifier: BSD-3-Clause
// The scene file as a tree: every value can be changed, luminaires and planes added, entries copied and deleted.
#ifndef studio_EditPanel_h
#define studio_EditPanel_h

#include <QPushButton>
#include <QTreeWidget>

#include "scene/Picking.h"
#include "scene/SceneDraft.h"
#include "session/Workbench.h"

namespace studio
{
class EditPanel : public QWidget
{
  Q_OBJECT

public:
  explicit EditPanel(Workbench* bench, QWidget* parent = nullptr);

  /// The place where the view was clicked last: where luminaires go.
  void aim(const Pick& pick);

signals:
  /// A changed draft: the window asks before results are lost, and opens it.
  void editAsked(const QJsonObject& draft);
  void saveAsked();

private:
  void makeButtons();
  void fill();
  void addItem(QTreeWidgetItem* parent, const QString& name, const QJsonValue& value, const DraftPath& path);
  void enable();
  void change(const DraftPath& path, const QString& text);
  void addLuminaire();
  void addPlane();
  void moveLuminaire();
  DraftPath chosenEntry() const;  // section and place in it; empty where no entry is chosen

  Workbench* Bench;
  QTreeWidget* Tree;
  QPushButton *Luminaire, *Plane, *Copy, *Delete, *Move, *Save;
  std::optional<Point> Place;
};
}  // namespace studio

#endif
