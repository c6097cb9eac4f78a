# SPDX-License-Identifier: BSD-3-Clause
"""A year of daylight: weather files, skies by the hour, daylight coefficients."""
