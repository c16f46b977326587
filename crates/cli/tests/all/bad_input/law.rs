//! Slips in a file of one law, and in limits of acceptance.

use super::{Row, refusals_of, row};
use tremolite_case::{LawFile, Limits};
use tremolite_laws::materials::MATERIALS;

const SOUND: &str = include_str!("../../../../../cases/laws/concrete.toml");

#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("[material]", "[materials]", 1, "there is no material and no interface", "write [material] or [interface]"),
    row("law = \"concrete-damage\"", "law = \"concrete-damge\"", 3, "`law` cannot be \"concrete-damge\"", "did you mean \"concrete-damage\"?"),
    row("young = \"25 GPa\"", "young = \"25 kN/m3\"", 4, "a stress or modulus is expected", "such as \"10 GPa\""),
    row("young = \"25 GPa\"", "young = \"0 GPa\"", 4, "`young` must be positive", "is usual"),
    row("poisson = 0.17", "poisson = 0.5", 5, "`poisson` must be at least 0 and below 0.5", "0.15 to 0.35 is usual"),
    row("tensile_strength = \"1.2 MPa\"", "tensile_strength = \"1.2 MPa\"\ngrade = \"C1\"", 7, "`grade` cannot be \"C1\"", "C25/30"),
    row("friction_angle = \"46 deg\"", "friction_angle = \"46 rad\"", 8, "`friction_angle` must be from 0 to 89.9 deg", "give a value in that range"),
    row("residual_tension = 0.1", "residual_tension = 0", 11, "`residual_tension` must be above 0 and at most 1", "give a value in that range"),
    row("ultimate_strain_ratio = 10.0", "ultimate_strain_ratio = 1", 13, "`ultimate_strain_ratio` must be above 1", "10 is usual"),
    row("rate = \"none\"", "rate = \"mc1990\"", 14, "`rate` cannot be \"mc1990\"", "mc90"),
];

const LIMITS: &str = "displacement = \"50 mm\"\ncrack_width = \"1 mm\"\ndamage = 0.5\n";

#[rustfmt::skip]
const OF_LIMITS: &[Row] = &[
    row("50 mm", "50 MPa", 1, "a length is expected", "write a length"),
    row("50 mm", "-50 mm", 1, "`displacement` must be", "give a value"),
    row("crack_width", "crack_with", 2, "`crack_with` is no key", "did you mean `crack_width`?"),
    row("damage = 0.5", "damage = 5", 3, "`damage` must be", "give a value"),
];

#[test]
fn each_slip_in_a_law_file_is_told_with_its_line_and_a_way_out() {
    refusals_of("law.toml", SOUND, ROWS, |path, text| {
        LawFile::parse(path, text, MATERIALS).map(drop).map_err(|report| report.render(false))
    });
}

#[test]
fn each_slip_in_a_file_of_limits_is_told_with_its_line_and_a_way_out() {
    refusals_of("limits.toml", LIMITS, OF_LIMITS, |path, text| {
        Limits::parse(path, text).map(drop).map_err(|report| report.render(false))
    });
}
