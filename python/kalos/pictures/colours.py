# SPDX-License-Identifier: BSD-3-Clause
"""The false colours of vtkKalosFalseColor for matplotlib, so that a value looks the same in every picture."""
import matplotlib
from matplotlib.colors import ListedColormap

from kalos.pictures.look import OWN_COLOURS
from kalos.vtk import vtkKalosFalseColor


def false_colours():
    """The colour map, from low to high."""
    table = vtkKalosFalseColor().GetLookupTable()
    colours = [table.GetTableValue(i) for i in range(table.GetNumberOfTableValues())]
    found = ListedColormap(colours, name="kalos")
    found.set_bad("0.8")  # values that are left out
    return found


def colour_map(name):
    """The colours of that name: kalos's own, or a colour map of Matplotlib."""
    if name == OWN_COLOURS:
        return false_colours()
    found = matplotlib.colormaps[name].copy()
    found.set_bad("0.8")
    return found
