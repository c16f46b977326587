//! What holds a model before the shaking.

/// The sides and the base before the shaking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bed {
    /// Whether the sides normal to x and to y stand on rollers, where they are neither periodic nor fixed; else nothing holds them.
    pub rollers: [bool; 2],
    pub base: Footing,
}

impl Default for Bed {
    /// That of ground: rollers, and a base that is held.
    fn default() -> Self {
        Bed { rollers: [true; 2], base: Footing::Fixed }
    }
}

impl Bed {
    /// That of a specimen, which only what is prescribed holds.
    pub const NONE: Bed = Bed { rollers: [false; 2], base: Footing::Free };
}

/// What holds the base before the shaking.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Footing {
    #[default]
    Fixed,
    /// Held along z.
    Roller,
    Free,
}

impl Footing {
    /// The components that are held.
    pub fn held(self) -> Option<[bool; 3]> {
        match self {
            Footing::Fixed => Some([true; 3]),
            Footing::Roller => Some([false, false, true]),
            Footing::Free => None,
        }
    }
}
