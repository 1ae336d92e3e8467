"""Opens an export of `trilith export --to vtk` like ParaView, and renders its last frame.

usage: pvpython --force-offscreen-rendering render.py FOLDER NAME
It reads the series FOLDER/NAME_bodies.pvd, NAME_contacts.pvd and NAME_bearings.pvd, and writes FOLDER/NAME.png.
"""
import sys

from paraview import servermanager, simple


def check(holds, what):
    if not holds:
        sys.exit(f"render.py: {what}")


def opened(path, arrays):
    """A series with its times and the requested arrays, at its last time."""
    reader = simple.PVDReader(FileName=path)
    times = list(reader.TimestepValues)
    check(len(times) > 1 and times == sorted(times), f"{path}: times {times}")
    reader.UpdatePipeline(times[-1])
    there = list(reader.PointData.keys()) + list(reader.CellData.keys())
    for array in arrays:
        check(array in there, f"{path}: no array '{array}' among {there}")
    return reader, times


def colours_in(picture):
    """How many colours a picture has."""
    data = servermanager.Fetch(simple.PNGSeriesReader(FileNames=[picture]))
    pixels = data.GetPointData().GetScalars()
    return len({pixels.GetTuple(i) for i in range(0, pixels.GetNumberOfTuples(), 7)})


def main(folder, name):
    bodies, times = opened(f"{folder}/{name}_bodies.pvd", ["displacement", "mass", "name"])
    first = simple.PVDReader(FileName=f"{folder}/{name}_bodies.pvd")
    first.UpdatePipeline(times[0])
    before, after = first.GetDataInformation(), bodies.GetDataInformation()
    check(before.GetNumberOfCells() == after.GetNumberOfCells() > 1, "bodies come or go")
    check(before.GetBounds() != after.GetBounds(), "nothing has moved from the first frame to the last")
    contacts, _ = opened(f"{folder}/{name}_contacts.pvd", ["force", "normal", "area"])
    check(contacts.GetDataInformation().GetNumberOfPoints() > 0, "nothing touches at the end")

    view = simple.CreateView("RenderView")
    view.ViewSize = [320, 240]
    shown = simple.Show(bodies, view)
    simple.ColorBy(shown, ("POINTS", "displacement"))
    shown.RescaleTransferFunctionToDataRange()
    view.ViewTime = times[-1]
    simple.ResetCamera(view)
    simple.Render(view)
    picture = f"{folder}/{name}.png"
    simple.SaveScreenshot(picture, view)
    colours = colours_in(picture)
    check(colours > 10, f"{picture} has {colours} colours: nothing is drawn")
    print(f"{after.GetNumberOfCells()} bodies at {times[-1]:g} s, {colours} colours")


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(sys.argv[1], sys.argv[2])
