#!/usr/bin/python3
"""Reads frames with VTK's own reader and compares them with what they should hold.

usage: read_with_vtk.py                  reads a frame of its own, right and wrong (what CTest runs)
       read_with_vtk.py FRAME.vtu [EXPECTED.json | EXPECTED.csv]
       read_with_vtk.py FRAMES.pvd

A frame is compared with the file beside it (same stem, .json or .csv) unless another is named. Every frame must hold one
vertex for each point, finite or not, and the time of the frame. A list of frames is checked for rising times, for files
that exist, and for frames whose own time is the one in the list; a frame is also compared where it has an expectation
beside it.

EXPECTED.json  {"points": 2, "time": 0.5,
                "arrays": {"velocity": {"components": 3, "min": [0, -1, 0], "max": [2, 0, 0]}}}
               "Points" stands for the positions. Exact: the files hold doubles.
EXPECTED.csv   header `position_0,position_1,velocity_0,...`, a row for each point: the components that are given.

Exit: 0 all as expected, 1 a difference, 2 usage, 7 a file cannot be read, 77 VTK is not installed (Debian:
python3-vtk9).
"""
import csv
import json
import pathlib
import sys
import tempfile
import xml.etree.ElementTree

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkCommonDataModel import VTK_VERTEX
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    print("VTK is not installed", file=sys.stderr)
    sys.exit(77)


class Difference(Exception):
    pass


def require(condition, message):
    if not condition:
        raise Difference(message)


def read(path):
    """The grid in a frame; VTK's complaints are errors here."""
    complaints = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(complaints)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    require(reader.CanReadFile(str(path)) == 1, "VTK does not take the file for one of its own")
    reader.Update()
    require(not complaints.GetOutput(), f"VTK says: {complaints.GetOutput()}")
    return reader.GetOutput()


def arrays_of(grid):
    """All arrays by name, the positions as "Points" and "position"; each with one row a point."""
    points = vtk_to_numpy(grid.GetPoints().GetData()) if grid.GetNumberOfPoints() else None
    arrays = {}
    for k in range(grid.GetPointData().GetNumberOfArrays()):
        array = grid.GetPointData().GetArray(k)
        require(array.GetNumberOfTuples() == grid.GetNumberOfPoints(), f"{array.GetName()}: not a row for each point")
        if points is not None:
            arrays[array.GetName()] = vtk_to_numpy(array).reshape(len(points), -1)
    if points is not None:
        arrays["Points"] = arrays["position"] = points
    return arrays


def check_structure(grid):
    count = grid.GetNumberOfPoints()
    require(grid.GetNumberOfCells() == count, "not one cell for each point")
    for k in range(count):
        require(grid.GetCellType(k) == VTK_VERTEX, f"cell {k} is no vertex")
        require(grid.GetCell(k).GetPointId(0) == k, f"cell {k} is not at point {k}")
    time = grid.GetFieldData().GetArray("TimeValue")
    require(time is not None and time.GetNumberOfTuples() == 1, "there is no TimeValue")
    return time.GetValue(0)


def check_json(grid, time, expected):
    require(grid.GetNumberOfPoints() == expected["points"],
            f"{grid.GetNumberOfPoints()} points, expected {expected['points']}")
    require(time == expected.get("time", time), f"time {time}, expected {expected.get('time')}")
    arrays = arrays_of(grid)
    for name, wanted in expected.get("arrays", {}).items():
        require(name in arrays, f"there is no array '{name}', only {sorted(arrays)}")
        found = arrays[name]
        components = wanted.get("components", found.shape[1])
        require(found.shape[1] == components, f"{name}: {found.shape[1]} components, expected {components}")
        for what, values in (("min", found.min(axis=0)), ("max", found.max(axis=0))):
            require(list(values) == wanted.get(what, list(values)),
                    f"{name}: {what} {list(values)}, expected {wanted.get(what)}")


def check_csv(grid, path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    require(grid.GetNumberOfPoints() == len(rows), f"{grid.GetNumberOfPoints()} points, expected {len(rows)}")
    arrays = arrays_of(grid)
    for number, row in enumerate(rows):
        for title, text in row.items():
            name, component = title.rsplit("_", 1)
            require(name in arrays, f"there is no array '{name}'")
            found, wanted = arrays[name][number][int(component)], float(text)
            require(found == wanted or (found != found and wanted != wanted),
                    f"{title} of point {number}: {found}, expected {wanted}")


def expectation_of(path):
    return next((p for p in (path.with_suffix(".json"), path.with_suffix(".csv")) if p.exists()), None)


def check_frame(path, expected):
    grid = read(path)
    time = check_structure(grid)
    if expected is not None and expected.suffix == ".json":
        check_json(grid, time, json.loads(expected.read_text(encoding="utf-8")))
    elif expected is not None:
        check_csv(grid, expected)
    arrays = grid.GetPointData().GetNumberOfArrays()
    print(f"{path}: {grid.GetNumberOfPoints()} points, {arrays} arrays, t = {time} s"
          + ("" if expected is None else f", as in {expected.name}"))
    return time


def check_list(path):
    entries = xml.etree.ElementTree.parse(path).getroot().findall("./Collection/DataSet")
    require(entries, "the list is empty")
    times = [float(entry.get("timestep")) for entry in entries]
    require(all(a < b for a, b in zip(times, times[1:])), "the times do not rise")
    for time, entry in zip(times, entries):
        frame = path.parent / entry.get("file")
        require(frame.exists(), f"{frame} is in the list, but not there")
        own = check_frame(frame, expectation_of(frame))
        require(own == time, f"{frame}: its own time is {own}, in the list it is {time}")


OWN = """<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
<FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">0.5</DataArray></FieldData>
<Piece NumberOfPoints="1" NumberOfCells="1">
<PointData><DataArray type="Float64" Name="mass" format="ascii">2</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 1 0</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">1</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">1</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>"""


def judge_itself():
    """A right frame is taken; one expected otherwise, and one that is cut off, are not."""
    with tempfile.TemporaryDirectory() as folder:
        frame, expected = pathlib.Path(folder, "own.vtu"), pathlib.Path(folder, "own.json")
        frame.write_text(OWN, encoding="utf-8")
        codes = []
        for mass in (2, 3):
            expected.write_text(json.dumps({"points": 1, "time": 0.5, "arrays": {"mass": {"min": [mass]}}}))
            codes.append(main([str(frame)]))
        frame.write_text(OWN[:400], encoding="utf-8")
        codes.append(main([str(frame)]))
    return 0 if codes == [0, 1, 1] else 1


def main(arguments):
    path = pathlib.Path(arguments[0]) if arguments else None
    if path is None or len(arguments) > 2 or path.suffix not in (".vtu", ".pvd"):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        if path.suffix == ".pvd":
            check_list(path)
        else:
            expected = pathlib.Path(arguments[1]) if len(arguments) == 2 else expectation_of(path)
            require(expected is not None, "there is nothing to compare the frame with")
            check_frame(path, expected)
    except Difference as difference:
        print(f"{path}: {difference}", file=sys.stderr)
        return 1
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        print(error, file=sys.stderr)
        return 7
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) if len(sys.argv) > 1 else judge_itself())
