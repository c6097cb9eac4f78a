# SPDX-License-Identifier: BSD-3-Clause
"""What all packages share: array names, options and their limits, output folders, progress."""
