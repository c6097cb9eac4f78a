// SPDX-License-Identifier: BSD-3-Clause
// A preview: results at some receivers stand for all until the first complete round.
#ifndef studio_Preview_h
#define studio_Preview_h

#include <vector>

#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// About `wanted` receivers, evenly taken from the cells of all blocks; null where there are not many more than that.
vtkSmartPointer<vtkDataObject> someReceivers(vtkDataObject* receivers, int wanted);

/// Results on some receivers for all of them: every cell takes those of the nearest that was solved and faces the same
/// of the six directions of the axes.
class Spread
{
public:
  /// `some` as someReceivers(receivers) gave them.
  Spread(vtkDataObject* some, vtkDataObject* receivers);

  /// The receivers with the cell arrays of a result on `some`.
  vtkSmartPointer<vtkDataObject> over(vtkDataObject* solved) const;

private:
  struct Set
  {
    vtkSmartPointer<vtkPolyData> receivers;
    vtkSmartPointer<vtkIdList> cells;  // of `some`, one for each receiver
  };
  std::vector<Set> Sets;
};
}  // namespace studio

#endif
