# Makes the meshes of this folder with Gmsh 4.15 (pip install gmsh) from the scripts beside it, the VTK and FLAC3D
# ones from those with meshio 5.3.5 (pip install meshio), and the ANSYS archive with the lines below.
import gmsh
import meshio

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)


def write(name, version=4.1, binary=0):
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.write(name)


for name in ("tunnel", "shapes"):
    gmsh.open(name + ".geo")
    gmsh.model.mesh.generate(3)
    write(name + ".msh")
    gmsh.write(name + ".inp")
write("shapes_binary.msh", binary=1)
write("shapes_v2.msh", version=2.2)
write("shapes_v2_binary.msh", version=2.2, binary=1)
gmsh.model.mesh.setOrder(2)
write("shapes_order2.msh", binary=1)
gmsh.finalize()

mesh = meshio.read("shapes.msh")
solids = meshio.Mesh(mesh.points, [c for c in mesh.cells if c.dim == 3])
solids.write("shapes_ascii.vtu", binary=False)
solids.write("shapes_base64.vtu", compression=None)
solids.write("shapes_zlib.vtu")
meshio.vtk.write("shapes_v42.vtk", solids, fmt_version="4.2", binary=False)
meshio.vtk.write("shapes_v51.vtk", solids, fmt_version="5.1", binary=True)
meshio.flac3d.write("shapes_binary.f3grid", solids, binary=True)


def archive(name, mesh):
    """An ANSYS archive as CDWRITE's manual has it: SOLID185, the other shapes as bricks with repeated nodes."""
    corners = {
        "hexahedron": (0, 1, 2, 3, 4, 5, 6, 7),
        "wedge": (0, 1, 2, 2, 3, 4, 5, 5),
        "pyramid": (0, 1, 2, 3, 4, 4, 4, 4),
        "tetra": (0, 1, 2, 2, 3, 3, 3, 3),
    }
    elements = [(cells.type, nodes) for cells in mesh.cells if cells.dim == 3 for nodes in cells.data]
    used = sorted({n for _, nodes in elements for n in nodes})
    lines = ["/PREP7", "ET,1,185", f"NBLOCK,6,SOLID,{used[-1] + 1:10d},{len(used):10d}", "(3i9,6e21.13e3)"]
    for n in used:
        places = [f"{x:.13E}".split("E") for x in mesh.points[n]]
        row = "".join(f"{f'{mantissa}E{int(power):+04d}':>21}" for mantissa, power in places)
        lines.append(f"{n + 1:9d}{0:9d}{0:9d}{row}")
    lines += ["N,R5.3,LOC,       -1,", f"EBLOCK,19,SOLID,{len(elements):10d},{len(elements):10d}", "(19i9)"]
    for number, (kind, nodes) in enumerate(elements, 1):
        row = [1, 1, 1, 1, 0, 0, 0, 0, 8, 0, number] + [nodes[c] + 1 for c in corners[kind]]
        lines.append("".join(f"{k:9d}" for k in row))
    lines.append("       -1")
    solid = [cells.dim == 3 for cells in mesh.cells]
    for group, blocks in mesh.cell_sets.items():
        if group.startswith("gmsh:"):
            continue
        first, members = 1, []
        for is_solid, cells, some in zip(solid, mesh.cells, blocks):
            if is_solid:
                members += [first + int(k) for k in some] if some is not None else []
                first += len(cells.data)
        if members:
            lines += [f"CMBLOCK,{group},ELEM,{len(members):8d}", "(8i10)"]
            rows = [members[k : k + 8] for k in range(0, len(members), 8)]
            lines += ["".join(f"{k:10d}" for k in row) for row in rows]
    lines += ["FINISH", ""]
    with open(name, "w") as out:
        out.write("\n".join(lines))


archive("shapes.cdb", mesh)
