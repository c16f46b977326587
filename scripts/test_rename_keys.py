"""Tests of `rename-keys`: python3 scripts/test_rename_keys.py."""

from __future__ import annotations

import contextlib
import importlib.machinery
import importlib.util
import io
import math
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from types import ModuleType

SCRIPT = Path(__file__).with_name("rename-keys")
REPOSITORY = SCRIPT.parent.parent


def load() -> ModuleType:
    """The script as a module; its name has no ending that Python knows."""
    loader = importlib.machinery.SourceFileLoader("rename_keys", str(SCRIPT))
    spec = importlib.util.spec_from_loader(loader.name, loader)
    assert spec is not None
    sys.modules[loader.name] = module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


sys.dont_write_bytecode = True
rename_keys = load()


class Folder(unittest.TestCase):
    """A folder of files to convert."""

    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_bytes(text.encode())
        return path

    def run_on(self, *arguments: object) -> tuple[int, str, str]:
        """Exit status, standard output and standard error, without the name of the folder."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = rename_keys.main([str(argument) for argument in arguments])
        return status, *(stream.getvalue().replace(f"{self.folder}/", "") for stream in (out, err))

    def converted(self, text: str, name: str = "case.toml") -> str:
        """The new text of a file that can be converted. A second run changes nothing."""
        path = self.write(name, text)
        status, _, err = self.run_on(path)
        self.assertEqual((status, err), (0, ""), text)
        new = path.read_bytes().decode()
        status, out, err = self.run_on(path)
        self.assertEqual((status, out, err, path.read_bytes().decode()), (0, "", "", new), "second run")
        return new

    def refused(self, text: str, name: str = "case.toml") -> str:
        """The messages about a file that cannot be converted and stays as it was."""
        path = self.write(name, text)
        status, _, err = self.run_on(path)
        self.assertEqual(status, 2, text)
        self.assertEqual(path.read_bytes().decode(), text)
        return err

    def assert_converted(self, old: str, new: str, name: str = "case.toml") -> None:
        self.assertEqual(self.converted(old, name), new)


class Renames(Folder):
    def test_each_key_has_its_new_name_in_its_table(self) -> None:
        for table, old, new in [
            ("[mesh.caverns]", 'near = "2 m"', 'size_near = "2 m"'),
            ("[mesh.caverns]", 'far = "9 m"', 'size_far = "9 m"'),
            ("[mesh.caverns]", 'along = "3 m"', 'size_along = "3 m"'),
            ("[material.rock]", 'ucs = "80 MPa"', 'compressive_strength = "80 MPa"'),
            ("[material]", 'ucs = "80 MPa"', 'compressive_strength = "80 MPa"'),
            ("[material.rock.water]", 'permeability = "1e-7 m/s"', 'hydraulic_conductivity = "1e-7 m/s"'),
            ("[material.water]", 'permeability = "1e-7 m/s"', 'hydraulic_conductivity = "1e-7 m/s"'),
            ("[[interface]]", "friction = 0.6", "friction_coefficient = 0.6"),
            ("[interface]", "friction = 0.6", "friction_coefficient = 0.6"),
            ("[initial]", 'lateral_of = "total"', 'k0_stress = "total"'),
            ("[motion]", 'process = ["baseline"]', 'processing = ["baseline"]'),
            ("[[record]]", 'process = ["baseline"]', 'processing = ["baseline"]'),
            ("[[motion.wave]]", 'part = "up"', 'surface_component = "up"'),
            ("[[section]]", "dynamic = 1.2", "dynamic_factor = 1.2"),
            ("[[region]]", 'element = "full"', 'element = "full-integration"'),
            ("[[region]]", 'element = "one-point"', 'element = "reduced-integration"'),
            ("[[region]]", 'element = "layered"', 'element = "layered"'),
            ("[[mesh.plane]]", 'dip_direction = "90 deg"', 'dip_azimuth = "90 deg"'),
            ("[[mesh.caverns.layer]]", 'dip_direction = "90 deg"', 'dip_azimuth = "0 deg"'),
            ("[mesh.group.halfspace]", 'dip_direction = "90 deg"', 'dip_azimuth = "90 deg"'),
            ("[[mesh.group.between.planes]]", 'dip_direction = "90 deg"', 'dip_azimuth = "90 deg"'),
        ]:
            with self.subTest(table=table, old=old):
                self.assert_converted(f"{table}\nother = 1\n{old}\n", f"{table}\nother = 1\n{new}\n")

    def test_the_list_of_pairs_of_monitors_has_its_new_name(self) -> None:
        self.assert_converted('[[relative]]\nbetween = ["A", "B"]\n', '[[monitor_pair]]\nbetween = ["A", "B"]\n')
        self.assert_converted('relative = [{ between = ["A", "B"] }]\n', 'monitor_pair = [{ between = ["A", "B"] }]\n')

    def test_keys_of_these_names_in_other_tables_stay(self) -> None:
        text = """title = "near = far"
[mesh.box]
part = [{ group = "a" }]
near = 1
[[mesh.box.part]]
group = "b"
[material.concrete]
law = "concrete-damage"
ucs = "30 MPa"
friction = 0.5
friction_angle = "46 deg"
permeability = "1e-7 m/s"
[water]
permeability = "1e-7 m/s"
[dynamic]
base = "viscous"
damping = { ratio = 0.02 }
part = "up"
process = ["baseline"]
[stage.bolts.bond]
friction = 0.5
[report.limits]
along = "1 mm"
[[monitor]]
element = "full"
[motion.site]
process = 1
"""
        self.assert_converted(text, text)

    def test_ucs_is_renamed_in_hoek_brown_materials_alone(self) -> None:
        text = '[material.a]\nlaw = "hoek-brown"\nucs = "80 MPa"\n[material.b]\nlaw = "own"\nucs = "80 MPa"\n'
        self.assert_converted(text, text.replace("ucs", "compressive_strength", 1))
        text = '[material.ucs]\nlaw = "elastic"\n[material.water]\nlaw = "own"\npermeability = "1e-9 m/s"\n'
        self.assert_converted(text, text)

    def test_a_permeability_in_m2_is_a_key_of_its_own(self) -> None:
        text = '[material.rock.water]\npermeability = "1e-14 m2"\n[material.clay]\nwater.permeability = "1e-11 m²/(Pa s)"\n'
        self.assert_converted(text, text)
        text = 'case = "case.toml"\n[vary]\n"material.rock.water.permeability" = { values = ["1e-14 m2", "1e-13 m2"] }\n'
        self.assert_converted(text, text, "study.toml")

    def test_inline_tables_and_dotted_keys(self) -> None:
        water = "[material]\nrock.water = { biot = 1, permeability = '1e-8 m/s' }\n'岩'.water.permeability = '1e-9 m/s'\n"
        for text, old, new in [
            ('interface = [{ name = "a", friction = 0.6 }, { friction = 0.7, name = "b" }]\n', "friction", "friction_coefficient"),
            ('mesh = { caverns = { near = "1 m", cavern = [{ name = "near" }] } }\n', "near =", "size_near ="),
            ('mesh.caverns.near = "1 m"\nmesh.group = []\n', "near", "size_near"),
            ('[mesh]\ncaverns."far" = "9 m"\n', "far", "size_far"),
            ('[motion]\nwave = [{ type = "P", part = "up" }]\n', "part", "surface_component"),
            (water, "permeability", "hydraulic_conductivity"),
        ]:
            self.assert_converted(text, text.replace(old, new))

    def test_comments_spaces_and_long_values_stay(self) -> None:
        old = '''# near = "no key"
title = """near = "1 m"
[[relative]] of a text"""   # one
[ mesh . caverns ]  # two
  near="1 m"# three
\tfar =  '9 m'

[motion]
process = [
  "baseline", # process = []
  "taper 1 s",
] # four
[[ relative ]] # five
'''
        new = old.replace('  near="1 m"#', '  size_near="1 m"#').replace("\tfar", "\tsize_far")
        self.assert_converted(old, new.replace("\nprocess", "\nprocessing").replace("[[ relative ]]", "[[ monitor_pair ]]"))

    def test_equals_signs_stay_in_their_column_where_there_is_room(self) -> None:
        text = '[mesh.caverns]\noverburden = "1 m"\nnear       = "1 m"  # c\n'
        self.assert_converted(text, text.replace("near     ", "size_near"))
        text = '[[mesh.plane]]\ndip           = "1 deg"\ndip_direction = "9 deg"\n'
        self.assert_converted(text, text.replace("dip_direction", "dip_azimuth  "))

    def test_line_ends_and_chinese_comments_stay(self) -> None:
        title, motion, x = 'title = "地下厂房"  # 围岩\r\n', "[motion]  # 地震动\r\n", 'model_x_azimuth = "30 deg"  # 模型x轴\r\n'
        old = f'\ufeff{title}{motion}process = ["baseline"]  # 处理\r\n{x}[[relative]]\r\n'
        new = f'\ufeff{title}{x}{motion}processing = ["baseline"]  # 处理\r\n[[monitor_pair]]\r\n'
        self.assert_converted(old, new)

    def test_old_and_new_names_side_by_side_are_refused(self) -> None:
        err = self.refused('[mesh.caverns]\nnear = "1 m"\nsize_near = "1 m"\n')
        self.assertIn("case.toml:2: `near` and `size_near` are both given. Keep `size_near`", err)
        self.assertIn("Keep that at the top", self.refused('model_x_azimuth = "1 deg"\n[motion]\nmodel_x_azimuth = "2 deg"\n'))
        self.assertIn("Keep `dip_azimuth`", self.refused('[[mesh.plane]]\ndip_direction = "1 deg"\ndip_azimuth = "2 deg"\n'))

    def test_the_report_has_a_line_for_each_change_and_a_dry_run_writes_nothing(self) -> None:
        text = 'title = "t"\n[mesh.caverns]\nnear = "1 m"\n[[mesh.plane]]\ndip_direction = "10 deg"\n[motion]\nmodel_x_azimuth = "0 deg"\n'
        path = self.write("case.toml", text)
        expected = (
            "case.toml:3: near -> size_near\n"
            'case.toml:5: dip_direction = "10 deg" -> dip_azimuth = "280 deg"\n'
            "case.toml:7: [motion] model_x_azimuth -> model_x_azimuth at the top of the file\n"
        )
        self.assertEqual(self.run_on("--dry-run", path), (0, expected, ""))
        self.assertEqual(path.read_text(), text)
        self.assertEqual(self.run_on(path), (0, expected, ""))
        self.assertNotEqual(path.read_text(), text)

    def test_files_that_cannot_be_read_are_named_and_the_others_converted(self) -> None:
        broken = self.write("broken.toml", 'title = "t"\nnear = \n')
        latin = self.folder / "latin.toml"
        latin.write_bytes(b'title = "\xe9"\n')
        good = self.write("good.toml", "[[relative]]\n")
        status, _, err = self.run_on(broken, latin, self.folder / "none.toml", good)
        self.assertEqual(status, 2)
        self.assertIn("broken.toml:2: the text is no TOML: a value is missing", err)
        self.assertIn("latin.toml: the file is not UTF-8 text", err)
        self.assertIn("none.toml: the file cannot be read", err)
        self.assertEqual(good.read_text(), "[[monitor_pair]]\n")


class Angles(Folder):
    def azimuths(self, kind: str, x_azimuth: str, *old: str) -> list[str]:
        table = {"layer": "[[mesh.caverns.layer]]", "plane": "[[mesh.plane]]"}[kind]
        motion = f'[motion]\nmodel_x_azimuth = "{x_azimuth}"\n' if x_azimuth else ""
        text = "title = 't'\n" + "".join(f'{table}\ndip_direction = "{one}"\n' for one in old) + motion
        return [line.split('"')[1] for line in self.converted(text).splitlines() if line.startswith("dip_azimuth")]

    def test_a_layer_counts_from_x_towards_y(self) -> None:
        self.assertEqual(self.azimuths("layer", "", "0 deg", "90 deg", "-45 deg", "180 deg"), ["90 deg", "0 deg", "135 deg", "270 deg"])
        self.assertEqual(self.azimuths("layer", "30 deg", "0 deg", "90 deg", "30 deg"), ["30 deg", "300 deg", "0 deg"])

    def test_a_plane_counts_clockwise_from_y(self) -> None:
        self.assertEqual(self.azimuths("plane", "", "0 deg", "90.0 deg", "-90 deg", "360 deg"), ["0 deg", "90.0 deg", "270 deg", "0 deg"])
        self.assertEqual(self.azimuths("plane", "30 deg", "0 deg", "90 deg", "300°"), ["300 deg", "30 deg", "240°"])

    def test_decimals_are_exact_and_units_stay(self) -> None:
        self.assertEqual(self.azimuths("layer", "30.1 deg", "0.2 deg", "1e1 deg", "10.10deg"), ["29.9 deg", "20.1 deg", "20deg"])
        self.assertEqual(self.azimuths("plane", "90.1 deg", "0.2 deg"), ["0.3 deg"])
        self.assertEqual(self.azimuths("plane", "90 deg", "0.5 rad", "500 mrad"), ["0.5 rad", "500 mrad"])
        number, unit = self.azimuths("layer", "", "0.5 rad")[0].split()
        self.assertEqual(unit, "rad")
        self.assertAlmostEqual(float(number), math.pi / 2 - 0.5, places=14)

    def test_old_and_new_angles_point_the_same_way(self) -> None:
        for x in (0, 30, 90, 200):
            for old in (0, 10, 100, 250):
                a, angle = math.radians(x), math.radians(old)
                cos, sin = math.cos(angle), math.sin(angle)
                for kind, along_x, along_y in [("layer", cos, sin), ("plane", sin, cos)]:
                    with self.subTest(kind=kind, x=x, old=old):
                        azimuth = math.radians(float(self.azimuths(kind, f"{x} deg", f"{old} deg")[0].split()[0]))
                        # x points to the azimuth a, and y to a - 90 deg.
                        self.assertAlmostEqual(math.sin(azimuth), along_x * math.sin(a) - along_y * math.cos(a), places=12)
                        self.assertAlmostEqual(math.cos(azimuth), along_x * math.cos(a) + along_y * math.sin(a), places=12)

    def test_a_layer_that_dips_towards_x_by_default_gets_its_azimuth(self) -> None:
        text = '[[mesh.caverns.layer]]\nname = "a"\ndip = "0 deg"\n[[mesh.caverns.layer]]\n  dip = "9 deg"  # c\n'
        self.assert_converted(text, text + '  dip_azimuth = "90 deg"\n')
        text = 'model_x_azimuth = "370.5 deg"\nmesh.caverns.layer = [{ dip = "9 deg", name = "a" }]\n'
        self.assert_converted(text, text.replace(", name", ', dip_azimuth = "10.5 deg", name'))

    def test_inline_planes_and_the_azimuth_that_was_moved_before(self) -> None:
        self.assert_converted(
            'model_x_azimuth = "0 deg"\n[[mesh.group]]\nbetween.planes = [{ dip_direction = "10 deg" }, { dip_direction = "100 deg" }]\n',
            'model_x_azimuth = "0 deg"\n[[mesh.group]]\nbetween.planes = [{ dip_azimuth = "280 deg" }, { dip_azimuth = "10 deg" }]\n',
        )

    def test_a_value_that_is_no_angle_is_refused(self) -> None:
        for value in ("90", '"90"', '"90 m"', '["90 deg"]'):
            err = self.refused(f"[[mesh.plane]]\ndip_direction = {value}\n")
            self.assertIn(f"case.toml:2: `dip_direction` is no angle with a unit: {value}. Write `dip_azimuth`", err)
            self.assertIn("stays as it was", err)
        err = self.refused('[[mesh.plane]]\ndip_direction = "9 deg"\n[motion]\nmodel_x_azimuth = 30\n')
        self.assertIn("`model_x_azimuth` is no angle with a unit: 30", err)


class Top(Folder):
    def test_the_azimuth_of_x_moves_behind_the_first_keys(self) -> None:
        top, x = '# head\ntitle = """a\nb"""  # t\nunits = "SI"\n', 'model_x_azimuth = "30 deg"   # x\n'
        tables = '\n# mesh\n[mesh.box]\n[motion]\nkind = "within"\n'
        self.assert_converted(f"{top}{tables}  {x}window = 1\n", f"{top}{x}{tables}window = 1\n")

    def test_without_first_keys_it_stands_before_the_first_table(self) -> None:
        self.assert_converted('[motion]\nmodel_x_azimuth = "1 deg"', 'model_x_azimuth = "1 deg"\n\n[motion]\n')
        head, mesh, x = "# head\n\n", "# of the mesh\n[mesh.box]\n[motion]\n", "model_x_azimuth = '1 deg'\n"
        self.assert_converted(head + mesh + x, f"{head}{x}\n{mesh}")
        initial, x = "initial = { lateral = 1 }\n", 'model_x_azimuth = "1 deg"'
        self.assert_converted(f"{initial}motion = {{ {x} }}\n", f"{x}\n{initial}motion = {{  }}\n")

    def test_it_leaves_tables_in_braces_and_dotted_keys(self) -> None:
        for old, new in [
            ('{ kind = "a", model_x_azimuth = "1 deg", file = "b" }', '{ kind = "a", file = "b" }'),
            ('{ kind = "a", model_x_azimuth = "1 deg" }', '{ kind = "a" }'),
            ('{ model_x_azimuth = "1 deg", kind = "a" }', '{ kind = "a" }'),
        ]:
            self.assert_converted(f"title = 't'\nmotion = {old}\n", f"title = 't'\nmodel_x_azimuth = \"1 deg\"\nmotion = {new}\n")
        self.assert_converted("motion.kind = 'a'\nmotion.model_x_azimuth = '1 deg'\n", "motion.kind = 'a'\nmodel_x_azimuth = '1 deg'\n")

    def test_that_of_a_record_stays(self) -> None:
        text = 'title = "t"\ncase = "case.toml"\n[[record]]\nname = "a"\nmodel_x_azimuth = "0 deg"\n'
        self.assert_converted(text, text)


class Studies(Folder):
    CASE = 'title = "t"\n[[mesh.caverns.layer]]\nname = "a"\n[[mesh.caverns.layer]]\nname = "b"\n[[mesh.plane]]\nname = "f"\n'
    HEAD = 'title = "s"\ncase = "case.toml"\n'

    def setUp(self) -> None:
        super().setUp()
        self.write("case.toml", self.CASE)

    def study(self, old: str, new: str) -> None:
        self.assert_converted(self.HEAD + old, self.HEAD + new, "study.toml")

    def test_paths_of_keys_have_their_new_names(self) -> None:
        for old, new in [
            ("mesh.caverns.near", "mesh.caverns.size_near"),
            ("interface[lining-rock].friction", "interface[lining-rock].friction_coefficient"),
            ("interface[*].friction", "interface[*].friction_coefficient"),
            ("material.rock.ucs", "material.rock.compressive_strength"),
            ("material.'a.b'.water.permeability", "material.'a.b'.water.hydraulic_conductivity"),
            ('material."ucs".ucs', 'material."ucs".compressive_strength'),
            ("initial.lateral_of", "initial.k0_stress"),
            ("motion.process", "motion.processing"),
            ("motion.wave[0].part", "motion.wave[0].surface_component"),
            ("motion.model_x_azimuth", "model_x_azimuth"),
            ("section[1].dynamic", "section[1].dynamic_factor"),
            ('relative["a"].between', 'monitor_pair["a"].between'),
            ("relative", "monitor_pair"),
            ("dynamic.damping.ratio", "dynamic.damping.ratio"),
            ("mesh.box.part[0].group", "mesh.box.part[0].group"),
        ]:
            for quote in {'"', "'"} - set(old):
                a, b = quote + old + quote, quote + new + quote
                with self.subTest(path=a):
                    self.study(f"[set]\n{a} = 1\n", f"[set]\n{b} = 1\n")
                    self.study(f"[vary]\n{a} = {{ values = [1, 2] }}\n", f"[vary]\n{b} = {{ values = [1, 2] }}\n")
                    self.study(f"[[row]]\nset = {{ {a} = 1 }}\n", f"[[row]]\nset = {{ {b} = 1 }}\n")
                    self.study(f"[[row]]\n[row.set]\n{a} = 1\n", f"[[row]]\n[row.set]\n{b} = 1\n")
                    self.study(f"[[correlation]]\nbetween = [{a}, 'a.b']\n", f"[[correlation]]\nbetween = [{b}, 'a.b']\n")

    def test_escaped_quotes_in_a_path_stay(self) -> None:
        self.study('[set]\n"material.\\"a.ucs\\".ucs" = 1\n', '[set]\n"material.\\"a.ucs\\".compressive_strength" = 1\n')
        self.study('[set]\n"relative[\\"a\\"].between" = 1\n', '[set]\n"monitor_pair[\\"a\\"].between" = 1\n')

    def test_whole_tables_and_words_that_a_study_sets(self) -> None:
        text = '[set]\n"mesh.caverns" = { near = "1 m", cavern = [] }\n"motion.wave" = [{ part = "up" }]\n'
        self.study(text, text.replace("near", "size_near").replace("part", "surface_component"))
        text = '[vary]\n"region[0].element" = { values = ["full", "one-point"] }\n'
        self.study(text, text.replace("full", "full-integration").replace("one-point", "reduced-integration"))
        self.study("[set]\nmotion.process = []\n[row.set]\n", "[set]\nmotion.processing = []\n[row.set]\n")

    def test_paths_into_the_summary_have_their_new_names(self) -> None:
        for old, new in [
            ("trust[energy].value", "checks[energy].value"),
            ("trust[0].value", "checks[0].value"),
            ('"trust"[near_sides].numbers."a.b"', '"checks"[boundary_stress_change].numbers."a.b"'),
            ("trust[held_at_the_end].value", "checks[unreleased_force].value"),
            ("trust[interface_step_a_b].value", "checks[contact_frequency_step_a_b].value"),
            ("trust[interface_chosen_接缝_2].value", "checks[contact_penalty_compliance_接缝_2].value"),
            ("trust[interface_slip_near_sides].value", "checks[interface_slip_near_sides].value"),
            ("trust[interface_stepped].value", "checks[interface_stepped].value"),
            ("trust[monitors_on_broken_elements].note_said.slots.a", "checks[monitors_on_broken_elements].note_message.slots.a"),
            ("facts[quiet_drift].value", "facts[drift_without_motion].value"),
            ("outcome_said.pattern", "outcome_message.pattern"),
            ("defaulted[0].key", "defaults_used[0].key"),
            ("before[0]", "warnings[0]"),
            ("bare_si", "assume_si"),
            ("positions.before[0]", "monitor_positions.before[0]"),
            *((same, same) for same in ("damage.trust.volume", 'relative."A-B".u.max', "monitors.A_said.s1.max", "trusted")),
        ]:
            for quotes in ("'", "'''") if '"' in old else ("'", '"', '"""'):
                a, b = quotes + old + quotes, quotes + new + quotes
                with self.subTest(path=a):
                    self.study(f'[measure]\n"m" = {{ summary = {a}, over = {a} }}\n', f'[measure]\n"m" = {{ summary = {b}, over = {b} }}\n')
                    self.study(f"[measure.trust]\nunless = {a}  # c\n", f"[measure.trust]\nunless = {b}  # c\n")
        text = "[measure]\ntrust = { checks = 'passed', unit = 'bare_si', names = ['before'], table = 'trust' }\nbefore.column = 'trust'\n"
        self.study(text, text)

    def test_dip_directions_take_the_azimuth_of_the_case(self) -> None:
        self.write("case.toml", self.CASE + '[motion]\nmodel_x_azimuth = "30 deg"\n')
        layer, plane = '"mesh.caverns.layer[b].dip_{}"', '"mesh.plane[f].dip_{}"'
        for old, new in [
            (f'[set]\n{layer} = "10 deg"\n', '[set]\n{} = "20 deg"\n'),
            (f'[set]\n{plane} = "10 deg"\n', '[set]\n{} = "310 deg"\n'),
            (f'[vary]\n{layer} = {{ values = ["0 deg", "40 deg"] }}\n', '[vary]\n{} = {{ values = ["30 deg", "350 deg"] }}\n'),
            (
                f'[vary]\n{layer} = {{ range = {{ from = "0 deg", to = "40 deg", count = 3 }} }}\n',
                '[vary]\n{} = {{ range = {{ from = "30 deg", to = "-10 deg", count = 3 }} }}\n',
            ),
            (f'[vary]\n{layer} = {{ uniform = ["0 deg", "40 deg"] }}\n', '[vary]\n{} = {{ uniform = ["-10 deg", "30 deg"] }}\n'),
            (f'[vary]\n{plane} = {{ uniform = ["0 deg", "40 deg"] }}\n', '[vary]\n{} = {{ uniform = ["-60 deg", "-20 deg"] }}\n'),
            (
                f'[vary]\n{layer} = {{ normal = {{ mean = "9 deg", sd = "2 deg", min = "5 deg", max = "20 deg" }} }}\n',
                '[vary]\n{} = {{ normal = {{ mean = "21 deg", sd = "2 deg", min = "10 deg", max = "25 deg" }} }}\n',
            ),
        ]:
            with self.subTest(old=old):
                path = layer if "layer" in old else plane
                self.study(old.replace("_{}", "_direction"), new.format(path.format("azimuth")))
        varied = f'[vary]\n{plane.format("direction")} = {{ lognormal = {{ median = "9 deg", beta = 0.1 }} }}\n'
        err = self.refused(self.HEAD + varied, "study.toml")
        self.assertIn("study.toml:4: the distribution `lognormal` of `dip_direction` cannot be converted", err)
        self.write("case.toml", "broken")
        err = self.refused(self.HEAD + f'[set]\n{plane.format("direction")} = "1 deg"\n', "study.toml")
        self.assertIn("study.toml:4: the case of the study cannot be read", err)

    def test_a_study_that_turns_the_x_axis_of_a_case_with_planes_is_refused(self) -> None:
        text = self.HEAD + '[vary]\n"motion.model_x_azimuth" = { values = ["0 deg", "90 deg"] }\n'
        self.assertIn('"model_x_azimuth" = { values', self.converted(text, "study.toml"))
        self.write("case.toml", self.CASE + 'dip = "9 deg"\ndip_direction = "1 deg"\n')
        err = self.refused(text, "study.toml")
        self.assertIn("study.toml:4: `motion.model_x_azimuth`: `dip_azimuth` counts from north", err)
        self.assertIn("set each `dip_azimuth` beside it by hand", err)

    def test_a_dip_without_a_direction_is_refused(self) -> None:
        text = self.HEAD + '[set]\n"mesh.caverns.layer[b].dip" = "9 deg"\n'
        self.assertIn("Add its `dip_azimuth` to the case by hand", self.refused(text, "study.toml"))
        self.converted(text + '"mesh.caverns.layer[b].dip_direction" = "9 deg"\n', "study.toml")
        self.write("case.toml", self.CASE.replace('"b"', '"b"\ndip_azimuth = "1 deg"'))
        self.converted(text, "study.toml")

    def test_an_old_column_of_a_table_of_samples_is_refused(self) -> None:
        text = self.HEAD + '[sample]\nkind = "table"\nfile = "samples.csv"\n'
        self.write("samples.csv", "name,interface[a].friction,mesh.caverns.near [m]\nx,1,2\n")
        err = self.refused(text, "study.toml")
        self.assertIn("study.toml:5: `samples.csv`: the column `interface[a].friction` has an old name", err)
        self.assertIn("Write `interface[a].friction_coefficient` by hand", err)
        self.assertIn("Write `mesh.caverns.size_near` by hand", err)
        self.write("samples.csv", "name,interface[a].friction_coefficient\nx,1\n")
        self.converted(text, "study.toml")


class Repository(Folder):
    def test_the_files_of_the_repository_have_the_new_names(self) -> None:
        folders = ["cases", "crates/case/tests/cases", "crates/cli/src/commands", "crates/cli/tests/data", "fuzz/corpus"]
        files = [file for folder in folders for file in sorted((REPOSITORY / folder).rglob("*.toml"))]
        self.assertGreater(len(files), 15)
        self.assertEqual(self.run_on("--dry-run", *files), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
