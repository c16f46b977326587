//! Which run begins when: what is done by what lies in the folders alone, so that a study may be killed at any moment and several
//! processes may work at it.

mod keep;

use super::lacks;
use super::planned::Planned;
use super::process::{End, Held};
use super::tables;
use crate::exit::Failure;
use crate::terminal::say;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tremolite_case::study::StudyFile;
use tremolite_results::study::{RunStatus, StudyRun};
use tremolite_results::{CHECKPOINTS, HAND_OVER};
use tremolite_study::measure::Results;
use tremolite_study::outcome::{Outcome, RunFolder};
use tremolite_study::plan::Plan;
use tremolite_study::results::{Missing, ends_chain};

/// How long one waits that finds nothing to begin.
const PAUSE: Duration = Duration::from_millis(200);

/// Tables are written again when this many times as long has passed as that took.
const SPARING: u32 = 20;

/// The runs that are left to do.
pub struct Queue<'a> {
    study: &'a StudyFile,
    plan: &'a Plan,
    planned: &'a [Planned],
    out: &'a Path,
    threads: usize,
    stop: Arc<AtomicBool>,
    inside: Mutex<Inside>,
}

struct Inside {
    /// In the order of the plan.
    waiting: Vec<usize>,
    running: usize,
    /// By runs that are equal before the earthquake: the one that is on its way through what comes before it.
    led: Vec<Option<usize>>,
    /// Where the hand-over of runs that are equal before the earthquake lies.
    hand_over: BTreeMap<usize, PathBuf>,
    ended: usize,
    of: usize,
    /// When tables were written last, and how long it took.
    tables: (Instant, Duration),
    fault: Option<Failure>,
}

/// What a worker does next.
enum Next {
    Run { run: usize, held: Held, from: Option<PathBuf>, leads: Option<usize> },
    Wait,
    End,
}

/// Makes runs that ended in some ways begin again.
pub fn retry(
    plan: &Plan,
    planned: &[Planned],
    out: &Path,
    chosen: &[usize],
    again: impl Fn(RunStatus) -> bool,
) -> Result<(), Failure> {
    for &run in chosen {
        let folder = RunFolder::new(out, &plan.runs[run].name);
        let status = Outcome::of(&folder, &planned[run].prepared.bare).status;
        if !again(status) {
            continue;
        }
        let results = folder.results();
        let files = match status {
            // What was ended from outside goes on from its checkpoint.
            RunStatus::Error => vec![folder.broken()],
            _ => {
                let checkpoints = CHECKPOINTS.map(|name| results.join("checkpoint").join(name));
                // Without checksums nothing is missed of it.
                let ended = ["SHA256SUMS", "summary.json"].map(|name| results.join(name));
                ended.into_iter().chain(checkpoints).collect()
            }
        };
        for file in files {
            match fs::remove_file(&file) {
                Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
                    return Err(Failure::failed(format!("{}: {e}", file.display())));
                }
                _ => {}
            }
        }
    }
    Ok(())
}

impl<'a> Queue<'a> {
    pub fn new(
        study: &'a StudyFile,
        plan: &'a Plan,
        planned: &'a [Planned],
        out: &'a Path,
        chosen: Vec<usize>,
        threads: usize,
        stop: Arc<AtomicBool>,
    ) -> Result<Queue<'a>, Failure> {
        let groups = planned.iter().filter_map(|p| p.before).max().map_or(0, |most| most + 1);
        let inside = Inside {
            of: chosen.len(),
            waiting: chosen,
            running: 0,
            led: vec![None; groups],
            hand_over: BTreeMap::new(),
            ended: 0,
            tables: (Instant::now(), Duration::ZERO),
            fault: None,
        };
        Ok(Queue { study, plan, planned, out, threads, stop, inside: Mutex::new(inside) })
    }

    /// Works on so many runs at once until none is left; whether it was stopped before.
    ///
    /// # Errors
    /// What no run can mend.
    pub fn work(&self, at_once: usize) -> Result<bool, Failure> {
        std::thread::scope(|scope| {
            for _ in 0..at_once {
                scope.spawn(|| self.worker());
            }
        });
        match self.inside().fault.take() {
            Some(fault) => Err(fault),
            None => self.tidy_all().map(|()| self.stop.load(Ordering::Relaxed)),
        }
    }

    fn inside(&self) -> MutexGuard<'_, Inside> {
        // A worker that panics ends the program; until then the list is whole between its changes.
        self.inside.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn worker(&self) {
        loop {
            if self.stop.load(Ordering::Relaxed) || self.inside().fault.is_some() {
                return;
            }
            let next = self.next();
            match next {
                Ok(Next::Run { run, held, from, leads }) => {
                    say(&format!("{} …", self.plan.runs[run].name));
                    let end = held.run(from.as_deref(), self.threads, &self.stop);
                    drop(held);
                    self.ended(run, leads, end);
                }
                Ok(Next::Wait) => std::thread::sleep(PAUSE),
                Ok(Next::End) => return,
                Err(fault) => {
                    self.inside().fault.get_or_insert(fault);
                    return;
                }
            }
        }
    }

    fn folder(&self, run: usize) -> RunFolder {
        RunFolder::new(self.out, &self.plan.runs[run].name)
    }

    fn outcome(&self, run: usize) -> Outcome {
        Outcome::of(&self.folder(run), &self.planned[run].prepared.bare)
    }

    /// The first run that may begin now.
    fn next(&self) -> Result<Next, Failure> {
        let mut inside = self.inside();
        let mut k = 0;
        while k < inside.waiting.len() {
            let run = inside.waiting[k];
            let mut has_ended = self.outcome(run).has_ended();
            if has_ended && Held::is_elsewhere(&self.folder(run))? {
                // Its summary stands before its page does.
                k += 1;
                continue;
            }
            let doubtful = has_ended || self.folder(run).lost_summary().is_some();
            if doubtful && let Some(why) = Held::set_aside_damaged(&self.folder(run))? {
                say(&why);
                has_ended = false;
            }
            if has_ended || self.is_not_needed(run) {
                inside.waiting.remove(k);
                inside.ended += 1;
                continue;
            }
            let may = match self.start(run, &mut inside) {
                Some(start) if !self.waits_for_lower(run) => Some(start),
                _ => None,
            };
            if let Some((from, leads)) = may {
                let Planned { prepared, case, .. } = &self.planned[run];
                if let Some(held) = Held::take(self.folder(run), &prepared.bare, case)? {
                    inside.waiting.remove(k);
                    // It may have ended elsewhere since it was looked at.
                    if self.outcome(run).has_ended() {
                        inside.ended += 1;
                        continue;
                    }
                    if let Some(group) = leads {
                        inside.led[group] = Some(run);
                    }
                    inside.running += 1;
                    return Ok(Next::Run { run, held, from, leads });
                }
            }
            k += 1;
        }
        Ok(if inside.waiting.is_empty() { Next::End } else { Next::Wait })
    }

    /// Where a run begins: from which hand-over, or which group it leads; nothing while another leads.
    fn start(&self, run: usize, inside: &mut Inside) -> Option<(Option<PathBuf>, Option<usize>)> {
        let group = self.planned[run].before.filter(|_| self.study.run.share);
        let Some(group) = group else { return Some((None, None)) };
        if let Some(known) =
            inside.hand_over.get(&group).filter(|known| known.join("checkpoint").join(HAND_OVER).is_file())
        {
            return Some((Some(known.clone()).filter(|known| *known != self.folder(run).results()), None));
        }
        let has = |other: &usize| {
            let folder = self.folder(*other);
            folder.is_of(&self.planned[*other].prepared.bare)
                && folder.results().join("checkpoint").join(HAND_OVER).is_file()
        };
        let found = match inside.led[group] {
            // Its stages may be done though it is not.
            Some(leader) => Some(leader).filter(has),
            None => {
                let of_group = |other: &usize| *other != run && self.planned[*other].before == Some(group);
                (0..self.planned.len()).filter(of_group).find(has)
            }
        };
        match found {
            Some(found) => {
                let place = self.folder(found).results();
                inside.hand_over.insert(group, place.clone());
                Some((Some(place), None))
            }
            None if inside.led[group].is_some() => None,
            None => Some((None, Some(group))),
        }
    }

    /// Lower levels of a chain of rising ones: they stand before it in the plan.
    fn lower(&self, run: usize) -> impl Iterator<Item = usize> {
        let runs = &self.plan.runs;
        let of_chain = move |lower: &usize| runs[*lower].chain == runs[run].chain;
        (0..run).rev().take_while(of_chain).filter(|_| self.plan.rises)
    }

    fn waits_for_lower(&self, run: usize) -> bool {
        self.lower(run).any(|lower| !self.outcome(lower).has_ended())
    }

    fn is_not_needed(&self, run: usize) -> bool {
        self.lower(run).any(|lower| {
            let folder = self.folder(lower);
            let outcome = Outcome::checked(&folder, &self.planned[lower].prepared.bare);
            let results = folder.results();
            let results = if outcome.status == RunStatus::Done { Results::of(&results) } else { None };
            let measure = |m| results.as_ref()?.number(m).ok().flatten();
            let measures = self.study.measures.iter().map(measure).collect();
            outcome.has_ended()
                && ends_chain(
                    self.study,
                    &StudyRun { status: outcome.status, measures, ..StudyRun::default() },
                )
        })
    }

    fn ended(&self, run: usize, leads: Option<usize>, end: Result<End, Failure>) {
        let mut inside = self.inside();
        inside.running -= 1;
        if let Some(group) = leads {
            inside.led[group] = None;
        }
        let name = &self.plan.runs[run].name;
        match end {
            Ok(End::Stopped) => {
                // One that was told to stop means all of them.
                self.stop.store(true, Ordering::Relaxed);
                return;
            }
            Err(fault) => {
                inside.fault.get_or_insert(fault);
                return;
            }
            Ok(End::Ended) => {}
        }
        inside.ended += 1;
        let outcome = self.outcome(run);
        say(&format!("{name} {} ({} of {})", outcome.status.word(), inside.ended, inside.of));
        if outcome.status == RunStatus::Done
            && let Err(fault) = self.done(run)
        {
            inside.fault.get_or_insert(fault);
        }
        if let Err(fault) = self.drop_hand_overs(self.planned[run].before) {
            inside.fault.get_or_insert(fault);
        }
        if inside.tables.0.elapsed() > SPARING * inside.tables.1 {
            let began = Instant::now();
            if let Err(fault) = tables::write(self.study, self.plan, self.planned, self.out) {
                inside.fault.get_or_insert(fault);
            }
            inside.tables = (Instant::now(), began.elapsed());
        }
    }

    /// Looks whether a run that is done has all that the study asks for, and removes what the study does not keep.
    fn done(&self, run: usize) -> Result<(), Failure> {
        let folder = self.folder(run);
        let root = folder.results();
        if let Some(results) = Results::of(&root) {
            for measure in &self.study.measures {
                if let Err(why) = results.number(measure) {
                    let (measure, run) = (measure.name.value.clone(), self.plan.runs[run].name.clone());
                    return Err(lacks(self.study, &Missing { measure, run, why }));
                }
            }
        }
        self.tidy(run)
    }
}
