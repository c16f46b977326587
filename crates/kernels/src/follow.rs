//! A law by its name, along a path, with the registers of an instruction set.

use tremolite_laws::interface_path::{InterfacePath, InterfaceResponse, drive_interface_named};
use tremolite_laws::path::{Path, PathError, Response, drive_named};
use tremolite_laws::{Interface, Isa, Material, Values};

/// What is done with a law that is known by its type.
struct Entry {
    name: &'static str,
    follow: fn(&Values, &Path, Isa) -> Result<Response, PathError>,
    warnings: fn(&Values) -> Vec<String>,
}

macro_rules! entries {
    ($($law:ty,)*) => {
        &[$(Entry { name: <$law>::NAME, follow: follow_law::<$law>, warnings: warnings_of::<$law> }),*]
    };
}

const ENTRIES: &[Entry] = tremolite_laws::for_each_material!(entries);

/// The response of a registered law. Strains under prescribed stress are sought in scalars; the response to them is
/// then that of the instruction set.
///
/// # Errors
/// See [`PathError`].
#[inline(never)]
pub fn follow(name: &str, values: &Values, path: &Path, isa: Isa) -> Result<Response, PathError> {
    match ENTRIES.iter().find(|e| e.name == name) {
        Some(entry) => (entry.follow)(values, path, isa),
        None => drive_named(name, values, path),
    }
}

/// What is unusual about the parameters though the law accepts them.
#[inline(never)]
pub fn warnings(name: &str, values: &Values) -> Vec<String> {
    ENTRIES.iter().find(|e| e.name == name).map_or_else(Vec::new, |entry| (entry.warnings)(values))
}

fn warnings_of<M: Material>(values: &Values) -> Vec<String> {
    M::new(values).map(|law| law.warnings()).unwrap_or_default()
}

fn follow_law<M: Material>(values: &Values, path: &Path, isa: Isa) -> Result<Response, PathError> {
    let law = M::new(values).map_err(PathError::Parameters)?;
    let response = drive_named(M::NAME, values, path)?;
    #[cfg(target_arch = "x86_64")]
    if isa.available() {
        match isa {
            Isa::Scalar => {}
            // SAFETY: the processor has it.
            Isa::Avx2 => return Ok(unsafe { wide::avx2(&law, path, response) }),
            // SAFETY: the processor has it.
            Isa::Avx512 => return Ok(unsafe { wide::avx512(&law, path, response) }),
        }
    }
    // Without wide registers there is the scalar set alone.
    let _ = isa;
    Ok(response)
}

/// What is done with an interface law that is known by its type.
struct InterfaceEntry {
    name: &'static str,
    follow: fn(&Values, &InterfacePath, Isa) -> Result<InterfaceResponse, PathError>,
    warnings: fn(&Values) -> Vec<String>,
}

macro_rules! interface_entries {
    ($($law:ty,)*) => {
        &[$(InterfaceEntry {
            name: <$law>::NAME,
            follow: follow_joint::<$law>,
            warnings: |values| <$law>::new(values).map(|law| law.warnings()).unwrap_or_default(),
        }),*]
    };
}

const INTERFACES: &[InterfaceEntry] = tremolite_laws::for_each_interface!(interface_entries);

/// The response of a registered interface law. Gaps under prescribed pressure are sought in scalars; the response to them is
/// then that of the instruction set.
///
/// # Errors
/// See [`PathError`].
#[inline(never)]
pub fn follow_interface(
    name: &str,
    values: &Values,
    path: &InterfacePath,
    isa: Isa,
) -> Result<InterfaceResponse, PathError> {
    match INTERFACES.iter().find(|e| e.name == name) {
        Some(entry) => (entry.follow)(values, path, isa),
        None => drive_interface_named(name, values, path),
    }
}

/// What is unusual about an interface's parameters though the law accepts them.
#[inline(never)]
pub fn interface_warnings(name: &str, values: &Values) -> Vec<String> {
    INTERFACES.iter().find(|e| e.name == name).map_or_else(Vec::new, |entry| (entry.warnings)(values))
}

fn follow_joint<I: Interface>(
    values: &Values,
    path: &InterfacePath,
    isa: Isa,
) -> Result<InterfaceResponse, PathError> {
    let law = I::new(values).map_err(PathError::Parameters)?;
    let response = drive_interface_named(I::NAME, values, path)?;
    #[cfg(target_arch = "x86_64")]
    if isa.available() {
        match isa {
            Isa::Scalar => {}
            // SAFETY: the processor has it.
            Isa::Avx2 => return Ok(unsafe { wide::joint_avx2(&law, response) }),
            // SAFETY: the processor has it.
            Isa::Avx512 => return Ok(unsafe { wide::joint_avx512(&law, response) }),
        }
    }
    // Without wide registers there is the scalar set alone.
    let _ = (law, isa);
    Ok(response)
}

#[cfg(target_arch = "x86_64")]
mod wide {
    use tremolite_laws::interface_path::InterfaceResponse;
    use tremolite_laws::lane::{Avx2, Avx512, Enabled};
    use tremolite_laws::path::{Path, Response};
    use tremolite_laws::{History, Interface, Lane, Material, Octet, Point};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in functions that are called where the processor has the instruction set.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx2,fma")]
    pub fn avx2<M: Material>(law: &M, path: &Path, response: Response) -> Response {
        again::<Avx2<Here>, M>(law, path, response)
    }

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub fn avx512<M: Material>(law: &M, path: &Path, response: Response) -> Response {
        again::<Avx512<Here>, M>(law, path, response)
    }

    /// Replaces stress and history by what lanes of this width make of the strains.
    #[inline(always)]
    fn again<L: Lane, M: Material>(law: &M, path: &Path, mut response: Response) -> Response {
        let mut history = <M::History<L> as History<L>>::zero();
        let mut first = Octet::ZERO;
        let mut next = 0;
        for row in 0..response.strain.len() {
            while next < response.between.len() && response.between[next].row == row {
                let step = &response.between[next];
                history = law.update(&at(path, step.dt), splat(&step.strain), history).1;
                next += 1;
            }
            let dt = if row > 0 { path.time[row] - path.time[row - 1] } else { 0.0 };
            let point = at(path, response.last_step(row, dt));
            let (stress, new) = law.update(&point, splat(&response.strain[row]), history);
            history = new;
            for (value, lanes) in response.stress[row].iter_mut().zip(stress) {
                lanes.store(&mut first, 0);
                *value = first.0[0];
            }
            for (column, value) in response.history.iter_mut().zip(history.as_ref()) {
                value.store(&mut first, 0);
                column[row] = first.0[0];
            }
        }
        response
    }

    #[inline(always)]
    fn at<L: Lane>(path: &Path, dt: f64) -> Point<L> {
        let mut point = Point::new(L::splat(dt));
        if let Some(h) = path.size {
            for squared in &mut point.size[..3] {
                *squared = L::splat(h * h);
            }
        }
        point
    }

    #[inline(always)]
    fn splat<L: Lane>(strain: &[f64; 6]) -> [L; 6] {
        let mut lanes = [L::splat(0.0); 6];
        for (lanes, value) in lanes.iter_mut().zip(strain) {
            *lanes = L::splat(*value);
        }
        lanes
    }

    #[target_feature(enable = "avx2,fma")]
    pub fn joint_avx2<I: Interface>(law: &I, response: InterfaceResponse) -> InterfaceResponse {
        joint_again::<Avx2<Here>, I>(law, response)
    }

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub fn joint_avx512<I: Interface>(law: &I, response: InterfaceResponse) -> InterfaceResponse {
        joint_again::<Avx512<Here>, I>(law, response)
    }

    /// Replaces traction and history by what lanes of this width make of gap and slip.
    #[inline(always)]
    fn joint_again<L: Lane, I: Interface>(law: &I, mut response: InterfaceResponse) -> InterfaceResponse {
        let mut history = <I::History<L> as History<L>>::zero();
        for row in 0..response.gap.len() {
            let [s1, s2] = response.slip[row];
            let slip = [L::splat(s1), L::splat(s2)];
            let (pressure, shear, new) = law.update(L::splat(response.gap[row]), slip, history);
            history = new;
            response.pressure[row] = first(pressure);
            response.shear[row] = [-first(shear[0]), -first(shear[1])];
            for (column, value) in response.history.iter_mut().zip(history.as_ref()) {
                column[row] = first(*value);
            }
        }
        response
    }

    #[inline(always)]
    fn first<L: Lane>(lanes: L) -> f64 {
        let mut octet = Octet::ZERO;
        lanes.store(&mut octet, 0);
        octet.0[0]
    }
}
