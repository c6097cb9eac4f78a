# SPDX-License-Identifier: BSD-3-Clause
"""What stands in the field data of a result: numbers, version and seed, and the audit."""
from typing import Any, Dict, List

from kalos.core import arrays


def field_value(output, name):
    """The number in a field data array of a data object."""
    array = output.GetFieldData().GetArray(name)
    return array.GetTuple1(0) if array else None


def provenance(output):
    """Version and seed of what made a data object; None where it does not tell."""
    version, seed = output.GetFieldData().GetAbstractArray(arrays.VERSION), field_value(output, arrays.SEED)
    return version and version.GetValue(0), None if seed is None else int(seed)


def trajectories(output):
    value = field_value(output, arrays.TRAJECTORIES)
    return None if value is None else int(value)


def audit(output: Any, name: str = arrays.AUDIT) -> List[Dict[str, str]]:
    """What the solve chose to model and why, or what the reader of a scene did: a list of {subject, choice, reason}."""
    table = output.GetFieldData().GetAbstractArray(name)
    if table is None:
        return []
    cells = [table.GetValue(i) for i in range(table.GetNumberOfValues())]
    return [dict(zip(("subject", "choice", "reason"), cells[i:i + 3])) for i in range(0, len(cells), 3)]


def warnings_of(entries):
    """What an audit warns of, a line each; in one of several solves a subject has the solve behind it: `warning, camera front`."""
    return [f"{one['choice']}: {one['reason']}" for one in entries if one["subject"].split(", ")[0] == "warning"]
