//! The words of the XML header.

use super::Values;

/// VTK's name of a number type.
pub(super) fn type_name(values: &Values) -> &'static str {
    match values {
        Values::Float32(_) => "Float32",
        Values::Float64(_) => "Float64",
        Values::Int32(_) => "Int32",
        Values::Int64(_) => "Int64",
        Values::UInt8(_) => "UInt8",
    }
}

/// Name of the information key that holds an array's unit.
pub(super) const UNIT_KEY: &str = "UNITS_LABEL";
