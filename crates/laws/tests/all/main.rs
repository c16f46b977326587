//! The tests of this crate, one binary.

mod common;
mod concrete_energy;
mod concrete_parameters;
mod concrete_paths;
mod concrete_rates;
mod concrete_residual;
mod concrete_strength;
mod damage_left;
mod derived;
mod eigen;
mod hex8;
mod interface_contract;
mod interface_lanes;
mod interface_path;
mod interface_walks;
mod joints;
mod lanes;
mod layered;
mod path;
mod path_stress;
mod rock_parameters;
mod rock_properties;
mod rock_reference;
mod rock_strength;
mod scaled;
mod size;
