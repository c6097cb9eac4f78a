# SPDX-License-Identifier: BSD-3-Clause
"""Error against time: the contenders of `kalos chart`, its measurements and its picture."""
