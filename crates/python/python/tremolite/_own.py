"""What a script adds to a run of its own: observers that remember, and forces on nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._tremolite import Beginning, Look


class Observer:
    """Something that looks at a run and remembers: `job.run(out, observers=[Drift()])`.

    every: when it looks in the earthquake, steps or a text such as `"0.05 s"`; None: with the rows of the histories. It looks at the end of
        each stage as well.
    name: by which its memory is kept; its class's name where it is None. Two of one run have names of their own.

    What it remembers from one look to the next is in a memory, a dict from name to array (n,) of float64, which is part of the
    checkpoint: so a resumed run goes on with it. All else that an observer holds is the script's affair.

        class Drift(tr.Observer):
            every = "0.01 s"
            def begin(self, at):
                self.most = at.memory.setdefault("most", np.zeros(1))
            def see(self, now):
                np.maximum(self.most, abs(now.displacement).max(), out=self.most)
    """

    every: int | str | None = None
    name: str | None = None

    def begin(self, at: Beginning) -> None:
        """Called as each stage and the earthquake begin or are gone on with, and after `Simulation.restore`: `at.memory` is the memory,
        `at.out` the folder of the results, `at.stage` the stage or None, `at.time` [s]."""

    def see(self, now: Look) -> bool | None:
        """Called with each look; `now.memory` is the memory. False stops the run in good order, with a checkpoint."""
        raise NotImplementedError

    def end(self) -> None:
        """Called as the earthquake is over, or is left."""


class NodalForce:
    """Forces on a few nodes in the earthquake, asked for once a step: `job.with_fields(forces=[Damper()])`.

    nodes: nodes (n,) of `job.mesh`, each once.
    stiffness, damping: by how much a force changes at most with displacement [N/m] and with velocity [N s/m], that is the largest
        eigenvalues of the matrices between all nodes; a spring k between two of them has 2 k. The stable step goes by them, so one at
        least is declared, 0 for forces that go by time alone. What changes faster than declared is stopped by the guard, at best.
    remembers: how many numbers it remembers; with any, `forces` is given them as a fourth argument, an array (remembers,) that it may
        write to. They are part of the checkpoint.
    name: as messages and the summary call it; its class's name where it is None.

        class Damper(tr.NodalForce):
            nodes, damping = roof, 2e5
            def forces(self, t, u, v):
                return -2e5 * v

    Their work stands in a line of its own of the energy balance, `own_forces`. They act while the ground shakes, not in the stages
    before. Each step waits for them with the interpreter held, so few nodes and NumPy pay. A forces function goes by its arguments
    alone: a look asks it as well.
    """

    nodes: Sequence[int] | np.ndarray[Any, Any] | None = None
    stiffness: float | None = None
    damping: float | None = None
    remembers: int = 0
    name: str | None = None

    def forces(self, t: float, u: np.ndarray[Any, Any], v: np.ndarray[Any, Any], *memory: np.ndarray[Any, Any]) -> Any:
        """Forces (n, 3) [N] at the time t [s] of the earthquake, with displacements u (n, 3) [m] since it began and velocities v (n, 3)
        [m/s] half a step ago."""
        raise NotImplementedError
