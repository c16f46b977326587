//! Pictures of a mesh as SVG text: a section across y, and a view in space. Coloured by group, for a look at what a
//! generator or a reader made.
//!
//! An element has the colour of the smallest of its groups, so that parts are seen and not their unions; the
//! largest of the groups seen is grey.

mod canvas;
mod cut;
mod view;

use canvas::{Canvas, Legend};

pub use view::view;

use crate::Mesh;

/// A rectangle in the plane of a section: lowest x and z, highest x and z \[m\].
pub type Window = [[f64; 2]; 2];

/// The section at `y` \[m\] as SVG, x to the right and z up, all of it or what lies in the window.
///
/// On a plane of nodes the elements at its lower side are drawn. Elements beyond the mesh's y, or nodes that are
/// not finite numbers, leave the picture empty but for its legend. Cut elements are drawn as if convex.
pub fn section(mesh: &Mesh, y: f64, window: Option<Window>) -> String {
    let pieces = cut::pieces(mesh, y);
    let window = window.unwrap_or_else(|| {
        let (low, high) = mesh.bounds();
        [[low[0], low[2]], [high[0], high[2]]]
    });
    let inside = |polygon: &[[f64; 2]]| {
        (0..2).all(|c| {
            polygon.iter().any(|p| p[c] > window[0][c]) && polygon.iter().any(|p| p[c] < window[1][c])
        })
    };
    let pieces: Vec<_> = pieces.into_iter().filter(|(_, polygon)| inside(polygon)).collect();
    let legend = Legend::new(mesh, pieces.iter().map(|p| p.0));
    let mut canvas = Canvas::new(window, legend.rows());
    for (element, polygon) in &pieces {
        canvas.polygon(polygon, legend.colour(*element), 1.0);
    }
    canvas.axes(["x", "z"]);
    canvas.finish(&legend, &format!("section at y = {y} m"))
}

/// The window round the groups chosen by name, with a margin \[m\]; nothing if they have no elements.
pub fn window_of(mesh: &Mesh, margin: f64, chosen: impl Fn(&str) -> bool) -> Option<Window> {
    let mut window = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for (_, elements) in mesh.groups.iter().filter(|(name, _)| chosen(name)) {
        for &n in elements.iter().flat_map(|&e| mesh.elements[e as usize].nodes()) {
            let [x, _, z] = mesh.nodes[n as usize];
            window[0] = [window[0][0].min(x), window[0][1].min(z)];
            window[1] = [window[1][0].max(x), window[1][1].max(z)];
        }
    }
    window[0].iter_mut().for_each(|x| *x -= margin);
    window[1].iter_mut().for_each(|x| *x += margin);
    (window[0][0] < window[1][0]).then_some(window)
}

#[cfg(test)]
mod tests;
