//! What the fields of the result files are called on the page.

use crate::language::{Language, say};

/// A field in words; its name where it is not known.
pub fn label(language: Language, name: &str) -> String {
    match name {
        "s1" => say!(language, "largest principal stress s1"),
        "s3" => say!(language, "smallest principal stress s3"),
        "p" => say!(language, "pressure of the water p"),
        "s1_eff" => say!(language, "largest effective principal stress"),
        "s3_eff" => say!(language, "smallest effective principal stress"),
        "s1_max" => say!(language, "largest s1 so far"),
        "s3_min" => say!(language, "smallest s3 so far"),
        "displacement_max" => say!(language, "largest displacement so far"),
        "d_tension" => say!(language, "damage in tension"),
        "d_shear" => say!(language, "damage in shear"),
        "d_b" => say!(language, "mean damage D_b now: closed cracks count less"),
        "d_b_max" => say!(language, "largest mean damage D_b so far"),
        "crack_opening" => say!(language, "widest crack so far"),
        "crack_across" => say!(language, "widest crack across bars so far"),
        "crack_direction" => say!(language, "which way the widest crack runs"),
        "plastic_shear_strain" => say!(language, "plastic shear strain"),
        "plastic_tension_strain" => say!(language, "plastic tension strain"),
        "plastic_state" => say!(language, "plastic state"),
        "plastic_exx" => say!(language, "plastic strain along x"),
        "plastic_eyy" => say!(language, "plastic strain along y"),
        "plastic_ezz" => say!(language, "plastic strain along z"),
        "plastic_gxy" => say!(language, "plastic shear strain in xy"),
        "plastic_gyz" => say!(language, "plastic shear strain in yz"),
        "plastic_gzx" => say!(language, "plastic shear strain in zx"),
        "gap" => say!(language, "gap now"),
        "gap_max" => say!(language, "largest gap so far"),
        "slip_max" => say!(language, "largest slip so far"),
        "pressure" => say!(language, "pressure now"),
        "pressure_max" => say!(language, "largest pressure so far"),
        "state" => say!(language, "state of the interface"),
        "slid" => say!(language, "slid so far (1)"),
        "opened" => say!(language, "opened so far (1)"),
        "area" => say!(language, "area of a pair"),
        _ => name.into(),
    }
}
