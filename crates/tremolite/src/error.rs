//! Why a run could not go on.

use crate::checkpoint::CheckpointError;
use std::path::PathBuf;
use tremolite_engine::ModelError;

/// What stopped it. What was computed before is kept.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: std::io::Error },
    #[error(transparent)]
    Results(#[from] tremolite_results::Error),
    #[error(transparent)]
    Vtu(#[from] tremolite_mesh::vtu::VtuError),
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error("the stage '{0}' comes before the earthquake; bring it to rest before the first step")]
    StageLeft(String),
    #[error("{} differs from {}, from which the run was started", case.display(), kept.display())]
    OtherCase { case: PathBuf, kept: PathBuf },
    #[error("no rest of another run can be the beginning: the case has no stages and no initial stress")]
    NoRest,
    #[error("behind another run's rest nothing is left to do: the case has no [motion]")]
    RestAlone,
    #[error("no stage is left to bring to rest; go on with steps")]
    NoStageLeft,
    #[error(
        "rank {0} runs another case than the first, or another program; start all ranks with the same program, case file and \
         input files"
    )]
    OtherRank(usize),
    #[error("what looks at the run failed in step {0}; go back to its checkpoint")]
    Spoiled(u64),
}
