//! What is said of a case, for people.

use super::Checked;
use crate::commands::defaulted::text;
use crate::terminal::{bytes, duration, print};
use tremolite_results::Origin;

impl Checked<'_> {
    pub(super) fn print(&self) {
        let Checked { survey, motion, .. } = self;
        print(&self.case.title.value);
        print(&format!(
            "\nMesh       {} elements ({} excavated), {} nodes",
            survey.active_elements, survey.void_elements, survey.nodes
        ));
        for (name, elements) in &self.groups {
            print(&format!("           {name:28} {elements:>8}"));
        }
        self.print_materials();
        print("\nMotion");
        print(&format!("           {}", motion.source));
        let [from, to] = motion.window;
        print(&format!("           {from:.2} to {to:.2} s of the record are used"));
        print(&format!(
            "           kind = {}: the incident wave is {} times the given motion",
            motion.kind, motion.factor
        ));
        for (m, name) in motion.intensity.iter().zip(["x", "y", "z"]) {
            let peaks = format!("{:.3} m/s2, {:.3} m/s, {:.3} m", m.pga, m.pgv, m.pgd);
            print(&format!("           given peaks along {name}: {peaks}"));
        }
        if let Some(coarsest) = survey.coarsest() {
            print(&format!(
                "           99.9 % of its energy lies below {:.1} Hz: {:.1} elements a shear wave there (8 or more is good); fewest in {}",
                motion.highest_frequency, coarsest.per_wavelength, self.coarsest
            ));
        }
        print("\nTime step");
        print(&format!("           {:.4e} s stable, set by {}", self.stable, self.set_by));
        print(&format!(
            "           {:.4e} s used, {} steps for {:.2} s",
            self.dt, self.steps.total, self.duration
        ));
        print("\nEstimate");
        print(&format!(
            "           {} with {} threads and {} ({:.1} million element updates a second), {} of memory",
            duration(self.seconds()),
            self.threads,
            self.isa.name(),
            self.updates_per_second() / 1e6,
            bytes(survey.bytes)
        ));
        self.print_disk();
        if !self.left_out.is_empty() {
            print("\nLeft out, and taken as");
            self.left_out.iter().for_each(|d| print(&format!("           {} = {}", d.key, d.value)));
        }
    }

    fn print_disk(&self) {
        let disk = self.disk;
        let bytes = |n: u64| bytes(usize::try_from(n).unwrap_or(usize::MAX));
        print(&format!(
            "           at most {} on disk: {} field files of {}, histories of {}, a checkpoint of {} while it runs",
            bytes(disk.total()),
            disk.field_files,
            bytes(disk.field_file),
            bytes(disk.histories),
            bytes(disk.checkpoint)
        ));
    }

    fn print_materials(&self) {
        print("\nMaterials");
        for (name, facts) in self.materials {
            print(&format!("           {name}: {}, {}", facts.law, facts.summary));
            for group in &facts.groups {
                let body = self.survey.bodies.iter().find(|b| b.name == group.names);
                let step = body.map_or(String::new(), |b| format!(", could run at {:.3e} s", b.element_step));
                print(&format!("             {} {} in {}{step}", group.elements, group.element, group.names));
            }
            print(&format!(
                "             {:.0} kg/m3, c_p {:.0} m/s, c_s {:.0} m/s; damping: {}",
                facts.density, facts.wave_speed_p, facts.wave_speed_s, facts.damping
            ));
            for (words, derived) in [("given", false), ("derived", true)] {
                let values = facts.values.iter().filter(|v| (v.origin == Origin::Derived) == derived);
                let values: Vec<String> = values.map(|v| format!("{} {}", v.name, text(v))).collect();
                if !values.is_empty() {
                    print(&format!("             {words}: {}", values.join(", ")));
                }
            }
        }
    }
}
