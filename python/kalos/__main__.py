# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m kalos is the command kalos."""
import sys

from kalos.commands.main import main

sys.exit(main())
