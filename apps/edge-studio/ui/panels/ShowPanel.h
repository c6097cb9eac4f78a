// SPDX-License-Identifier: BSD-3-Clause
// Chooses what the view shows, and how.
#ifndef studio_ShowPanel_h
#define studio_ShowPanel_h

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTreeWidget>

#include "session/Workbench.h"

namespace studio
{
class ShowPanel : public QWidget
{
  Q_OBJECT

public:
  explicit ShowPanel(Workbench* bench, QWidget* parent = nullptr);

private:
  void makeSets();
  void connectAll();
  void read();   // from the bench into the widgets
  void write();  // the other way
  void listSets();
  void setToggled();

  Workbench* Bench;
  QComboBox *QuantityBox, *ScaleBox;
  QCheckBox *Automatic, *Smooth, *Isolines, *Edges, *Luminaires;
  QDoubleSpinBox *Low, *High;
  QTreeWidget* Sets;
};
}  // namespace studio

#endif
