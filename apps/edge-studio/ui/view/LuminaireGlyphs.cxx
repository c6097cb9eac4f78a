// SPDX-License-Identifier: BSD-3-Clause
#include "view/LuminaireGlyphs.h"

#include <cmath>
#include <string>

#include "base/Point.h"
#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosLuminaireSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace studio
{
namespace
{
struct Frame
{
  Point origin, u, v, axis;
  Point at(double x, double y, double z) const { return this->origin + x * this->u + y * this->v + z * this->axis; }
};

class Lines
{
public:
  explicit Lines(vtkPolyData* data) : Data(data)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data->SetPoints(points);
    vtkNew<vtkCellArray> lines;
    data->SetLines(lines);
  }
  void add(const std::vector<Point>& points)
  {
    this->Data->GetLines()->InsertNextCell(static_cast<int>(points.size()));
    for (const Point& p : points)
      this->Data->GetLines()->InsertCellPoint(this->Data->GetPoints()->InsertNextPoint(p.GetData()));
  }

private:
  vtkPolyData* Data;
};

/// Meridians and parallels of a solid of revolution r(theta) about the axis.
template <class Radius>
void addSolid(const Frame& frame, double end, const Radius& radius, Lines& lines)
{
  constexpr int steps = 24, meridians = 12, parallels = 6;
  auto at = [&](double theta, double phi) {
    const double r = radius(theta);
    return frame.at(r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi), r * std::cos(theta));
  };
  for (int m = 0; m < meridians; ++m)
  {
    std::vector<Point> line;
    for (int i = 0; i <= steps; ++i)
      line.push_back(at(end * i / steps, 2 * vtkMath::Pi() * m / meridians));
    lines.add(line);
  }
  for (int k = 1; k < parallels; ++k)
  {
    std::vector<Point> line;
    for (int i = 0; i <= 2 * steps; ++i)
      line.push_back(at(end * k / parallels, vtkMath::Pi() * i / steps));
    lines.add(line);
  }
}
/// The half-plane C = 90 deg, at a right angle to the axis.
Point upOf(vtkPointData* data, vtkIdType luminaire, const Frame& frame)
{
  Point up = frame.v;
  if (vtkDataArray* ups = data->GetArray(vtkKalosArrayNames::Up))
    ups->GetTuple(luminaire, up.GetData());
  return up;
}

/// The curves of a candela table in their planes; false where the table is not about the photometric axis.
bool addTable(Frame frame, const Point& up, vtkFieldData* fields, int index, double size, Lines& lines)
{
  namespace Names = vtkKalosArrayNames;
  vtkDataArray* table = fields->GetArray((Names::CandelaTable + std::to_string(index)).c_str());
  vtkDataArray* poles = fields->GetArray(Names::CandelaPoles);
  if (!table || !poles || poles->GetComponent(index, 0) != 0)
    return false;
  frame.v = up;
  frame.u = frame.axis.Cross(up);
  const double largest = table->GetRange(2)[1];
  std::vector<Point> curve;
  for (vtkIdType i = 0; i < table->GetNumberOfTuples(); ++i)
  {
    const double c = vtkMath::RadiansFromDegrees(table->GetComponent(i, 0)),
                 gamma = vtkMath::RadiansFromDegrees(table->GetComponent(i, 1)),
                 r = largest > 0 ? size * table->GetComponent(i, 2) / largest : 0;
    curve.push_back(
        frame.at(r * std::sin(gamma) * std::cos(c), r * std::sin(gamma) * std::sin(c), r * std::cos(gamma)));
    const bool last = i + 1 == table->GetNumberOfTuples() || table->GetComponent(i + 1, 0) != table->GetComponent(i, 0);
    if (!last)
      continue;
    lines.add(curve);
    curve.clear();
  }
  return true;
}
}  // namespace

vtkSmartPointer<vtkPolyData> luminaireGlyphs(vtkPolyData* luminaires, double size)
{
  namespace Names = vtkKalosArrayNames;
  auto glyphs = vtkSmartPointer<vtkPolyData>::New();
  Lines lines(glyphs);
  vtkPointData* data = luminaires->GetPointData();
  vtkDataArray *directions = data->GetArray(Names::Direction), *distributions = data->GetArray(Names::Distribution),
               *sidesU = data->GetArray(Names::SideU), *sidesV = data->GetArray(Names::SideV);
  for (vtkIdType i = 0; i < luminaires->GetNumberOfPoints(); ++i)
  {
    Frame frame{};
    luminaires->GetPoint(i, frame.origin.GetData());
    frame.axis = Point(0, 0, -1);
    if (directions)
      directions->GetTuple(i, frame.axis.GetData());
    frame.axis.Normalize();
    vtkMath::Perpendiculars(frame.axis.GetData(), frame.u.GetData(), frame.v.GetData(), 0);
    const int kind = distributions ? static_cast<int>(distributions->GetComponent(i, 0))
                                   : static_cast<int>(vtkKalosLuminaireSource::LAMBERTIAN);
    if (kind == vtkKalosLuminaireSource::ISOTROPIC)
      addSolid(
          frame, vtkMath::Pi(), [&](double) { return 0.5 * size; }, lines);
    else if (kind == vtkKalosLuminaireSource::LAMBERTIAN)
      addSolid(
          frame, vtkMath::Pi() / 2, [&](double theta) { return size * std::cos(theta); }, lines);
    else if (!addTable(frame, upOf(data, i, frame), luminaires->GetFieldData(), kind - 2, size, lines))
    {
      const Point tip = frame.at(0, 0, size), left = frame.at(-0.2 * size, 0, 0.75 * size),
                  right = frame.at(0.2 * size, 0, 0.75 * size);
      lines.add({frame.origin, tip});
      lines.add({left, tip, right});
    }
    if (!sidesU || !sidesV)
      continue;
    Frame panel = frame;
    sidesU->GetTuple(i, panel.u.GetData());
    sidesV->GetTuple(i, panel.v.GetData());
    if (panel.u.Norm() > 0)
      lines.add({panel.at(-0.5, -0.5, 0), panel.at(0.5, -0.5, 0), panel.at(0.5, 0.5, 0), panel.at(-0.5, 0.5, 0),
                 panel.at(-0.5, -0.5, 0)});
  }
  return glyphs;
}
}  // namespace studio
