//! `tremolite motion spectrum`: response spectra.

use super::files::Files;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use tremolite_motion::{Process, default_periods, pseudo_acceleration};

pub fn run(files: &Files) -> Outcome {
    let periods = default_periods();
    let mut list = Vec::new();
    for mut c in files.accelerations()? {
        Process::DetrendLinear.apply(&mut [&mut c]).map_err(Failure::input)?;
        let psa = pseudo_acceleration(&c.acceleration, c.dt, &periods, 0.05).map_err(Failure::input)?;
        if files.json {
            list.push(serde_json::json!({ "name": c.name, "file": c.file, "periods": periods, "psa": psa }));
        } else {
            print(&format!("# {} : period [s], pseudo-acceleration [m/s2], 5 % damping", c.name));
            for (t, a) in periods.iter().zip(&psa) {
                print(&format!("{t:.4} {a:.6}"));
            }
        }
    }
    if files.json {
        print(&serde_json::json!({ "channels": list }).to_string());
    }
    Ok(Code::Done)
}
