//! State and reliance: the two classes by which a run is judged.
//!
//! The state says whether the lining withstands: the worst of damage, utilisation of sections and limits of acceptance. The reliance says
//! how far the results can be used: the worst of checks, warnings of `tremolite check` and completeness. [`items`] has the table of what
//! sets which class.

pub mod items;

use serde::{Deserialize, Serialize};

use crate::{Said, Summary, Table, said};

/// Whether the lining withstands, the worst last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Every mode of failure is judged, nothing is damaged, and the run is complete.
    Withstands,
    /// A mode of failure, a limit or a part of the shaking is not judged.
    #[default]
    NotJudged,
    /// A lining or a bolt is damaged.
    Damaged,
    /// A strength or a limit of acceptance is exceeded.
    Fails,
}

/// How far the results can be used, the worst last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reliance {
    /// The run is complete, every check passes, and no warning was given.
    Sound,
    /// Read the reasons before the results are used.
    WithReservations,
    /// The results do not describe the case.
    #[default]
    NotToBeUsed,
}

/// A class of state or of reliance.
pub trait Class: Copy + Ord + 'static {
    /// The class where no item sets another.
    const BEST: Self;

    /// In words.
    fn words(self) -> Said;

    /// As files have it.
    fn key(self) -> &'static str;
}

impl Class for State {
    const BEST: State = State::Withstands;

    fn words(self) -> Said {
        match self {
            State::Withstands => said!("withstands"),
            State::NotJudged => said!("not judged"),
            State::Damaged => said!("damaged"),
            State::Fails => said!("fails"),
        }
    }

    fn key(self) -> &'static str {
        match self {
            State::Withstands => "withstands",
            State::NotJudged => "not_judged",
            State::Damaged => "damaged",
            State::Fails => "fails",
        }
    }
}

impl Class for Reliance {
    const BEST: Reliance = Reliance::Sound;

    fn words(self) -> Said {
        match self {
            Reliance::Sound => said!("sound"),
            Reliance::WithReservations => said!("with reservations"),
            Reliance::NotToBeUsed => said!("not to be used"),
        }
    }

    fn key(self) -> &'static str {
        match self {
            Reliance::Sound => "sound",
            Reliance::WithReservations => "with_reservations",
            Reliance::NotToBeUsed => "not_to_be_used",
        }
    }
}

/// A class with its reasons.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, bound(serialize = "C: Serialize", deserialize = "C: Deserialize<'de> + Default"))]
pub struct Judgement<C> {
    pub class: C,
    /// The worst first; empty for the best class.
    pub reasons: Vec<Reason<C>>,
}

/// Why a class is not the best.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, bound(serialize = "C: Serialize", deserialize = "C: Deserialize<'de> + Default"))]
pub struct Reason<C> {
    /// [`items::Item::id`].
    pub item: String,
    /// The class that it sets.
    pub class: C,
    /// In a sentence.
    pub text: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub text_message: Said,
}

/// Reasons that stand beside a class of state, and of reliance, which names long checks; of more the number is told.
const OF_STATE: usize = 3;
const OF_RELIANCE: usize = 2;

/// Both judgements of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assessment {
    pub state: Judgement<State>,
    pub reliance: Judgement<Reliance>,
}

/// Judges a run by its summary and monitors.csv.
pub fn assess(summary: &Summary, monitors: Option<&Table>) -> Assessment {
    let run = items::Run::new(summary, monitors);
    Assessment { state: judge(&items::STATE, &run), reliance: judge(&items::RELIANCE, &run) }
}

fn judge<C: Class>(items: &[items::Item<C>], run: &items::Run) -> Judgement<C> {
    let reasons = items.iter().flat_map(|item| {
        (item.reasons)(run).into_iter().map(|said| Reason {
            item: item.id.to_owned(),
            class: item.class,
            text: said.to_string(),
            text_message: said,
        })
    });
    let mut reasons: Vec<Reason<C>> = reasons.collect();
    // Of one class in the order of the table.
    reasons.sort_by_key(|reason| std::cmp::Reverse(reason.class));
    Judgement { class: reasons.first().map_or(C::BEST, |reason| reason.class), reasons }
}

impl<C: Class> Judgement<C> {
    /// The first `most` reasons, and how many more there are.
    fn first(&self, most: usize) -> Vec<Said> {
        let mut texts: Vec<Said> =
            self.reasons.iter().take(most).map(|reason| reason.text_message.clone()).collect();
        match self.reasons.len().saturating_sub(most) {
            0 => {}
            1 => texts.push(said!("One more reason is in summary.json.")),
            more => texts.push(said!("{more} more reasons are in summary.json.", more = more.to_string())),
        }
        texts
    }
}

impl Assessment {
    /// Both classes in a sentence.
    pub fn classes(&self) -> Said {
        said!(
            "State: {state}. Reliance: {reliance}.",
            state = self.state.class.words(),
            reliance = self.reliance.class.words(),
        )
    }

    /// Why the state is what it is, the first reasons in a sentence each.
    pub fn why_state(&self, summary: &Summary) -> Vec<Said> {
        if self.state.class != State::BEST {
            return self.state.first(OF_STATE);
        }
        let still = summary.computed.model.steps == 0 && !summary.computed.stages.is_empty();
        let mut texts = vec![match still {
            true => said!("No damage is computed. No earthquake has come."),
            false => said!("No damage is computed."),
        }];
        if !summary.parts.sections.is_empty() {
            texts.push(said!("No utilisation is above 1."));
        }
        match summary.case.report.limits.len() {
            0 => {}
            1 => texts.push(said!("The one limit of acceptance is met.")),
            met => texts.push(said!("All {met} limits of acceptance are met.", met = met.to_string())),
        }
        texts
    }

    /// Why the reliance is what it is, the first reasons in a sentence each.
    pub fn why_reliance(&self, summary: &Summary) -> Vec<Said> {
        let judged = summary.judged();
        let passed = judged - summary.warnings().min(judged);
        let checks = said!(
            "{passed} of {judged} checks of the run pass.",
            passed = passed.to_string(),
            judged = judged.to_string(),
        );
        let first = self.reliance.first(OF_RELIANCE);
        if judged > 0 { std::iter::once(checks).chain(first).collect() } else { first }
    }
}
