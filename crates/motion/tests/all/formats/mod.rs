//! Formats of records, one module each: small files written here, and real ones where they are at hand ([`crate::records`]).

/// Small good files of one format, for [`crate::hostile`] to damage; none of a format that has no module here.
pub fn good(format: &str) -> Vec<Vec<u8>> {
    let files: Vec<String> = match format {
        _ => Vec::new(),
    };
    files.into_iter().map(String::into_bytes).collect()
}
