# SPDX-License-Identifier: BSD-3-Clause
"""The HTML page of `kalos solve --report`."""
