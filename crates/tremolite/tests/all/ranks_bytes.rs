//! A rank holds its share of parts and of what they remember, and what is on every rank besides is known.

use crate::bolts_bits::bolted_of;
use crate::ranks::plan;
use crate::ranks_pit::pit_of;
use crate::ready::Ready;
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::simulation::{Built, Go, Simulation, StageEnd, Start, Stepping};
use tremolite::{Bytes, Division, Engine, Loopback, Ranks};
use tremolite_laws::Isa;
use tremolite_results::ResultFolder;

/// Bytes over so many ranks that one may hold: what is beyond 1 is the patches' unequal memory and contributions of others.
const MOST: f64 = 1.3;

/// Through all stages, as far as a few cycles bring each, and a step of the shaking.
fn held(mut simulation: Simulation) -> Bytes {
    while simulation.stage().is_some() {
        assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
    }
    assert_eq!(simulation.step(1).unwrap(), Stepping::On);
    simulation.bytes().unwrap()
}

#[test]
fn a_rank_holds_its_share_of_parts_and_memory() {
    let mut problem = pit_of(bolted_of(Isa::best(), [14, 12, 20]));
    problem.patch_elements = Some(32);
    let mut plan = plan(&problem, &["start", "bolts", "pit"], 0.012);
    let release = Release { cycles: 3, tolerance: [1e9; 2], ..Release::default() };
    plan.stages.iter_mut().for_each(|stage| stage.release = release);
    let Ready { model, assembly, phase } = Ready::new(problem);
    let built = Built::of(&model, &assembly, &phase);
    let run = |ranks: Option<Arc<Ranks>>, results: &ResultFolder| {
        held(Simulation::among(&built, &plan, results, Start::Rest, Vec::new(), ranks).unwrap())
    };
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "bytes", true).unwrap();
    let alone = run(None, &results);
    println!("{} elements, {} nodes", model.mesh.elements.len(), model.nodes.len());
    assert!(alone.parts > 0 && alone.memory > alone.parts && alone.pushes > 0, "{alone:?}");
    for ranks in [2, 4] {
        let division = Division::even(&model, &assembly, ranks);
        // With the parts of all, a rank holds more than its share, which is then seen.
        let first = Arc::new(Loopback::ranks(ranks).remove(0));
        let rank = Arc::new(Ranks::new(first, division.clone()));
        let all = Engine::among(&model, &assembly, &phase, Some(&rank)).bytes(&assembly.rest());
        assert!(all.shared() as f64 > MOST / f64::from(ranks) * alone.shared() as f64, "{all:?}");
        let each: Vec<Bytes> = std::thread::scope(|scope| {
            let (run, results, division) = (&run, &results, &division);
            let spawn = |exchange: Loopback| {
                let own = Arc::new(Ranks::new(Arc::new(exchange), division.clone()));
                scope.spawn(move || run(Some(own), results))
            };
            let threads: Vec<_> = Loopback::ranks(ranks).into_iter().map(spawn).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        let sum = |of: fn(&Bytes) -> usize| each.iter().map(of).sum::<usize>();
        assert_eq!(sum(|one| one.parts), alone.parts, "each part is on one rank");
        // Two rows more on a rank say that there was a hand-over, whether it has parts or not.
        assert_eq!(sum(|one| one.memory), alone.memory + 64 * ranks as usize, "so is what it remembers");
        for one in &each {
            let share = one.shared() as f64 / alone.shared() as f64;
            println!("{ranks} ranks: {:.3} of 1/{ranks}, {one:?} of {alone:?}", share * f64::from(ranks));
            assert!(share <= MOST / f64::from(ranks), "{ranks} ranks: {share:.3}, {one:?} of {alone:?}");
            assert!(one.everywhere <= alone.everywhere, "{ranks} ranks");
        }
    }
}
