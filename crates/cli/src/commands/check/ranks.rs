//! How a run would be shared out to several ranks, in lines.

use crate::terminal::{bytes, duration, print, sent};
use tremolite::scaling::{Network, Seconds, SharedOut};

/// Rows of a table at most; beyond, the extremes say enough.
const ROWS: usize = 16;

/// How much more than the mean, while all is sound and once something has cracked.
pub fn more(sound: f64, cracked: f64) -> String {
    let [sound, cracked] = [sound, cracked].map(|imbalance| format!("{:.1}", 100.0 * (imbalance - 1.0)));
    match sound == cracked {
        true => format!("{sound} % more than the mean"),
        false => format!("{sound} % more than the mean, up to {cracked} % where parts have cracked"),
    }
}

pub fn print_lines(shared: &SharedOut) {
    let SharedOut { ranks, of_rank, .. } = shared;
    print(&format!("ranks {ranks}"));
    print(&format!(
        "  in each step the one with most work has {}",
        more(shared.imbalance, shared.imbalance_cracked)
    ));
    print(&format!("  {:.1} % of the nodes are moved by one rank more", 100.0 * shared.moved_again));
    let [most, mean] = [
        of_rank.iter().map(|one| one.bytes).fold(0.0, f64::max),
        of_rank.iter().map(|one| one.bytes).sum::<f64>() / f64::from(*ranks),
    ];
    print(&format!("  sent in a step: {} by a rank in the mean, {} at most", sent(mean), sent(most)));
    print(&format!(
        "  about {} of memory for the rank with most work, and up to {} for the first where it writes what all have",
        bytes(shared.memory_bytes),
        bytes(shared.first_bytes)
    ));
    let idle = of_rank.iter().filter(|one| one.work == 0.0).count();
    if idle > 0 {
        print(&format!("  {idle} ranks have no elements: there are {} patches", shared.patches));
    }
    let Seconds { stages, steps, messages, rows } = shared.seconds;
    print(&format!(
        "  about {} if each rank had a machine like this one to itself: {} for the stages, {} for the steps of the rank with most work, \
         {} for messages, {} for rows, which the first rank looks at alone",
        duration(shared.seconds.all()),
        duration(stages),
        duration(steps),
        duration(messages),
        duration(rows)
    ));
    let Network { latency, bandwidth } = shared.network;
    print(&format!(
        "  so {:.0} % of the machines' time is used. Not measured: messages are taken to need {:.0} µs and {:.0} GB/s",
        100.0 * shared.efficiency,
        1e6 * latency,
        1e-9 * bandwidth
    ));
    if of_rank.len() <= ROWS {
        print("  rank   work    nodes  neighbours  sent in a step");
        for (rank, one) in of_rank.iter().enumerate() {
            print(&format!(
                "  {rank:4}  {:4.1} %  {:7}  {:10}  {:>14}",
                100.0 * one.work,
                one.nodes,
                one.neighbours,
                sent(one.bytes)
            ));
        }
    }
}
