# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands have in common, and the estimate they ask for."""
from kalos.core.limits import COUNT, SEED, THREADS, length
from kalos.core.options import DEFAULT_METHOD, METHODS, Options
from kalos.errors import KalosError


def add_method_options(command, method):
    """What a single estimate depends on; `method` is the default."""
    defaults = Options()
    add = command.add_argument
    add("--method", choices=METHODS, default=method, metavar="METHOD",
        help=f"one of {', '.join(METHODS)} ({method or f'{DEFAULT_METHOD}; sphere-published with --table1'})")
    add("--trajectories", metavar="N", type=COUNT,
        help="at most so many trajectories (10000; no limit with --error or --time)")
    add("--delta", metavar="M", type=length,
        help="distance below which the methods with a neighbourhood alter the kernel, m (auto: from the vertices' density)")
    add("--epsilon", metavar="M", type=length, help="radius of the neighbourhood, m (auto: likewise)")
    add("--photons", metavar="K", type=COUNT, help="photon-map: count the nearest K photons (off: those within a radius)")
    add("--cone-filter", action="store_true", help="photon-map: photons count less the farther they are")
    add("--final-gather", action="store_true", help="photon-map: read the map where rays from the receivers end")
    add("--seed", metavar="K", type=SEED, default=defaults.seed, help="seed of the random numbers (%(default)s)")
    add("--threads", metavar="T", type=THREADS, default=defaults.threads, help="threads, 0 for all (%(default)s)")


def options_of(arguments):
    given = {name: getattr(arguments, name, None) for name in Options.__dataclass_fields__}
    options = Options(**{name: value for name, value in given.items() if value is not None})
    wrong = options.for_another_method()
    if wrong:
        name, methods = wrong
        raise KalosError(f"--{name.replace('_', '-')}: has no effect on {options.method}, expected --method {' or '.join(methods)}")
    return options
