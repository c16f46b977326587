"""Stress by element, and loads."""

import json

import numpy as np
import pytest

import tremolite as tr
from conftest import pulse, same_files


def test_a_stress_by_element_runs_and_the_cases_own_gives_the_cases_bytes(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.01 s"}))
    stress = job.initial_stress
    assert stress.shape == (len(job.mesh), 6) and (stress[:, 2] < 0).all()
    # Horizontal over vertical, as the case has it.
    assert np.allclose(stress[:, 0], 0.6 * stress[:, 2])
    whole = job.run(tmp_path / "whole")
    assert same_files(whole.path, job.with_fields(initial_stress=stress).run(tmp_path / "same").path) == []
    other = stress.copy()
    other[:, 0] *= 1.5
    result = job.with_fields(initial_stress=other).run(tmp_path / "other")
    named = [one["name"] for one in json.loads((result.path / "summary.json").read_text())["inputs"]]
    assert "initial stress" in named
    sections = [np.array([row["N"] for row in one.rows("sections")]) for one in (whole, result)]
    assert np.abs(sections[1] - sections[0]).max() > 1e4


def test_a_load_on_a_columns_top_becomes_its_stress(job, tmp_path):
    # 4 m2 of the column's top under 4 kN upwards, let go slowly: 1 kPa of tension at rest.
    top = job.mesh.nodes_near((1.0, 1.0, 0.0), 1.5)
    assert len(top) == 4
    t = np.linspace(0.0, 1.0, 200)
    ramp = 0.5 - 0.5 * np.cos(np.pi * np.minimum(t / 0.6, 1.0))
    loaded = tr.Job(job.case, motion=pulse().scaled(1e-9)).with_fields(loads=[(top, (0.0, 0.0, 1000.0), t, ramp)])
    result = loaded.run(tmp_path / "a")
    szz = result.monitors["top"].szz
    # What is not yet at rest 0.4 s behind the ramp is small: the base absorbs.
    assert szz[-1] == pytest.approx(1000.0, rel=0.05) and szz[0] == 0.0
    assert result.energy["input"][-1] > 0


def test_fields_that_do_not_fit_are_refused_in_words(job, cavern):
    t, f = [0.0, 1.0], [0.0, 1.0]
    for loads, words in [
        ([([999], (0, 0, 1), t, f)], "no node 999"),
        ([([0], (0, 0, 1), [1.0, 0.0], f)], "do not grow"),
        ([([0], (0, 0, 1), t, [0.0, np.nan])], "not finite"),
        ([([0], (0, 1), t, f)], "a load is"),
        ([([0], (0, 0, 1), t)], "a load is"),
        ([3], "a load is"),
    ]:
        with pytest.raises(tr.Error, match=words):
            job.with_fields(loads=loads)
    with pytest.raises(tr.Error, match=r"write \[initial\]"):
        job.with_fields(initial_stress=np.zeros((10, 6)))
    staged = tr.Job(cavern)
    for stress, words in [
        (np.zeros((3, 6)), "3 rows"),
        (np.zeros((3, 5)), r"\(elements, 6\)"),
        (np.full((len(staged.mesh), 6), np.nan), "not finite"),
    ]:
        with pytest.raises(tr.Error, match=words):
            staged.with_fields(initial_stress=stress)
