//! Plates one element thick, of bricks and wedges, with parts left out.

use tremolite_mesh::{Element, Mesh, Shape};

/// A plate in x and z between y = 0 and its thickness.
pub struct Plate {
    pub mesh: Mesh,
    /// Where the nodes at y = 0 lie \[m\]; they are the mesh's first ones, and those opposite follow in the same order.
    pub points: Vec<[f64; 2]>,
}

impl Plate {
    /// Cells of three or four points, counter-clockwise where x points to the right and z up; points without a cell are left out.
    fn new(points: &[[f64; 2]], cells: &[Vec<usize>], thickness: f64) -> Self {
        let mut number = vec![u32::MAX; points.len()];
        let mut used = Vec::new();
        for &p in cells.iter().flatten() {
            if number[p] == u32::MAX {
                number[p] = used.len() as u32;
                used.push(points[p]);
            }
        }
        let behind = used.len() as u32;
        let elements = cells.iter().map(|cell| {
            let front: Vec<u32> = cell.iter().map(|&p| number[p]).collect();
            match front[..] {
                [a, b, c, d] => {
                    let [e, f, g, h] = [a, b, c, d].map(|n| n + behind);
                    Element::new(Shape::Hex8, &[a, b, f, e, d, c, g, h])
                }
                [a, b, c] => Element::new(Shape::Wedge6, &[a + behind, b + behind, c + behind, a, b, c]),
                _ => unreachable!("cells have three or four points"),
            }
        });
        let mut mesh = Mesh { elements: elements.collect(), ..Mesh::default() };
        for y in [0.0, thickness] {
            mesh.nodes.extend(used.iter().map(|x| [x[0], y, x[1]]));
        }
        Plate { mesh, points: used }
    }

    /// Bricks between lines along x and z \[m\], of those whose centre is kept.
    pub fn bricks(lines: [&[f64]; 2], thickness: f64, keep: impl Fn([f64; 2]) -> bool) -> Self {
        let [across, up] = lines;
        let points: Vec<[f64; 2]> = up.iter().flat_map(|&z| across.iter().map(move |&x| [x, z])).collect();
        let mut cells = Vec::new();
        for k in 0..up.len() - 1 {
            for i in 0..across.len() - 1 {
                let n = |i: usize, k: usize| i + k * across.len();
                if keep([0.5 * (across[i] + across[i + 1]), 0.5 * (up[k] + up[k + 1])]) {
                    cells.push(vec![n(i, k), n(i + 1, k), n(i + 1, k + 1), n(i, k + 1)]);
                }
            }
        }
        Plate::new(&points, &cells, thickness)
    }

    /// Squares that stand on their corners, with half diagonals of `half` \[m\], and halves of them along the edges; of those whose
    /// centre is kept. All edges must lie on multiples of `half`, even ones where two meet.
    pub fn diamonds(numbers: [usize; 2], half: f64, thickness: f64, keep: impl Fn([f64; 2]) -> bool) -> Self {
        let [wide, high] = numbers;
        let n = |i: usize, k: usize| i + k * (wide + 1);
        let points: Vec<[f64; 2]> =
            (0..=high).flat_map(|k| (0..=wide).map(move |i| [i as f64 * half, k as f64 * half])).collect();
        let centre = |cell: &[usize]| {
            let sum = cell.iter().fold([0.0, 0.0], |s, &p| [s[0] + points[p][0], s[1] + points[p][1]]);
            sum.map(|s| s / cell.len() as f64)
        };
        let mut cells = Vec::new();
        // Each diamond about a point with an odd sum of numbers, each half of it where the other lies outside.
        for k in 0..=high {
            for i in (0..=wide).filter(|i| (i + k) % 2 == 1) {
                let right =
                    (i < wide && k > 0 && k < high).then(|| vec![n(i, k - 1), n(i + 1, k), n(i, k + 1)]);
                let left = (i > 0 && k > 0 && k < high).then(|| vec![n(i, k - 1), n(i, k + 1), n(i - 1, k)]);
                let upper =
                    (k < high && i > 0 && i < wide).then(|| vec![n(i - 1, k), n(i + 1, k), n(i, k + 1)]);
                let lower = (k > 0 && i > 0 && i < wide).then(|| vec![n(i - 1, k), n(i, k - 1), n(i + 1, k)]);
                let stands = |half: &Option<Vec<usize>>| half.as_ref().is_some_and(|cell| keep(centre(cell)));
                match [&right, &left, &upper, &lower].map(stands) {
                    [true, true, true, true] => {
                        cells.push(vec![n(i, k - 1), n(i + 1, k), n(i, k + 1), n(i - 1, k)]);
                    }
                    [true, false, ..] => cells.extend(right),
                    [false, true, ..] => cells.extend(left),
                    [_, _, true, false] => cells.extend(upper),
                    [_, _, false, true] => cells.extend(lower),
                    _ => {}
                }
            }
        }
        Plate::new(&points, &cells, thickness)
    }

    /// The same with its nodes moved.
    pub fn moved(mut self, to: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        self.points.iter_mut().for_each(|x| *x = to(*x));
        for (n, x) in self.mesh.nodes.iter_mut().enumerate() {
            let point = self.points[n % self.points.len()];
            *x = [point[0], x[1], point[1]];
        }
        self
    }

    /// The points of an element at y = 0.
    pub fn outline(&self, element: u32) -> Vec<u32> {
        let front = self.points.len() as u32;
        let mut nodes: Vec<u32> =
            self.mesh.elements[element as usize].nodes().iter().copied().filter(|&n| n < front).collect();
        // Of a brick they come as a, b, d, c.
        if nodes.len() == 4 {
            nodes.swap(2, 3);
        }
        nodes
    }

    /// The mean of an element's corners \[m\].
    pub fn centre(&self, element: u32) -> [f64; 2] {
        let outline = self.outline(element);
        let sum = outline
            .iter()
            .map(|&n| self.points[n as usize])
            .fold([0.0, 0.0], |s, x| [s[0] + x[0], s[1] + x[1]]);
        sum.map(|s| s / outline.len() as f64)
    }

    /// The node at y = 0 that is nearest to a place \[m\].
    pub fn nearest(&self, x: [f64; 2]) -> u32 {
        let far = |n: &u32| (self.points[*n as usize][0] - x[0]).hypot(self.points[*n as usize][1] - x[1]);
        (0..self.points.len() as u32).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    }

    /// The two nodes of a row along x between which a place lies \[m\], and their shares in it.
    pub fn between(&self, x: [f64; 2]) -> [(u32, f64); 2] {
        let row = (0..self.points.len() as u32).filter(|&n| (self.points[n as usize][1] - x[1]).abs() < 1e-9);
        let place = |n: u32| self.points[n as usize][0];
        let (low, high): (Vec<u32>, Vec<u32>) = row.partition(|&n| place(n) <= x[0]);
        let low = low.into_iter().max_by(|&a, &b| place(a).total_cmp(&place(b)));
        let high = high.into_iter().min_by(|&a, &b| place(a).total_cmp(&place(b)));
        match (low, high) {
            (Some(a), Some(b)) => {
                let share = (x[0] - place(a)) / (place(b) - place(a));
                [(a, 1.0 - share), (b, share)]
            }
            (a, b) => [(a.or(b).unwrap_or(0), 1.0), (0, 0.0)],
        }
    }

    /// The nodes through the thickness that are picked, each as a corner of one element.
    pub fn corners(&self, pick: impl Fn([f64; 2]) -> bool) -> Vec<(u32, u8)> {
        let mut told = vec![false; self.mesh.nodes.len()];
        let mut corners = Vec::new();
        for (e, element) in (0u32..).zip(&self.mesh.elements) {
            let mut mask = 0;
            for (k, &node) in element.nodes().iter().enumerate() {
                let x = self.mesh.nodes[node as usize];
                if pick([x[0], x[2]]) && !told[node as usize] {
                    told[node as usize] = true;
                    mask |= 1 << k;
                }
            }
            if mask != 0 {
                corners.push((e, mask));
            }
        }
        corners
    }
}

/// Lines \[m\] from one place to the next: fine ones of at most `fine` between `from` and `to`, growing outside by at most `growth` a
/// step to at most `most`, down to `ends`.
pub fn graded(ends: [f64; 2], [from, to]: [f64; 2], fine: f64, growth: f64, most: f64) -> Vec<f64> {
    let beside = |length: f64| {
        // As many steps as growing ones need, then shrunk to fit.
        let (mut steps, mut sum, mut step) = (Vec::new(), 0.0, fine);
        while sum < length * (1.0 - 1e-9) {
            step = (step * growth).min(most);
            sum += step;
            steps.push(sum);
        }
        steps.into_iter().map(|s| s * length / sum).collect::<Vec<f64>>()
    };
    let many = ((to - from) / fine).round().max(1.0);
    let mut lines: Vec<f64> = beside(from - ends[0]).into_iter().rev().map(|s| from - s).collect();
    lines.extend((0..=many as u32).map(|i| from + (to - from) * f64::from(i) / many));
    lines.extend(beside(ends[1] - to).into_iter().map(|s| to + s));
    lines
}

/// 1 between the two inner numbers, 0 beyond the outer ones, and straight between.
pub fn within(x: f64, [none, all, still, gone]: [f64; 4]) -> f64 {
    ((x - none) / (all - none)).min((gone - x) / (gone - still)).clamp(0.0, 1.0)
}
