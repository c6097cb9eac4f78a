# SPDX-License-Identifier: BSD-3-Clause
"""Closed forms and the methods compared with them: `kalos validate`."""
