#!/usr/bin/python3
"""What is wrong with the fields of a result as VTK reads them, a line each: paraview.py RESULT_FOLDER N_INSTANTS"""

import csv
import json
import math
import sys
import xml.etree.ElementTree as xml

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

SECTORS = 96
SECTION = {"displacement (m)": 3, "stress (Pa)": 9, "pressure (Pa)": 1, "von Mises stress (Pa)": 1}
SURFACE = {
    "displacement (m)": 3,
    "traction (Pa)": 3,
    "contact pressure (Pa)": 1,
    "shear traction (Pa)": 1,
    "zone (0 open, 1 sticks, 2 slips forward, 3 backward)": 1,
}
folder, n_instants = sys.argv[1], int(sys.argv[2])
problems = []


def expect(true, what):
    if not true:
        problems.append(what)


def expect_near(value, wanted, tolerance, what):
    expect(abs(value - wanted) <= tolerance, f"{what}: {value:.6g}, expected {wanted:.6g} +- {tolerance:.2g}")


def series_of(name):
    steps = [(float(e.get("timestep")), e.get("file")) for e in xml.parse(f"{folder}/{name}.pvd").iter("DataSet")]
    expect(len(steps) == n_instants, f"{name}.pvd has {len(steps)} steps, expected {n_instants}")
    expect(all(a[0] < b[0] for a, b in zip(steps, steps[1:])), f"{name}.pvd: times do not increase")
    return steps


def read(file, wanted):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(f"{folder}/{file}")
    reader.Update()
    data = reader.GetOutput().GetPointData()
    arrays = {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}
    sizes = {name: array.GetNumberOfComponents() for name, array in arrays.items()}
    expect(sizes == wanted, f"{file}: fields {sizes}, expected {wanted}")
    return reader, {name: vtk_to_numpy(array) for name, array in arrays.items()}


def forces_on(file, row):
    """Integrals over the flat pieces of the revolved surface, whose area is sin(w)/w of that of the rings."""
    reader, fields = read(file, SURFACE)
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    w = 2 * math.pi / SECTORS
    area = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Area")) * w / math.sin(w)
    of_cells = lambda name: fields[name].reshape(len(area), 4, -1)[:, 0]
    force = (area[:, None] * of_cells("traction (Pa)")).sum(0)
    # A plain sum over rings and a reading of the edge: they differ to second order in the size of the rings.
    f_n, f_x = float(row["F_N [N]"]), float(row["F_x [N]"])
    expect_near(force[2], f_n, 3e-3 * f_n, f"{file}: normal force")
    expect_near(force[0], f_x, 3e-3 * f_n, f"{file}: tangential force")
    expect_near(force[1], 0, 1e-6 * f_n, f"{file}: force across")
    pressed = (area * of_cells("contact pressure (Pa)")[:, 0]).sum()
    expect_near(pressed, force[2], 1e-6 * f_n, f"{file}: integral of the pressure")
    dragged = (area * of_cells("shear traction (Pa)")[:, 0]).sum()
    expect_near(dragged, force[0], 1e-6 * f_n, f"{file}: integral of the shear")
    zone, p = fields["zone (0 open, 1 sticks, 2 slips forward, 3 backward)"], fields["contact pressure (Pa)"]
    expect(((zone == 0) == (p == 0)).all(), f"{file}: zones are not open where nothing presses")
    tau = fields["shear traction (Pa)"]
    expect((tau[zone == 2] > 0).all() and (tau[zone == 3] < 0).all(), f"{file}: slip against the traction")
    return force


def check_section(file, row):
    reader, fields = read(file, SECTION)
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
    stress, pressure, u = fields["stress (Pa)"], fields["pressure (Pa)"], fields["displacement (m)"]
    largest = abs(stress).max()
    trace = stress[:, 0] + stress[:, 4] + stress[:, 8]
    expect_near(abs(trace + 3 * pressure).max(), 0, 1e-5 * largest, f"{file}: trace of the stress + 3 p")
    deviator = stress.reshape(-1, 3, 3) + pressure[:, None, None] * numpy.eye(3)
    mises = numpy.sqrt(1.5 * (deviator**2).sum((1, 2)))
    expect_near(abs(mises - fields["von Mises stress (Pa)"]).max(), 0, 1e-5 * largest, f"{file}: von Mises stress")
    expect(points[:, 2].min() == 0 and abs(points[:, 1]).max() == 0, f"{file}: not the half-plane z >= 0 of y = 0")
    centre = numpy.argmin(abs(points[:, 0]) + points[:, 2])
    # The centre sticks and lies on the indenter, but for the mean of the ring around it.
    expect_near(u[centre, 2], float(row["d [m]"]), 2e-3 * float(row["d [m]"]), f"{file}: depth of the centre")
    expect_near(u[centre, 0], float(row["u_x [m]"]), 2e-3 * float(row["d [m]"]), f"{file}: centre along x")
    return stress[centre]


rows = list(csv.DictReader(open(f"{folder}/history.csv")))
times = numpy.array([float(row["t [s]"]) for row in rows])
forces = []
surfaces, sections = series_of("surface"), series_of("fields")
expect([t for t, _ in surfaces] == [t for t, _ in sections], "the two series have other times")
for (time, surface), (_, section) in zip(surfaces, sections):
    row = rows[numpy.argmin(abs(times - time))]
    expect_near(time, float(row["t [s]"]), 1e-6 * times[-1], f"{surface}: time")
    forces.append(forces_on(surface, row))
    check_section(section, row)
fe = json.load(open(f"{folder}/result.json"))["fe"]
largest = max(force[2] for force in forces)
expect_near(largest, fe["normal_force_max"], 1e-2 * largest, "largest normal force of the instants")
largest = max(abs(force[0]) for force in forces)
expect_near(largest, fe["tangential_force_max"], 3e-2 * largest, "largest tangential force of the instants")
print("\n".join(problems))
sys.exit(bool(problems))
