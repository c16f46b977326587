//! MPI's own calls.

use mpi::ffi;
use std::ffi::c_int;
use tremolite_engine::exchange::{Halo, To, room};

/// Numbers of one message at most: MPI counts by 32 bits.
const MOST: usize = 1 << 27;

/// Messages on their way, with the memory that MPI reads and writes meanwhile.
#[derive(Default)]
pub struct Messages {
    out: Vec<f64>,
    into: Vec<f64>,
    requests: Vec<ffi::MPI_Request>,
}

// SAFETY: a request is a number or an address of MPI's own, which takes it from any thread, one at a time.
unsafe impl Send for Messages {}

/// Pieces of what one rank sends another, each one message.
fn pieces(range: &std::ops::Range<usize>) -> impl Iterator<Item = (usize, c_int)> + use<> {
    let range = range.clone();
    range.clone().step_by(MOST).map(move |at| (at, (range.end - at).min(MOST) as c_int))
}

const TAG: c_int = 32;

impl Messages {
    pub fn start(&mut self, halo: &Halo, words: &mut Vec<f64>) {
        let [send, receive] = halo.words();
        // Nothing is copied: the memory changes hands.
        std::mem::swap(&mut self.out, words);
        assert!(self.out.len() >= send, "as many numbers as are sent");
        room(&mut self.into, receive);
        self.requests.clear();
        for (from, range) in &halo.receive {
            for (at, count) in pieces(range) {
                let mut request = std::mem::MaybeUninit::uninit();
                // SAFETY: the memory is `into`'s, whose length does not change before `finish` has waited for the request.
                unsafe {
                    let to = self.into.as_mut_ptr().add(at).cast();
                    let world = ffi::RSMPI_COMM_WORLD;
                    ffi::MPI_Irecv(
                        to,
                        count,
                        ffi::RSMPI_DOUBLE,
                        *from as c_int,
                        TAG,
                        world,
                        request.as_mut_ptr(),
                    );
                    self.requests.push(request.assume_init());
                }
            }
        }
        for (to, range) in &halo.send {
            for (at, count) in pieces(range) {
                let mut request = std::mem::MaybeUninit::uninit();
                // SAFETY: the memory is `out`'s, which does not change before `finish` has waited for the request.
                unsafe {
                    let from = self.out.as_ptr().add(at).cast();
                    let world = ffi::RSMPI_COMM_WORLD;
                    ffi::MPI_Isend(
                        from,
                        count,
                        ffi::RSMPI_DOUBLE,
                        *to as c_int,
                        TAG,
                        world,
                        request.as_mut_ptr(),
                    );
                    self.requests.push(request.assume_init());
                }
            }
        }
    }

    pub fn finish(&mut self, words: &mut Vec<f64>) {
        let count = self.requests.len();
        let mut statuses: Vec<ffi::MPI_Status> = Vec::with_capacity(count);
        // SAFETY: there is room for a status of each request, all of which were begun in `start`.
        unsafe {
            ffi::MPI_Waitall(count as c_int, self.requests.as_mut_ptr(), statuses.as_mut_ptr());
        }
        self.requests.clear();
        std::mem::swap(&mut self.into, words);
    }

    /// By collective calls as long as MPI can count what there is; else piece by piece.
    pub fn gather(&mut self, rank: u32, own: &[f64], counts: &[usize], to: To) -> Vec<f64> {
        let whole: usize = counts.iter().sum();
        let mut all = match (to, rank) {
            (To::First, 1..) => Vec::new(),
            _ => vec![0.0; whole],
        };
        if whole < c_int::MAX as usize {
            let counts: Vec<c_int> = counts.iter().map(|&count| count as c_int).collect();
            let begins = |sum: &mut c_int, count: &c_int| {
                *sum += count;
                Some(*sum - count)
            };
            let starts: Vec<c_int> = counts.iter().scan(0, begins).collect();
            let (from, count) = (own.as_ptr().cast(), own.len() as c_int);
            // SAFETY: a constant of the library.
            let (into, double) = (all.as_mut_ptr().cast(), unsafe { ffi::RSMPI_DOUBLE });
            // SAFETY: there is room for all that the ranks say they send, where it is received.
            unsafe {
                let world = ffi::RSMPI_COMM_WORLD;
                match to {
                    To::First => ffi::MPI_Gatherv(
                        from,
                        count,
                        double,
                        into,
                        counts.as_ptr(),
                        starts.as_ptr(),
                        double,
                        0,
                        world,
                    ),
                    To::All => ffi::MPI_Allgatherv(
                        from,
                        count,
                        double,
                        into,
                        counts.as_ptr(),
                        starts.as_ptr(),
                        double,
                        world,
                    ),
                };
            }
            return all;
        }
        let mut at = 0;
        for (from, &count) in (0u32..).zip(counts) {
            let range = at..at + count;
            at = range.end;
            if from == rank && !all.is_empty() {
                all[range.clone()].copy_from_slice(own);
            }
            match to {
                // SAFETY: all ranks have room for all.
                To::All => pieces(&range).for_each(|(at, count)| unsafe {
                    let (into, world) = (all.as_mut_ptr().add(at).cast(), ffi::RSMPI_COMM_WORLD);
                    ffi::MPI_Bcast(into, count, ffi::RSMPI_DOUBLE, from as c_int, world);
                }),
                To::First if from > 0 && from == rank => {
                    let halo = Halo { send: vec![(0, 0..count)], receive: Vec::new() };
                    self.start(&halo, &mut own.to_vec());
                    self.finish(&mut Vec::new());
                }
                To::First if from > 0 && rank == 0 => {
                    let halo = Halo { send: Vec::new(), receive: vec![(from, 0..count)] };
                    let mut words = Vec::new();
                    self.start(&halo, &mut words);
                    self.finish(&mut words);
                    all[range].copy_from_slice(&words[..count]);
                }
                To::First => {}
            }
        }
        all
    }

    pub fn agree(&mut self, bits: u64) -> u64 {
        let mut all = 0u64;
        // SAFETY: one number goes in and one comes out.
        unsafe {
            let (from, into) = ((&raw const bits).cast(), (&raw mut all).cast());
            let world = ffi::RSMPI_COMM_WORLD;
            ffi::MPI_Allreduce(from, into, 1, ffi::RSMPI_UINT64_T, ffi::RSMPI_BOR, world);
        }
        all
    }
}

/// Ends all ranks.
pub fn abort(status: i32) {
    // SAFETY: MPI was started.
    unsafe {
        ffi::MPI_Abort(ffi::RSMPI_COMM_WORLD, status);
    }
}
