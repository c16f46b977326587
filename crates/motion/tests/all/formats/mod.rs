//! Formats of records, one module each: small files written here, and real ones where they are at hand ([`crate::records`]).

mod cosmos;
mod csmip;
mod figures;
mod geonet;
mod pairs;
mod smc;
mod usc;

/// Small good files of one format, for [`crate::hostile`] to damage; none of a format that has no module here.
pub fn good(format: &str) -> Vec<Vec<u8>> {
    let files: Vec<String> = match format {
        "COSMOS" => vec![cosmos::small(), cosmos::small_counts()],
        "SMC" => vec![smc::small(), smc::small_pairs()],
        "CSMIP, CDMG, USC" => vec![csmip::small_v2(), csmip::small_v1(), usc::small_pairs()],
        _ => Vec::new(),
    };
    files.into_iter().map(String::into_bytes).collect()
}
