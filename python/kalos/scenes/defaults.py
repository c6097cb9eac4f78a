# SPDX-License-Identifier: BSD-3-Clause
"""Defaults of the arrays of surfaces and luminaires."""
from kalos.core import arrays

DISTRIBUTIONS = {"isotropic": 0, "lambertian": 1}  # the array Distribution; 2 and more are candela tables
MATERIAL = {arrays.EXITANCE: 0.0, arrays.SPECULAR: 0.0, arrays.ROUGHNESS: 1.0, arrays.MIRROR: 0.0,
            arrays.TRANSMITTANCE: 0.0, arrays.REFRACTIVE_INDEX: 1.52}
LAMP = {arrays.DIRECTION: (0.0, 0.0, -1.0), arrays.UP: (0.0, 1.0, 0.0), arrays.DISTRIBUTION: DISTRIBUTIONS["lambertian"],
        arrays.SIDE_U: (0.0, 0.0, 0.0), arrays.SIDE_V: (0.0, 0.0, 0.0)}
