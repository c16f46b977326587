//! The check of a run that ends while a permanent displacement still grows.

use crate::evidence::Evidence;
use crate::trust::{cut_short, on_broken_elements};
use tremolite_results::{Said, TrustLine, said};

/// Change of a residual displacement in the last second over the residual. Dashpots bring a block to rest as e^(−t/τ), so that a share r a
/// second leaves r τ of the residual to come: 2 % of it where τ is a second.
const MOST: f64 = 0.02;
/// Share of a monitor's largest displacement below which a residual is none.
const LEAST: f64 = 0.05;
/// Seconds at the end that are looked at, and the largest share of the run that they may be.
const WINDOW: f64 = 1.0;
const SHARE: f64 = 0.25;

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    const ID: &str = "residual_displacement_rate";
    let name = said!("change of residual displacement in the last second over the residual");
    let none = |why: Said| TrustLine::not_applicable(ID, name.clone(), why);
    let Evidence { model, plan, histories, .. } = evidence;
    let motion = cut_short::line(evidence);
    if !motion.pass && !motion.not_applicable {
        return none(said!("the motion goes on after the end of the run"));
    }
    let Some(time) = histories.columns.iter().position(|column| column.name == "time") else {
        return none(said!("no row was written"));
    };
    let times = &histories.values[time];
    let (Some(first), Some(last)) = (times.first(), times.last()) else {
        return none(said!("no row was written"));
    };
    let window = WINDOW.min(SHARE * (last - first));
    let incident = model.boundaries.incident.as_ref();
    let (_, loose) = on_broken_elements(evidence);
    let mut worst: Option<Growth> = None;
    for monitor in plan.monitors.iter().filter(|monitor| !loose.contains(&monitor.name.as_str())) {
        // What the ground far from the works does: the motion of an outcrop, which slow displacement is at each depth.
        let own = [("ux", 0), ("uy", 1), ("uz", 2)].map(|(quantity, axis)| {
            let history = format!("{}.{quantity}", monitor.name);
            let column = histories.columns.iter().position(|column| column.name == history)?;
            let ground = |t: f64| incident.map_or(0.0, |of| 2.0 * of.factor * of.motion.at(t).u[axis]);
            let values = times.iter().zip(&histories.values[column]);
            let relative: Vec<f64> = values.map(|(&t, u)| u - ground(t)).collect();
            Some((history, Ends::of(times, &relative, window)?))
        });
        let own: Vec<(String, Ends)> = own.into_iter().flatten().collect();
        let largest = own.iter().map(|(_, ends)| ends.largest).fold(0.0, f64::max);
        for (history, Ends { before, after, .. }) in own {
            if after.abs() < LEAST * largest || largest == 0.0 {
                continue;
            }
            // From the middle of one half of the window to that of the other.
            let share = (after - before).abs() / (0.5 * window) / after.abs();
            if worst.as_ref().is_none_or(|worst| share > worst.share) {
                worst = Some(Growth { share, history, residual: after });
            }
        }
    }
    let Some(Growth { share, history, residual }) = worst else {
        return none(said!("no monitor has a residual displacement"));
    };
    TrustLine::at_most(ID, name, share, MOST, "1/s").with("residual", residual).with("window", window).with_note(said!(
        "{history}: {residual} m at the end, and it still grows: give a longer `dynamic.duration`; with `base = \"viscous-spring\"` \
         compare base = \"viscous\" or wider `sides` as well",
        history = history,
        residual = format!("{residual:.3e}"),
    ))
}

/// The monitor that still moves most.
struct Growth {
    /// 1/s
    share: f64,
    history: String,
    /// m
    residual: f64,
}

/// Of a history of displacement \[m\]: its means over the two halves of the last `window`, and its largest size.
#[derive(Debug, PartialEq)]
struct Ends {
    before: f64,
    after: f64,
    largest: f64,
}

impl Ends {
    /// None where a half has no row or a value is not finite.
    fn of(times: &[f64], values: &[f64], window: f64) -> Option<Self> {
        let end = times.last()?;
        let mean = |from: f64, to: f64| {
            let rows = times.iter().zip(values).filter(|(t, _)| **t > from && **t <= to);
            let (sum, count) = rows.fold((0.0, 0.0), |(sum, count), (_, u)| (sum + u, count + 1.0));
            Some(sum / count).filter(|mean: &f64| mean.is_finite())
        };
        let middle = end - 0.5 * window;
        let largest = values.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
        Some(Ends { before: mean(end - window, middle)?, after: mean(middle, *end)?, largest })
    }
}

#[cfg(test)]
mod tests {
    use super::Ends;

    /// 2 mm (1 − e^(−t/τ)) with a vibration of 10 Hz: the change a second is that of the exponential, the vibration has no part in it.
    #[test]
    fn a_residual_that_creeps_is_told_from_one_that_vibrates() {
        let times: Vec<f64> = (0..=400).map(|k| 0.01 * f64::from(k)).collect();
        let share = |tau: f64| {
            let at =
                |t: &f64| 2e-3 * (1.0 - (-t / tau).exp()) + 1e-4 * (20.0 * std::f64::consts::PI * t).sin();
            let values: Vec<f64> = times.iter().map(at).collect();
            let Ends { before, after, .. } = Ends::of(&times, &values, 1.0).unwrap();
            (after - before).abs() / 0.5 / after.abs()
        };
        // e^(−3.5/1.3)/1.3/(1 − e^(−3.75/1.3)).
        assert!((share(1.3) - 0.0553).abs() < 1e-3, "{}", share(1.3));
        assert!(share(0.2) < 1e-3, "{}", share(0.2));
        assert_eq!(Ends::of(&[0.0, 1.0], &[0.0, f64::NAN], 1.0), None);
    }
}
