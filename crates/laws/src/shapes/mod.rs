//! Element shapes: geometry worked out once, kernels over lanes.

pub mod hex8;
