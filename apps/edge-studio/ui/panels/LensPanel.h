// SPDX-License-Identifier: BSD-3-Clause
// The edge lens: the edges of the scene, the worst first, and both faces beside the chosen one as a heat map of each
// method's error.
#ifndef studio_LensPanel_h
#define studio_LensPanel_h

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>

#include "charts/LegendBar.h"
#include "probe/EdgeLens.h"
#include "session/Workbench.h"
#include "view/SceneView.h"

namespace studio
{
/// One row for each method: the faces beside the edge unrolled, the edge in the middle, 1 m at the ends.
class LensView : public QWidget
{
  Q_OBJECT

public:
  explicit LensView(const EdgeLens* lens, QWidget* parent = nullptr);

  /// The heat map of a method, a pixel for each point; null where it has not run.
  QImage heatMap(int method) const;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  const EdgeLens* Lens;
};

class LensPanel : public QWidget
{
  Q_OBJECT

public:
  LensPanel(Workbench* bench, SceneView* view, QWidget* parent = nullptr);
  const EdgeLens& lens() const { return this->Lens; }

signals:
  void marked(const QVector<QVector<studio::Point>>& lines);

private:
  void listEdges();
  void choose(int row);
  void lookAtEdge();
  void measure();
  void show();

  Workbench* Bench;
  SceneView* View;
  EdgeLens Lens;
  QVector<EdgePiece> Pieces;
  std::optional<LensGrid> Chosen;
  QListWidget* Edges;
  QSlider* Effort;
  QLabel *EffortText, *About;
  QPushButton *Measure, *Stop;
  LensView* Picture;
};
}  // namespace studio

#endif
