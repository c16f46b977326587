//! Levels of the ground at which series are kept, and cubics between them.

use super::ground::LayeredGround;

/// Points a wave length and a period.
pub const FINE: f64 = 20.0;

/// A level at which series are kept.
#[derive(Clone, Copy, Debug)]
pub struct At {
    pub layer: usize,
    /// m above the layer's bottom.
    pub above: f64,
}

/// Where levels are: cells of equal height in each layer.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Of each layer: its bottom, the height of a cell \[m\], the number of its first level, the number of its cells.
    layers: Vec<(f64, f64, usize, usize)>,
    pub levels: Vec<At>,
}

impl Grid {
    /// For waves of a frequency \[Hz\] at most.
    pub fn new(ground: &LayeredGround, frequency: f64) -> Grid {
        let mut bottom = 0.0;
        let mut grid = Grid { layers: Vec::new(), levels: Vec::new() };
        for (layer, stratum) in ground.strata().iter().enumerate() {
            let cells = (stratum.thickness * FINE * frequency / stratum.rock.s).ceil().max(1.0) as usize;
            let cell = stratum.thickness / cells as f64;
            grid.layers.push((bottom, cell, grid.levels.len(), cells));
            grid.levels.extend((0..=cells).map(|k| At { layer, above: k as f64 * cell }));
            bottom += stratum.thickness;
        }
        grid
    }

    /// How many levels there are.
    pub fn count(&self) -> usize {
        self.levels.len()
    }

    /// The level below a height \[m\] above the base, the height of the cell there, and the place in it from 0 to 1.
    pub fn cell(&self, height: f64) -> (usize, f64, f64) {
        let k = self.layers.iter().rposition(|layer| height > layer.0).unwrap_or(0);
        let (bottom, cell, first, cells) = self.layers[k];
        let place = ((height - bottom) / cell).clamp(0.0, cells as f64);
        let index = (place as usize).min(cells - 1);
        (first + index, cell, place - index as f64)
    }
}

/// Weights of value and slope at both ends of a unit interval.
pub fn hermite(x: f64) -> [[f64; 2]; 2] {
    let y = 1.0 - x;
    [[y * y * (1.0 + 2.0 * x), x * y * y], [x * x * (3.0 - 2.0 * x), -x * x * y]]
}
