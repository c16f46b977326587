//! The lines of the energy balance: one list, by which parts, the engine, `energy.csv` and the summary go.

use std::ops::{Add, Index, IndexMut};

/// Who finds the value of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Booked {
    /// The node pass, from velocities at one time.
    Motion,
    /// Parts, when they are looked at: what they would give back.
    Stored,
    /// Parts, when they are looked at: what they have dissipated or created since the start.
    Spent,
    /// Parts, step by step: work of their forces on the nodes, positive where energy flows from the nodes into the part.
    Work,
    /// The node pass, step by step: work against forces that go by velocity, and where levels of steps meet.
    Damping,
    /// The start of the run.
    Start,
    /// Nobody: what the other lines leave.
    Rest,
}

macro_rules! lines {
    ($($(#[doc = $doc:literal])+ $line:ident = $name:literal, $sign:literal, $booked:ident;)+) => {
        /// A line of the balance \[J\].
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Line {
            $($(#[doc = $doc])+ $line,)+
        }

        impl Line {
            /// All lines, in the order of `energy.csv`.
            pub const ALL: &[Line] = &[$(Line::$line),+];

            /// The word in `energy.csv` and in `summary.json`.
            pub const fn name(self) -> &'static str {
                match self { $(Line::$line => $name,)+ }
            }

            /// How the line enters the sum whose value is the error.
            pub const fn sign(self) -> f64 {
                match self { $(Line::$line => $sign,)+ }
            }

            /// Who finds its value.
            pub const fn booked(self) -> Booked {
                match self { $(Line::$line => Booked::$booked,)+ }
            }
        }
    };
}

impl Line {
    /// Whether it is a line of interfaces, which a model without any has not.
    pub const fn of_interfaces(self) -> bool {
        matches!(self, Line::Interface | Line::Friction | Line::CreatedByInterface | Line::ContactDamping)
    }

    /// Whether it is a line of water that cannot leave its pores, which a model without any has not.
    pub const fn of_pores(self) -> bool {
        matches!(self, Line::PoreWater)
    }

    /// Whether it is a line of bolts, which a model without any has not.
    pub const fn of_bolts(self) -> bool {
        matches!(self, Line::Bolts | Line::BoltFriction | Line::BoltPlastic)
    }
}

lines! {
    /// ½vᵀMv at v̂.
    Kinetic = "kinetic", 1.0, Motion;
    /// What elements would give back: ∫ [`tremolite_laws::Material::stored_energy`].
    Strain = "strain", 1.0, Stored;
    /// Held by the stabilisation of one-point elements.
    Hourglass = "hourglass", 1.0, Stored;
    /// Taken by damage and plastic flow, as laws book it step by step.
    Dissipated = "dissipated", 1.0, Spent;
    /// Given out by laws that have no potential, as they book it.
    Created = "created_by_law", -1.0, Spent;
    /// Taken by damping over a band, as its bodies book it step by step.
    Band = "band_damping", 1.0, Spent;
    /// Taken by artificial viscosity.
    Viscosity = "artificial_viscosity", 1.0, Work;
    /// Taken by water that cannot leave its pores and by what its pressure does to the grains, beyond what they took at the start.
    PoreWater = "pore_water", 1.0, Work;
    /// What pairs of interfaces would give back.
    Interface = "interface", 1.0, Stored;
    /// Taken by friction and breaking bonds of interfaces, as their laws book it.
    Friction = "friction", 1.0, Spent;
    /// Given out by interface laws whose shear stiffness goes by the closure, as they book it; negative where they took it.
    CreatedByInterface = "created_by_interface", -1.0, Spent;
    /// Taken by the dashpots of closed pairs whose bond is broken.
    ContactDamping = "contact_damping", 1.0, Work;
    /// What bolts and their bonds would give back.
    Bolts = "bolts", 1.0, Stored;
    /// Taken by bonds of bolts that slide.
    BoltFriction = "bolt_friction", 1.0, Spent;
    /// Taken by bolts that yield and break.
    BoltPlastic = "bolt_plastic", 1.0, Spent;
    /// Taken by Rayleigh damping.
    Rayleigh = "rayleigh_damping", 1.0, Damping;
    /// Taken by the dashpots of the base.
    BaseDashpots = "base_dashpots", 1.0, Damping;
    /// Taken by the dashpots of the sides.
    SideDashpots = "side_dashpots", 1.0, Damping;
    /// Taken where parts push nodes with longer steps than their own: what these are pushed with between their own times.
    Levels = "levels", 1.0, Damping;
    /// Work into springs of the boundary, and what they held at the start.
    Springs = "base_springs", 1.0, Work;
    /// Work through free-field sides on the model: of what the slabs pass on beyond what they did at the start, and of the
    /// dashpots between.
    FreeField = "free_field", -1.0, Work;
    /// Work of incident waves and loads on the model.
    Input = "input", -1.0, Work;
    /// Work on the model of forces that a program or a script adds of its own; negative where they take energy.
    Own = "own_forces", -1.0, Work;
    /// Energy that the run started with.
    Initial = "initial", -1.0, Start;
    /// What is found less what was put in: the sum of all other lines with their signs.
    Error = "error", 0.0, Rest;
}

/// A value \[J\] for each line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines([f64; Line::ALL.len()]);

impl Default for Lines {
    fn default() -> Self {
        Lines([0.0; Line::ALL.len()])
    }
}

impl Lines {
    /// Lines with their values, in the order of [`Line::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Line, f64)> + '_ {
        Line::ALL.iter().map(|&line| (line, self[line]))
    }

    /// Every value, in the order of [`Line::ALL`].
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.0.iter_mut()
    }

    /// Sum of the lines with their signs, in the order of the list.
    pub fn sum(&self) -> f64 {
        Line::ALL.iter().fold(0.0, |sum, &line| sum + line.sign() * self[line])
    }
}

impl Index<Line> for Lines {
    type Output = f64;
    fn index(&self, line: Line) -> &f64 {
        &self.0[line as usize]
    }
}

impl IndexMut<Line> for Lines {
    fn index_mut(&mut self, line: Line) -> &mut f64 {
        &mut self.0[line as usize]
    }
}

impl Add for Lines {
    type Output = Lines;
    fn add(mut self, more: Lines) -> Lines {
        for (a, b) in self.0.iter_mut().zip(more.0) {
            *a += b;
        }
        self
    }
}
