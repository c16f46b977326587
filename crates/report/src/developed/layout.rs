//! How developed sheets are laid out on a figure.

use crate::developed::unfold::{Flat, Sheet};
use crate::language::{Language, say};

/// Room left of a panel's sheets for numbers, and right of them for the colour bar with its key.
pub const LEFT: f64 = 52.0;
pub const BAR: f64 = 142.0;
/// Right of sheets whose axis lies across: what their parts are.
const SIDES: f64 = 74.0;
const WIDTH: f64 = 940.0;
/// Between sheets: room for a name, or for numbers.
const BETWEEN: f64 = 34.0;
const TALLEST: f64 = 620.0;

/// Whether each panel has a bar of colours beside it, or the last one alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bars {
    Each,
    One,
}

/// Where sheets lie, in figure units from the panel's upper left corner of the sheets.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Whether their axes run upwards rather than across.
    pub upright: bool,
    /// Figure units per metre.
    pub zoom: f64,
    /// Whether panels stand side by side.
    pub beside: bool,
    bars: Bars,
    /// Of all sheets together.
    pub size: (f64, f64),
    pub spots: Vec<Spot>,
}

/// One sheet: where its corner of the least u and v lies, and its extent along u and to the right of the crown.
#[derive(Clone, Debug)]
pub struct Spot {
    pub at: (f64, f64),
    /// From and to, in m: u, and s = −v.
    pub u: [f64; 2],
    pub s: [f64; 2],
}

impl Layout {
    /// The one that shows sheets largest in so many panels of equal content.
    pub fn of(sheets: &[Sheet], panels: usize, bars: Bars) -> Self {
        let ends: Vec<Spot> = sheets.iter().map(extent).collect();
        let sum = |along: fn(&Spot) -> [f64; 2]| ends.iter().map(|e| along(e)[1] - along(e)[0]).sum::<f64>();
        let most = ends.iter().map(|e| e.u[1] - e.u[0]).fold(1e-9, f64::max);
        let around = sum(|e| e.s).max(1e-9);
        let gaps = BETWEEN * (sheets.len().saturating_sub(1)) as f64;
        let mut best: Option<Layout> = None;
        for (upright, beside) in [(false, false), (true, false), (false, true), (true, true)] {
            // A dip is drawn upwards.
            if (beside && panels < 2) || (upright && !sheets.iter().all(|sheet| sheet.wraps)) {
                continue;
            }
            let (columns, rows) = if beside { (panels as f64, 1.0) } else { (1.0, panels as f64) };
            let sides = if upright { 0.0 } else { SIDES };
            let bar = if bars == Bars::Each { columns * BAR } else { BAR };
            let room = ((WIDTH - bar) / columns - LEFT - sides, TALLEST / rows);
            let zoom = if upright {
                ((room.0 - gaps) / around).min(room.1 / most)
            } else {
                (room.0 / most).min((room.1 - gaps) / around)
            };
            // Of nearly equal ones the first, whose axis lies across.
            if best.as_ref().is_none_or(|known| zoom > 1.05 * known.zoom) {
                best = Some(Layout { upright, zoom, beside, bars, size: (0.0, 0.0), spots: ends.clone() });
            }
        }
        let mut layout = best.unwrap_or(Layout {
            upright: false,
            zoom: 1.0,
            beside: false,
            bars,
            size: (0.0, 0.0),
            spots: ends,
        });
        layout.lay();
        layout
    }

    fn lay(&mut self) {
        let mut across = 0.0;
        let most = self.spots.iter().map(|e| e.u[1] - e.u[0]).fold(0.0, f64::max) * self.zoom;
        for (k, spot) in self.spots.iter_mut().enumerate() {
            across += if k == 0 { 0.0 } else { BETWEEN };
            spot.at = if self.upright { (across, most) } else { (0.0, across) };
            across += (spot.s[1] - spot.s[0]) * self.zoom;
        }
        self.size = if self.upright { (across, most) } else { (most, across) };
    }

    /// Where a point (u, v) of a sheet lies.
    pub fn place(&self, sheet: usize, [u, v]: [f64; 2]) -> (f64, f64) {
        let Spot { at, u: [first, _], s: [left, _] } = self.spots[sheet];
        let (along, around) = ((u - first) * self.zoom, (-v - left) * self.zoom);
        if self.upright { (at.0 + around, at.1 - along) } else { (at.0 + along, at.1 + around) }
    }

    /// Width of a panel with what stands beside its sheets.
    pub fn panel_width(&self, panels: usize) -> f64 {
        match (self.beside, self.bars) {
            (false, _) => WIDTH,
            (true, Bars::Each) => WIDTH / panels as f64,
            (true, Bars::One) => (WIDTH - BAR) / panels as f64,
        }
    }

    /// Where the colour bar begins, from the sheets' left.
    pub fn bar_at(&self) -> f64 {
        self.size.0 + if self.upright { 20.0 } else { SIDES + 12.0 }
    }
}

fn extent(sheet: &Sheet) -> Spot {
    let ends = |c: &dyn Fn(&[f64; 2]) -> f64| {
        let all = sheet.faces.iter().flat_map(|face| &face.corners).map(c);
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    Spot { at: (0.0, 0.0), u: ends(&|c| c[0]), s: ends(&|c| -c[1]) }
}

/// What a run of faces of a lining may be.
#[derive(Clone, Copy, PartialEq)]
enum SheetPart {
    Crown,
    Floor,
    Left,
    Right,
}

/// What a run of faces of a lining is, and the middle of where it lies to the right of the crown (m).
pub fn marks(language: Language, sheet: &Sheet) -> Vec<(String, f64)> {
    const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;
    if !sheet.wraps || sheet.axis[2].abs() > 0.5 {
        return Vec::new();
    }
    let [x, y, _] = sheet.axis;
    let mut ends: Vec<(SheetPart, bool, [f64; 2])> = Vec::new();
    for face in sheet.faces.iter().filter(|face| !face.end && face.piece == 0) {
        let n = face.normal;
        let s = -face.corners.iter().map(|c| c[1]).sum::<f64>() / face.corners.len() as f64;
        let name = match n[2] {
            up if up > STEEP => SheetPart::Crown,
            up if up < -STEEP => SheetPart::Floor,
            // Right of who looks along the axis: axis × z.
            _ if n[0] * y - n[1] * x > 0.0 => SheetPart::Right,
            _ => SheetPart::Left,
        };
        // The floor is cut in two.
        let side = name == SheetPart::Floor && s > 0.0;
        match ends.iter_mut().find(|(known, left, _)| *known == name && *left == side) {
            Some((_, _, [low, high])) => (*low, *high) = (low.min(s), high.max(s)),
            None => ends.push((name, side, [s, s])),
        }
    }
    // A lining without a floor has feet that face downwards.
    let around = ends.iter().map(|(.., [low, high])| high - low).sum::<f64>();
    let name = |part: SheetPart, width: f64| match part {
        SheetPart::Floor if width < 0.05 * around => say!(language, "foot"),
        SheetPart::Floor => say!(language, "floor"),
        SheetPart::Crown => say!(language, "crown"),
        SheetPart::Left => say!(language, "left wall"),
        SheetPart::Right => say!(language, "right wall"),
    };
    ends.into_iter().map(|(own, _, [low, high])| (name(own, high - low), 0.5 * (low + high))).collect()
}

/// The middles (u, v) of the end walls of a lining.
pub fn end_walls(sheet: &Sheet) -> Vec<[f64; 2]> {
    let middle = |faces: &mut dyn Iterator<Item = &Flat>| {
        let mut sum = [0.0; 3];
        for corner in faces.flat_map(|face| &face.corners) {
            sum = [sum[0] + corner[0], sum[1] + corner[1], sum[2] + 1.0];
        }
        (sum[2] > 0.0).then(|| [sum[0] / sum[2], sum[1] / sum[2]])
    };
    let Some([along, _]) = middle(&mut sheet.faces.iter().filter(|face| !face.end)) else {
        return Vec::new();
    };
    let ends = |far: bool| {
        let beyond = move |face: &&Flat| face.end && (face.corners[0][0] > along) == far;
        middle(&mut sheet.faces.iter().filter(beyond))
    };
    if sheet.wraps { [ends(false), ends(true)].into_iter().flatten().collect() } else { Vec::new() }
}
