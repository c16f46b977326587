//! Elasticity of what damage has left: the K of Rayleigh's ξK in bodies that lose stiffness.

use tremolite_laws::materials::Elastic;
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Parameter, Point, Sym, Values};

/// Columns of what is left at a point: V ([`Material::integrity`]), then the share against hourglass modes.
pub(super) const LEFT: usize = 7;

const fn column(name: &'static str) -> Column {
    Column::new(name, "1", "what damage has left")
}

/// The law; its history holds what is left, and stays as it is.
pub(super) struct Weakened(pub Moduli);

impl Material for Weakened {
    const NAME: &'static str = "weakened";
    const SUMMARY: &'static str = "elasticity of what damage has left";
    const SOURCE: &'static str = "wang2018, damage of (7) on the damping of (19)";
    const PARAMETERS: &'static [Parameter] = Elastic::PARAMETERS;
    const HISTORY: &'static [Column] = &[
        column("left_xx"),
        column("left_yy"),
        column("left_zz"),
        column("left_xy"),
        column("left_yz"),
        column("left_zx"),
        column("left_hourglass"),
    ];
    type History<L: Lane> = [L; LEFT];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Elastic::new(values).map(|law| Weakened(law.moduli()))
    }

    fn moduli(&self) -> Moduli {
        self.0
    }

    fn scaled(&self, factor: f64) -> Self {
        Weakened(self.0.scaled(factor))
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, left: &[L; LEFT]) -> L {
        left[LEFT - 1]
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, e: Sym<L>, left: [L; LEFT]) -> (Sym<L>, [L; LEFT]) {
        let v = [left[0], left[1], left[2], left[3], left[4], left[5]];
        (self.0.stress_left(&e, &v), left)
    }
}
