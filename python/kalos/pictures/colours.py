# SPDX-License-Identifier: BSD-3-Clause
"""The false colours of vtkKalosFalseColor for matplotlib, so that a value looks the same in every picture."""
from matplotlib.colors import ListedColormap

from kalos.vtk import vtkKalosFalseColor


def false_colours():
    """The colour map, from low to high."""
    table = vtkKalosFalseColor().GetLookupTable()
    colours = [table.GetTableValue(i) for i in range(table.GetNumberOfTableValues())]
    found = ListedColormap(colours, name="kalos")
    found.set_bad("0.8")  # values that are left out
    return found
