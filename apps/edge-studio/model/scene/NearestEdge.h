// SPDX-License-Identifier: BSD-3-Clause
// The singular edge next to a point, and the line across it.
#ifndef studio_NearestEdge_h
#define studio_NearestEdge_h

#include <QVector>
#include <optional>

#include "scene/Picking.h"

namespace studio
{
struct NearestEdge
{
  double distance;  ///< m
  double angle;     ///< degrees, on the side of the normals
  Point foot;       ///< of the perpendicular, on the edge
  Point along;      ///< unit
  bool contact;
};

/// Of the edges of a severity above 0; none in a scene without any.
std::optional<NearestEdge> nearestEdge(const SceneDocument& scene, const Point& point);

/// Points on the surface or plane of a pick, on the line through it that meets the nearest singular edge at a right
/// angle.
struct ProbeLine
{
  NearestEdge edge;
  Point normal;
  QVector<double> distances;  ///< m from the edge, 0.1 mm and ten a decade up
  QVector<Point> points;
};

/// As far as the surface or plane reaches and nothing stands in the way; none where there is no edge or the pick lies
/// on it.
std::optional<ProbeLine> lineAcrossEdge(const ScenePtr& scene, const Pick& pick);

/// Receivers with a normal for each, for vtkKalosIlluminance.
vtkSmartPointer<vtkPolyData> pointReceivers(const QVector<Point>& points, const QVector<Point>& normals);
}  // namespace studio

#endif
