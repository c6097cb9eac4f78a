# SPDX-License-Identifier: BSD-3-Clause
"""Skies: daylight for kalos.illuminance() and kalos.luminance(), and where the sun stands."""
from __future__ import annotations

import datetime
import warnings
from typing import Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.core.sharing import shared
from kalos.errors import InputError, update
from kalos.scenes.checks import numbers, within
from kalos.vtk import vtkKalosSkySource

NEEDING_SUN = (2, 4, *range(6, 16))  # types of the CIE whose luminance depends on where the sun is


def sky(cie: Optional[int] = None, *, horizontal_illuminance: Optional[float] = None, zenith_luminance: Optional[float] = None,
        sun: Optional[Tuple[float, float]] = None, sun_illuminance: Optional[float] = None,
        irradiance: Optional[Tuple[float, float]] = None, luminance_map: Optional[ArrayLike] = None,
        ground_reflectance: float = 0.0, north_deg: float = 0.0) -> vtkPolyData:
    """A sky, to be given as a luminaire or in the list of them.

    cie: type of CIE S 011, 1 to 16; or irradiance: (direct normal, diffuse horizontal), W/m2, of Perez's all-weather sky; or
    luminance_map: (rows, columns) cd/m2, latitude-longitude from the zenith down, north in the middle and east to the right.
    horizontal_illuminance: lx, without the sun, or zenith_luminance: cd/m2; Perez and a map know their own. sun: (elevation,
    azimuth clockwise from north), degrees. sun_illuminance: lx across its rays. north_deg: north is +y turned clockwise by it.

    >>> overcast = sky(1, horizontal_illuminance=10000, ground_reflectance=0.2)
    """
    if (cie is not None) + (irradiance is not None) + (luminance_map is not None) != 1:
        raise InputError("sky: one of cie, irradiance and luminance_map is expected")
    if horizontal_illuminance is not None and zenith_luminance is not None:
        raise InputError("sky: both horizontal_illuminance and zenith_luminance are given, expected one of them")
    if sun is None and (irradiance is not None or cie in NEEDING_SUN):
        raise InputError("sun: is missing, expected (elevation, azimuth) in degrees: this sky is brightest about it")
    source = vtkKalosSkySource()
    source.SetHorizontalIlluminance(-1.0 if horizontal_illuminance is None else horizontal_illuminance)
    source.SetZenithLuminance(-1.0 if zenith_luminance is None else zenith_luminance)
    if sun is not None:
        source.SetSunElevationDegrees(sun[0])
        source.SetSunAzimuthDegrees(sun[1])
    source.SetSunNormalIlluminance((0.0 if irradiance is None else -1.0) if sun_illuminance is None else sun_illuminance)
    source.SetGroundReflectance(ground_reflectance)
    source.SetNorthDegrees(north_deg)
    if cie is not None:
        source.SetModel(cie if cie > 0 else 99)  # 0 and -1 mean others
    elif irradiance is not None:
        source.SetModel(vtkKalosSkySource.PEREZ)
        source.SetDirectNormalIrradiance(irradiance[0])
        source.SetDiffuseHorizontalIrradiance(irradiance[1])
    else:
        rows = within("luminance_map", numbers("luminance_map", luminance_map, [("rows", "columns")]), 0, np.inf, "cd/m2 >= 0")
        source.SetModel(vtkKalosSkySource.MAP)
        source.SetMap(shared(np.ascontiguousarray(rows, np.float32), "SkyMap"))
    update(source)
    return source.GetOutput()


def sun_position(when: datetime.datetime, latitude: float, longitude: float) -> Tuple[float, float]:
    """Elevation and azimuth of the sun's middle, degrees, azimuth clockwise from north; without refraction.

    when: a date and time with its time zone. latitude: degrees north, longitude: degrees east. Needs astropy (Debian's
    python3-astropy); raises InputError without it. The elevation is below 0 at night.
    """
    elevation, azimuth = sun_positions(when, 1, latitude, longitude)
    return float(elevation[0]), float(azimuth[0])


def sun_positions(first: datetime.datetime, hours: int, latitude: float, longitude: float) -> Tuple[np.ndarray, np.ndarray]:
    """The same of so many hours from the first on, as arrays."""
    if first.tzinfo is None:
        raise InputError("when: has no time zone, expected one, such as datetime.timezone.utc")
    for name, value, most in (("latitude", latitude, 90), ("longitude", longitude, 180)):
        if not -most <= value <= most:
            raise InputError(f"{name}: is {value}, expected degrees from {-most} to {most}")
    try:
        from astropy import units
        from astropy.coordinates import AltAz, EarthLocation, get_sun
        from astropy.time import Time, TimeDelta
        from astropy.utils import iers
    except ImportError:
        raise InputError("sun_position: astropy is not installed, expected Debian's python3-astropy or PyPI's astropy") from None
    with iers.conf.set_temp("auto_download", False), iers.conf.set_temp("iers_degraded_accuracy", "ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # tables of leap seconds that are some months old do for sunlight
        time = Time(first.astimezone(datetime.timezone.utc).replace(tzinfo=None)) + TimeDelta(np.arange(hours) * units.hour)
        place = EarthLocation.from_geodetic(longitude, latitude)
        found = get_sun(time).transform_to(AltAz(obstime=time, location=place))
        return found.alt.deg, found.az.deg
