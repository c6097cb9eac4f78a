// SPDX-License-Identifier: BSD-3-Clause
// The figures of the shown result by set, what a task requires of them, and the audit.
#ifndef studio_ValuesPanel_h
#define studio_ValuesPanel_h

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTableWidget>
#include <QTreeWidget>

#include "results/Statistics.h"
#include "session/Workbench.h"

namespace studio
{
class ValuesPanel : public QWidget
{
  Q_OBJECT

public:
  explicit ValuesPanel(Workbench* bench, QWidget* parent = nullptr);

signals:
  /// The place of a smallest or largest value, m.
  void placeChosen(const studio::Point& place);

private:
  void makeTable();
  void makeRequirement();
  void show();
  void fillRow(int row, const SetStatistics& set);
  void listSets();
  void readRequirement();
  void writeRequirement();
  void showAudit();
  void choose(int row, int column);

  Workbench* Bench;
  QTableWidget* Table;
  QComboBox* Set;
  QDoubleSpinBox *Mean, *Uniformity;
  QTreeWidget* Audit;
  QVector<SetStatistics> Shown;
};
}  // namespace studio

#endif
