# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance and luminance of scenes in memory: the array interface and its results."""
