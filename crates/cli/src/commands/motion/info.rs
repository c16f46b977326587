//! `tremolite motion info`: what records hold.

use super::files::Files;
use super::measures::{figures, seconds};
use crate::exit::{Code, Outcome};
use crate::terminal::print;
use tremolite_motion::{Channel, Intensity};

pub fn run(files: &Files) -> Outcome {
    let channels = files.channels()?;
    if files.json {
        let list: Vec<serde_json::Value> = channels.iter().map(json).collect();
        print(&serde_json::json!({ "channels": list }).to_string());
    } else {
        channels.iter().for_each(|c| print(&text(c)));
    }
    Ok(Code::Done)
}

/// What has a unit is there only for an acceleration; the peak of counts is in counts.
fn json(c: &Channel) -> serde_json::Value {
    let m = Intensity::of(c);
    let known = |value: f64| if c.raw { serde_json::Value::Null } else { value.into() };
    serde_json::json!({
        "name": c.name, "file": c.file, "dt": m.dt, "npts": m.npts, "units": c.units.to_string(), "pga": m.pga,
        "pgv": known(m.pgv), "pgd": known(m.pgd), "arias": known(m.arias), "d5_95": m.d5_95, "cav": known(m.cav),
        "format": c.format, "start": c.start, "end": c.end(), "orientation": c.orientation.map(|o| o.to_string()),
        "remarks": c.remarks, "other_sensor": c.other_sensor,
    })
}

fn text(c: &Channel) -> String {
    let m = Intensity::of(c);
    let direction = c.orientation.map_or("direction not stated".to_owned(), |o| o.to_string());
    let mut lines = vec![
        format!(
            "{} [{}]: {} points of {} s, {} s to {} s",
            c.name,
            c.units,
            m.npts,
            m.dt,
            seconds(c.start),
            seconds(c.end())
        ),
        format!("    format {}, {direction}", c.format),
    ];
    let [pga, pgv, pgd, arias, cav] = [m.pga, m.pgv, m.pgd, m.arias, m.cav].map(figures);
    lines.push(if c.other_sensor {
        format!(
            "    peak {pga} counts, D5-95 {:.2} s; by the channel's code no record of acceleration, which no sensitivity \
             makes of it",
            m.d5_95
        )
    } else if c.raw {
        format!(
            "    peak {pga} counts, D5-95 {:.2} s; what a count is is not known: --sensitivity \"427336 counts/(m/s2)\", say",
            m.d5_95
        )
    } else {
        format!(
            "    PGA {pga} m/s2, PGV {pgv} m/s, PGD {pgd} m, Arias {arias} m/s, D5-95 {:.2} s, CAV {cav} m/s",
            m.d5_95
        )
    });
    lines.extend(c.remarks.iter().map(|remark| format!("    {remark}")));
    lines.join("\n")
}
