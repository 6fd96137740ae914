#!/usr/bin/python3
"""A picture of the fields of a case, with VTK: the section coloured by the von Mises stress, the surface behind it by
the shear traction with the tractions as arrows, both as they are displaced, five times as far.

    fretval run CASE -o results                            # with Output / Fields = cycle in the case
    xvfb-run -a docs/example/fields.py results/NAME PICTURE.png [STEP [WIDTH]]

Needs the Debian packages python3-vtk9, xvfb and xauth; without xvfb-run where there is a screen.
"""

import sys
import xml.etree.ElementTree as xml

import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (both register what vtkRenderingCore draws with)
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkCleanPolyData, vtkGlyph3D, vtkPointDataToCellData
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkTransformPolyDataFilter, vtkWarpVector
from vtkmodules.vtkFiltersSources import vtkArrowSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkDataSetMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

MAGNIFIED = 5
BLUE, WHITE, RED = (0.13, 0.4, 0.67), (0.95, 0.95, 0.95), (0.7, 0.09, 0.17)
DARK, BRIGHT = (0.15, 0.1, 0.3), (0.99, 0.9, 0.4)


def made(kind, **settings):
    """An object of VTK with its settings, which its constructor takes from version 9.4 on alone."""
    thing = kind()
    for name, value in settings.items():
        getattr(thing, "Set" + name)(value)
    return thing


def grid_of(folder, series, step):
    files = [entry.get("file") for entry in xml.parse(f"{folder}/{series}.pvd").iter("DataSet")]
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(f"{folder}/{files[step]}")
    reader.Update()
    return reader.GetOutput()


def clipped(grid, origin, normal):
    """What lies on the side of a plane that its normal points to."""
    plane = made(vtkPlane, Origin=origin, Normal=normal)
    clip = made(vtkClipDataSet, ClipFunction=plane)
    clip.SetInputData(grid)
    clip.Update()
    return clip.GetOutput()


def warped(grid):
    grid.GetPointData().SetActiveVectors("displacement (m)")
    warp = made(vtkWarpVector, ScaleFactor=MAGNIFIED)
    warp.SetInputData(grid)
    warp.Update()
    return warp.GetOutput()


def actor_of(grid, field, colours):
    mapper = vtkDataSetMapper()
    mapper.SetInputData(grid)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(colours)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def colours_between(low, high, *shades):
    colours = vtkColorTransferFunction()
    for i, shade in enumerate(shades):
        colours.AddRGBPoint(low + (high - low) * i / (len(shades) - 1), *shade)
    return colours


def arrows_of(surface, length):
    """Tractions, their tips on the surface."""
    surface.GetPointData().SetActiveVectors("traction (Pa)")
    cells = vtkPointDataToCellData()
    cells.SetInputData(surface)
    centres = made(vtkCellCenters, VertexCells=True)
    centres.SetInputConnection(cells.GetOutputPort())
    some = made(vtkCleanPolyData, Tolerance=0.07)  # one of those that are next to each other
    some.SetInputConnection(centres.GetOutputPort())
    arrow = made(vtkArrowSource, ShaftRadius=0.02, TipRadius=0.06, TipLength=0.2)
    back = vtkTransform()
    back.Translate(-1, 0, 0)
    turned = made(vtkTransformPolyDataFilter, Transform=back)
    turned.SetInputConnection(arrow.GetOutputPort())
    largest = surface.GetPointData().GetArray("traction (Pa)").GetMaxNorm()
    glyphs = made(vtkGlyph3D, ScaleFactor=length / largest if largest > 0 else 0)
    glyphs.SetInputConnection(some.GetOutputPort())
    glyphs.SetSourceConnection(turned.GetOutputPort())
    glyphs.SetInputArrayToProcess(1, 0, 0, 0, "traction (Pa)")
    glyphs.SetVectorModeToUseVector()
    glyphs.SetScaleModeToScaleByVector()
    glyphs.Update()
    mapper = made(vtkDataSetMapper, ScalarVisibility=False)
    mapper.SetInputData(glyphs.GetOutput())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.2, 0.2, 0.2)
    return actor


def legend_of(field, colours, left):
    bar = made(vtkScalarBarActor, LookupTable=colours, Title=field, NumberOfLabels=2, UnconstrainedFontSize=True)
    bar.SetLabelFormat("%.2g")
    bar.SetOrientationToHorizontal()
    bar.SetPosition(left, 0.02)
    bar.SetWidth(0.36)
    bar.SetHeight(0.12)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(15)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


def scene_of(folder, step):
    surface, section = grid_of(folder, "surface", step), grid_of(folder, "fields", step)
    radius = surface.GetBounds()[1]
    section = clipped(section, (0, 0, 1.2 * radius), (0, 0, -1))
    for side in (1, -1):
        section = clipped(section, (-side * 1.7 * radius, 0, 0), (side, 0, 0))
    behind = clipped(warped(surface), (0, 0, 0), (0, -1, 0))
    tau = max(abs(end) for end in surface.GetPointData().GetArray("shear traction (Pa)").GetRange())
    stress = colours_between(0, section.GetPointData().GetArray("von Mises stress (Pa)").GetRange()[1], DARK, RED, BRIGHT)
    shear = colours_between(-tau, tau, BLUE, WHITE, RED)
    scene = made(vtkRenderer, Background=(1, 1, 1))
    scene.AddActor(actor_of(warped(section), "von Mises stress (Pa)", stress))
    scene.AddActor(actor_of(behind, "shear traction (Pa)", shear))
    scene.AddActor(arrows_of(behind, 0.5 * radius))
    scene.AddActor(legend_of("von Mises stress (Pa)", stress, 0.08))
    scene.AddActor(legend_of("shear traction (Pa)", shear, 0.56))
    camera = scene.GetActiveCamera()
    camera.SetViewUp(0, 0, -1)
    camera.SetFocalPoint(0, 0, 0.4 * radius)
    camera.SetPosition(0.8 * radius, 5 * radius, -2.4 * radius)
    scene.ResetCameraClippingRange()
    camera.Zoom(1.2)
    return scene


def draw(scene, picture, width):
    window = made(vtkRenderWindow, OffScreenRendering=True, MultiSamples=8)
    window.SetSize(width, width * 5 // 8)
    window.AddRenderer(scene)
    window.Render()
    image = made(vtkWindowToImageFilter, Input=window)
    writer = made(vtkPNGWriter, FileName=picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    step, width = (int(text) for text in (sys.argv[3:] + ["-1", "960"][len(sys.argv) - 3 :]))
    draw(scene_of(sys.argv[1], step), sys.argv[2], width)
