# SPDX-License-Identifier: MIT
"""Meshes of other programs read by Leonhard, and Leonhard's by them: called by run.sh.

    interop.py PROGRAM FOLDER TOOL...

PROGRAM is leonhard, FOLDER an empty one for the files, the tools are those that are there: gmsh tetgen meshio vtk metis.
Prints a line a comparison; exit code 1 if one differs.
"""
import json
import pathlib
import subprocess
import sys

import account

PROGRAM, FOLDER, TOOLS = sys.argv[1], pathlib.Path(sys.argv[2]), set(sys.argv[3:])
GEOMETRY = pathlib.Path(__file__).resolve().parent / "geometry"
PLANE, SPACE = ("plane", "quads"), ("ball", "layers")
counts = {"ok": 0, "WRONG": 0}


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, cwd=FOLDER)
    if done.returncode != 0:
        raise RuntimeError("%s: exit code %d: %s" % (" ".join(map(str, words)), done.returncode, (done.stderr or done.stdout)[-400:]))
    return done.stdout


def compare(name, ours, theirs, leave_out=()):
    """ours and theirs are functions that give accounts, so that what they throw is a difference too."""
    try:
        words = account.differences(ours(), theirs(), leave_out)
    except Exception as error:  # whatever another program's reader throws belongs into the list
        words = ["%s: %s" % (type(error).__name__, error)]
    result = "WRONG" if words else "ok"
    counts[result] += 1
    print("%-6s %-58s %s" % (result, name, "; ".join(words)), flush=True)


def attempt(name, work):
    compare(name, lambda: (work(), NOTHING)[1], lambda: NOTHING)


NOTHING = {"cells": {}, "vertices": 0, "size": 0.0, "regions": {}, "markers": {}, "names": {}}


def leonhard(path, *options, with_unmarked=False):
    return lambda: account.of_leonhard(PROGRAM, FOLDER / path, options, with_unmarked)


def meshio(path):
    return lambda: account.of_meshio(FOLDER / path)


def vtk(path):
    return lambda: account.of_vtk(FOLDER / path)


# ---- files that other programs wrote ----


def gmsh_files():
    forms = {"22.msh": ["-format", "msh22"], "41.msh": ["-format", "msh41"], "22b.msh": ["-format", "msh22", "-bin"],
             "41b.msh": ["-format", "msh41", "-bin"]}
    for geometry in PLANE + SPACE:
        dimension = "-2" if geometry in PLANE else "-3"
        source = GEOMETRY / (geometry + ".geo")
        for form, options in forms.items():
            run("gmsh", source, dimension, "-o", f"{geometry}_{form}", "-v", "1", *options)
        reference = meshio(f"{geometry}_22.msh")
        for form in forms:
            compare(f"gmsh {geometry}_{form}", leonhard(f"{geometry}_{form}"), reference)
        for extension in ("vtk", "su2", "mesh"):
            if (geometry, extension) == ("layers", "mesh"):
                continue  # Gmsh 4.8 leaves prisms out and keeps their faces: refused
            file = f"{geometry}_gmsh.{extension}"
            run("gmsh", source, dimension, "-o", file, "-v", "1")
            compare(f"gmsh {file}", leonhard(file), meshio(file))
        run("gmsh", source, dimension, "-o", f"{geometry}_bin.vtk", "-v", "1", "-bin")
        compare(f"gmsh {geometry}_bin.vtk", leonhard(f"{geometry}_bin.vtk"), meshio(f"{geometry}_gmsh.vtk"))
        for form in ("22", "41"):
            file = f"{geometry}_second_{form}.msh"
            run("gmsh", source, dimension, "-order", "2", "-o", file, "-v", "1", "-format", "msh" + form)
            compare(f"gmsh {file}", leonhard(file), reference, {"vertices"} if geometry == "layers" else ())
            file = f"{geometry}_all_{form}.msh"
            run("gmsh", source, dimension, "-save_all", "-o", file, "-v", "1", "-format", "msh" + form)
            compare(f"gmsh {file}", leonhard(file), reference, {"markers", "regions", "names"})
        run("gmsh", source, dimension, "-part", "3", "-o", f"{geometry}_parts.msh", "-v", "1")
        compare(f"gmsh {geometry}_parts.msh", leonhard(f"{geometry}_parts.msh"), reference, {"markers"})


def face_markers(path):
    """Of a TetGen .face file."""
    rows = [line.split() for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]
    found = {}
    for row in rows[1:]:
        if row[-1] != "0":
            found[int(row[-1])] = found.get(int(row[-1]), 0) + 1
    return found


def tetgen_files():
    cube = FOLDER / "cube.poly"
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    lines = ["8 3 0 0"] + ["%d %d %d %d" % (i + 1, *p) for i, p in enumerate(corners)] + ["6 1"]
    for marker, face in enumerate(faces, 1):
        lines += ["1 0 %d" % marker, "4 %d %d %d %d" % face]
    cube.write_text("\n".join(lines + ["0", "1", "1 0.5 0.5 0.5 7 0.02"]) + "\n")
    def theirs():
        result = account.of_meshio(FOLDER / "cube.1.ele")
        result["markers"] = face_markers(FOLDER / "cube.1.face")
        result["regions"] = {7: result["cells"]["tetra"]}
        return result

    for options in ("pqAa", "pqAaz", "pqAaef"):
        run("tetgen", "-" + options, cube)
        compare(f"tetgen -{options}", leonhard("cube.1.ele"), theirs)
    linear = account.of_leonhard(PROGRAM, FOLDER / "cube.1.ele")
    run("tetgen", "-pqAao2", cube)
    compare("tetgen -pqAao2", leonhard("cube.1.ele"), lambda: linear)


def meshio_files():
    import meshio as library

    for geometry in PLANE + SPACE:
        mesh = account.quietly(library.read, FOLDER / f"{geometry}_22.msh")
        with_entities = account.quietly(library.read, FOLDER / f"{geometry}_41.msh")  # which it needs to write 4.1
        forms = {"none.vtu": {"compression": None}, "ascii.vtu": {"binary": False}, "zlib.vtu": {"compression": "zlib"},
                 "lzma.vtu": {"compression": "lzma"}, "42.vtk": {"file_format": "vtk42"}, "51.vtk": {"file_format": "vtk51"},
                 "42a.vtk": {"file_format": "vtk42", "binary": False}, "51a.vtk": {"file_format": "vtk51", "binary": False},
                 "22.msh": {"file_format": "gmsh22"}, "22a.msh": {"file_format": "gmsh22", "binary": False},
                 "41.msh": {"file_format": "gmsh"}, "41a.msh": {"file_format": "gmsh", "binary": False}, "medit.mesh": {}}
        for form, options in forms.items():
            file = f"{geometry}_meshio_{form}"
            source = with_entities if form.startswith("41") else mesh
            account.quietly(library.write, FOLDER / file, source, **options)
            # meshio gives each vertex the reference 1, which faces without one then share
            left = {"markers"} if (geometry, form) == ("layers", "medit.mesh") else ()
            compare(f"meshio {file}", leonhard(file), meshio(file), left)


def vtk_files():
    import vtk as library

    compressors = {"plain": None, "zlib": library.vtkZLibDataCompressor, "lz4": library.vtkLZ4DataCompressor,
                   "lzma": library.vtkLZMADataCompressor}
    for geometry in PLANE + SPACE:
        run(PROGRAM, "convert", f"{geometry}_22.msh", f"{geometry}_for_vtk.vtu", "--quiet")
        grid = account.vtk_reader(FOLDER / f"{geometry}_for_vtk.vtu")

        def write(file, compressor=None, mode="Appended", header=None, big=False, raw=True):
            writer = library.vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(FOLDER / file))
            writer.SetInputData(grid)
            getattr(writer, "SetDataModeTo" + mode)()
            writer.SetEncodeAppendedData(0 if raw else 1)
            writer.SetCompressor(compressor() if compressor else None)
            if header:
                writer.SetHeaderType(header)
            if big:
                writer.SetByteOrderToBigEndian()
            writer.Write()
            compare(f"vtk {file}", leonhard(file, with_unmarked=True), vtk(file))

        write(f"{geometry}_vtk_ascii.vtu", mode="Ascii")
        for name, compressor in compressors.items():
            write(f"{geometry}_vtk_{name}_raw.vtu", compressor)
            write(f"{geometry}_vtk_{name}_base64.vtu", compressor, raw=False)
            write(f"{geometry}_vtk_{name}_inline.vtu", compressor, mode="Binary", header=32)
        write(f"{geometry}_vtk_big.vtu", compressors["zlib"], big=True)
        for version, number in (("42", 42), ("51", 51)):
            for form in ("ASCII", "Binary"):
                writer = library.vtkUnstructuredGridWriter()
                file = f"{geometry}_vtk_{version}_{form}.vtk"
                writer.SetFileName(str(FOLDER / file))
                writer.SetInputData(grid)
                writer.SetFileVersion(number)
                getattr(writer, "SetFileTypeTo" + form)()
                writer.Write()
                compare(f"vtk {file}", leonhard(file, with_unmarked=True), vtk(file))


def gpmetis_files():
    (FOLDER / "grid.edges").write_text("".join(
        "%d %d\n" % (i, j) for i in range(400) for j in (i + 1, i + 20) if j < 400 and (j != i + 1 or j % 20 != 0)))
    neighbours = [[] for _ in range(400)]
    for line in (FOLDER / "grid.edges").read_text().splitlines():
        i, j = map(int, line.split())
        neighbours[i].append(j + 1)
        neighbours[j].append(i + 1)
    (FOLDER / "grid.graph").write_text("400 760\n" + "".join(" ".join(map(str, row)) + "\n" for row in neighbours))
    for parts in (2, 8):
        said = run("gpmetis", "grid.graph", parts)
        cut = int(said.split("Edgecut:")[1].split(",")[0])

        def read():
            report = json.loads(run(PROGRAM, "communicate", "grid.graph", "--parts-file", f"grid.graph.part.{parts}", "--json"))
            if report["cut"] != cut:
                raise RuntimeError("edge cut %s, not %d" % (report["cut"], cut))

        attempt(f"gpmetis grid.graph.part.{parts}", read)


def surface_files():
    """The box of box_surface.geo: closed, manifold, oriented, volume 1."""
    for form in ("stl", "bin.stl", "msh", "mesh", "vtk"):

        def read():
            file = f"surface_gmsh.{form}"
            binary = ["-bin"] if form.startswith("bin") else []
            run("gmsh", GEOMETRY / "box_surface.geo", "-2", "-o", file, "-v", "1", *binary)
            report = json.loads(run(PROGRAM, "check", file, "--weld", "0", "--json"))
            found = [report[key] for key in ("closed", "manifold", "oriented")] + [round(abs(report["volume"]), 12)]
            if found != [True, True, True, 1.0]:
                raise RuntimeError("closed, manifold, oriented, volume: %s" % found)

        attempt(f"gmsh surface_gmsh.{form}", read)
    for form in ("off", "obj", "ply", "stl", "mesh", "msh", "vtu"):
        file = f"surface_ours.{form}"
        attempt(f"leonhard writes {file}", lambda: run(PROGRAM, "convert", "surface_gmsh.msh", file, "--quiet"))
        if "meshio" in TOOLS:
            compare(f"meshio reads {file}", meshio(file), meshio("surface_gmsh.msh"),
                    {"vertices", "regions", "markers", "names"})


# ---- files that Leonhard wrote ----


def our_files():
    outputs = {"vtu": [], "41.msh": [], "22.msh": ["--msh-version", "2.2"], "41b.msh": ["--binary"],
               "22b.msh": ["--msh-version", "2.2", "--binary"], "su2": [], "mesh": []}
    for geometry in PLANE + SPACE:
        source = f"{geometry}_41.msh"
        ours = leonhard(source, with_unmarked=True)
        for form, options in outputs.items():
            file = f"{geometry}_ours.{form}"
            left = {"regions", "markers", "names"} if form == "su2" else {"names"} if form in ("vtu", "mesh") else set()
            attempt(f"leonhard writes {file}", lambda: run(PROGRAM, "convert", source, file, "--quiet", *options))
            if "meshio" in TOOLS:
                compare(f"meshio reads {file}", meshio(file), ours, left)
            if "vtk" in TOOLS and form == "vtu":
                compare(f"vtk reads {file}", vtk(file), ours, left)
            if "gmsh" in TOOLS and form.endswith("msh"):
                back = file.replace(".msh", "_gmsh.msh")
                attempt(f"gmsh saves {file}", lambda: run("gmsh", file, "-save", "-o", back, "-format", "msh22", "-v", "1"))
                compare(f"gmsh keeps {file}", meshio(back) if "meshio" in TOOLS else leonhard(back), ours, left)


if "gmsh" in TOOLS:
    gmsh_files()
if "tetgen" in TOOLS and "meshio" in TOOLS:
    tetgen_files()
if {"gmsh", "meshio"} <= TOOLS:
    meshio_files()
if {"gmsh", "vtk"} <= TOOLS:
    vtk_files()
if "metis" in TOOLS:
    gpmetis_files()
if "gmsh" in TOOLS:
    surface_files()
    our_files()
print("%d comparisons, %d not as expected" % (sum(counts.values()), counts["WRONG"]))
sys.exit(1 if counts["WRONG"] else 0)
