# SPDX-License-Identifier: BSD-3-Clause
"""Results as numbers, statistics, tables and text."""
