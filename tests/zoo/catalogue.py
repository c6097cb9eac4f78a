# SPDX-License-Identifier: BSD-3-Clause
"""All rooms of the zoo, each in the file of its kind."""
import edges
import gloss
import lamps
import many
import mirrors
import neighbours
import odd
import openings

ROOMS = [room for kind in (lamps, neighbours, openings, edges, mirrors, gloss, many, odd) for room in kind.ROOMS]
