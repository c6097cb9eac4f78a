# SPDX-License-Identifier: BSD-3-Clause
"""The colour scale of a picture: by default from 0 to a round number, in the colours of vtkKalosFalseColor."""
import math
from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Colormap, LogNorm, Normalize

from kalos.pictures.colours import colour_map
from kalos.pictures.look import LOOK, Look

ROUND = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)


DECADES = 3  # of a logarithmic scale whose range is automatic


@dataclass
class Scale:
    colours: Colormap
    norm: Normalize
    cut: str  # at which ends values lie outside: neither, min, max or both, as Matplotlib has it


def colour_scale(values: Any, ends: Optional[Tuple[float, float]] = None, look: Look = LOOK) -> Scale:
    """Between the `ends`, or from 0 (DECADES below, if logarithmic) to the largest value; to the 99th percentile where a few spikes
    would darken all else. Masked values do not count."""
    values = np.ma.compressed(values)
    low, high = ends or automatic(values, look.log)
    norm = LogNorm(low, high, clip=True) if look.log else Normalize(low, high)
    below, above = (len(values) and values.min() < low and low > 0), (len(values) and values.max() > high)
    cut = "both" if below and above else "min" if below else "max" if above else "neither"
    return Scale(colour_map(look.colours), norm, cut)


def automatic(values, log):
    """The ends of a scale for these values."""
    if len(values) == 0:
        return (0.1**DECADES, 1.0) if log else (0.0, 1.0)
    high, usual = float(np.max(values)), float(np.percentile(values, 99))
    top = round_up(high if high <= 1.5 * usual or usual <= 0 else usual)
    return (top / 10**DECADES if log else 0.0), top


def round_up(value):
    if value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next((step * power for step in ROUND if step * power >= value * (1 - 1e-9)), 10 * power)


CUT = {"neither": "", "min": " (arrow: below the scale)", "max": " (arrow: above the scale)", "both": " (arrows: beyond the scale)"}


def colour_bar(axes: Any, scale: Scale, label: str) -> None:
    """The legend, as high as the picture, with an arrow where values are cut off."""
    beside = axes.inset_axes([1.03, 0, 0.04, 1])
    mappable = ScalarMappable(norm=scale.norm, cmap=scale.colours)
    bar = axes.figure.colorbar(mappable, cax=beside, extend=scale.cut, extendfrac=0.04)
    bar.set_label(label + CUT[scale.cut])
    bar.outline.set_linewidth(0.5)
