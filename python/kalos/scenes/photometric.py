# SPDX-License-Identifier: BSD-3-Clause
"""Bands and their photometric total."""
import numpy as np

BAND_WEIGHTS = {1: np.ones(1), 3: np.array([0.2126, 0.7152, 0.0722])}  # photometric share of a band; else equal


def band_weights(bands):
    """Photometric share of each band."""
    return BAND_WEIGHTS.get(bands, np.full(bands, 1 / bands))


def photometric(values):
    """The total of values with a column per band, or with one value each."""
    return values if values.ndim == 1 else values @ band_weights(values.shape[1])
