# Makes the Nastran and LS-DYNA files of this folder from shapes.msh with writers of others: pyNastran 1.4.1 and Gmsh 4.15
# (pip install "numpy<2" pyNastran gmsh meshio==5.3.5), and PyDYNA 0.12.1 (pip install ansys-dyna-core pandas meshio==5.3.5).
# Prints the figures that their readers find. Run as `python make_decks.py nastran` and `python make_decks.py dyna`.
import sys

import meshio
import numpy as np

SOLIDS = {"hexahedron": 8, "wedge": 6, "pyramid": 5, "tetra": 4}
mesh = meshio.read("shapes.msh")
groups = ["bricks", "wedges", "roof"]


def solids():
    """Number, group (from 1), shape and node numbers of each solid, in the order of the file."""
    number = 0
    for k, block in enumerate(mesh.cells):
        for row, nodes in enumerate(block.data):
            if block.type in SOLIDS:
                number += 1
                inside = [g for g, name in enumerate(groups, 1) if row in mesh.cell_sets[name][k]]
                yield number, inside[0], block.type, [int(n) + 1 for n in nodes]


def nastran():
    from pyNastran.bdf.bdf import BDF

    model = BDF(debug=None)
    # A system turned by 30 degrees about z and moved; every third node has its coordinates there.
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    origin, x, z = np.array([-0.5, -3.0, -0.5]), np.array([c, s, 0.0]), np.array([0.0, 0.0, 1.0])
    model.add_cord2r(7, origin, origin + z, origin + x)
    axes = np.array([x, np.cross(z, x), z])
    for n, place in enumerate(mesh.points, 1):
        turned = n % 3 == 0
        model.add_grid(n, axes @ (place - origin) if turned else place, cp=7 if turned else 0)
    for number, group, shape, nodes in solids():
        add = {"hexahedron": model.add_chexa, "wedge": model.add_cpenta, "pyramid": model.add_cpyram, "tetra": model.add_ctetra}
        add[shape](number, group, nodes)
    for k, name in enumerate(groups, 1):
        model.add_psolid(k, 1, comment=f'HMNAME PROP {k:23d}"{name}" 4')
    model.add_mat1(1, 1e10, None, 0.25)
    model.write_bdf("shapes.bdf", size=16, is_double=True, write_header=False, interspersed=False)
    again = BDF(debug=None)
    again.read_bdf("shapes.bdf", punch=True)
    for k, name in enumerate(groups, 1):
        members = [e for e in again.elements.values() if e.pid == k]
        print("shapes.bdf", name, len(members), sum(e.Volume() for e in members))
    places = np.array([node.get_position() for node in again.nodes.values()])
    print("shapes.bdf", len(places), "nodes, sums", *places.sum(axis=0))

    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open("shapes.msh")
    gmsh.option.setNumber("Mesh.BdfFieldFormat", 0)
    gmsh.write("rounded_free.bdf")
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
    gmsh.model.mesh.setOrder(2)
    gmsh.option.setNumber("Mesh.BdfFieldFormat", 2)
    gmsh.write("rounded_order2.bdf")
    gmsh.finalize()
    again = BDF(debug=None)
    again.read_bdf("rounded_order2.bdf", punch=True, xref=False)
    counts = {}
    for e in again.elements.values():
        kind = f"{e.type} of {len([n for n in e.nodes if n])} nodes"
        counts[kind] = counts.get(kind, 0) + 1
    print("rounded_order2.bdf", counts)


def dyna():
    import pandas as pd
    from ansys.dyna.core import Deck
    from ansys.dyna.core import keywords as kwd
    from ansys.dyna.core.lib.keyword_base import format_type

    # The order of LS-DYNA's bricks with repeated nodes.
    corners = {
        "hexahedron": (0, 1, 2, 3, 4, 5, 6, 7),
        "wedge": (0, 1, 4, 3, 2, 2, 5, 5),
        "pyramid": (0, 1, 2, 3, 4, 4, 4, 4),
        "tetra": (0, 1, 2, 3, 3, 3, 3, 3),
    }
    for name, layout in (("shapes.k", format_type.default), ("shapes_long.k", format_type.long)):
        deck = Deck(title="shapes", format=layout)
        x, y, z = mesh.points.T
        node = kwd.Node()
        node.nodes = pd.DataFrame({"nid": range(1, len(x) + 1), "x": x, "y": y, "z": z})
        deck.append(node)
        rows = [(n, g, *(nodes[c] for c in corners[shape])) for n, g, shape, nodes in solids()]
        element = kwd.ElementSolid()
        if name == "shapes.k":
            element.set_legacy_format()
        element.elements = pd.DataFrame(rows, columns=["eid", "pid", *(f"n{k}" for k in range(1, 9))])
        deck.append(element)
        for k, title in enumerate(groups, 1):
            part = kwd.Part()
            part.parts = pd.DataFrame({"heading": [title], "pid": [k], "secid": [1], "mid": [1]})
            deck.append(part)
        members = kwd.SetSolidList() if hasattr(kwd, "SetSolidList") else kwd.SetSolid()
        members.options["TITLE"].active = True
        members.title, members.sid = "first four", 9
        for k in range(1, 5):
            setattr(members, f"k{k}", k)
        deck.append(members)
        with open(name, "w") as out:
            out.write(deck.write())


{"nastran": nastran, "dyna": dyna}[sys.argv[1]]()
