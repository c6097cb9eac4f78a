// SPDX-License-Identifier: BSD-3-Clause
#include "scene/FineShadows.h"

#include <algorithm>
#include <map>
#include <string>

#include "base/DataSets.h"
#include "base/ErrorCollector.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosIlluminance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

bool hasAreasOfLight(vtkPolyData* surfaces, vtkPolyData* luminaires)
{
  vtkDataArray *exitance = surfaces->GetCellData()->GetArray(Names::Exitance),
               *side = luminaires->GetPointData()->GetArray(Names::SideU);
  return (exitance && exitance->GetRange(-1)[1] > 0) || (side && side->GetRange(-1)[1] > 0);
}

/// The surfaces with a reflectance of 0: trajectories end at the first hit, and only direct light is left.
vtkSmartPointer<vtkPolyData> blackened(vtkPolyData* surfaces)
{
  auto black = vtkSmartPointer<vtkPolyData>::New();
  black->CopyStructure(surfaces);
  vtkNew<vtkDoubleArray> reflectance;
  reflectance->SetName(Names::Reflectance);
  reflectance->SetNumberOfTuples(surfaces->GetNumberOfCells());
  reflectance->Fill(0);
  black->GetCellData()->AddArray(reflectance);
  return black;
}
}  // namespace

/// Cuts cells level by level.
class FineShadows::Cutter
{
public:
  Cutter(FineShadows& fine, vtkPolyData* set, vtkPolyData* surfaces, vtkPolyData* luminaires) : Fine(fine)
  {
    this->Illuminance->SetInputData(1, blackened(surfaces));
    this->Illuminance->SetInputData(2, luminaires);
    this->Illuminance->SetMethod(vtkKalosIlluminance::LOCAL);
    this->Illuminance->SetTrajectories(1);
    this->Illuminance->KeepSceneOn();
    this->Illuminance->TellWarningsOff();
    this->Points->SetDataTypeToDouble();
    this->Points->DeepCopy(set->GetPoints());
    this->Places.resize(static_cast<std::size_t>(set->GetNumberOfPoints()));
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i)
    {
      set->GetCellPoints(i, ids);
      const Corners corners(ids->begin(), ids->end());
      this->Cells.push_back({corners, i});
      // Measured slightly inside the cell, because a wall may stand on its border.
      const Point centre = cellCentre(set, i), normal(set->GetCellData()->GetNormals()->GetTuple3(i));
      for (const vtkIdType corner : corners)
        this->Places[static_cast<std::size_t>(corner)] = {this->at(corner) + 1e-3 * (centre - this->at(corner)),
                                                          normal};
    }
    this->measure();
  }

  /// Whether any cell was cut.
  bool cut(vtkPolyData* set, double finest)
  {
    bool any = false;
    for (bool again = true; again && this->Light.size() < 200000;)
    {
      again = false;
      std::vector<Cell> next;
      for (const Cell& cell : this->Cells)
        if (this->crossed(cell) && this->side(cell) > 2 * finest &&
            (cell.corners.size() == 3 || cell.corners.size() == 4))
        {
          this->quarter(cell, Point(set->GetCellData()->GetNormals()->GetTuple3(cell.origin)), next);
          again = any = true;
        }
        else
          next.push_back(cell);
      this->Cells = next;
      this->measure();
    }
    return any;
  }

  void finish(vtkIdType setPoints)
  {
    vtkNew<vtkCellArray> polygons;
    std::vector<bool> exact(this->Light.size());
    for (const Cell& cell : this->Cells)
    {
      polygons->InsertNextCell(static_cast<vtkIdType>(cell.corners.size()), cell.corners.data());
      if (cell.isPart)
        for (const vtkIdType corner : cell.corners)
          exact[static_cast<std::size_t>(corner)] = true;
    }
    for (std::size_t i = 0; i < exact.size(); ++i)
      this->Fine.Direct.push_back(exact[i] ? this->Light[i] : -1);
    this->Fine.SetPoints = setPoints;
    this->Fine.Mesh = vtkSmartPointer<vtkPolyData>::New();
    this->Fine.Mesh->SetPoints(this->Points);
    this->Fine.Mesh->SetPolys(polygons);
  }

private:
  struct Cell
  {
    Corners corners;
    vtkIdType origin;  // cell of the set
    bool isPart = false;
  };
  struct Place
  {
    Point position, normal;
  };

  Point at(vtkIdType point) const { return Point(this->Points->GetPoint(point)); }
  double side(const Cell& cell) const { return (this->at(cell.corners[1]) - this->at(cell.corners[0])).Norm(); }

  bool crossed(const Cell& cell) const
  {
    double least = 1e300, most = 0;
    for (const vtkIdType corner : cell.corners)
    {
      least = std::min(least, this->Light[static_cast<std::size_t>(corner)]);
      most = std::max(most, this->Light[static_cast<std::size_t>(corner)]);
    }
    return least < 0.75 * most;
  }

  vtkIdType middle(const Corners& parents, const Point& normal)
  {
    Corners key = parents;
    std::sort(key.begin(), key.end());
    const auto [entry, isNew] = this->Middles.try_emplace(key, this->Points->GetNumberOfPoints());
    if (isNew)
    {
      Point sum(0, 0, 0);
      for (const vtkIdType parent : parents)
        sum += this->at(parent);
      const Point place = (1.0 / static_cast<double>(parents.size())) * sum;
      this->Points->InsertNextPoint(place.GetData());
      this->Places.push_back({place, normal});
      this->Fine.Parents.push_back(parents);
    }
    return entry->second;
  }

  void quarter(const Cell& cell, const Point& normal, std::vector<Cell>& parts)
  {
    const std::size_t count = cell.corners.size();
    Corners middles;
    for (std::size_t k = 0; k < count; ++k)
      middles.push_back(this->middle({cell.corners[k], cell.corners[(k + 1) % count]}, normal));
    const vtkIdType centre = count == 4 ? this->middle(cell.corners, normal) : 0;
    for (std::size_t k = 0; k < count; ++k)
    {
      Corners corners{cell.corners[k], middles[k]};
      if (count == 4)
        corners.push_back(centre);
      corners.push_back(middles[(k + count - 1) % count]);
      parts.push_back({corners, cell.origin, true});
    }
    if (count == 3)
      parts.push_back({middles, cell.origin, true});
  }

  // Computes the direct light at the points that were added since the last call.
  void measure()
  {
    const std::size_t first = this->Light.size();
    if (first == this->Places.size())
      return;
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetName("Normals");
    for (std::size_t i = first; i < this->Places.size(); ++i)
    {
      places->InsertNextPoint(this->Places[i].position.GetData());
      normals->InsertNextTuple(this->Places[i].normal.GetData());
    }
    vtkNew<vtkPolyData> receivers;
    receivers->SetPoints(places);
    receivers->GetPointData()->SetNormals(normals);
    const auto errors = ErrorCollector::watch(this->Illuminance);
    this->Illuminance->SetInputDataObject(0, receivers);
    this->Illuminance->Update();
    auto* solved = vtkDataSet::SafeDownCast(this->Illuminance->GetOutputDataObject(0));
    vtkDataArray* direct = solved ? solved->GetPointData()->GetArray(Names::DirectIlluminance) : nullptr;
    for (std::size_t i = first; i < this->Places.size(); ++i)
      this->Light.push_back(direct ? direct->GetComponent(static_cast<vtkIdType>(i - first), 0) : 0);
  }

  FineShadows& Fine;
  vtkNew<vtkKalosIlluminance> Illuminance;
  vtkNew<vtkPoints> Points;
  std::vector<Cell> Cells;
  std::vector<Place> Places;  // where the light of each point is measured
  std::vector<double> Light;  // direct, lx
  std::map<Corners, vtkIdType> Middles;
};

std::shared_ptr<const FineShadows> FineShadows::make(vtkPolyData* set, vtkPolyData* surfaces, vtkPolyData* luminaires,
                                                     double finest)
{
  if (!set->GetCellData()->GetNormals() || luminaires->GetNumberOfPoints() == 0 ||
      hasAreasOfLight(surfaces, luminaires))
    return nullptr;
  auto fine = std::make_shared<FineShadows>();
  Cutter cutter(*fine, set, surfaces, luminaires);
  if (!cutter.cut(set, finest))
    return nullptr;
  cutter.finish(set->GetNumberOfPoints());
  return fine;
}

vtkSmartPointer<vtkPolyData> FineShadows::picture(vtkPolyData* solved, const char* array) const
{
  vtkDataArray *values = solved->GetCellData()->GetArray(array),
               *direct = solved->GetCellData()->GetArray(Names::DirectIlluminance);
  const std::string name = array;
  if (!values || !direct || (name != Names::Illuminance && name != Names::DirectIlluminance))
    return nullptr;
  vtkNew<vtkDoubleArray> all, indirect;
  all->SetName("All");
  indirect->SetName("Indirect");
  for (vtkIdType i = 0; i < solved->GetNumberOfCells(); ++i)
  {
    all->InsertNextValue(values->GetComponent(i, 0));
    indirect->InsertNextValue(values->GetComponent(i, 0) - direct->GetComponent(i, 0));
  }
  vtkNew<vtkPolyData> cells;
  cells->CopyStructure(solved);
  cells->GetCellData()->AddArray(all);
  cells->GetCellData()->AddArray(indirect);
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(cells);
  toPoints->Update();
  vtkPointData* atPoints = toPoints->GetOutput()->GetPointData();
  vtkDataArray *allAt = atPoints->GetArray("All"), *indirectAt = atPoints->GetArray("Indirect");
  std::vector<double> smooth(this->Direct.size());
  vtkNew<vtkDoubleArray> shown;
  shown->SetName(array);
  for (std::size_t i = 0; i < this->Direct.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    const bool ofSet = point < this->SetPoints;
    if (ofSet)
      smooth[i] = indirectAt->GetComponent(point, 0);
    else
    {
      const Corners& parents = this->Parents[i - static_cast<std::size_t>(this->SetPoints)];
      for (const vtkIdType parent : parents)
        smooth[i] += smooth[static_cast<std::size_t>(parent)] / static_cast<double>(parents.size());
    }
    shown->InsertNextValue(this->Direct[i] >= 0 ? std::max(0.0, smooth[i] + this->Direct[i])
                                                : allAt->GetComponent(point, 0));
  }
  auto picture = vtkSmartPointer<vtkPolyData>::New();
  picture->ShallowCopy(this->Mesh);
  picture->GetPointData()->AddArray(shown);
  return picture;
}
}  // namespace studio
