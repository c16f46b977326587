//! Who has what: what a rank does not have it does not know, what is counted is what is sent, and all have as much to do.

use crate::block::block;
use crate::damage::concrete;
use crate::poison::OneSided;
use crate::ranks::{Case, how, shaken, through};
use crate::ready::Ready;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use tremolite::simulation::{Built, Start};
use tremolite::{Base, Division, Layers, Member, Model, Quadrature, Side};
use tremolite_results::ResultFolder;

/// Both ends of the block are on different ranks: it is so long that it is cut across.
#[test]
fn what_a_part_did_not_name_its_rank_does_not_have() {
    let far = |named: bool| {
        let mut problem = shaken(block([3, 3, 24]));
        problem.patch_elements = Some(8);
        problem.base = Base::Viscous;
        problem.parts = vec![Arc::new(move |_: &_, engine_node: &[u32]| {
            let [first, .., last] = engine_node else { panic!("a mesh has nodes") };
            let part = OneSided { nodes: [*first], other: *last, named };
            Member::new("one-sided", Box::new(part))
        })];
        Case::new(problem, &[], 0.006)
    };
    for named in [true, false] {
        let case = far(named);
        let whole = case.alone();
        let start = |folder: &ResultFolder, ranks| through(case.simulation(folder, Start::Rest, ranks));
        let other = catch_unwind(AssertUnwindSafe(|| case.among(how(3, 1, false), start).0));
        assert_eq!(other.is_ok_and(|other| other.1 == whole.1), named);
    }
}

/// The division's own counts are what is sent.
#[test]
fn what_is_exchanged_is_what_the_division_says() {
    let mut problem = shaken(block([6, 5, 14]));
    problem.sides = [Side::FreeField; 2];
    let case = Case::new(problem, &[], 0.012);
    let took = case.holds("counted", &[how(3, 1, false)]);
    let Built { model, assembly, phase, .. } = &case.built;
    let division = Division::even(model, assembly, 3);
    for (rank, took) in (0..).zip(took) {
        let own = phase.of_rank(model, assembly, &division, rank);
        let bytes = 8 * own.ours.as_ref().unwrap().halos[0].halo.words()[0] as u64;
        assert!(bytes > 0 && took.bytes == bytes * took.halos, "{rank}: {took:?}, {bytes}");
    }
    assert!(division.imbalance < 1.2, "{:?}", division.weights);
}

/// How much longer than without waiting a step of the coarsest level takes, if ranks have these patches: in each step of the finest all wait for the one
/// with most elements due.
fn waited(model: &Model, ranks: u32, of: impl Fn(usize) -> u32) -> f64 {
    let coarsest = model.nodes.coarsest();
    let (mut slowest, mut all) = (0.0, 0.0);
    for step in 0..1u32 << coarsest {
        let due = step.trailing_zeros().min(coarsest.into());
        let mut each = vec![0; ranks as usize];
        for (p, patch) in model.patches.iter().enumerate().filter(|(_, patch)| u32::from(patch.level) <= due)
        {
            each[of(p) as usize] += patch.elements.len();
        }
        slowest += each.iter().copied().max().unwrap_or(0) as f64;
        all += each.iter().sum::<usize>() as f64;
    }
    f64::from(ranks) * slowest / all
}

/// A ninth of a column has fine elements, which are due eight times where the others are due once: cut into equal work in all, one of two ranks has
/// the fine ones, the other all else, and they wait for each other in turn.
#[test]
fn ranks_are_even_on_each_level_of_steps() {
    let mut problem = shaken(block([6, 5, 72]));
    problem.patch_elements = Some(8);
    // All elements cost the same.
    problem.bodies[1].quadrature = problem.bodies[0].quadrature;
    let ready = Ready::new(problem).levelled(|[_, _, z]| if z < 14.0 / 9.0 { 0 } else { 3 });
    let Ready { model, assembly, .. } = ready;
    assert_eq!(model.nodes.coarsest(), 3);
    let height = |p: &usize| {
        let elements = model.patches[*p].elements.iter();
        elements.map(|&e| tremolite::hexahedra::centroid(&model.mesh, e)[2]).fold(0.0, f64::max)
    };
    let mut upwards: Vec<usize> = (0..model.patches.len()).collect();
    upwards.sort_by(|a, b| height(a).total_cmp(&height(b)));
    let work = |p: usize| (model.patches[p].elements.len() << (3 - model.patches[p].level)) as f64;
    let whole: f64 = upwards.iter().map(|&p| work(p)).sum();
    for ranks in [2, 3, 4] {
        let mut in_all = vec![0; upwards.len()];
        let mut sum = 0.0;
        for &p in &upwards {
            sum += work(p);
            in_all[p] = ((sum - 0.5 * work(p)) / whole * f64::from(ranks)) as u32;
        }
        let division = Division::even(&model, &assembly, ranks);
        let even = waited(&model, ranks, |p| division.of_member[assembly.of_patch[p] as usize]);
        let uneven = waited(&model, ranks, |p| in_all[p]);
        println!("{ranks} ranks: {even}, {} by its own count; equal in all {uneven}", division.imbalance);
        assert!(even < 1.2 && division.imbalance < 1.2, "{ranks} ranks: {even}, {}", division.imbalance);
        assert!(uneven > 1.6, "{ranks} ranks with equal work in all: {uneven}");
    }
}

/// Either of two linings may crack alone, which leaves no rank to wait much, as a cut between them would.
#[test]
fn ranks_stay_even_where_one_lining_cracks_before_the_other() {
    let mut problem = shaken(block([12, 5, 12]));
    problem.patch_elements = Some(8);
    let middle = |e: u32| tremolite::hexahedra::centroid(&problem.mesh, e)[0];
    let [left, right] = [1.0, 8.0].map(|from| {
        (0..problem.mesh.elements.len() as u32)
            .filter(|&e| (from..from + 3.0).contains(&middle(e)))
            .collect::<Vec<u32>>()
    });
    let linings: Vec<u32> = left.iter().chain(&right).copied().collect();
    let mut lining = problem.bodies[1].clone();
    lining.name = "lining".into();
    lining.material = concrete(5e3, "effective");
    // As dear as linings are beside rock.
    lining.quadrature = Quadrature::Layered(Layers::Nine);
    problem.bodies.iter_mut().for_each(|body| body.elements.retain(|e| !linings.contains(e)));
    lining.elements = linings;
    problem.bodies.push(lining);
    let Ready { model, assembly, .. } = Ready::new(problem);
    // Among three ranks of so small a model what two move costs more than a lining that cracks alone, which leaves 1.21.
    let ranks = 2;
    let division = Division::even(&model, &assembly, ranks);
    for lining in [&left, &right] {
        let mut each = [0usize; 2];
        for (p, patch) in model.patches.iter().enumerate() {
            let inside = patch.elements.iter().filter(|e| lining.contains(e)).count();
            each[division.of_member[assembly.of_patch[p] as usize] as usize] += inside;
        }
        println!("{each:?}; {} to {}", division.imbalance, division.imbalance_cracked);
        assert!(2 * each.iter().max().unwrap() < 3 * lining.len() / 2, "{each:?}");
    }
    assert!(division.imbalance_cracked < 1.2, "{}", division.imbalance_cracked);
}
