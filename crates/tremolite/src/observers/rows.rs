//! A row of what monitors see: of monitors.csv as the ground shakes, of stages.csv at the end of a stage.
//!
//! One list of cells, a column each with its value, makes headers and rows, whoever saw.

use crate::plan::{Monitor, Plan};
use crate::quantities::{BOLT, MONITOR, MonitorSeen, PAIR, RELATIVE, WET};
use tremolite_engine::bolts::SegmentSeen;
use tremolite_kernels::contact::PairSeen;
use tremolite_results::{Column, Subject};

/// What all monitors of a plan see at one time, in its order; nothing where nothing stands.
#[derive(Default)]
pub struct Seen {
    pub monitors: Vec<Option<MonitorSeen>>,
    /// On interfaces.
    pub pairs: Vec<Option<PairSeen>>,
    /// On bolts.
    pub bolts: Vec<Option<SegmentSeen>>,
}

impl Seen {
    /// Displacement \[m\] of one monitor less that of another.
    fn relative(&self, [first, second]: [usize; 2]) -> Option<[f64; 3]> {
        let (first, second) = (self.monitors[first]?.moved.u, self.monitors[second]?.moved.u);
        Some([0, 1, 2].map(|i| first[i] - second[i]))
    }
}

/// A cell's value of what is seen.
type Value = Box<dyn Fn(&Seen) -> f64 + Send + Sync>;

/// A column and what stands in it.
pub struct Cell {
    pub column: Column,
    /// Where its subject is, whatever it is called.
    pub place: String,
    value: Value,
}

impl Cell {
    /// The value in a row; not a number where nothing stands.
    pub fn value(&self, seen: &Seen) -> f64 {
        (self.value)(seen)
    }
}

/// The cells of a plan's monitors, in the order of the tables.
pub fn cells(plan: &Plan) -> Vec<Cell> {
    let mut cells = Vec::new();
    let mut add = |subject: &Subject, place: &str, (name, unit), value: Value| {
        cells.push(Cell { column: Column::of(subject.clone(), name, unit), place: place.to_owned(), value });
    };
    let name = |monitor: &Monitor| monitor.name.clone();
    for (k, monitor) in plan.monitors.iter().enumerate() {
        let (subject, place) = (Subject::Monitor(name(monitor)), format!("{:?}", monitor.point));
        for q in MONITOR.iter().chain(WET.iter().filter(|_| plan.water)) {
            let value = |seen: &MonitorSeen| q.value.at(seen);
            add(&subject, &place, (q.name, q.unit), Box::new(move |s| or_nan(s.monitors[k].as_ref(), value)));
        }
    }
    for &pair in &plan.relatives {
        let [a, b] = pair.map(|k| &plan.monitors[k]);
        let (subject, place) =
            (Subject::Relative([name(a), name(b)]), format!("{:?} {:?}", a.point, b.point));
        for q in RELATIVE {
            add(
                &subject,
                &place,
                (q.name, q.unit),
                Box::new(move |s| or_nan(s.relative(pair).as_ref(), q.value)),
            );
        }
    }
    for (k, pair) in plan.pairs.iter().enumerate() {
        let (subject, place) =
            (Subject::Pair(pair.name.clone()), format!("{:?} {}", pair.point, pair.interface));
        for q in PAIR {
            add(&subject, &place, (q.name, q.unit), Box::new(move |s| or_nan(s.pairs[k].as_ref(), q.value)));
        }
    }
    for (k, bolt) in plan.bolts.iter().enumerate() {
        let (subject, place) =
            (Subject::Bolt(bolt.name.clone()), format!("{:?} bolts {}", bolt.point, bolt.set));
        for q in BOLT {
            add(&subject, &place, (q.name, q.unit), Box::new(move |s| or_nan(s.bolts[k].as_ref(), q.value)));
        }
    }
    cells
}

fn or_nan<S>(seen: Option<&S>, value: impl Fn(&S) -> f64) -> f64 {
    seen.map_or(f64::NAN, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{BoltMonitor, PairMonitor};
    use crate::quantities::Moved;
    use crate::support::tests::{plan, under};
    use std::collections::BTreeMap;
    use tremolite_mesh::locate::Location;

    /// Two monitors with their pair, and one each on an interface and a bolt.
    fn watched() -> Plan {
        let point = [0.0; 3];
        let location = Location { element: 0, natural: point, weights: [0.125; 8], distance: 0.0 };
        let monitor = |name: &str| Monitor { name: name.into(), point, location };
        Plan {
            monitors: vec![monitor("a.b-c"), monitor("d")],
            relatives: vec![[0, 1]],
            sections: Vec::new(),
            pairs: vec![PairMonitor { name: "joint".into(), point, interface: 0 }],
            bolts: vec![BoltMonitor { name: "bar".into(), point, set: 0 }],
            ..plan(&[])
        }
    }

    fn monitor(u: [f64; 3]) -> MonitorSeen {
        let moved = Moved { u, v: [4.0, 5.0, 6.0], a: [7.0, 8.0, 9.0], s1_elastic: 19.0 };
        MonitorSeen {
            moved,
            stress: [10.0, 11.0, 12.0, 13.0, 14.0, 15.0],
            principal: [16.0, 17.0, 18.0],
            pore: 0.5,
        }
    }

    fn row<'c>(cells: &'c [Cell], seen: &Seen) -> BTreeMap<&'c str, f64> {
        let row: BTreeMap<&str, f64> =
            cells.iter().map(|cell| (cell.column.name.as_str(), cell.value(seen))).collect();
        assert_eq!(row.len(), cells.len(), "two columns of one name");
        row
    }

    #[test]
    fn every_column_holds_what_its_name_says() {
        let cells = cells(&watched());
        let pair = PairSeen {
            gap: 1.0,
            slip: [2.0, 3.0],
            pressure: 4.0,
            shear: [-5.0, -6.0],
            state: 2,
            ..PairSeen::default()
        };
        let seen = Seen {
            monitors: vec![Some(monitor([1.0, 2.0, 3.0])), Some(monitor([-1.0, 1.0, 1.0]))],
            pairs: vec![Some(pair)],
            bolts: vec![Some(SegmentSeen { slip: 3.0, ..under(-1e5) })],
        };
        let row = row(&cells, &seen);
        let names = "ux uy uz vx vy vz ax ay az sxx syy szz sxy syz szx s1 s2 s3 s1_elastic";
        for (name, value) in names.split(' ').zip(1u8..) {
            assert_eq!(row[format!("a.b-c.{name}").as_str()], f64::from(value), "{name}");
        }
        for (name, value) in [("ux", 2.0), ("uy", 1.0), ("uz", 2.0), ("u", 3.0)] {
            assert_eq!(row[format!("a.b-c-d.{name}").as_str()], value, "{name}");
        }
        let names = ["gap", "slip1", "slip2", "pressure", "shear1", "shear2"];
        for (name, value) in names.into_iter().zip(1u8..) {
            assert_eq!(row[format!("joint.{name}").as_str()], f64::from(value), "{name}");
        }
        let others = [("joint.state", 2.0), ("bar.force", -1e5), ("bar.force_over_yield", 0.5)];
        for (name, value) in others.into_iter().chain([("bar.slip", 3.0), ("bar.state", 0.0)]) {
            assert_eq!(row[name], value, "{name}");
        }
    }

    #[test]
    fn with_water_a_monitor_tells_the_pressure_and_effective_stresses_as_well() {
        let wet = Plan { water: true, ..watched() };
        let (all, dry) = (cells(&wet), cells(&watched()));
        assert_eq!(all.len(), dry.len() + 2 * WET.len());
        let seen = Seen { monitors: vec![Some(monitor([0.0; 3])); 2], pairs: vec![None], bolts: vec![None] };
        let row = row(&all, &seen);
        for (name, value) in [("p", 0.5), ("s1_eff", 16.5), ("s2_eff", 17.5), ("s3_eff", 18.5)] {
            assert_eq!(row[format!("d.{name}").as_str()], value, "{name}");
        }
    }

    #[test]
    fn every_subject_has_every_quantity_of_its_list_and_no_number_where_nothing_stands() {
        let cells = cells(&watched());
        let of = |subject: &Subject| -> Vec<(&str, &str)> {
            let own = cells.iter().filter(|cell| cell.column.subject == *subject);
            own.map(|cell| (cell.column.quantity.as_str(), cell.column.unit.as_str())).collect()
        };
        let [first, second] = ["a.b-c", "d"].map(str::to_owned);
        let all = [
            of(&Subject::Monitor(first.clone())),
            of(&Subject::Monitor(second.clone())),
            of(&Subject::Relative([first, second])),
            of(&Subject::Pair("joint".into())),
            of(&Subject::Bolt("bar".into())),
        ];
        let monitor: Vec<_> = MONITOR.iter().map(|q| (q.name, q.unit)).collect();
        let relative = RELATIVE.iter().map(|q| (q.name, q.unit)).collect();
        let pair = PAIR.iter().map(|q| (q.name, q.unit)).collect();
        let bolt = BOLT.iter().map(|q| (q.name, q.unit)).collect();
        assert_eq!(all, [monitor.clone(), monitor, relative, pair, bolt]);
        assert_eq!(all.concat().len(), cells.len());

        let nothing = Seen { monitors: vec![None; 2], pairs: vec![None], bolts: vec![None] };
        assert!(cells.iter().all(|cell| cell.value(&nothing).is_nan()));
    }
}
