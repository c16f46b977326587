//! Where a station lies in its lining, in one word.

use crate::sections::Station;

/// Cosines between the way from the intrados outwards and the vertical: down to 30° it is the crown, to 75° its haunch; a floor looks up
/// within 45°.
const CROWN: f64 = 0.866_025_403_784_438_6;
const HAUNCH: f64 = 0.258_819_045_102_520_7;
const FLOOR: f64 = -std::f64::consts::FRAC_1_SQRT_2;
/// Share of the height of a lining's stations below which a wall is its foot.
const FOOT: f64 = 0.15;

/// `crown`, `haunch`, `wall`, `foot` or `floor`; `low` and `high` bound the middles of the lining's stations \[m\].
pub fn part(station: &Station, [low, high]: [f64; 2]) -> &'static str {
    match -station.normal[2] {
        up if up >= CROWN => "crown",
        up if up >= HAUNCH => "haunch",
        up if up <= FLOOR => "floor",
        _ if station.place[2] < low + FOOT * (high - low) => "foot",
        _ => "wall",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stations_round_a_hall_are_named_by_where_their_intrados_looks() {
        let of = |degrees: f64, z: f64| {
            // Round from the top: outwards is (sin, 0, cos), the normal towards the intrados its opposite.
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let station = Station {
                stack: Vec::new(),
                place: [0.0, 0.0, z],
                normal: [-sine, 0.0, -cosine],
                along: [cosine, 0.0, -sine],
                thickness: 0.5,
                faces: [[[0.0; 3]; 4]; 2],
            };
            part(&station, [0.0, 20.0])
        };
        assert_eq!([of(0.0, 20.0), of(29.0, 19.0), of(-29.0, 19.0)], ["crown"; 3]);
        assert_eq!([of(31.0, 18.0), of(-74.0, 16.0)], ["haunch"; 2]);
        assert_eq!([of(90.0, 10.0), of(-90.0, 3.1)], ["wall"; 2]);
        assert_eq!([of(90.0, 2.9), of(-90.0, 0.0)], ["foot"; 2]);
        assert_eq!(of(180.0, 0.0), "floor");
    }
}
