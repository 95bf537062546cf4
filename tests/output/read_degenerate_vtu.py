"""Reads a hexahedron, two wedges and six pyramids, each kind of them a cube of edge 1, and compares counts and
volumes. Exit code: 0 all equal, 1 a difference, 77 no meshio."""
import sys

try:
    import meshio
except ImportError:
    sys.exit(77)

mesh = meshio.read(sys.argv[1])
cells = {block.type: block.data for block in mesh.cells}


def tetrahedron(a, b, c, d):
    """Volume, positive if a b c runs counter-clockwise seen from d."""
    u, v, w = (mesh.points[i] - mesh.points[a] for i in (b, c, d))
    return float((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2]) / 6


def wedge(a, b, c, d, e, f):
    """meshio turns VTK's wedge, whose first triangle looks away from the second, into that of gmsh."""
    return tetrahedron(a, b, c, d), tetrahedron(b, c, d, e), tetrahedron(c, d, e, f)


def pyramid(a, b, c, d, e):
    """VTK's base runs counter-clockwise seen from the apex."""
    return tetrahedron(a, b, c, e), tetrahedron(a, c, d, e)


failures = []
for kind, count, volumes in (("wedge", 2, wedge), ("pyramid", 6, pyramid)):
    parts = [volumes(*cell) for cell in cells[kind]]
    if len(parts) != count or min(min(p) for p in parts) <= 0 or abs(sum(sum(p) for p in parts) - 1) > 1e-14:
        failures.append(f"{kind}: {parts}")
if len(cells["hexahedron"]) != 1:
    failures.append("hexahedron")
print(failures)
sys.exit(1 if failures else 0)
