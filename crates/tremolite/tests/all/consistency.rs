//! Parts agree with themselves: K w with their forces, the work that they book with what they hold.

use crate::block::block;
use crate::contact::between;
use crate::outside_part::on_springs;
use crate::ready::Ready;
use tremolite::parts::{Kept, Motion, Own, Scratch, StateSizes, Tick};
use tremolite::{Base, Booked, Interface, Line, Lines, Member, Problem, Side};
use tremolite_laws::{Octet, Row};

/// A member's forces and the work it books, with a memory of its own.
struct Alone<'a> {
    member: &'a Member,
    history: Vec<Octet>,
    overstress: Vec<Octet>,
    numbers: Vec<f64>,
}

impl<'a> Alone<'a> {
    fn new(member: &'a Member) -> Self {
        let StateSizes { history, overstress, numbers } = member.part.state_sizes();
        Alone {
            member,
            history: vec![Octet::ZERO; history],
            overstress: vec![Octet::ZERO; overstress],
            numbers: vec![0.0; numbers],
        }
    }

    fn forces(&mut self, u: &[Row], du: &[Row]) -> (Vec<Row>, Lines) {
        let mut out = vec![Row::ZERO; self.member.part.nodes().len()];
        let own = Own {
            history: &mut self.history,
            overstress: &mut self.overstress,
            numbers: &mut self.numbers,
            reference: &mut [],
            initial: &[],
        };
        let tick = Tick { time: 0.05, dt: 1e-5, step: 0 };
        let work =
            self.member.part.forces(&tick, &Motion::new(u, du), own, &mut out, &mut Scratch::default());
        (out, work)
    }

    fn energy(&self, u: &[Row], du: &[Row]) -> Lines {
        let kept = Kept { history: &self.history, numbers: &self.numbers, reference: &[], initial: &[] };
        self.member.part.energy(&Motion::new(u, du), kept)
    }
}

/// From u to u + w, both random on the user's nodes: forces change by K w, and springs book ½(f + f′)·w, which for
/// linear ones is the change of what they say they hold, in the same line.
fn agrees(problem: Problem) {
    let ready = Ready::new(problem);
    let mut seed = 7_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        1e-4 * ((seed >> 33) as f64 / f64::from(1 << 30) - 1.0)
    };
    // The reference column stays: springs see what moves against it.
    let mut rows = || -> Vec<Row> {
        let counted = |n: usize| ready.model.nodes.counts(n);
        (0..ready.phase.mass.len())
            .map(|n| if counted(n) { Row::new([random(), random(), random()]) } else { Row::ZERO })
            .collect()
    };
    let (u, w) = (rows(), rows());
    let next: Vec<Row> = u.iter().zip(&w).map(|(u, w)| Row([0, 1, 2, 3].map(|i| u.0[i] + w.0[i]))).collect();
    let mut springs = 0;
    for &m in &ready.phase.active {
        let member = &ready.assembly.members[m as usize];
        let mut alone = Alone::new(member);
        let (before, _) = alone.forces(&u, &u);
        let held = alone.energy(&u, &u);
        let (after, work) = alone.forces(&next, &w);
        let gained = alone.energy(&next, &w);
        let mut product = vec![Row::ZERO; before.len()];
        member.part.stiffness_times(&w, &mut product, &mut Scratch::default());
        let most = after.iter().flat_map(|f| f.0).fold(1.0_f64, |m, f| m.max(f.abs()));
        for ((a, b), k) in after.iter().zip(&before).zip(&product) {
            for i in 0..3 {
                assert!((a.0[i] - b.0[i] - k.0[i]).abs() < 1e-9 * most, "{}: {a:?} {b:?} {k:?}", member.name);
            }
        }
        for &line in Line::ALL.iter().filter(|line| line.booked() == Booked::Work && line.sign() > 0.0) {
            let change = gained[line] - held[line];
            let most = gained[line].abs().max(held[line].abs());
            assert!((work[line] - change).abs() <= 1e-9 * most, "{}: {line:?}", member.name);
            springs += usize::from(change != 0.0);
        }
        // A bonded joint of constant stiffness is a spring as well; what it holds is a line that is looked at.
        let work: f64 = (0..before.len())
            .map(|k| {
                let node = member.part.nodes()[k] as usize;
                (0..3).map(|i| 0.5 * (before[k].0[i] + after[k].0[i]) * w[node].0[i]).sum::<f64>()
            })
            .sum();
        if member.name.contains("joint") {
            let change = gained[Line::Interface] - held[Line::Interface];
            let most = gained[Line::Interface].max(held[Line::Interface]);
            assert!((work - change).abs() <= 1e-9 * most, "{}: {work} J, {change} J", member.name);
            springs += usize::from(change != 0.0);
        }
    }
    assert!(springs > 0, "a part with springs was looked at");
}

#[test]
fn parts_push_as_their_stiffness_says_and_book_what_they_then_hold() {
    for side in Side::EXAMPLES {
        let mut problem = block([5, 4, 6]);
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
        problem.sides = [side; 2];
        agrees(problem);
    }
    agrees(on_springs(1e7));
    let mut problem = block([5, 4, 6]);
    problem.base = Base::Viscous;
    let strong = [("normal_stiffness", 3e9), ("friction_coefficient", 0.5), ("cohesion", 1e12)];
    // What goes by the rate of strain has no part in the stiffness.
    let joint = Interface { viscosity: 0.0, ..between(&problem, [1, 0], "coulomb", &strong) };
    problem.interfaces = vec![joint];
    agrees(problem);
}
