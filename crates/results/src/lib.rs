//! The result files: where they lie, what they hold, and how they are written and read.
//!
//! A run writes one folder ([`ResultFolder`]). What a script or the report needs to know of it is
//! in three kinds of file, each with one module here:
//!
//! | file | module | content |
//! |---|---|---|
//! | `summary.json` | [`summary`] | verdict, facts of the model, peaks, checks |
//! | `monitors.csv`, `energy.csv`, `damage.csv` | [`table`] | histories; headers are `name [unit]` |
//! | `interfaces.csv` | [`table`] | the same of interfaces |
//! | `monitors.columns.json` … | [`columns`] | whose the columns of a table are, and which quantity |
//! | `motion.csv` | [`table`] | the given motion and the incident wave |
//! | `free_field.csv` | [`free_field`] | velocities of the free field, predicted and measured, and the model's beside them |
//! | `spectra.csv` | [`table`] | response spectra of the motion, the free field and the monitors |
//! | `depth.csv` | [`table`] | peaks of the free field along depth, and of the model's edge beside it |
//! | `stages.csv` | [`stages`] | stages before the earthquake, a row each |
//! | `relaxation.csv` | [`table`] | how the stages came to rest |
//! | `sections.csv` | [`sections`] | thrust, moment and shear of linings |
//! | `utilisation.csv` | [`utilisation`] | what sections of linings use of their strength |
//! | `bolts.csv` | [`bolts`] | forces, slip and state of bolts, a row a bolt and time |
//! | `own/*.csv` | [`own_table`] | tables that a user's program adds |
//! | `fields.pvd`, `interfaces.pvd`, `stages.pvd`, `bolts.pvd` | [`pvd`] | the times of the files in `fields/`, `interfaces/`, `stages/` and `bolts/` |
//! | `fields/*.vtu`, and `*.pvtu` of a large mesh, whose pieces they are | [`fields`], [`cut`], [`mod@slice`], [`skin`], [`field_file`] | cuts through them, the outside of linings, and all of them as plain data; `tremolite_mesh::vtu` reads and writes the files themselves |
//! | `interfaces/*.vtu` | [`surface`] | interfaces with what their pairs did |
//! | `bolts/*.vtu` | [`bolt_lines`] | the segments of bolts with what they did |
//! | `study.json` | [`study`] | of a study: its runs, and the curves fitted to them |
//!
//! Histories grow while the run goes on and can be read at any moment. Small files are replaced
//! whole, so a reader sees the old one or the new one, never half of one.

#![forbid(unsafe_code)]

mod arrays;
pub mod assessment;
pub mod bolt_group;
pub mod bolt_lines;
pub mod bolts;
mod by_name;
pub mod checksums;
mod column;
pub mod columns;
pub mod cut;
pub mod damage;
pub mod error;
pub mod failure_modes;
pub mod field_file;
pub mod fields;
pub mod folder;
pub mod free_field;
mod growing_file;
pub mod hexahedron;
pub mod interface;
pub mod limits;
pub mod materials;
pub mod number;
pub mod own_table;
pub mod peaks;
pub mod pvd;
mod replace;
pub mod said;
pub mod same;
pub mod section_strength;
pub mod sections;
pub mod skin;
pub mod slice;
pub mod stages;
pub mod stress;
pub mod study;
pub mod summary;
pub mod surface;
pub mod table;
pub mod table_writer;
pub mod trust;
pub mod utilisation;

pub use assessment::{Assessment, Class, Judgement, Reason, Reliance, State, assess};
pub use bolt_group::{BoltPeak, BoltPlace, BoltSummary};
pub use bolt_lines::{BoltLine, BoltLines};
pub use bolts::{BOLT_COLUMNS, BoltColumn, BoltRow, BoltWriter, EARTHQUAKE, read_bolts};
pub use by_name::halves;
pub use column::{Column, Subject};
pub use cut::{Cut, CutCell};
pub use damage::{
    CrackDirection, Cracks, Damaged, Finding, GroupDamage, Onset, Opened, Place, RateFactor, Severity,
};
pub use error::Error;
pub use failure_modes::{FailureModes, JudgedBy};
pub use field_file::{FieldCell, FieldFile, Scalar};
pub use fields::Fields;
pub use folder::{CHECKPOINTS, HAND_OVER, OWN_TABLES, ResultFolder, TABLES};
pub use free_field::{FreeField, Station, Velocities};
pub use growing_file::Extent;
pub use interface::{InterfaceSummary, PairPeak, PairPlace};
pub use materials::{MaterialFacts, MaterialGroup, MaterialValue, Origin};
pub use peaks::{Peaks, PeaksByName, peaks_by_monitor};
pub use pvd::{Pvd, Snapshot};
pub use replace::replace_file;
pub use said::{Said, Slot};
pub use same::{OTHER_FACTS, OTHER_FILES, differences};
pub use section_strength::{Border, Factors, LastingCrack, SectionStrength, Used};
pub use sections::{EFFECTIVE, SectionRow, read_sections, write_sections};
pub use skin::Skin;
pub use slice::{Corner, Piece, Slice};
pub use stages::{StageSeepage, StageSummary, write_stages};
pub use stress::{GroupStress, StressPeak};
pub use summary::{
    CaseFacts, Computed, Conclusion, Deconvolved, Defaulted, InitialStress, Input, LiningExtent, ModelFacts,
    MonitorFacts, MotionFacts, PageWish, PartFacts, RunFacts, SoilLayer, Soundness, Status, Summary,
    Synchrony, TargetSpectrum, Wave, WavePart, check_summary_path,
};
pub use surface::{ElementGroups, PairSurface};
pub use table::Table;
pub use table_writer::TableWriter;
pub use trust::{Bound, Fact, TrustLine, snake, tell_apart};
