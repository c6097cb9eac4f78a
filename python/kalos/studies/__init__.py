# SPDX-License-Identifier: BSD-3-Clause
"""Many settings on one scene: the sweeps, errors and picture of `kalos study`."""
