# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results: false colour, isolux lines, plans, charts."""
