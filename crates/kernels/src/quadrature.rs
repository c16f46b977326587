//! How an element is integrated.

/// Points of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quadrature {
    /// One point and elastic stabilisation: fast, for rock.
    OnePoint,
    /// 2×2×2 points: sees bending cracks through a thickness, for linings.
    Full,
}

impl Quadrature {
    /// Integration points in an element.
    pub const fn points(self) -> usize {
        match self {
            Quadrature::OnePoint => 1,
            Quadrature::Full => 8,
        }
    }
}
