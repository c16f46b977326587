//! Plain concrete: what a section without steel bears.

/// A section of concrete alone, a metre wide.
///
/// Cracked it bears what the compressed part does with its strength all over, N = f_c (h − 2e) (EN 1992-1-1 12.6.1 (3), equation
/// 12.2 with η = 1; GB 50010-2010 D.2.1 has the same form). Where its tensile strength may count (EN 1992-1-1 12.3.1 (2)) it bears as
/// well what leaves every fibre of the elastic section between f_c and f_t. It bears what either does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain {
    /// m
    pub thickness: f64,
    /// Strength in compression, above 0, and in tension; 0: none counts \[Pa\].
    pub compression: f64,
    pub tension: f64,
}

impl Plain {
    /// Utilisation by proportional loading of N and M; infinite where nothing on their ray is borne.
    pub fn utilisation(&self, [n, m]: [f64; 2]) -> f64 {
        if n == 0.0 && m == 0.0 {
            return 0.0;
        }
        self.cracked([n, m]).min(self.sound([n, m]))
    }

    fn cracked(&self, [n, m]: [f64; 2]) -> f64 {
        let pressed = self.thickness - 2.0 * (m / n).abs();
        if n < 0.0 && pressed > 0.0 { -n / (self.compression * pressed) } else { f64::INFINITY }
    }

    fn sound(&self, [n, m]: [f64; 2]) -> f64 {
        let (direct, bending) = (n / self.thickness, 6.0 * m.abs() / (self.thickness * self.thickness));
        let (pulled, pressed) = (direct + bending, bending - direct);
        // Without tensile strength only what pulls nowhere is sound.
        let pulled = if pulled <= 0.0 { 0.0 } else { pulled / self.tension };
        pulled.max(pressed / self.compression)
    }
}
