# SPDX-License-Identifier: BSD-3-Clause
"""Preparation of a scene before it is solved: its surfaces repaired, and where estimates turn singular."""
import math
from dataclasses import dataclass, field

from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.preparation.mesh import EDGE_CLASSES, lengths, of_file, table, unrepaired
from kalos.vtk import vtkKalosSingularEdges, vtkKalosSurfaceRepair

# What a repair can do to the light in a scene. Points merged in place and points split are not seen, and no triangle is turned:
# reflection is two-sided, and triangles that emit keep their side.
CHANGES = {"points moved by merging": "points moved", "degenerate triangles dropped": "degenerate triangles dropped",
           "duplicate triangles dropped": "duplicate triangles dropped", "triangles cut to stitch": "triangles cut to stitch"}

PATIENCE = 1  # s, before a bar shows: most scenes take milliseconds


@dataclass(frozen=True)
class Prepared:
    """What an estimator takes instead of the reader's outputs, None for these themselves, and what the audit says."""

    surfaces: object = None  # vtkPolyData, where repair had something to change
    receivers: object = None  # vtkMultiBlockDataSet with EdgeDistance and EdgeAngle
    audit: list = field(default_factory=list)

    def put(self, estimator):
        """Connects a vtkKalosIlluminance or vtkKalosLuminanceImage and returns it."""
        if estimator.IsA("vtkKalosIlluminance"):
            inputs = ((0, self.receivers), (1, self.surfaces))
        else:
            inputs = ((0, self.surfaces),)
        for port, data in inputs:
            if data:
                estimator.SetInputDataObject(port, data)
        return estimator


UNPREPARED = Prepared(audit=[{"subject": "preparation", "choice": "off", "reason": "the surfaces were taken as they are"}])


def prepare_scene(scene, reader):
    """Repairs the surfaces that a scene reader has read and finds their singular edges, judged on both sides."""
    surfaces = reader.GetOutputDataObject(0)
    if surfaces.GetNumberOfCells() == 0:
        return Prepared()
    repair = vtkKalosSurfaceRepair()
    repair.SetInputData(surfaces)
    repair.KeepSidesOn()
    repaired = of_file(scene, repair, "repair", PATIENCE)
    done = table(repair.GetReport())
    edges = vtkKalosSingularEdges()
    edges.SetInputData(0, repaired)
    edges.SetInputData(1, reader.GetReceivers())
    edges.BothSidesOn()
    curves = of_file(scene, edges, "singular edges", PATIENCE)
    receivers = edges.GetOutputDataObject(1)
    changed = any(done[key] for key in CHANGES)
    return Prepared(repaired if changed else None, receivers,
                    [*repair_lines(done, unrepaired(repaired), surfaces),
                     *edge_lines(curves, table(edges.GetReport()), done, nearest(receivers))])


def line(subject, choice, reason):
    return {"subject": subject, "choice": choice, "reason": reason}


def repair_lines(done, left, surfaces):
    changes = [f"{done[key]} {text}" for key, text in CHANGES.items() if done[key]]
    if changes:
        yield line("repair", ", ".join(changes),
                   f"points nearer than {done['tolerance, m']:.2g} m are one; area {done['area before, m²']:.6g} m² before, "
                   f"{done['area after, m²']:.6g} m² after")
    else:
        yield line("repair", "nothing to do", f"the {done['triangles before']} triangles are sound")
    if left:
        first = left[0]
        ids = surfaces.GetCellData().GetArray(arrays.SURFACE_ID)
        names = surfaces.GetFieldData().GetAbstractArray(arrays.SURFACE_NAMES)
        yield line("not repaired", f"{len(left)} cells",
                   f"the first is of surface {names.GetValue(int(ids.GetTuple1(first['cell'])))}: {first['reason']}")


def edge_lines(curves, counts, done, distance):
    found = {name: lengths(curves, getattr(vtkKalosSingularEdges, value)) for name, value in EDGE_CLASSES.items()}
    singular = any(entry["curves"] for entry in found.values())
    yield line("singular edges",
               ", ".join(f"{entry['curves']} {name} ({entry['length_m']:.4g} m)" for name, entry in found.items()),
               "the kernel has no bound there; both sides of a surface count" if singular
               else "no two surfaces meet at an angle that the kernel has no bound at")
    yield line("other edges", f"{counts['border edges']} border, {counts['convex edges']} convex, {counts['coplanar edges']} flat",
               "surfaces end at borders" if done["border edges after"] else "the surfaces are closed")
    if math.isfinite(distance):
        yield line("receivers", f"{distance:.3g} m from a singular edge or more", "the array EdgeDistance holds it for each")


def nearest(receivers):
    """The smallest distance of any receiver from a singular edge, m; infinite without."""
    smallest = math.inf
    for i in range(receivers.GetNumberOfBlocks()):
        block = receivers.GetBlock(i)
        for data in (block.GetPointData(), block.GetCellData()):
            found = data.GetArray(vtkKalosSingularEdges.EdgeDistanceArrayName())
            if found and found.GetNumberOfTuples():
                smallest = min(smallest, float(vtk_to_numpy(found).min()))
    return smallest
