# Makes the meshes of this folder with Gmsh 4.15 (pip install gmsh) from the scripts beside it, and the VTK and
# FLAC3D ones from those with meshio 5.3.5 (pip install meshio).
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
