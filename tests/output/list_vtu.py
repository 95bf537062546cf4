"""Lists the cells of a VTU file as meshio, which knows nothing of strike, reads them: for each its kind, "part", "equivalent
plastic strain", the xx of "stress", and the places of its corners. Exit code 77: no meshio is installed."""
import sys

try:
    import meshio
except ImportError:
    sys.exit(77)

mesh = meshio.read(sys.argv[1])
for k, block in enumerate(mesh.cells):
    part, strain, stress = (mesh.cell_data[name][k] for name in ("part", "equivalent plastic strain", "stress"))
    for e, cell in enumerate(block.data):
        numbers = [part[e], strain[e], stress[e][0], *mesh.points[cell].flat]
        print(block.type, *(repr(float(number)) for number in numbers))
