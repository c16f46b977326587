//! Layers of different rock.

use super::error::{Named, value};
use super::{CavernError, name};
use crate::Mesh;

const MOST_LAYERS: usize = 1000;

/// A layer of rock under a plane, down to the plane of the next one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RockLayer {
    /// Last part of the name of its group, `rock.NAME`.
    pub name: String,
    /// Of its upper plane below z = 0, at x = 0 and y = 0 \[m\]. The first layer's is 0: it reaches up to the
    /// ground, wherever that is.
    pub depth: f64,
    /// Angle at which the upper plane falls \[rad\]; 0 for a level plane and for the first layer.
    pub dip: f64,
    /// Direction in which it falls, from x towards y \[rad\].
    pub dip_direction: f64,
}

impl RockLayer {
    /// Level of the upper plane \[m\].
    fn top(&self, x: f64, y: f64) -> f64 {
        let (sin, cos) = self.dip_direction.sin_cos();
        -self.depth - self.dip.tan() * (x * cos + y * sin)
    }
}

pub(super) fn check(layers: &[RockLayer]) -> Result<(), CavernError> {
    if layers.len() > MOST_LAYERS {
        return Err(value("layers", layers.len() as f64, format!("at most {MOST_LAYERS} layers")));
    }
    for (k, layer) in layers.iter().enumerate() {
        let taken = layers[..k].iter().any(|other| other.name == layer.name);
        name::check(Named::Layer, &layer.name, taken)?;
        let key = |key: &str| format!("layer {}.{key}", layer.name);
        if k == 0 {
            for (name, x) in [("depth", layer.depth), ("dip", layer.dip)] {
                if x != 0.0 {
                    return Err(value(key(name), x, "0: the first layer reaches up to the ground"));
                }
            }
        } else if !(layer.depth > layers[k - 1].depth && layer.depth <= 1e7) {
            let must = format!("below the layer before, {} m (and at most 1e7 m)", layers[k - 1].depth);
            return Err(value(key("depth"), layer.depth, must));
        }
        let steepest = 80f64.to_radians();
        if !(0.0..=steepest).contains(&layer.dip) {
            return Err(value(key("dip"), layer.dip.to_degrees(), "from 0 to 80 degrees"));
        }
        if !layer.dip_direction.is_finite() {
            return Err(value(key("dip_direction"), layer.dip_direction, "an angle"));
        }
    }
    Ok(())
}

/// Adds the group `rock.NAME` of each layer: the elements of `rock` whose middles (means of their nodes) lie below
/// its plane and below that of no later one.
pub(super) fn group(layers: &[RockLayer], mesh: &mut Mesh) {
    let Some(rock) = mesh.groups.get("rock") else { return };
    let mut lists = vec![Vec::new(); layers.len()];
    for &e in rock {
        let nodes = mesh.elements[e as usize].nodes();
        let middle: [f64; 3] = std::array::from_fn(|c| {
            nodes.iter().map(|&n| mesh.nodes[n as usize][c]).sum::<f64>() / nodes.len() as f64
        });
        let below = |layer: &RockLayer| middle[2] < layer.top(middle[0], middle[1]);
        let place = layers.iter().rposition(below).unwrap_or(0);
        if let Some(list) = lists.get_mut(place) {
            list.push(e);
        }
    }
    for (layer, list) in layers.iter().zip(lists) {
        if !list.is_empty() {
            mesh.groups.insert(format!("rock.{}", layer.name), list);
        }
    }
}
