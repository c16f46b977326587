//! The section of a mesh that is the same all along y.

use std::collections::{BTreeMap, HashMap};

use super::curve::{Curve, Freedom, dot, length, minus};
use crate::{Element, Face, Mesh};

/// cos of the turn beyond which a border has a corner at a node, which must stay.
const CORNER: f64 = 0.77;
/// The same of a border that may move: where it is straighter it is kept.
const STRAIGHT: f64 = 0.98;

/// One element after the other along y.
pub(super) struct Cell {
    /// Three or four points, counter-clockwise with x to the right and z up.
    pub corners: Vec<u32>,
    /// Its elements by their places along y.
    pub elements: Vec<u32>,
    /// Whether no plane parts it.
    pub whole: bool,
}

/// A section, x to the right and z up.
pub(super) struct Section {
    pub points: Vec<[f64; 2]>,
    /// The nodes of each point, by their places along y.
    pub columns: Vec<Vec<u32>>,
    pub cells: Vec<Cell>,
    pub freedom: Vec<Freedom>,
    /// Whether a point lies on the section's outline.
    pub outer: Vec<bool>,
    /// Cells at each point.
    pub round: Vec<Vec<u32>>,
    /// Points joined with each by an edge.
    pub beside: Vec<Vec<u32>>,
    /// The cells at each edge, by its points in ascending order.
    pub edges: BTreeMap<[u32; 2], Vec<u32>>,
    /// The point at the same z on the opposite side, of points on the sides.
    pub opposite: HashMap<u32, u32>,
}

/// The nodes of an element's faces at its lower and at its upper y, each lower one with the upper one behind it, in the order in which
/// the lower face is seen from outside; nothing if it is no such element.
pub(super) fn ends(mesh: &Mesh, element: &Element) -> Option<(Vec<u32>, Vec<u32>)> {
    let nodes = element.nodes();
    let y = |n: u32| mesh.nodes[n as usize][1];
    let low = nodes.iter().map(|&n| y(n)).fold(f64::INFINITY, f64::min);
    let lower = |n: &u32| y(*n) == low;
    if 2 * nodes.iter().filter(|n| lower(n)).count() != nodes.len() {
        return None;
    }
    let faces =
        element.shape.faces().iter().map(|face| face.iter().map(|&k| element.nodes[k]).collect::<Vec<u32>>());
    let face = faces.into_iter().find(|face| face.iter().all(lower))?;
    let place = |n: u32| [mesh.nodes[n as usize][0], mesh.nodes[n as usize][2]];
    let behind = |n: &u32| nodes.iter().copied().find(|m| !lower(m) && place(*m) == place(*n));
    let upper: Vec<u32> = face.iter().map(behind).collect::<Option<_>>()?;
    Some((face, upper))
}

impl Section {
    /// The section of a mesh; nothing if it is not the same all along y. `ways` are those of the planes that cut it before, as pairs of
    /// nodes: they are borders. `loose` lets the borders of soft groups move.
    pub fn of(
        mesh: &Mesh,
        whole: &[bool],
        soft: &[String],
        ways: &[Vec<[u32; 2]>],
        loose: bool,
    ) -> Result<Section, ()> {
        let mut planes: Vec<f64> = mesh.nodes.iter().map(|x| x[1]).collect();
        planes.sort_by(f64::total_cmp);
        planes.dedup();
        let level = |y: f64| planes.partition_point(|p| *p < y);
        let bits = |x: f64| (x + 0.0).to_bits();
        let mut known: HashMap<[u64; 2], u32> = HashMap::new();
        let (mut points, mut columns) = (Vec::new(), Vec::<Vec<u32>>::new());
        let mut point_of = vec![0; mesh.nodes.len()];
        for (n, x) in mesh.nodes.iter().enumerate() {
            let point = *known.entry([bits(x[0]), bits(x[2])]).or_insert_with(|| {
                points.push([x[0], x[2]]);
                columns.push(vec![u32::MAX; planes.len()]);
                points.len() as u32 - 1
            });
            point_of[n] = point;
            columns[point as usize][level(x[1])] = n as u32;
        }
        if columns.iter().flatten().any(|n| *n == u32::MAX) {
            return Err(());
        }
        let mut cells: Vec<Cell> = Vec::new();
        let mut cell_of: HashMap<Vec<u32>, usize> = HashMap::new();
        for (e, element) in mesh.elements.iter().enumerate() {
            let (lower, upper) = ends(mesh, element).ok_or(())?;
            let at = level(mesh.nodes[lower[0] as usize][1]);
            if level(mesh.nodes[upper[0] as usize][1]) != at + 1 {
                return Err(());
            }
            let corners: Vec<u32> = lower.iter().map(|&n| point_of[n as usize]).collect();
            let mut key = corners.clone();
            key.sort_unstable();
            let cell = *cell_of.entry(key).or_insert_with(|| {
                cells.push(Cell { corners, elements: vec![u32::MAX; planes.len() - 1], whole: false });
                cells.len() - 1
            });
            cells[cell].elements[at] = e as u32;
            cells[cell].whole |= whole[e];
        }
        if cells.iter().flat_map(|cell| &cell.elements).any(|e| *e == u32::MAX) {
            return Err(());
        }
        let mut section = Section {
            freedom: vec![Freedom::Free; points.len()],
            outer: vec![false; points.len()],
            round: vec![Vec::new(); points.len()],
            beside: vec![Vec::new(); points.len()],
            edges: BTreeMap::new(),
            opposite: HashMap::new(),
            points,
            columns,
            cells,
        };
        section.join();
        let lines: Vec<[u32; 2]> =
            ways.iter().flatten().map(|way| way.map(|n| point_of[n as usize])).collect();
        section.free(&parts(mesh, &section.cells, soft), &lines, loose);
        section.pair();
        Ok(section)
    }

    /// Finds what lies beside what.
    fn join(&mut self) {
        for (c, cell) in self.cells.iter().enumerate() {
            for (k, &a) in cell.corners.iter().enumerate() {
                let b = cell.corners[(k + 1) % cell.corners.len()];
                self.round[a as usize].push(c as u32);
                let cells = self.edges.entry(key(a, b)).or_default();
                if cells.is_empty() {
                    self.beside[a as usize].push(b);
                    self.beside[b as usize].push(a);
                }
                cells.push(c as u32);
            }
        }
        for (&[a, b], cells) in &self.edges {
            if cells.len() == 1 {
                self.outer[a as usize] = true;
                self.outer[b as usize] = true;
            }
        }
    }

    /// Finds how points may move, by the borders between parts, hard and soft, and the lines of earlier planes.
    fn free(&mut self, parts: &[[u32; 2]], lines: &[[u32; 2]], loose: bool) {
        let mut borders: Vec<[Vec<u32>; 2]> = vec![[Vec::new(), Vec::new()]; self.points.len()];
        for (&[a, b], cells) in &self.edges {
            let is = |which: usize| {
                cells.len() != 2 || parts[cells[0] as usize][which] != parts[cells[1] as usize][which]
            };
            let kind = if is(0) || lines.iter().any(|&[p, q]| key(p, q) == [a, b]) {
                0
            } else if is(1) && !loose {
                1
            } else {
                continue;
            };
            borders[a as usize][kind].push(b);
            borders[b as usize][kind].push(a);
        }
        for (p, [hard, soft]) in borders.iter().enumerate() {
            self.freedom[p] = match (&hard[..], &soft[..]) {
                ([], []) => Freedom::Free,
                ([], &[a, b]) => self.curve(a, p, b, STRAIGHT).unwrap_or(Freedom::Free),
                ([], _) => Freedom::Free,
                (&[a, b], _) => self.curve(a, p, b, CORNER).unwrap_or(Freedom::Fixed),
                _ => Freedom::Fixed,
            };
        }
    }

    /// A border through three points, unless it turns too much at the middle one.
    fn curve(&self, before: u32, at: usize, behind: u32, least: f64) -> Option<Freedom> {
        let [before, behind] = [before, behind].map(|p| self.points[p as usize]);
        let at = self.points[at];
        let (to, from) = (minus(at, before), minus(behind, at));
        let straight = dot(to, from) > least * length(to) * length(from);
        straight.then(|| Freedom::Along(Curve::through(before, at, behind)))
    }

    /// Pairs points of the sides x = const that lie at the same z.
    fn pair(&mut self) {
        let x = || self.points.iter().map(|p| p[0]);
        let (low, high) = (x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max));
        let on = |side: f64| {
            (0u32..).zip(&self.points).filter(move |(_, p)| p[0] == side).map(|(p, x)| (p, x[1].to_bits()))
        };
        let right: HashMap<u64, u32> = on(high).map(|(p, z)| (z, p)).collect();
        let pairs: Vec<[u32; 2]> = on(low).filter_map(|(p, z)| Some([p, *right.get(&z)?])).collect();
        for [a, b] in pairs {
            self.opposite.insert(a, b);
            self.opposite.insert(b, a);
        }
    }

    /// The sum of e eᵀ over the edges at a point, such that of a node between bricks it is that of its two directions: how far it may
    /// go, by direction \[m²\].
    pub fn spread(&self, p: u32) -> [[f64; 2]; 2] {
        let mut sum = [[0.0; 2]; 2];
        let beside = &self.beside[p as usize];
        for &q in beside {
            let e = minus(self.points[q as usize], self.points[p as usize]);
            (0..2).for_each(|i| (0..2).for_each(|j| sum[i][j] += 2.0 * e[i] * e[j] / beside.len() as f64));
        }
        sum
    }

    /// Whether an edge or diagonal lies inside what is whole.
    pub fn inside_whole(&self, a: u32, b: u32) -> bool {
        match self.edges.get(&key(a, b)) {
            Some(cells) => cells.len() == 2 && cells.iter().all(|&c| self.cells[c as usize].whole),
            None => self.shared(a, b).is_some_and(|c| self.cells[c as usize].whole),
        }
    }

    /// A cell that has both points.
    pub fn shared(&self, a: u32, b: u32) -> Option<u32> {
        self.round[a as usize].iter().copied().find(|c| self.cells[*c as usize].corners.contains(&b))
    }
}

pub(super) fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// What parts each cell belongs to: by groups whose borders stay, and by those whose borders may move. The groups of the planes
/// themselves are not there yet.
fn parts(mesh: &Mesh, cells: &[Cell], soft: &[String]) -> Vec<[u32; 2]> {
    let mut names: Vec<[Vec<u32>; 2]> = vec![[Vec::new(), Vec::new()]; mesh.elements.len()];
    for (g, (name, elements)) in (0..).zip(&mesh.groups) {
        let which = usize::from(soft.contains(name));
        elements.iter().for_each(|&e| names[e as usize][which].push(g));
    }
    let mut known: [BTreeMap<Vec<&Vec<u32>>, u32>; 2] = [BTreeMap::new(), BTreeMap::new()];
    let mut all = Vec::with_capacity(cells.len());
    for cell in cells {
        all.push([0, 1].map(|which| {
            let along: Vec<&Vec<u32>> = cell.elements.iter().map(|&e| &names[e as usize][which]).collect();
            let next = known[which].len() as u32;
            *known[which].entry(along).or_insert(next)
        }));
    }
    all
}

/// Face sets keep their faces where an element is parted: those of its pieces whose nodes they had.
pub(super) fn renamed(mesh: &Mesh, face: Face, old: &Element, pieces: [u32; 2]) -> Vec<Face> {
    let had: Vec<u32> = old.shape.faces()[face.side as usize].iter().map(|&k| old.nodes[k]).collect();
    let sides = pieces.into_iter().flat_map(|element| {
        let count = mesh.elements[element as usize].shape.faces().len() as u8;
        (0..count).map(move |side| Face { element, side })
    });
    sides.filter(|&new| mesh.face_nodes(new).all(|n| had.contains(&n))).collect()
}
