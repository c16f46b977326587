//! The seam for interface laws: tractions between two surfaces from their gap and slip.

use crate::lane::Lane;
use crate::material::History;
use crate::parameter::{BadParameter, Choice, Column, LawInfo, Parameter, Values};

/// What a pair does, as its law's state column says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum PairState {
    /// The bond holds.
    Bonded = 0,
    /// The bond is broken, the pair closed, and friction holds.
    Stuck = 1,
    /// It slides.
    Sliding = 2,
    /// It is open and carries nothing.
    Open = 3,
}

impl PairState {
    pub const ALL: [PairState; 4] =
        [PairState::Bonded, PairState::Stuck, PairState::Sliding, PairState::Open];

    /// The word for people.
    pub const fn word(self) -> &'static str {
        match self {
            PairState::Bonded => "bonded",
            PairState::Stuck => "stuck",
            PairState::Sliding => "sliding",
            PairState::Open => "open",
        }
    }

    /// What it says of the pair.
    pub const fn meaning(self) -> &'static str {
        match self {
            PairState::Bonded => "the bond holds",
            PairState::Stuck => "the bond is broken, the pair closed, and friction holds",
            PairState::Sliding => "it slides",
            PairState::Open => "it is open and carries nothing",
        }
    }

    /// As the law's column and result files have it.
    pub const fn number(self) -> f64 {
        self as u8 as f64
    }
}

/// An interface law, per area of the interface.
///
/// The relative displacement d of the second side against the first has the gap g = d·m \[m\] (positive when open; m points
/// out of the first side into the second) and the slip s \[m\] along two tangents. The traction on the second side is
/// p m + t with the pressure p \[Pa\] positive in compression, and on the first side the opposite. So the work done by the
/// interface on the bodies is p Δg + t·Δs, and a shear t opposes the slip that caused it.
///
/// Written in [`Lane`] operations alone, as [`crate::Material`] is. There is no time in it. All that a law must remember, the
/// gap and slip that it saw last among it, is in its history; a history of zeros is that of a pair that was just made, without
/// traction.
pub trait Interface: Send + Sync + Sized + 'static {
    /// The word after `law =` in a case.
    const NAME: &'static str;
    /// One line for `tremolite list interfaces`.
    const SUMMARY: &'static str;
    /// Key of references.bib and equations.
    const SOURCE: &'static str;
    const PARAMETERS: &'static [Parameter];
    const HISTORY: &'static [Column];
    /// Column of the [`PairState`].
    const STATE: usize;
    /// Columns that are 1 once the pair has slid, and once it has opened.
    const SLID: usize;
    const OPENED: usize;
    /// Column in which the law books what friction and breaking bonds have taken \[J/m²\].
    const DISSIPATION: usize;
    /// Column in which the law books what it has given out beyond what it took \[J/m²\]; negative where it took it.
    const CREATION: usize;
    /// One lane per entry of `HISTORY`.
    type History<L: Lane>: History<L>;

    /// A checked instance.
    ///
    /// # Errors
    /// Every value the law refuses.
    fn new(values: &Values) -> Result<Self, Vec<BadParameter>>;

    /// The values with what a model knows better than the law filled in: what [`crate::parameter::Need::Chosen`] leaves open, so
    /// that no state is stiffer than the choice, and the pressure from which on the law goes straight. Given values stay as they
    /// are, and may leave a state that is stiffer.
    fn chosen(values: &Values, choice: &Choice) -> Values;

    /// Normal and tangential stiffness \[Pa/m\] at a pressure \[Pa\].
    fn stiffness(&self, pressure: f64) -> [f64; 2];

    /// The stiffest that any state can be, normal and tangential \[Pa/m\]: the step goes by it.
    fn stiffest(&self) -> [f64; 2];

    /// The pressure \[Pa\] from which on the law is straight for the sake of the step, where there is one.
    fn straight_from(&self) -> Option<f64> {
        None
    }

    /// The largest closure T \[m\], of a law that has one.
    fn closure_limit(&self) -> Option<f64> {
        None
    }

    /// What is unusual about the parameters though the law accepts them, a sentence each.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    /// The gap \[m\] and history of a pair that begins with a pressure and shear t \[Pa\]: updated at this gap and no slip it
    /// answers with just these, as long as they are within its strength. A tension beyond it is gone: the pair begins open.
    fn start(&self, pressure: f64, shear: [f64; 2]) -> (f64, Self::History<f64>);

    /// Pressure, shear t \[Pa\] and new history for a gap and slip \[m\].
    fn update<L: Lane>(
        &self,
        gap: L,
        slip: [L; 2],
        history: Self::History<L>,
    ) -> (L, [L; 2], Self::History<L>);

    /// Energy \[J/m²\] that the pair would give back, at a gap and with a shear t that [`Interface::update`] answered with
    /// this history.
    fn stored_energy<L: Lane>(&self, gap: L, shear: [L; 2], history: &Self::History<L>) -> L;
}

impl LawInfo {
    /// The description of interface law `I`.
    pub const fn of_interface<I: Interface>() -> Self {
        LawInfo {
            name: I::NAME,
            summary: I::SUMMARY,
            source: I::SOURCE,
            parameters: I::PARAMETERS,
            history: I::HISTORY,
            pressure_dependent: false,
            damages: false,
            check: |values| I::new(values).map(|_| ()),
            chosen: I::chosen,
        }
    }
}
