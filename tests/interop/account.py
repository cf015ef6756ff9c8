# SPDX-License-Identifier: MIT
"""What a mesh file holds, as Leonhard, meshio and VTK see it: the same account from each, so that they can be compared.

An account has: cells {kind: count}, vertices (those that cells use), size (area or volume), regions and markers {number: count},
names {number: name} of both ("r3", "m3"). Facets without a marker and cells without a region do not count.
"""
import contextlib
import io
import json
import subprocess

import numpy

# Corners of simplices that fill a cell, in the order that meshio, VTK and Gmsh have in common.
SIMPLICES = {
    "line": [(0, 1)],
    "triangle": [(0, 1, 2)],
    "quad": [(0, 1, 2), (0, 2, 3)],
    "tetra": [(0, 1, 2, 3)],
    "pyramid": [(0, 1, 2, 4), (0, 2, 3, 4)],
    "wedge": [(0, 1, 2, 3), (1, 2, 3, 4), (2, 3, 4, 5)],
    "hexahedron": [(0, 1, 3, 4), (1, 2, 3, 6), (1, 3, 4, 6), (1, 4, 5, 6), (3, 4, 6, 7)],
}
DIMENSION = {"line": 1, "triangle": 2, "quad": 2, "tetra": 3, "pyramid": 3, "wedge": 3, "hexahedron": 3}
LEONHARD_KINDS = {"triangles": "triangle", "quadrilaterals": "quad", "tetrahedra": "tetra", "pyramids": "pyramid",
                  "prisms": "wedge", "hexahedra": "hexahedron"}
GROUPS = ("gmsh:physical", "medit:ref", "CellEntityIds", "su2:tag")  # else ours: region of cells, marker of facets


def size_of(kind, points, cells):
    """Area or volume of cells whose faces are flat, whatever their orientation."""
    total = 0.0
    for corners in SIMPLICES[kind]:
        p = [points[cells[:, i]] for i in corners]
        if len(corners) == 4:
            parts = numpy.einsum("ij,ij->i", p[1] - p[0], numpy.cross(p[2] - p[0], p[3] - p[0])) / 6
        elif len(corners) == 3:
            parts = numpy.linalg.norm(numpy.cross(p[1] - p[0], p[2] - p[0]), axis=1) / 2
        else:
            parts = numpy.linalg.norm(p[1] - p[0], axis=1)
        total += numpy.abs(parts).sum()
    return float(total)


def add(counts, numbers):
    for number, count in zip(*numpy.unique(numbers, return_counts=True)):
        if number != 0:
            counts[int(number)] = counts.get(int(number), 0) + int(count)


def corners_of(kind):
    return 1 + max(max(simplex) for simplex in SIMPLICES[kind])


def account(points, blocks, names=None):
    """blocks: (kind, cells, group of each or None); kinds of second order by their corners."""
    if points.shape[1] == 2:
        points = numpy.column_stack([points, numpy.zeros(len(points))])
    blocks = [(kind, cells, group) for kind, cells, group in blocks if kind in DIMENSION and len(cells) > 0]
    dimension = max(DIMENSION[kind] for kind, _, _ in blocks)
    result = {"cells": {}, "vertices": 0, "size": 0.0, "regions": {}, "markers": {}, "names": names or {}}
    used = set()
    for kind, cells, group in blocks:
        cells = cells[:, : corners_of(kind)]
        if DIMENSION[kind] == dimension:
            result["cells"][kind] = result["cells"].get(kind, 0) + len(cells)
            result["size"] += size_of(kind, points, cells)
            used.update(cells.ravel().tolist())
            if group is not None:
                add(result["regions"], group)
        elif DIMENSION[kind] == dimension - 1 and group is not None:
            add(result["markers"], group)
    result["vertices"] = len(used)
    return result


def quietly(work, *arguments, **options):
    """What work gives, without what it prints: meshio is talkative."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        return work(*arguments, **options)


def of_meshio(path):
    import meshio

    mesh = quietly(meshio.read, path)
    groups = next((mesh.cell_data[name] for name in GROUPS if name in mesh.cell_data), None)
    top = max(DIMENSION.get(block.type, 0) for block in mesh.cells)
    blocks = []
    for i, block in enumerate(mesh.cells):
        kind = {"triangle6": "triangle", "line3": "line", "tetra10": "tetra"}.get(block.type, block.type)
        own = "region" if DIMENSION.get(kind, 0) == top else "marker"
        arrays = groups if groups is not None else mesh.cell_data.get(own)
        group = None if arrays is None else numpy.asarray(arrays[i]).ravel()
        blocks.append((kind, block.data, group))
    dimension = max(DIMENSION.get(kind, 0) for kind, cells, _ in blocks if len(cells) > 0)
    names = {}
    for name, data in mesh.field_data.items():
        if len(data) == 2 and data[1] in (dimension - 1, dimension):  # Gmsh's: number and dimension
            names[("r%d" if data[1] == dimension else "m%d") % data[0]] = name
    return account(mesh.points, blocks, names)


def vtk_reader(path):
    import vtk

    if str(path).endswith(".vtk"):
        reader = vtk.vtkUnstructuredGridReader()
        reader.ReadAllScalarsOn()
    else:
        reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("VTK cannot read " + str(path)))
    reader.Update()
    if errors:
        raise RuntimeError(errors[0])
    return reader.GetOutput()


def of_vtk(path):
    from vtk.util.numpy_support import vtk_to_numpy

    grid = vtk_reader(path)
    kinds = {3: "line", 5: "triangle", 9: "quad", 10: "tetra", 12: "hexahedron", 13: "wedge", 14: "pyramid"}
    points = vtk_to_numpy(grid.GetPoints().GetData())
    types = vtk_to_numpy(grid.GetCellTypesArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    data = grid.GetCellData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())
              if data.GetArray(i) is not None}
    top = max(DIMENSION[kinds[t]] for t in set(types) if t in kinds)
    blocks = []
    for number, kind in kinds.items():
        rows = numpy.flatnonzero(types == number)
        if len(rows) == 0:
            continue
        cells = numpy.array([corners[offsets[i]: offsets[i] + corners_of(kind)] for i in rows])
        own = "region" if DIMENSION[kind] == top else "marker"
        array = next((arrays[name] for name in GROUPS + (own,) if name in arrays), None)
        blocks.append((kind, cells, None if array is None else array[rows]))
    return account(points, blocks)


def of_leonhard(program, path, options=(), with_unmarked=False):
    """with_unmarked: whether facets that got a marker only in Leonhard count too."""
    run = subprocess.run([program, "check", str(path), "--json", *options], capture_output=True, text=True, timeout=300)
    if run.returncode not in (0, 3):
        raise RuntimeError("leonhard check %s: exit code %d: %s" % (path, run.returncode, run.stderr.strip()))
    report = json.loads(run.stdout)
    if not report["valid"] or not report["euler"]["balances"]:
        raise RuntimeError("leonhard check %s: not sound: %s" % (path, report["invalid"]))
    result = {"cells": {}, "vertices": report["vertices"], "size": report.get("area", report.get("volume")), "regions": {},
              "markers": {}, "names": {}}
    for ours, kind in LEONHARD_KINDS.items():
        if report.get(ours, 0) > 0:
            result["cells"][kind] = report[ours]
    for group in report["regions"]:
        if group["region"] != 0:
            result["regions"][int(group["region"])] = group["cells"]
            result["names"]["r%d" % group["region"]] = group["name"]
    for group in report["boundary"] + report["inner_facets"]:
        if group["marker"] != 0 and (with_unmarked or group["name"] != "unmarked"):
            count = group.get("edges", group.get("faces"))
            result["markers"][group["marker"]] = result["markers"].get(group["marker"], 0) + count
            result["names"]["m%d" % group["marker"]] = group["name"]
    return result


def differences(ours, theirs, leave_out=()):
    """In words; names only where both have one, sizes to 1e-9."""
    words = []
    for key in ("cells", "vertices", "regions", "markers"):
        if key not in leave_out and ours[key] != theirs[key]:
            words.append("%s: %s, not %s" % (key, ours[key], theirs[key]))
    if "size" not in leave_out and abs(ours["size"] - theirs["size"]) > 1e-9 * abs(theirs["size"]):
        words.append("size: %.17g, not %.17g" % (ours["size"], theirs["size"]))
    if "names" not in leave_out:
        for number, name in theirs["names"].items():
            if ours["names"].get(number, name) != name:
                words.append("name of %s: %r, not %r" % (number, ours["names"][number], name))
    return words
