//! The words of the XML header that the writer and the reader share.

use super::Values;

/// VTK's name of a number type.
pub(super) fn type_name(values: &Values) -> &'static str {
    match values {
        Values::Float32(_) => "Float32",
        Values::Float64(_) => "Float64",
        Values::Int32(_) => "Int32",
        Values::UInt8(_) => "UInt8",
    }
}

/// Marks the start of the raw data; everything before it is XML, but for the closing tag.
pub(super) const APPENDED: &str = "<AppendedData encoding=\"raw\">";
/// Name of the information key that holds an array's unit.
pub(super) const UNIT_KEY: &str = "UNITS_LABEL";
