//! The tests of this crate, one binary.

mod boundary_figures;
mod check;
mod checks;
mod chinese;
mod chinese_laws;
mod chinese_run;
mod circles;
mod commands;
mod every_law;
mod interfaces;
mod law;
mod law_figures;
mod law_interface;
mod layout;
mod list;
mod mesh;
mod motion;
mod motion_told;
mod references;
mod shipped_cases;
mod shotcrete;
mod sides;
mod stage_case;
mod stage_refusals;
mod stages;
mod verify;
