# Makes the meshes of this folder with Gmsh 4.15 (pip install gmsh) from the scripts beside it.
import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
for name in ("tunnel", "shapes"):
    gmsh.open(name + ".geo")
    gmsh.model.mesh.generate(3)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.write(name + ".msh")
gmsh.finalize()
