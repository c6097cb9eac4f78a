# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: built from arrays, read from files, joined, checked."""
