"""Reads the film that vtu.test.cpp writes, with readers that know nothing of strike (VTK's own and meshio), and compares
counts and values with the formulas below. Exit code: 0 all equal, 1 a difference, 77 no reader installed."""
import sys
import xml.etree.ElementTree
import json
import os

folder = sys.argv[1]
HEXAHEDRA, TETRAHEDRA, QUADRILATERALS = (int(n) for n in sys.argv[2:5])
PARTICLES = [int(n) for n in sys.argv[5].split(",")]  # the node of each
NODES = int(sys.argv[6])
TIMES = [0.0, 0.125, 80.0]
failures = []


def check(what, found, wanted):
    if found != wanted:
        failures.append(f"{what}: {found!r}, not {wanted!r}")


def node_fields(x, y, z, t):
    return {
        "temperature <K> & more": [x + 2 * y + 4 * z + t],
        "velocity": [x, y * t, z - t],
    }


def cell_fields(cell):
    return {
        "number": [cell],
        "stress": [cell, cell + 1, cell + 2, cell + 3, cell + 4, cell + 5],
        "gradient": [cell * k for k in range(9)],
    }


def compare(reader, t, points, kinds, vertices, point_data, cell_data):
    check(f"{reader} nodes", len(points), NODES)
    check(f"{reader} cells", kinds, [12] * HEXAHEDRA + [10] * TETRAHEDRA + [9] * QUADRILATERALS + [1] * len(PARTICLES))
    check(f"{reader} nodes of particles", vertices, PARTICLES)
    for i, (x, y, z) in enumerate(points):
        for name, values in node_fields(x, y, z, t).items():
            check(f"{reader} {name} of node {i}", list(point_data[name][i]), values)
    for cell in range(len(kinds)):
        for name, values in cell_fields(cell).items():
            check(f"{reader} {name} of cell {cell}", list(cell_data[name][cell]), values)


def rows(array):
    return [[float(v) for v in (row if hasattr(row, "__len__") else [row])] for row in array]


def with_meshio(path, t):
    import meshio

    mesh = meshio.read(path)
    kind = {"hexahedron": 12, "tetra": 10, "quad": 9, "vertex": 1}
    kinds = [kind[block.type] for block in mesh.cells for _ in block.data]
    cell_data = {name: [row for block in blocks for row in rows(block)] for name, blocks in mesh.cell_data.items()}
    vertices = [int(node) for block in mesh.cells if block.type == "vertex" for (node,) in block.data]
    compare("meshio", t, rows(mesh.points), kinds, vertices, {n: rows(a) for n, a in mesh.point_data.items()}, cell_data)
    volume = sum(abs(box_volume(mesh.points[cell])) for block in mesh.cells if block.type == "hexahedron" for cell in block.data)
    check("meshio volume of the hexahedra", volume, 1.0)


def box_volume(corners):
    """Of a brick with edges along the axes, from its corners 0 and 6."""
    edges = corners[6] - corners[0]
    return float(edges[0] * edges[1] * edges[2])


def with_vtk(path, t):
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    if reader.GetErrorCode():
        failures.append(f"vtk cannot read {path}")
    grid = reader.GetOutput()

    def table(data):
        arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
        return {a.GetName(): [list(a.GetTuple(i)) for i in range(a.GetNumberOfTuples())] for a in arrays}

    points = [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())]
    kinds = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
    vertices = [grid.GetCell(i).GetPointId(0) for i, kind in enumerate(kinds) if kind == 1]
    compare("vtk", t, points, kinds, vertices, table(grid.GetPointData()), table(grid.GetCellData()))
    check("vtk time", grid.GetFieldData().GetArray("TimeValue").GetTuple(0), (t,))


readers = []
for reader, module in ((with_meshio, "meshio"), (with_vtk, "vtkmodules.vtkIOXML")):
    try:
        __import__(module)
        readers.append(reader)
    except ImportError:
        print(f"{module} is not installed: skipped")
if not readers:
    sys.exit(77)

film = [(f.get("file"), float(f.get("timestep"))) for f in xml.etree.ElementTree.parse(os.path.join(folder, "film.pvd")).iter("DataSet")]
with open(os.path.join(folder, "film.vtu.series")) as file:
    series = [(f["name"], f["time"]) for f in json.load(file)["files"]]
check("times in film.pvd", [t for _, t in film], TIMES)
check("film.vtu.series", series, film)
for name, t in film:
    for reader in readers:
        reader(os.path.join(folder, name), t)
for failure in failures[:20]:
    print(failure)
print(f"{len(film)} files, {len(readers)} readers, {len(failures)} differences")
sys.exit(1 if failures else 0)
