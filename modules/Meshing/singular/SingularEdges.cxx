// SPDX-License-Identifier: BSD-3-Clause
#include "singular/SingularEdges.h"

#include "mesh/Tolerances.h"
#include "singular/Contacts.h"
#include "singular/Curves.h"
#include "singular/MeshEdges.h"

namespace kalos::meshing
{
Curves findSingularEdges(TriangleMesh mesh, const EdgeSettings& settings, const Progress& progress)
{
  check(mesh);
  Curves result;
  EdgeReport& counts = result.report;
  const Tolerances tolerances(mesh, settings.tolerance);
  counts.tolerance = tolerances.largest();

  // Connect triangles that only share coordinates; drop duplicates, which would all intersect each other.
  report(progress, 0.0);
  mergePoints(mesh, tolerances);
  counts.degenerate = dropDegenerate(mesh, tolerances);
  std::fill(mesh.material.begin(), mesh.material.end(), 0u);
  counts.duplicate = dropDuplicates(mesh).dropped;
  report(progress, 0.15);

  std::vector<Segment> segments;
  appendMeshEdges(mesh, settings, counts, segments);
  report(progress, 0.4);
  if (settings.wanted[static_cast<int>(EdgeClass::Contact)])
  {
    const std::size_t before = segments.size();
    appendContacts(mesh, tolerances, settings, segments,
                   progress ? [&](double share) { return progress(0.4 + 0.5 * share); } : Progress());
    counts.edges[static_cast<int>(EdgeClass::Contact)] = segments.size() - before;
  }
  report(progress, 0.9);
  joinSegments(segments, counts.tolerance, result);
  report(progress, 1.0);
  return result;
}
}  // namespace kalos::meshing
