// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosMeshReader
 * @brief   read a surface in whatever state, to be repaired
 *
 * Reads .obj, .ply, .stl, .off, .vtp, .gltf and .glb by the readers that vtkKalosSceneReader uses for scenes, in double
 * precision; but faces without area stay, curved surfaces and unknown statements of an OBJ are passed over, and nothing
 * needs a material.
 *
 * Output: polygons. Of an OBJ, the cell array MaterialIds and the field data array MaterialNames hold the names of its
 * usemtl statements (empty where none applies); a glTF has the arrays that vtkKalosSceneReader gives its surfaces, in
 * metres with z up; a VTP has what it holds. What was passed over stands in the field data array SceneNotes.
 *
 * Errors are one line `FILE: WHERE: what is wrong and what is expected`, with an empty output.
 */
#ifndef vtkKalosMeshReader_h
#define vtkKalosMeshReader_h

#include "vtkKalosIOPhotometryModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosMeshReader* New();
  vtkTypeMacro(vtkKalosMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the mesh file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkKalosMeshReader();
  ~vtkKalosMeshReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkKalosMeshReader(const vtkKalosMeshReader&) = delete;
  void operator=(const vtkKalosMeshReader&) = delete;
};

#endif
