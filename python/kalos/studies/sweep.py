# SPDX-License-Identifier: BSD-3-Clause
"""Which settings a study solves, and how their pictures are laid out: rows of panels."""
import itertools
from dataclasses import dataclass, replace

from kalos.core.options import OWN_OPTIONS, REFERENCE_METHOD, Options
from kalos.errors import KalosError

MOST = 400  # combinations: a guard against typing errors
SYMBOLS = {"trajectories": "N", "delta": "δ", "epsilon": "ε"}

# Methods that an option has no effect on.
NO_EFFECT = {"delta": ("local", "compensated", "gathered", "disc", "direct", "paths", "photon-map"),
             "epsilon": ("local", "compensated", "gathered", "paths")}

# V. P. Budak, A. V. Grimailo, V. S. Zheltov, S. A. Yakushev: GraphiCon 2023, Table 1. A cross, not every combination.
TABLE1 = [("trajectories", (10000, 1000, 100), {"delta": 0.25, "epsilon": 0.15}),
          ("epsilon", (0.05, 0.10, 0.15), {"trajectories": 10000, "delta": 0.25}),
          ("delta", (0.01, 0.05, 0.10, 0.25), {"trajectories": 10000, "epsilon": 0.15})]


@dataclass(frozen=True)
class Panel:
    label: str
    options: Options


@dataclass(frozen=True)
class Row:
    title: str
    panels: tuple


def label(name, value):
    """A setting in a few characters: `δ = 0.25 m`."""
    if name not in SYMBOLS:
        return f"seed {value}" if name == "seed" else str(value)
    if value is None:
        return f"{SYMBOLS[name]} automatic"
    return f"{SYMBOLS[name]} = {value}" if name == "trajectories" else f"{SYMBOLS[name]} = {value:g} m"


def combinations(sweeps, base):
    """Every combination of the sweeps, a list of (name, values): the last one runs along the rows."""
    names = [name for name, _ in sweeps]
    if not sweeps:
        raise KalosError("--sweep: missing, expected NAME=v1,v2,... or --table1")
    for name in names:
        if names.count(name) > 1:
            raise KalosError(f"--sweep: {name} appears twice, expected each name once")
    count = 1
    for _, values in sweeps:
        count *= len(values)
    if count > MOST:
        raise KalosError(f"--sweep: {count} combinations, expected at most {MOST}")
    check_effect(dict(sweeps), base)
    *outer, (name, values) = sweeps
    rows = []
    for chosen in itertools.product(*(options for _, options in outer)):
        fixed = dict(zip(names, chosen))
        panels = tuple(Panel(label(name, value), replace(base, **fixed, **{name: value})) for value in values)
        rows.append(Row(", ".join(label(*item) for item in fixed.items()), panels))
    return with_reference_method(rows)


def check_effect(sweeps, base):
    """Refuses a sweep over an option that has no effect on the method."""
    for method in sweeps.get("method", (base.method,)):
        for name in NO_EFFECT:
            if name in sweeps and method in NO_EFFECT[name]:
                raise KalosError(f"--sweep: {name} has no effect on {method}, expected --method sphere-exact or another "
                                 "with such a neighbourhood")


def table1(sweeps, base):
    """The three series of Table 1; the method and the seed are those of `base`."""
    if sweeps:
        raise KalosError("--table1: given together with --sweep, expected one of them")
    rows = []
    for name, values, fixed in TABLE1:
        panels = tuple(Panel(label(name, value), replace(base, **fixed, **{name: value})) for value in values)
        rows.append(Row(f"{SYMBOLS[name]} varies, {', '.join(label(*item) for item in fixed.items())}", panels))
    return with_reference_method(rows)


def with_reference_method(rows):
    """One more row: compensated, which has no neighbourhood, with the same numbers of trajectories."""
    panels = {}
    for row in rows:
        for panel in row.panels:
            options = replace(panel.options, method=REFERENCE_METHOD, delta=None, epsilon=None, **dict.fromkeys(OWN_OPTIONS))
            panels.setdefault(options.trajectories, options)
    named = [Panel(label("trajectories", n) if n else REFERENCE_METHOD, options) for n, options in panels.items()]
    return rows + [Row(f"{REFERENCE_METHOD}, no neighbourhood", tuple(named))]
