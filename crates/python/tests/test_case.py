"""Cases from file, text and dict; changes; faults; schema."""

import json
import pickle
import subprocess

import numpy as np
import pytest

import tremolite as tr


def test_a_dict_a_text_and_a_file_are_the_same_case(column, tmp_path):
    case = tr.Case.from_dict(column)
    (tmp_path / "case.toml").write_text(case.text)
    of_file = tr.Case(tmp_path / "case.toml")
    assert of_file.text == case.text == tr.Case.from_text(case.text).text
    assert case.to_dict() == of_file.to_dict() == column
    assert of_file.directory == tmp_path and [str(f) for f in case.files] == ["pulse"]


def test_a_case_is_changed_by_the_paths_of_its_keys(column):
    case = tr.Case.from_dict(column)
    other = case.with_({"material.rock.young": "3 GPa", "monitor[top].at": ["1 m", "1 m", "-3 m"], "dynamic.safety": np.float64(0.5)})
    keys = other.to_dict()
    assert keys["material"]["rock"]["young"] == "3 GPa"
    assert keys["monitor"][0]["at"][2] == "-3 m" and keys["dynamic"]["safety"] == 0.5
    assert case.to_dict()["material"]["rock"]["young"] == "2 GPa"
    assert other != case and case == tr.Case.from_dict(column)


def test_all_faults_come_at_once_with_key_line_message_and_remedy(column):
    column["material"]["rock"]["yuong"] = column["material"]["rock"].pop("young")
    column["dynamic"]["base"] = "elastic"
    with pytest.raises(tr.CaseError) as caught:
        tr.Case.from_dict(column)
    problems = {p.key: p for p in caught.value.problems}
    assert {"material.rock.yuong", "dynamic.base"} <= problems.keys()
    misspelt = problems["material.rock.yuong"]
    assert misspelt.remedy == "did you mean `young`?" and misspelt.line > 1 and misspelt.column == 1
    assert "yuong" in misspelt.message and "did you mean" in str(caught.value) and "young" in repr(misspelt)


def test_a_fault_of_a_change_is_told_as_of_that(column):
    with pytest.raises(tr.CaseError) as caught:
        tr.Case.from_dict(column).with_({"material.rock.young": "3 kg"})
    (problem,) = caught.value.problems
    assert problem.key == "material.rock.young" and problem.line is None


def test_values_that_no_case_holds_are_refused_in_words(column):
    for value, words in [(None, "leave the key out"), (object(), "holds texts"), ({1: 2}, "keys of a case are texts")]:
        with pytest.raises(tr.Error, match=words):
            tr.Case.from_dict({**column, "title": value})
    with pytest.raises(tr.CaseError, match="there is no file|No such file|cannot"):
        tr.Case("no such case.toml")


def test_texts_with_quotes_and_other_scripts_stay_what_they_are(column):
    title = 'a "quoted" \\ title\nin two lines, 映秀湾'
    assert tr.Case.from_dict({**column, "title": title}).title == title


def test_the_schema_is_that_of_the_command(command):
    printed = subprocess.run([*command, "schema"], check=True, capture_output=True, text=True).stdout
    assert tr.Case.schema() == json.loads(printed)


def test_a_case_shows_itself_and_goes_to_other_processes(column):
    case = tr.Case.from_dict(column)
    assert "elastic" in case._repr_html_() and case.title in repr(case)
    assert pickle.loads(pickle.dumps(case)) == case
    assert case.defaults["dynamic.safety"] == "0.9"


def test_bare_numbers_are_refused_but_for_a_dict_in_si(column):
    bare = {**column, "material": {"rock": {**column["material"]["rock"], "young": 2e9}}}
    with pytest.raises(tr.CaseError) as caught:
        tr.Case.from_dict(bare)
    assert caught.value.problems[0].key == "material.rock.young" and '"2 GPa"' in caught.value.problems[0].remedy
    assert tr.Case.from_dict(bare, units="SI").to_dict() == {**bare, "units": "SI"}
    assert "units" not in bare
    with pytest.raises(tr.CaseError, match="units"):
        tr.Case.from_dict(bare, units="US")
