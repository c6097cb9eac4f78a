// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosFalseColor
 * @brief   colours for illuminance and luminance
 *
 * Input: vtkDataSet (images too) or vtkCompositeDataSet. Output: the same with the unsigned char array "FalseColor" of
 * 3 components (sRGB) beside the coloured array, in point or cell data. Leaves of a composite share one range; leaves
 * without the array pass unchanged.
 *
 * - ArrayName (default empty): the array, 1 component; empty: Illuminance, else Luminance
 * - Scale (default LINEAR): LINEAR, LOGARITHMIC (base 10)
 * - AutomaticRange (default on): from the smallest to the largest finite value; logarithmic: of positive ones, and at
 *   most 4 decades
 * - Range (default (0, 1000)): in the array's unit, where AutomaticRange is off; logarithmic: above 0
 *
 * The table has 256 perceptually uniform colours from black-blue (low) over red to light yellow (high). Values beyond
 * the range take the colour of its nearer end; so does 0 on the logarithmic scale. NaN is grey (128, 128, 128).
 *
 * GetLookupTable(), GetUsedRange() and GetUnitLabel() serve legends (vtkScalarBarActor, matplotlib) after Update().
 *
 * Errors: no such array, an array of several components, and a range that is not finite, empty or, on the logarithmic
 * scale, not above 0 give an error event and an empty output.
 */
#ifndef vtkKalosFalseColor_h
#define vtkKalosFalseColor_h

#include <string>  // for ArrayName

#include "vtkKalosViewsPhotometryModule.h"
#include "vtkNew.h"  // for Table
#include "vtkPassInputTypeAlgorithm.h"

class vtkDataSet;
class vtkLookupTable;

class VTKKALOSVIEWSPHOTOMETRY_EXPORT vtkKalosFalseColor : public vtkPassInputTypeAlgorithm
{
public:
  static vtkKalosFalseColor* New();
  vtkTypeMacro(vtkKalosFalseColor, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Scales
  {
    LINEAR = 0,
    LOGARITHMIC = 1
  };

  ///@{
  /** Name of the array to colour; empty for Illuminance, else Luminance. */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /** LINEAR or LOGARITHMIC. */
  vtkSetClampMacro(Scale, int, LINEAR, LOGARITHMIC);
  vtkGetMacro(Scale, int);
  ///@}

  ///@{
  /** Take the range from the data. */
  vtkSetMacro(AutomaticRange, bool);
  vtkGetMacro(AutomaticRange, bool);
  vtkBooleanMacro(AutomaticRange, bool);
  ///@}

  ///@{
  /** The values of the first and the last colour, in the array's unit; read where AutomaticRange is off. */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  /** The range that the last update used. */
  vtkGetVector2Macro(UsedRange, double);

  /** The table of the last update: colours, range, scale and NaN colour. */
  vtkLookupTable* GetLookupTable();

  /** "lx", "cd/m²" or "lm/m²" (UTF-8) of the array that the last update coloured; empty for arrays that are not
   * Kalos's. */
  std::string GetUnitLabel() const { return this->UnitLabel; }

  /** Name of the array of colours. */
  static const char* ColorArrayName() { return "FalseColor"; }

protected:
  vtkKalosFalseColor();
  ~vtkKalosFalseColor() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string ArrayName;
  int Scale = LINEAR;
  bool AutomaticRange = true;
  double Range[2] = {0.0, 1000.0};
  double UsedRange[2] = {0.0, 1.0};
  std::string UnitLabel;
  vtkNew<vtkLookupTable> Table;

private:
  vtkKalosFalseColor(const vtkKalosFalseColor&) = delete;
  void operator=(const vtkKalosFalseColor&) = delete;

  void AddColors(vtkDataSet* leaf, const std::string& name);
};

#endif
