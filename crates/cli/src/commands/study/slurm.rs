//! A script of array tasks for Slurm: each task works at a share of the runs, by the command that anyone else would give.

use super::Args;
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::say;
use std::path::Path;
use tremolite_case::study::StudyFile;
use tremolite_study::plan::Plan;

/// Array tasks where none are asked for, at most.
const TASKS: usize = 100;

pub fn write(folder: &Path, args: &Args, out: &Path, study: &StudyFile, plan: &Plan) -> Outcome {
    let tasks = args.tasks.unwrap_or(TASKS).clamp(1, plan.chains().max(1));
    let wish = |n: Option<u32>| n.map(|n| n as usize);
    let at_once = args.jobs.or(wish(study.run.at_once)).unwrap_or(1);
    let threads = args.threads.or(wish(study.run.threads)).unwrap_or(4);
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let text = |text: &str| format!("'{}'", text.replace('\'', "'\\''"));
    let quoted = |path: &Path| text(&whole(path).to_string_lossy());
    let name = args.study.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let program: Vec<String> = machine::again().iter().map(|word| text(&word.to_string_lossy())).collect();
    let command = format!("{} study {} --out {}", program.join(" "), quoted(&args.study), quoted(out));
    let script = format!(
        "#!/bin/bash\n\
         # {} runs in {tasks} array tasks of {} runs at once; a task that is ended goes on where it was when it is submitted again.\n\
         #SBATCH --job-name={}\n\
         #SBATCH --array=1-{tasks}\n\
         #SBATCH --cpus-per-task={}\n\
         #SBATCH --output=\"{}/%a.log\"\n\
         # Time to write checkpoints before the limit; set the limit, the memory and the partition by your cluster.\n\
         #SBATCH --signal=B:TERM@120\n\
         #SBATCH --time=24:00:00\n\
         exec {command} --shard \"$SLURM_ARRAY_TASK_ID/{tasks}\" --jobs {at_once} --threads {threads}\n",
        plan.runs.len(),
        at_once,
        tremolite_study::plan::slug(&name),
        at_once * threads,
        // A space would end the option, and Slurm puts numbers of its own in place of what stands behind %.
        whole(folder).to_string_lossy().replace('\\', "\\\\").replace('"', "\\\"").replace('%', "%%"),
    );
    let failed = |e: std::io::Error| Failure::failed(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(failed)?;
    let place = folder.join("study.sbatch");
    std::fs::write(&place, script).map_err(failed)?;
    say(&format!("submit it with: sbatch {}", place.display()));
    say(&format!("when it has ended: {command} --gather"));
    Ok(Code::Done)
}
