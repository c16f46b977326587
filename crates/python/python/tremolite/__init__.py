"""Does the concrete lining of an underground powerhouse survive an earthquake?

A case is read (`Case`), built with its mesh and its records (`Job`), run at once (`Job.run`) or step by step (`Job.start`), and its
results are read (`Result`). `Mesh` and `Motion` hold inputs in memory; `law` drives a material or an interface at a point.

    import tremolite as tr
    case = tr.Case("case.toml").with_({"initial.lateral": 1.2})
    result = tr.Job(case).run("results/a")
    print(result.verdict)

SI inside; texts with units where a case file has them. z points up, stresses are positive in tension, six components are xx, yy, zz,
xy, yz, zx. The same case gives the same bits here and from the command line.
"""

from ._by_element import Field, by_element
from ._fields import FieldFile, Grid
from ._fitting import Candidate, artificial, select
from ._law import InterfacePath, Law, MaterialPath, law
from ._mesh import Mesh
from ._motion import Channel, Motion
from ._own import NodalForce, Observer
from ._results import Result, compare
from ._soft_ground import soft_ground
from ._study import Study
from ._study_result import Curve, StudyResult, StudyTable
from ._tables import Table
from ._tremolite import (
    Beginning,
    Case,
    CaseError,
    CaseWarning,
    Error,
    Job,
    Look,
    Problem,
    RunError,
    RunWarning,
    Simulation,
    StageEnd,
    Stopped,
    Target,
    __version__,
)

__all__ = [
    "Beginning",
    "Candidate",
    "Case",
    "CaseError",
    "CaseWarning",
    "Channel",
    "Curve",
    "Error",
    "Field",
    "FieldFile",
    "Grid",
    "InterfacePath",
    "Job",
    "Law",
    "Look",
    "MaterialPath",
    "Mesh",
    "Motion",
    "NodalForce",
    "Observer",
    "Problem",
    "Result",
    "RunError",
    "RunWarning",
    "Simulation",
    "StageEnd",
    "Stopped",
    "Study",
    "StudyResult",
    "StudyTable",
    "Table",
    "Target",
    "__version__",
    "artificial",
    "by_element",
    "compare",
    "law",
    "select",
    "soft_ground",
]
