# SPDX-License-Identifier: BSD-3-Clause
"""Names of the data arrays, as in vtkKalosArrayNames.h, where their units stand. A test compares the two."""

REFLECTANCE = "Reflectance"
EXITANCE = "Exitance"
SPECULAR = "Specular"
ROUGHNESS = "Roughness"
MIRROR = "Mirror"
SURFACE_ID = "SurfaceId"
SURFACE_NAMES = "SurfaceNames"

LUMINOUS_FLUX = "LuminousFlux"
DIRECTION = "Direction"
DISTRIBUTION = "Distribution"
SIDE_U = "SideU"
SIDE_V = "SideV"

ILLUMINANCE = "Illuminance"
ILLUMINANCE_STANDARD_ERROR = "IlluminanceStandardError"
DIRECT_ILLUMINANCE = "DirectIlluminance"
INTERVAL_TRUSTED = "IntervalTrusted"
ILLUMINANCE_BANDS = "IlluminanceBands"

LUMINANCE = "Luminance"
LUMINANCE_STANDARD_ERROR = "LuminanceStandardError"
LUMINANCE_BANDS = "LuminanceBands"

PHOTOMETRY_WARNINGS = "PhotometryWarnings"
INTENSITY = "Intensity"

AUDIT = "Audit"
TRAJECTORIES = "Trajectories"
RAYS = "Rays"
SOLVE_SECONDS = "SolveSeconds"
SOLVE_CPU_SECONDS = "SolveCpuSeconds"
