//! Which of the shared flags each verb takes, and what `--help` shows of them.

use super::{Cli, Failure};
use clap::{Command, CommandFactory};
use lightbench_kit::flags::Flags;

/// What every `--help` ends with.
const EXIT_CODES: &str = "\
Exit codes: 0 done; 1 a claim failed or a file could not be written; 2 wrong usage or input;
129, 130, 143 stopped by SIGHUP, by Ctrl-C (SIGINT), by SIGTERM";

/// A verb, the shared flags that have an effect on it, and what its `--out` names.
struct Takes {
    verb: &'static str,
    flags: &'static [&'static str],
    out: &'static str,
}

const TAKES: &[Takes] = &[
    Takes { verb: "list", flags: &["only", "quiet"], out: "" },
    Takes {
        verb: "figures",
        flags: &["out", "quality", "seed", "threads", "width", "height", "spp", "only", "quiet", "list"],
        out: "Folder for the figures and the page [default: figures]",
    },
    Takes {
        verb: "render",
        flags: &[
            "out", "quality", "seed", "threads", "width", "height", "spp", "only", "format", "quiet", "list",
        ],
        out: "Folder for pictures, or a file (.png, .exr, .hdr; .svg with --pixel) [default: out]",
    },
    Takes {
        verb: "compare",
        flags: &["out", "quiet"],
        out: "Folder for the error picture, or its file (.png, .exr, .hdr) [default: out]",
    },
    Takes { verb: "check", flags: &["quiet", "list"], out: "" },
    Takes {
        verb: "convert",
        flags: &["out", "quiet"],
        out: "Folder for the files, or the file of a single tree (.csg) [default: out]",
    },
    Takes { verb: "probe", flags: &["quiet", "list"], out: "" },
];

/// The names of all shared flags.
fn shared() -> impl Iterator<Item = String> {
    let flags = <Flags as clap::Args>::augment_args(Command::new("flags"));
    flags.get_arguments().map(|a| a.get_id().to_string()).collect::<Vec<_>>().into_iter()
}

/// The command line; each verb's help shows the flags that it takes.
pub(super) fn command() -> Command {
    let command = Cli::command().after_help(EXIT_CODES);
    TAKES.iter().fold(command, |command, takes| {
        command.mut_subcommand(takes.verb, |verb| {
            shared().fold(verb.after_help(EXIT_CODES), |verb, flag| {
                verb.mut_arg(&flag, |arg| {
                    let arg = if flag == "out" { arg.help(takes.out) } else { arg };
                    arg.hide(!takes.flags.contains(&flag.as_str()))
                })
            })
        })
    })
}

/// Refuses a flag that would have no effect.
pub(super) fn without_effect(verb: &str, flags: &Flags) -> Result<(), Failure> {
    let takes = TAKES.iter().find(|t| t.verb == verb).map_or(&[][..], |t| t.flags);
    match flags.given().into_iter().find(|given| !takes.contains(given)) {
        None => Ok(()),
        Some(flag) => {
            let takes = takes.join(", --");
            Err(Failure::input(format!(
                "{verb} takes no --{flag}, which would change nothing; it takes --{takes}"
            )))
        }
    }
}
