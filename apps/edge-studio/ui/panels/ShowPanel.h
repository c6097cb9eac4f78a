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
  void makeBoxes();
  void makeChecks();
  void makeSets();
  void connectAll();
  void read();   // from the bench into the widgets
  void write();  // the other way
  void enableQuantities();
  void listSets();
  void setToggled();

  Workbench* Bench;
  QComboBox *QuantityBox, *ScaleBox, *ColoursBox;
  QCheckBox *Automatic, *Smooth, *Isolines, *Values, *Edges, *Luminaires;
  QDoubleSpinBox *Low, *High;
  QTreeWidget* Sets;
};
}  // namespace studio

#endif
