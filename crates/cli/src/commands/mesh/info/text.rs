//! What is said of a mesh, in words and tables.

use super::Info;
use crate::commands::mesh::steps::{FEW, NEAR};
use crate::terminal::print;
use std::collections::BTreeMap;
use std::path::Path;
use tremolite::hexahedra::centroid;
use tremolite_mesh::quality::{self, Summary};

impl Info<'_> {
    pub(super) fn print(&self, file: &Path) {
        let mesh = self.mesh;
        print(&format!("{}, {} nodes", in_words(&self.types(self.all())), mesh.nodes.len()));
        let (low, high) = mesh.bounds();
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            print(&format!("  {name} from {:.3} to {:.3} m", low[axis], high[axis]));
        }
        print(&format!(
            "\n{:30} {:>9} {:>13} {:>9} {:>17} {:>8}  types",
            "group", "elements", "volume [m3]", "Jacobian", "edges [m]", "aspect"
        ));
        self.row("(all)", &self.whole, self.all());
        for (name, of) in &self.groups {
            self.row(name, of, mesh.groups[*name].iter().copied());
        }
        self.print_steps();
        self.print_topology(file);
    }

    fn row(&self, name: &str, of: &Summary, elements: impl Iterator<Item = u32>) {
        let edges = format!("{:.3} to {:.3}", of.shortest_edge, of.longest_edge);
        print(&format!(
            "{name:30} {:>9} {:>13.1} {:>9.3} {edges:>17} {:>8.1}  {}",
            of.elements,
            of.volume,
            of.min_scaled_jacobian,
            of.max_aspect,
            in_words(&self.types(elements))
        ));
    }

    fn print_steps(&self) {
        print("\nstable step, of each element alone");
        let (whole, by_group) = self.limits();
        let Some(whole) = whole else {
            print("  no element has a material");
            return;
        };
        for made in &self.made {
            let Some(limits) = self.steps.limits(made.elements.iter().copied()) else { continue };
            print(&format!(
                "  {:28} {:>9} elements, c_p {:.0} m/s: {:.3e} s, {:.2} times that of the run",
                made.name,
                made.elements.len(),
                made.p_wave(),
                limits.step,
                limits.step / whole.step
            ));
        }
        if self.assumed {
            print(
                "  assumed: E = 10 GPa, nu = 0.25, density = 2752 kg/m3 everywhere; --material gives others",
            );
        }
        let unknown = self.steps.unknown();
        if unknown > 0 {
            print(&format!("  {unknown} elements have no material and do not count"));
        }
        print(&format!(
            "\n{:30} {:>11} {:>11} {:>9}  worst element",
            "group", "step [s]", "median [s]", "near it"
        ));
        for (name, limits) in [("(all)", whole)].into_iter().chain(by_group) {
            let quality = quality::of(self.mesh, limits.element as usize);
            print(&format!(
                "{name:30} {:>11.3e} {:>11.3e} {:>9}  {}: edges {:.3} to {:.3} m, Jacobian {:.2}",
                limits.step,
                limits.median,
                limits.near,
                self.element(limits.element),
                quality.shortest_edge,
                quality.longest_edge,
                quality.scaled_jacobian
            ));
        }
        print(&format!("  near it: elements within {NEAR} times the step"));
        let times = |step: f64| format!("{:.2}", step / whole.step);
        let mut words = format!("{} times without its worst {FEW} elements", times(whole.without_few));
        // Of a small mesh a hundredth is less than that.
        if self.mesh.elements.len() > 100 * FEW {
            words.push_str(&format!(", {} times without the worst hundredth", times(whole.percentile)));
        }
        print(&format!(
            "  a run could take longer steps: {words}, {} times if no element were worse than the median",
            times(whole.median)
        ));
        let worst = self.steps.worst(FEW).into_iter().map(|e| self.mesh.element_id(e as usize).to_string());
        print(&format!("  the worst {FEW}: {}", worst.collect::<Vec<_>>().join(", ")));
    }

    fn element(&self, element: u32) -> String {
        let [x, y, z] = centroid(self.mesh, element);
        format!("{} at ({x:.1}, {y:.1}, {z:.1}) m", self.mesh.element_id(element as usize))
    }

    fn print_topology(&self, file: &Path) {
        let count = |name: &str, count: usize| print(&format!("  {name:28} {count:>9}"));
        print("\nouter faces by side");
        for (name, faces) in &self.sides {
            count(name, faces.len());
        }
        if let Some(angle) = self.turned {
            print(&format!(
                "the outer sides are turned by {:.6} deg about z: mesh.file.rotate of a case, or mesh convert --rotate, turns them",
                angle.to_degrees()
            ));
        }
        if !self.mesh.faces.is_empty() {
            print("named faces");
            for (name, faces) in &self.mesh.faces {
                count(name, faces.len());
            }
        }
        print(&format!("outer faces on no side and in no named set: {}", self.elsewhere));
        if let Some(first) = self.crowded.first() {
            print(&format!(
                "{} faces are shared by more than two elements: elements lie on one another, such as {}; remove one of each",
                self.crowded.len(),
                self.element(first.element)
            ));
        }
        match self.parts.as_slice() {
            [_] => print("all elements hang together"),
            parts => {
                let sizes: Vec<String> = parts.iter().take(8).map(usize::to_string).collect();
                let more = if parts.len() > 8 { ", …" } else { "" };
                print(&format!("{} separate parts, of {}{more} elements", parts.len(), sizes.join(", ")));
            }
        }
        let (tolerance, pairs) = self.coincident;
        let file = file.display().to_string();
        let file = if file.contains(char::is_whitespace) { format!("\"{file}\"") } else { file };
        if pairs > 0 {
            print(&format!(
                "{pairs} nodes lie within {tolerance:.1e} m of another; this joins them:\n  \
                 tremolite mesh convert {file} joined.vtu --merge {tolerance:.1e}"
            ));
        } else {
            print(&format!("no two nodes lie within {tolerance:.1e} m of one another"));
        }
    }
}

fn in_words(types: &BTreeMap<&str, usize>) -> String {
    types.iter().map(|(name, count)| format!("{count} {name}")).collect::<Vec<_>>().join(", ")
}
