# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and scenes repaired before they are solved."""
