//! An assembly with the parts of its interfaces: how stiff a pair may be for the step.
//!
//! **ω_c.** A pair of nodes with masses m₁, m₂ and the stiffness per area k has ω_c² = Σ kA/m₁ + Σ kA/m₂, each sum over all
//! pairs of that node's tied set, with k at its stiffest: at unlike masses a node with two partners is stiffer than any pair
//! alone says. Explicit contact gains or loses energy at each impact; with a dashpot of 1 % of critical it loses on the whole
//! up to ω_cΔt = 0.8, which bounds the step ([`Interface::limit`](crate::interface::Interface)).
//!
//! **Stiffness left out.** It is what keeps that limit at the step that the elements alone allow, so that impacts do not set the
//! step; in K its pairs still take a few per cent of it, and a shear stiffness that is given may take more. But it is no softer than ten
//! times the elements beside it ([`give`](crate::give)), at the price of a shorter step, where the step is not given.

use crate::assembly::{Assembly, constant};
use crate::bolting;
use crate::contacts::{Contacts, LoadedPair};
use crate::engine::stable_step;
use crate::error::ModelError;
use crate::give::least_stiffness;
use crate::interface::Seam;
use crate::level_finding::sure_step;
use crate::life::{Life, Stage};
use crate::member::{Kind, Member};
use crate::model::Model;
use crate::pair_masses::{PairMasses, Phases};
use crate::parts::Reads;
use crate::phase::Phase;
use crate::pore_forces::in_seam;
use crate::problem::TimeStep;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;
use tremolite_kernels::contact::Pair;
use tremolite_kernels::{AnyInterface, Line};
use tremolite_laws::{Choice, Need, Values};
use tremolite_mesh::order::hilbert_order;
use tremolite_mesh::pairs::tangents;

/// Pairs that one thread works on together.
const CHUNK: usize = 256;

impl Assembly {
    /// The parts of a model.
    ///
    /// # Errors
    /// If no face lies on the plane of a base that should do something, a part of the program's own does not fit, an interface's
    /// law refuses what was chosen for it, or a pair's nodes move as one.
    pub fn new(model: &Model) -> Result<Arc<Self>, ModelError> {
        Assembly::with(model, None)
    }

    /// The parts of the same model cut and numbered otherwise, with the stiffness of interfaces that was chosen for this.
    ///
    /// # Errors
    /// As [`Assembly::new`].
    pub fn again(&self, model: &Model) -> Result<Arc<Self>, ModelError> {
        Assembly::with(model, Some(&self.values))
    }

    fn with(model: &Model, values: Option<&[Values]>) -> Result<Arc<Self>, ModelError> {
        let mut assembly = Assembly::without_interfaces(model)?;
        if !model.seams.is_empty() {
            add(model, values, &mut assembly)?;
            assembly.settle(model);
        }
        if !model.bolts.is_empty() {
            bolt(model, &mut assembly);
            assembly.settle(model);
        }
        let Assembly { members, slices, contacts, bolts, .. } = &mut assembly;
        for (m, (member, slices)) in (0u32..).zip(members.iter().zip(slices.iter())) {
            match member.kind {
                Kind::Pairs(seam) => {
                    let contacts = &mut contacts[seam as usize];
                    contacts.histories.push(slices.history.clone());
                    contacts.held.push(Some(slices.history.clone()));
                    contacts.members.push(m);
                }
                Kind::Bolts(set) => bolts[set as usize].starts.push(slices.numbers.start),
                Kind::Patch(_) | Kind::Boundary | Kind::Load | Kind::Weight | Kind::Own => {}
            }
        }
        Ok(Arc::new(assembly))
    }

    /// Puts in members behind everything of the house.
    fn insert(&mut self, more: Vec<Member>) {
        let at = self.members.iter().position(|member| member.kind == Kind::Own);
        let at = at.unwrap_or(self.members.len());
        self.members.splice(at..at, more);
    }
}

/// Puts in the parts of all bolts, behind those of the interfaces.
fn bolt(model: &Model, assembly: &mut Assembly) {
    let mut more = Vec::new();
    for (number, set) in (0u32..).zip(&model.bolts) {
        let (members, bolting) = bolting::members(model, set, number);
        more.extend(members);
        assembly.bolts.push(bolting);
    }
    assembly.insert(more);
}

/// Builds the parts of all interfaces into an assembly of everything else.
fn add(model: &Model, values: Option<&[Values]>, assembly: &mut Assembly) -> Result<(), ModelError> {
    let phases = Phases::of(model, assembly)?;
    for seam in &model.seams {
        let tied = |&k: &usize| {
            let [a, b] = phases.masters(model, seam, k);
            a == b
        };
        if let Some(pair) = (0..seam.pairs.len()).find(tied) {
            let node = model.mesh.node_id(seam.pairs[pair].nodes[1] as usize);
            let reason = format!("both sides of node {node} are tied to one another");
            return Err(ModelError::Interface { name: seam.name.clone(), reason });
        }
    }
    let masses = PairMasses::of(model, &phases);
    assembly.values = match values {
        Some(values) => values.to_vec(),
        None => chosen(model, assembly, &phases.0[&Stage::Shaking], &masses),
    };
    let values = assembly.values.clone();
    let mut laws: Vec<Arc<dyn AnyInterface>> = Vec::new();
    for (seam, values) in model.seams.iter().zip(&values) {
        if let Some(of) = seam.of {
            laws.push(laws[of].clone());
            continue;
        }
        let law = (seam.law.build)(values).map_err(|bad| {
            let bad: Vec<String> = bad.iter().map(ToString::to_string).collect();
            let given = (seam.law.build)(&(seam.law.info.chosen)(&seam.values, &beyond(seam))).is_err();
            let whose =
                if given { "" } else { "with the stiffness that was chosen for it, as none is given, " };
            ModelError::Interface { name: seam.name.clone(), reason: format!("{whose}{}", bad.join("; ")) }
        })?;
        laws.push(law);
    }
    let stiffest: Vec<f64> = laws.iter().map(|law| law.stiffest()[0]).collect();
    let mut members = Vec::new();
    let mut dampings: Vec<f64> = Vec::new();
    for (s, (seam, law)) in model.seams.iter().zip(laws).enumerate() {
        let squares = masses.squares(s, |other| stiffest[other]);
        // What is gone before has no part in the impacts of the shaking.
        let (stiffest_pair, square) = seam
            .lasting()
            .map(|k| (k, squares[k]))
            .fold((0, 0.0), |worst, (k, square)| if square > worst.1 { (k, square) } else { worst });
        let frequency = square.sqrt();
        let damping = match seam.of {
            Some(of) => dampings[of],
            None if frequency > 0.0 => 2.0 * seam.damping * stiffest[s] / frequency,
            None => 0.0,
        };
        dampings.push(damping);
        let mut places = vec![(0, 0); seam.pairs.len()];
        let centres: Vec<[f64; 3]> = (0..seam.pairs.len()).map(|k| seam.place(&model.mesh, k)).collect();
        let order = hilbert_order(&centres);
        let mut of_life: BTreeMap<(Life, u8), Vec<u32>> = BTreeMap::new();
        for pair in order {
            let nodes = seam.pairs[pair as usize].nodes.map(|n| model.engine_node[n as usize]);
            let level = nodes.map(|n| model.nodes.level[n as usize]).into_iter().min().unwrap_or(0);
            of_life.entry((seam.lives[pair as usize], level)).or_default().push(pair);
        }
        let chunks = of_life.iter().flat_map(|((life, _), own)| own.chunks(CHUNK).map(move |c| (*life, c)));
        for (count, (life, chunk)) in (0u32..).zip(chunks) {
            for (place, &pair) in chunk.iter().enumerate() {
                places[pair as usize] = (count, place as u32);
            }
            let (nodes, pairs) = part(model, seam, chunk);
            let springs = pairs.iter().flat_map(|pair| {
                let stiffness = pair.area * stiffest[s];
                pair.nodes.map(|n| (nodes[n as usize], stiffness))
            });
            let springs = springs.collect();
            let part = law.contact(nodes, &pairs, damping, model.scheme.isa);
            let name = format!("interface '{}'", seam.name);
            let member = Member::of(Kind::Pairs(s as u32), name, part);
            members.push(Member {
                reads: Reads { elements: beside_freed(seam, chunk), ..member.reads.clone() },
                springs,
                life,
                line: Some(Line::Interface),
                counted: seam.of.is_none(),
                ..member
            });
        }
        let chosen = seam.law.info.parameters.iter().any(|parameter| {
            matches!(parameter.need, Need::Chosen(_)) && !seam.values.0.contains_key(parameter.name)
        });
        let loaded = seam.tractions.iter().zip(&seam.lives).zip(0u32..).zip(&seam.pairs);
        let effective = |[pressure, t1, t2]: [f64; 3], pair: u32| {
            [pressure - model.water.in_pair(seam, pair as usize, Stage::Before(0)), t1, t2]
        };
        let loaded =
            loaded.filter(|(((_, life), _), _)| !life.is_later()).map(|(((&traction, _), pair), shape)| {
                LoadedPair { pair, normal: shape.normal, traction: effective(traction, pair) }
            });
        let loaded = loaded.collect();
        for acting in in_seam(model, seam) {
            let name = format!("water in '{}'", seam.name);
            members.extend(constant(&name, &acting.forces, &acting.life, !acting.outside));
        }
        assembly.contacts.push(Contacts {
            law,
            chosen,
            places,
            histories: Vec::new(),
            held: Vec::new(),
            members: Vec::new(),
            loaded,
            frequency,
            stiffest_pair,
        });
    }
    assembly.insert(members);
    Ok(())
}

/// The elements beside those of some pairs that a stage frees, by whose stress these begin.
fn beside_freed(seam: &Seam, pairs: &[u32]) -> Vec<u32> {
    let freed = pairs.iter().filter(|&&k| seam.freed[k as usize]);
    let faces = freed.flat_map(|&k| &seam.pairs[k as usize].corners);
    let mut elements: Vec<u32> =
        faces.flat_map(|(f, _)| seam.faces[*f as usize].map(|face| face.element)).collect();
    elements.sort_unstable();
    elements.dedup();
    elements
}

/// A choice with which no law refuses what it would not refuse by itself.
fn beyond(seam: &Seam) -> Choice {
    Choice { stiffness: 1e15, least: 0.0, pressure: seam.pressure }
}

/// A chunk's nodes and its pairs on them.
fn part(model: &Model, seam: &Seam, chunk: &[u32]) -> (Vec<u32>, Vec<Pair>) {
    let mut nodes: Vec<u32> = Vec::new();
    let mut local: BTreeMap<u32, u16> = BTreeMap::new();
    let mut position = |node: u32| match local.entry(node) {
        Entry::Occupied(known) => *known.get(),
        Entry::Vacant(new) => {
            nodes.push(model.engine_node[node as usize]);
            // Two nodes a pair at most.
            *new.insert(nodes.len() as u16 - 1)
        }
    };
    let pairs = chunk
        .iter()
        .map(|&k| {
            let shape = &seam.pairs[k as usize];
            let [e1, e2] = tangents(shape.normal);
            Pair {
                nodes: shape.nodes.map(&mut position),
                axes: [shape.normal, e1, e2],
                area: shape.normal_area,
            }
        })
        .collect();
    (nodes, pairs)
}

/// Least share of ω_c² that is left to an interface whose stiffness is chosen, where given ones at the same nodes take it up.
const LEAST_SHARE: f64 = 0.1;

/// The values of all interfaces, with what they leave to be chosen.
fn chosen(model: &Model, assembly: &Assembly, phase: &Phase, masses: &PairMasses) -> Vec<Values> {
    let fill_from = |seam: &Seam, stiffness: f64, least: f64| {
        (seam.law.info.chosen)(&seam.values, &Choice { stiffness, least, pressure: seam.pressure })
    };
    let fill = |seam: &Seam, stiffness: f64| fill_from(seam, stiffness, 0.0);
    // Whose stiffness is given, which the choice then leaves alone.
    let given: Vec<Option<f64>> = model
        .seams
        .iter()
        .map(|seam| {
            // Stiff enough that a pressure which is given does not hide the choice.
            let known = fill(seam, 1e15) == fill(seam, 2e15);
            known.then(|| (seam.law.build)(&fill(seam, 1.0)).ok().map(|law| law.stiffest()[0])).flatten()
        })
        .collect();
    let open = |(seam, given): (&Seam, &Option<f64>)| given.is_none().then_some(seam.limit);
    let limits = model.seams.iter().zip(&given).filter_map(open);
    let Some(limit) = limits.reduce(f64::min) else {
        return model.seams.iter().map(|seam| fill(seam, 1.0)).collect();
    };
    let TimeStep { given: step, safety, .. } = model.scheme.time_step;
    // ω_c² of a step, with the least of the limits, since interfaces may meet at a node.
    let most = |dt: f64| (limit / dt).powi(2);
    let choose = |most: f64, s: usize| {
        let fixed = masses.squares(s, |other: usize| given[other].unwrap_or(0.0));
        let own = masses.squares(s, |other: usize| f64::from(u8::from(given[other].is_none())));
        // By what is there in the shaking; where all of it is gone by then, as if that were to shake.
        let seam = &model.seams[s];
        let lasts = seam.lasting().next().is_some();
        (0..seam.pairs.len())
            .filter(|&k| !lasts || seam.lives[k].holds(Stage::Shaking))
            .map(|k| (most - fixed[k]).max(LEAST_SHARE * most) / own[k])
            .fold(f64::INFINITY, f64::min)
    };
    // An interface has the same law wherever it runs.
    let whose = |s: usize| model.seams[s].of.unwrap_or(s);
    // A softer joint than this would keep the ground's motion from what lies behind it, so it rather shortens the step, which only what
    // is near pays for; a step that is given stays.
    let least = |s: usize| match step {
        Some(_) => 0.0,
        None => least_stiffness(model, &model.seams[s]),
    };
    let least: Vec<f64> = (0..model.seams.len())
        .map(|s| if whose(s) == s && given[s].is_none() { least(s) } else { 0.0 })
        .collect();
    let of_step = |dt: f64| -> Vec<Values> {
        let mut stiffness = vec![f64::INFINITY; model.seams.len()];
        for s in 0..model.seams.len() {
            stiffness[whose(s)] = stiffness[whose(s)].min(choose(most(dt), s));
        }
        let fill = |(s, seam)| fill_from(seam, stiffness[whose(s)], least[whose(s)]);
        model.seams.iter().enumerate().map(fill).collect()
    };
    if let Some(step) = step {
        return of_step(step);
    }
    // The shorter the step, the stiffer; where they are as stiff with any longer one as with a step that is surely stable, the stable step, which takes
    // tens of products to find, says nothing.
    if let Some(sure) = sure_step(model, assembly, phase) {
        let stiffest = of_step(safety * sure);
        if stiffest == of_step(f64::INFINITY) {
            return stiffest;
        }
    }
    of_step(safety * stable_step(model, assembly, phase).dt)
}
