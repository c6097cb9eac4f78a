// SPDX-License-Identifier: BSD-3-Clause
// What must hold of whatever a scene reader lets through.
#ifndef SceneCheck_h
#define SceneCheck_h

#include "FuzzFile.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosSceneReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace fuzz
{
inline void checkRange(vtkDataArray* array, double low, double below)
{
  require(array != nullptr);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      require(array->GetComponent(i, c) >= low && array->GetComponent(i, c) < below);
}

/// An error and nothing, or a scene whose numbers are in range.
inline void checkScene(const std::string& path)
{
  static Reading<vtkKalosSceneReader> reader;
  const bool failed = reader.fails(path);
  vtkPolyData* surfaces = reader->GetSurfaces();
  if (failed)
  {
    require(surfaces->GetNumberOfCells() == 0 && reader->GetReceivers()->GetNumberOfBlocks() == 0);
    return;
  }
  require(reader->GetReceivers()->GetNumberOfBlocks() > 0 || reader->GetNumberOfCameras() > 0);
  vtkCellData* cells = surfaces->GetCellData();
  checkRange(cells->GetArray(vtkKalosArrayNames::Reflectance), 0, 1);
  checkRange(cells->GetArray(vtkKalosArrayNames::Specular), 0, 1);
  checkRange(cells->GetArray(vtkKalosArrayNames::Mirror), 0, 1);
  checkRange(cells->GetArray(vtkKalosArrayNames::Exitance), 0, HUGE_VAL);
  for (vtkIdType i = 0; i < surfaces->GetNumberOfPoints(); ++i)
    for (int c = 0; c < 3; ++c)
      require(std::isfinite(surfaces->GetPoint(i)[c]));
  vtkPolyData* luminaires = reader->GetLuminaires();
  if (luminaires->GetNumberOfPoints() > 0)
    checkRange(luminaires->GetPointData()->GetArray(vtkKalosArrayNames::LuminousFlux), 0, HUGE_VAL);
}
}  // namespace fuzz

#endif
