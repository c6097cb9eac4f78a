// SPDX-License-Identifier: BSD-3-Clause
// Pictures with finer cells along the borders of shadows.
#ifndef studio_FineShadows_h
#define studio_FineShadows_h

#include <memory>
#include <vector>

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// The cells of a receiver set, cut again and again where the direct light of their corners differs. The direct light
/// of point luminaires is known exactly at every corner, whatever the method, and what is indirect is smooth: a corner
/// shows its own direct light and the indirect light of the cells around it.
class FineShadows
{
public:
  /// Null where nothing is to be cut, and where the direct light is not known exactly: luminaires or surfaces that are
  /// areas of light. `finest` is the side of the smallest cells, m.
  static std::shared_ptr<const FineShadows> make(vtkPolyData* set, vtkPolyData* surfaces, vtkPolyData* luminaires,
                                                 double finest);

  /// The finer cells with this array at their points. `solved` is the set with results; null where the array is neither
  /// the illuminance nor the direct illuminance.
  vtkSmartPointer<vtkPolyData> picture(vtkPolyData* solved, const char* array) const;

private:
  using Corners = std::vector<vtkIdType>;
  class Cutter;

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkIdType SetPoints = 0;       // the first points are those of the set
  std::vector<Corners> Parents;  // of each point after them: it lies in their middle
  std::vector<double> Direct;    // lx at each point; less than 0: the cells of the set say it
};
}  // namespace studio

#endif
