// SPDX-License-Identifier: BSD-3-Clause
// The error of every method on both faces beside an edge, from 0.1 mm to 1 m away.
#ifndef studio_EdgeLens_h
#define studio_EdgeLens_h

#include "run/RunQueue.h"
#include "scene/EdgeList.h"

namespace studio
{
/// Points on both faces beside an edge: rows along it, columns away from it on a logarithmic scale.
struct LensGrid
{
  static constexpr int rows = 16, columns = 41;  ///< of each face
  EdgePiece edge;
  std::array<Flank, 2> flanks;
  QVector<Point> points, normals;
  QVector<int> index;  ///< of the point, face by face and row by row; -1: the face does not reach as far

  int at(int face, int row, int column) const { return this->index[(face * rows + row) * columns + column]; }
  static double distance(int column);  ///< m from the edge
};

std::optional<LensGrid> lensGrid(const ScenePtr& scene, const EdgePiece& edge);

class EdgeLens : public QObject
{
  Q_OBJECT

public:
  explicit EdgeLens(QObject* parent = nullptr);

  /// Runs every method, see methodJobs(). Errors are relative to the truth or to the reference.
  void start(const ScenePtr& scene, const LensGrid& grid, const MethodSettings& settings);
  void cancel() { this->Queue.cancel(); }
  void forget();  ///< stops, and is as new
  bool active() const { return this->Queue.active(); }

  const std::optional<LensGrid>& grid() const { return this->Grid; }

  /// The relative error of a method at each point of the grid, value/truth - 1; empty where it has not run yet.
  QVector<double> errors(int method) const;

signals:
  void changed();
  void problem(const QString& message);

private:
  RunQueue Queue;
  std::optional<LensGrid> Grid;
  std::optional<double> Truth;
};
}  // namespace studio

#endif
