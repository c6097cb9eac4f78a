# SPDX-License-Identifier: BSD-3-Clause
"""From a scene file to a folder of results."""
