//! What bolts remember, bolt by bolt among the numbers of their part: of the whole, of each link, of each point, and where the bar
//! is at each node of its chain.

/// The status of a link that was cut off by an excavation; below, as [`crate::bolts::SegmentState`] numbers them.
pub const CUT_OFF: f64 = 4.0;
pub const BROKEN: f64 = 3.0;
pub const YIELDED: f64 = 2.0;

/// What of the chain's matrix is remembered: it is eliminated; it has nothing that holds it.
pub const FACTORED: f64 = 1.0;
pub const NOT_LINEAR: f64 = 2.0;

macro_rules! remembered {
    ($(#[doc = $of:literal])+ $name:ident { $($(#[doc = $doc:literal])+ $field:ident,)+ }) => {
        $(#[doc = $of])+
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $name {
            $($(#[doc = $doc])+ pub $field: f64,)+
        }

        impl $name {
            /// How many numbers it takes.
            pub const NUMBERS: usize = [$(stringify!($field)),+].len();

            pub fn read(numbers: &[f64; Self::NUMBERS]) -> Self {
                let [$($field),+] = *numbers;
                $name { $($field),+ }
            }

            pub fn write(&self, numbers: &mut [f64; Self::NUMBERS]) {
                *numbers = [$(self.$field),+];
            }
        }
    };
}

remembered! {
    /// Of a bolt with a bond.
    WholeMemory {
        /// Largest force \[N\] that no law answers for, as the sliders had not settled.
        rest,
        /// Most passes that settled them.
        passes,
        /// [`FACTORED`], [`NOT_LINEAR`], or 0 if its matrix is to be eliminated first.
        factored,
    }
}

remembered! {
    /// Of a segment.
    LinkMemory {
        /// Elongation \[m\] at which it is without force.
        reference,
        /// Elongation \[m\] seen last.
        elongation,
        /// Plastic elongation \[m\].
        plastic,
        /// Tension \[N\].
        force,
        /// That of largest size since the stage began.
        largest,
        /// J
        dissipated,
        /// [`CUT_OFF`], [`BROKEN`], [`YIELDED`], or less.
        status,
        /// Tension \[N\] that is kept whatever the elongation; 0 for none.
        kept,
    }
}

remembered! {
    /// Of the bond at a point.
    PointMemory {
        /// Displacement \[m\] of the ground along the bar when the bolt was placed.
        reference,
        /// N/m
        stiffness,
        /// Force at which it slides \[N\].
        strength,
        /// Plastic slip \[m\] of the bar ahead of the ground.
        slip,
        /// Force on the ground along the bar \[N\].
        force,
        /// Largest size \[m\] of the slip, elastic part included.
        largest,
        /// J
        dissipated,
        /// 1 if it ever slid.
        slid,
    }
}

/// How the numbers of a bolt lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    bonded: bool,
    links: usize,
    points: usize,
}

impl Layout {
    pub fn of(bonded: bool, links: usize, points: usize) -> Self {
        Layout { bonded, links, points }
    }

    pub fn numbers(&self) -> usize {
        let links = self.links * LinkMemory::NUMBERS;
        match self.bonded {
            true => WholeMemory::NUMBERS + links + self.points * PointMemory::NUMBERS + 3 * (self.links + 1),
            false => links,
        }
    }

    /// The links and points of a bolt as it remembers them; no points without a bond.
    pub fn seen(&self, numbers: &[f64]) -> (WholeMemory, Vec<LinkMemory>, Vec<PointMemory>) {
        let mut numbers = numbers.to_vec();
        let memory = BoltMemory::of(self, &mut numbers);
        let links = memory.links.iter().map(LinkMemory::read).collect();
        (memory.whole(), links, memory.points.iter().map(PointMemory::read).collect())
    }
}

/// The numbers of a bolt.
pub struct BoltMemory<'n> {
    whole: &'n mut [f64],
    pub links: &'n mut [[f64; LinkMemory::NUMBERS]],
    /// None without a bond.
    pub points: &'n mut [[f64; PointMemory::NUMBERS]],
    /// Displacement \[m\] of the bar along its axis at the nodes of its chain since it was placed; none without a bond.
    pub bar: &'n mut [f64],
    /// Of each node, what couples it to the next after the elimination, and one over its pivot; none without a bond.
    pub factors: &'n mut [[f64; 2]],
}

impl<'n> BoltMemory<'n> {
    pub fn of(layout: &Layout, numbers: &'n mut [f64]) -> Self {
        let (whole, numbers) = numbers.split_at_mut(if layout.bonded { WholeMemory::NUMBERS } else { 0 });
        let (links, numbers) = numbers.split_at_mut(layout.links * LinkMemory::NUMBERS);
        let bonded = if layout.bonded { layout.points } else { 0 };
        let (points, nodes) = numbers.split_at_mut(bonded * PointMemory::NUMBERS);
        let (bar, factors) = nodes.split_at_mut(nodes.len() / 3);
        let (links, points) = (links.as_chunks_mut().0, points.as_chunks_mut().0);
        BoltMemory { whole, links, points, bar, factors: factors.as_chunks_mut().0 }
    }

    pub fn clear(&mut self) {
        self.whole.fill(0.0);
        self.links.as_flattened_mut().fill(0.0);
        self.points.as_flattened_mut().fill(0.0);
        self.bar.fill(0.0);
    }

    pub fn whole(&self) -> WholeMemory {
        self.whole.first_chunk().map(WholeMemory::read).unwrap_or_default()
    }

    pub fn set_whole(&mut self, whole: WholeMemory) {
        if let Some(numbers) = self.whole.first_chunk_mut() {
            whole.write(numbers);
        }
    }

    pub fn set_factored(&mut self, factored: f64) {
        let whole = WholeMemory { factored, ..self.whole() };
        self.set_whole(whole);
    }

    pub fn link(&self, k: usize) -> LinkMemory {
        LinkMemory::read(&self.links[k])
    }

    pub fn set_link(&mut self, k: usize, link: &LinkMemory) {
        link.write(&mut self.links[k]);
    }

    pub fn point(&self, k: usize) -> PointMemory {
        PointMemory::read(&self.points[k])
    }

    pub fn set_point(&mut self, k: usize, point: &PointMemory) {
        point.write(&mut self.points[k]);
    }
}
