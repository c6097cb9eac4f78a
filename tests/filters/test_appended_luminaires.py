# SPDX-License-Identifier: BSD-3-Clause
"""Luminaires keep their candela tables behind any filter that appends, groups or writes them, in any order.

Source of truth: light adds up, and what each luminaire gives by itself is tested in tests/photometry.
"""
import itertools

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendDataSets, vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkMultiBlockDataGroupFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from kalos.vtk import vtkKalosCalculationPlane, vtkKalosIlluminance, vtkKalosLuminaireSource, vtkKalosPhotometryReader


def measured(folder, name, candela, place):
    path = folder / f"{name}.ies"
    path.write_text("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n" + candela + "\n")
    reader = vtkKalosPhotometryReader()
    reader.SetFileName(str(path))
    reader.SetPosition(place)
    reader.SetName(name)
    reader.Update()
    return reader.GetOutputDataObject(3)


def lambertian(place):
    source = vtkKalosLuminaireSource()
    source.SetPosition(place)
    source.SetFlux(1000)
    source.Update()
    return source.GetOutput()


@pytest.fixture
def lamps(tmp_path):
    return [measured(tmp_path, "narrow", "1000 100 0", (1, 1, 3)), measured(tmp_path, "wide", "100 500 200", (3, 1, 3)),
            lambertian((2, 2, 3))]


def direct(luminaires):
    plane = vtkKalosCalculationPlane()
    plane.SetU(4, 0, 0)
    plane.SetV(0, 3, 0)
    plane.SetResolution(4, 3)
    plane.Update()
    estimator = vtkKalosIlluminance()
    estimator.SetInputDataObject(0, plane.GetOutput())
    estimator.SetInputDataObject(1, vtkPolyData())
    estimator.SetInputDataObject(2, luminaires)
    estimator.SetTrajectories(32)
    estimator.Update()
    return vtk_to_numpy(estimator.GetOutputDataObject(0).GetCellData().GetArray("DirectIlluminance"))


def by_poly_data(pieces, folder):
    append = vtkAppendPolyData()
    for piece in pieces:
        append.AddInputData(piece)
    append.Update()
    return append.GetOutput()


def by_data_sets(pieces, folder):
    append = vtkAppendDataSets()
    for piece in pieces:
        append.AddInputData(piece)
    append.SetOutputDataSetType(4)  # an unstructured grid, as the user meets it
    geometry = vtkGeometryFilter()
    geometry.SetInputConnection(append.GetOutputPort())
    geometry.Update()
    return geometry.GetOutput()


def by_blocks(pieces, folder):
    """Grouped into blocks, one in another, and made one again, as ParaView's Merge Blocks does."""
    inner, outer = vtkMultiBlockDataGroupFilter(), vtkMultiBlockDataGroupFilter()
    for piece in pieces[:2]:
        inner.AddInputData(piece)
    outer.AddInputConnection(inner.GetOutputPort())
    outer.AddInputData(pieces[2])
    merged = vtkCompositeDataGeometryFilter()
    merged.SetInputConnection(outer.GetOutputPort())
    merged.Update()
    return merged.GetOutput()


def by_a_list(pieces, folder):
    """kalos.illuminance(surfaces, [lamp, lamps]) joins them so: the first two come appended already."""
    from kalos.scenes.joined import joined_luminaires

    return joined_luminaires([by_poly_data(pieces[:2], folder), pieces[2]])


def by_a_file(pieces, folder):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(by_poly_data(pieces, folder))
    writer.SetFileName(str(folder / "lamps.vtp"))
    writer.Write()
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(folder / "lamps.vtp"))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("append", [by_poly_data, by_data_sets, by_blocks, by_a_file, by_a_list])
@pytest.mark.parametrize("order", itertools.permutations(range(3)))
def test_light_adds_up(lamps, tmp_path, append, order):
    expected = sum(direct(lamp) for lamp in lamps)
    assert (expected > 10).all()
    np.testing.assert_allclose(direct(append([lamps[i] for i in order], tmp_path)), expected, rtol=1e-12)


def test_a_text_that_is_no_table(lamps):
    from helpers import update_error

    broken = vtkPolyData()
    broken.DeepCopy(lamps[0])
    broken.GetPointData().GetAbstractArray("CandelaTables").SetValue(0, "axis 1 2")
    estimator = vtkKalosIlluminance()
    plane = vtkKalosCalculationPlane()
    plane.Update()
    estimator.SetInputDataObject(0, plane.GetOutput())
    estimator.SetInputDataObject(1, vtkPolyData())
    estimator.SetInputDataObject(2, broken)
    assert "CandelaTables of luminaire 0: is no candela table, expected a text of vtkKalosLuminaireSource" in update_error(estimator)
