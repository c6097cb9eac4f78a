// SPDX-License-Identifier: BSD-3-Clause
/** Photometric files as VTK data: text from disk, solid, polar curves, candela table. */
#ifndef KalosPhotometricData_h
#define KalosPhotometricData_h

#include <string>

#include "photometry/PhotometricFile.h"

class vtkPolyData;
class vtkTable;

namespace kalos::photometric
{
/** Read and parse; a tilt file is looked for beside the file. Throws PhotometryError. */
PhotometricFile readFile(const std::string& path, int lampSet);

/** cd in half-plane C at angle gamma, degrees. */
double intensity(const CandelaTable& table, double c, double gamma);

void fillSolid(const CandelaTable& table, vtkPolyData* solid);
void fillPolarCurves(const CandelaTable& table, vtkPolyData* curves);
void fillTable(const CandelaTable& table, vtkTable* columns);
}  // namespace kalos::photometric

#endif
