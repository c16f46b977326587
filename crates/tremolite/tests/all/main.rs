//! All tests of the engine and of runs: one binary, since each links the whole engine.

mod block;
mod bolt_patterns;
mod bolt_results;
mod bolts;
mod bolts_bits;
mod bolts_staged;
mod consistency;
mod contact;
mod cracked_damping;
mod damage;
mod engine;
mod free_field;
mod free_field_file;
mod ground;
mod history;
mod outside_law;
mod outside_part;
mod ready;
mod reinforcement;
mod relax;
mod runs;
mod setup_materials;
mod shapes;
mod staged;
mod stages;
mod viscosity;
