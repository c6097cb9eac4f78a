// SPDX-License-Identifier: BSD-3-Clause
// Panels of the probed point and of the line across the nearest edge.
#ifndef studio_ProbePanel_h
#define studio_ProbePanel_h

#include <QLabel>
#include <QPushButton>

#include "charts/ChartView.h"
#include "probe/LineProbe.h"
#include "probe/Probe.h"
#include "session/Workbench.h"

namespace studio
{
class ProbePanel : public QWidget
{
  Q_OBJECT

public:
  explicit ProbePanel(Workbench* bench, QWidget* parent = nullptr);

  void probe(const Pick& pick);
  const Probe& pointProbe() const { return this->Point; }

signals:
  void marked(const QVector<QVector<studio::Point>>& lines);

private:
  void clear();
  void show();

  Workbench* Bench;
  Probe Point;
  QLabel *Value, *Place;
  ChartView *Convergence, *Histogram;
};

class LinePanel : public QWidget
{
  Q_OBJECT

public:
  explicit LinePanel(Workbench* bench, QWidget* parent = nullptr);

  /// The next measurement goes through this point.
  void aim(const Pick& pick);
  const LineProbe& lineProbe() const { return this->Line; }

signals:
  void marked(const QVector<QVector<studio::Point>>& lines);

private:
  void clear();
  void measure();
  void show();

  Workbench* Bench;
  LineProbe Line;
  std::optional<ProbeLine> Aim;
  QLabel* About;
  QPushButton *Measure, *Stop;
  ChartView* Against;
};
}  // namespace studio

#endif
