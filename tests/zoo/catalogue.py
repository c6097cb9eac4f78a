# SPDX-License-Identifier: BSD-3-Clause
"""All rooms of the zoo, each in the file of its kind."""
import edges
import lamps
import many
import mirrors
import neighbours

ROOMS = [room for kind in (lamps, neighbours, edges, mirrors, many) for room in kind.ROOMS]
