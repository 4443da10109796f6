//! Help, versions, wrong flags, closed pipes.

use crate::bench::Bench;
use std::process::Stdio;

const VERBS: [&str; 6] = ["list", "figures", "render", "compare", "check", "probe"];

#[test]
fn help_fits_in_100_columns_and_names_every_flag() {
    let bench = Bench::new("help");
    for verb in [""].into_iter().chain(VERBS) {
        let help = bench.line(&format!("{verb} --help")).done();
        assert_eq!(help.err, "");
        for line in help.out.lines() {
            assert!(line.chars().count() <= 100, "{verb}: {} columns: {line}", line.chars().count());
        }
        for flag in "out quality seed threads width height spp only format quiet list help version".split(' ')
        {
            assert!(help.out.contains(&format!("--{flag}")), "{verb} --help is silent about --{flag}");
        }
    }
}

#[test]
fn every_verb_tells_its_version() {
    let bench = Bench::new("version");
    for verb in [""].into_iter().chain(VERBS) {
        let version = bench.line(&format!("{verb} --version")).done();
        assert!(version.out.contains(env!("CARGO_PKG_VERSION")) && version.out.contains("lightbench"));
    }
}

#[test]
fn wrong_usage_ends_with_2() {
    let bench = Bench::with_scene("wrong_usage");
    for (line, words) in [
        ("", &["Usage"] as &[&str]),
        ("rendre s.scene", &["rendre"]),
        ("render", &["expected scene files"]),
        ("check", &["expected scene files"]),
        ("probe", &["--list"]),
        ("compare s.scene", &["<B>"]),
        ("render s.scene --widht 3", &["--widht", "--width"]),
        ("render s.scene --width 0", &["--width", "0"]),
        ("render s.scene --width 65536", &["--width", "65535"]),
        ("render s.scene --width -1", &["-1"]),
        ("render s.scene --width 1e3", &["1e3"]),
        ("render s.scene --spp 0", &["--spp"]),
        ("render s.scene --threads 0", &["--threads"]),
        ("render s.scene --threads 1025", &["--threads", "1024"]),
        ("render s.scene --seed 18446744073709551616", &["--seed"]),
        ("render s.scene --seed x", &["--seed", "x"]),
        ("render s.scene --seed -1", &["--seed", "whole number from 0 to 18446744073709551615"]),
        ("list --seed -1", &["whole number from 0"]),
        ("render s.scene --pixel -1,0", &["column,row", "both from 0", "-1,0"]),
        ("render s.scene --quality best", &["best", "final"]),
        ("render s.scene --format gif", &["gif", "exr"]),
        ("render s.scene --tone loud", &["loud", "filmic"]),
        ("render s.scene --integrator magic", &["magic", "local"]),
        ("render s.scene --pixel 3", &["3", "column,row"]),
        ("render s.scene --pixel 3,y", &["3,y"]),
        ("render s.scene --pixel 3,4,5", &["3,4,5"]),
        ("render s.scene --pixel=-1,0", &["-1,0"]),
        ("render s.scene --pixel 99999999999999999999,0", &["99999999999999999999"]),
    ] {
        bench.line(line).refused(2, words);
    }
    assert_eq!(bench.files(), ["s.scene"]);
}

#[test]
fn lists_what_there_is_to_choose_from() {
    let bench = Bench::new("lists");
    let render = bench.line("render --list").done();
    for name in ["visibility", "unshadowed", "local", "clamp", "divide", "filmic"] {
        assert!(render.out.contains(name), "{name} is not in\n{}", render.out);
    }
    assert!(bench.line("check --list").done().out.contains("RenderWidth"));
    assert!(bench.line("probe --list").done().out.contains("ray_sphere"));
    assert!(bench.line("list").done().out.contains("lesson_01"));
}

/// A reader that has read enough, or nobody at all on the other end, is no reason to fail.
#[cfg(unix)]
#[test]
fn closed_pipes_are_no_failure() {
    let bench = Bench::with_scene("closed_pipes");
    for (args, file) in [
        ("probe --list", None),
        ("check s.scene", None),
        ("render s.scene --quality smoke", Some("out/s.png")),
    ] {
        let words: Vec<&str> = args.split(' ').collect();
        let mut command = bench.command(&words);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("runs");
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().expect("ends").code(), Some(0), "{args}");
        assert!(file.is_none_or(|file| bench.folder.join(file).exists()), "{args}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_under_stdout_is_told() {
    let bench = Bench::new("full_stdout");
    let full = std::fs::File::options().write(true).open("/dev/full").expect("/dev/full");
    let ran = bench.command(&["probe", "--list"]).stdout(full).output().expect("runs");
    assert_eq!(ran.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&ran.stderr).starts_with("stdout: "));
}
