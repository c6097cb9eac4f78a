// SPDX-License-Identifier: BSD-3-Clause
// The illuminance on a desk in a scene file, by the VTK classes: desk SCENE.json
#include <cstdio>
#include <cstdlib>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosCalculationPlane.h"
#include "vtkKalosIlluminance.h"
#include "vtkKalosSceneReader.h"
#include "vtkNew.h"

int main(int count, char* arguments[])
{
  if (count != 2)
  {
    std::fprintf(stderr, "usage: desk SCENE.json\n");
    return EXIT_FAILURE;
  }
  vtkNew<vtkKalosSceneReader> scene;
  scene->SetFileName(arguments[1]);

  vtkNew<vtkKalosCalculationPlane> desk;
  desk->SetOrigin(2, 2, 0.75);
  desk->SetResolution(4, 4);

  vtkNew<vtkKalosIlluminance> light;
  light->SetInputConnection(0, desk->GetOutputPort());
  light->SetInputConnection(1, scene->GetOutputPort(0));
  light->SetInputConnection(2, scene->GetOutputPort(1));
  light->SetRelativeError(0.05);
  light->Update();

  auto* output = vtkDataSet::SafeDownCast(light->GetOutputDataObject(0));
  vtkDataArray* lux = output ? output->GetCellData()->GetArray(vtkKalosArrayNames::Illuminance) : nullptr;
  if (!lux)
    return EXIT_FAILURE;  // VTK has said why
  vtkDataArray* error = output->GetCellData()->GetArray(vtkKalosArrayNames::IlluminanceStandardError);
  for (vtkIdType i = 0; i < lux->GetNumberOfTuples(); ++i)
    std::printf("%.1f lx, standard error %.1f\n", lux->GetComponent(i, 0), error->GetComponent(i, 0));
  return EXIT_SUCCESS;
}
