//! What a stage leaves without support, before it comes down.

use crate::outlook::{Hold, Outlook, Piece};
use tremolite_case::{Case, Diagnostic};
use tremolite_laws::Dimension;

/// Of pieces that nothing holds up, at the stage that leaves them so.
pub fn of_pieces(case: &Case, outlook: &Outlook) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    for (k, stage) in outlook.stages.iter().enumerate() {
        // The initial equilibrium stands in the case as what it begins with.
        let span = match (k.checked_sub(1).and_then(|k| case.stages.get(k)), &case.initial.stress) {
            (Some(written), _) => written.name.span.clone(),
            (None, Some(stress)) => stress.span(),
            (None, None) => case.stages.first().map_or(0..0, |first| first.name.span.clone()),
        };
        for piece in &stage.pieces {
            problems.push(warning(span.clone(), &stage.name, piece));
        }
    }
    problems
}

fn warning(span: std::ops::Range<usize>, stage: &str, piece: &Piece) -> Diagnostic {
    let what = format!("after '{stage}' {}", in_words(piece));
    match &piece.held {
        Hold::Nothing => Diagnostic::new(
            span,
            format!("{what} touches neither the base nor a side that holds it: it will come down"),
            "take it out as well, leave rock that holds it, or give a side \"fixed\"",
        ),
        Hold::Hangs { interfaces, bolts, .. } if bolts.is_empty() => Diagnostic::new(
            span,
            format!("{what} hangs by {} alone: bond and friction there must carry it", interfaces.join(", ")),
            "see that they do; else leave what it rests on, or take it out",
        ),
        Hold::Hangs { interfaces, bolts, lifted } => Diagnostic::new(
            span,
            format!(
                "{what} hangs by {}: at their strength the bolts lift {:.0} % of its weight",
                [&interfaces[..], bolts].concat().join(", "),
                100.0 * lifted
            ),
            "see that bond and friction carry the rest; else give more bolts, leave what it rests on, or take it out",
        ),
    }
}

/// How many elements of which group, how large, where.
pub fn in_words(piece: &Piece) -> String {
    let (low, high) = piece.bounds;
    let [x, y, z] = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
    let [a, b, c] = [0, 1, 2].map(|i| format!("{:.1}", high[i] - low[i]));
    let elements = match piece.elements.len() {
        1 => "1 element".to_owned(),
        n => format!("{n} elements"),
    };
    format!(
        "a piece of '{}' ({elements}, {}, {a} × {b} × {c} m) around ({x:.1}, {y:.1}, {z:.1}) m",
        piece.group,
        volume(piece.volume)
    )
}

fn volume(volume: f64) -> String {
    let volume: f64 = format!("{volume:.2e}").parse().unwrap_or(volume);
    format!("{volume} m3")
}

/// Compression positive, as ground is spoken of.
pub fn pressure(stress: f64) -> String {
    let pressure: f64 = format!("{:.3e}", 0.0 - stress).parse().unwrap_or(-stress);
    tremolite_case::units::format(pressure, Dimension::PRESSURE)
}
