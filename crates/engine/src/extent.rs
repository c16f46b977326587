//! How far elements extend, as laws with a fracture energy see it.

use tremolite_laws::shapes::hex8::Hex8;
use tremolite_laws::sym3::principal_values;

/// Smallest and largest extent \[m\] of an element over all directions p: √(p·G·p) of the size tensor G that its law is
/// given ([`tremolite_laws::Point::size`]); for a brick the shortest and the longest edge.
pub fn extents(hex: &Hex8) -> [f64; 2] {
    let [least, _, most] = sizes(hex);
    [least, most]
}

/// Principal extents \[m\] of an element, rising; for a brick its edges.
pub fn sizes(hex: &Hex8) -> [f64; 3] {
    let [most, middle, least] = principal_values(&size_tensor(hex));
    [least, middle, most].map(|x| x.max(0.0).sqrt())
}

/// G = ½ Σ (x − x̄)⊗(x − x̄) over the corners \[m²\], in the order of Voigt.
pub fn size_tensor(hex: &Hex8) -> [f64; 6] {
    let mean = [0, 1, 2].map(|i| hex.corners.iter().map(|x| x[i]).sum::<f64>() / 8.0);
    [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
        .map(|(i, j)| 0.5 * hex.corners.iter().map(|x| (x[i] - mean[i]) * (x[j] - mean[j])).sum::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_laws::shapes::hex8::CORNERS;

    #[test]
    fn a_brick_extends_from_its_shortest_to_its_longest_edge_however_it_is_turned() {
        let (sin, cos) = 0.7_f64.sin_cos();
        let corners = CORNERS.map(|c| {
            let [x, y, z] = [0.125 * c[0], 0.6 * c[1], 1.5 * c[2]];
            [5.0 + cos * x - sin * z, y, 2.0 + sin * x + cos * z]
        });
        let hex = Hex8::new(corners).unwrap();
        let [least, most] = extents(&hex);
        assert!((sizes(&hex)[1] - 1.2).abs() < 1e-7);
        assert!((least - 0.25).abs() < 1e-7 && (most - 3.0).abs() < 1e-12, "{least} {most}");
    }
}
