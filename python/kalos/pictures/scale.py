# SPDX-License-Identifier: BSD-3-Clause
"""The colour scale of a picture: from 0 to a round number, in the colours of vtkKalosFalseColor."""
import math
from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Colormap, Normalize

from kalos.pictures.colours import false_colours

ROUND = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)


@dataclass
class Scale:
    colours: Colormap
    norm: Normalize
    cut: bool  # whether values lie above the top


def colour_scale(values):
    """From 0 to the largest value; to the 99th percentile where a few spikes would darken all else. Masked values do not count."""
    values = np.ma.compressed(values)
    if len(values) == 0:
        return Scale(false_colours(), Normalize(0, 1), False)
    high = float(np.max(values))
    usual = float(np.percentile(values, 99))
    top = round_up(high if high <= 1.5 * usual or usual <= 0 else usual)
    return Scale(false_colours(), Normalize(0, top), high > top)


def round_up(value):
    if value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next((step * power for step in ROUND if step * power >= value * (1 - 1e-9)), 10 * power)


def colour_bar(axes, scale, label):
    """The legend, as high as the picture, with an arrow at the top where values are cut off."""
    beside = axes.inset_axes([1.03, 0, 0.04, 1])
    mappable = ScalarMappable(norm=scale.norm, cmap=scale.colours)
    bar = axes.figure.colorbar(mappable, cax=beside, extend="max" if scale.cut else "neither", extendfrac=0.04)
    bar.set_label(label + (" (arrow: above the scale)" if scale.cut else ""))
    bar.outline.set_linewidth(0.5)
