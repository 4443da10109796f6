//! Help, versions, wrong flags, closed pipes.

use crate::bench::Bench;
use std::process::Stdio;

/// Each verb, and the shared flags that have an effect on it.
const VERBS: [(&str, &str); 7] = [
    ("list", "only quiet"),
    ("figures", "out quality seed threads width height spp only quiet list"),
    ("render", "out quality seed threads width height spp only format quiet list"),
    ("compare", "out quiet"),
    ("check", "quiet list"),
    ("convert", "out quiet"),
    ("probe", "quiet list"),
];

/// Every shared flag with a value that is right.
const FLAGS: [&str; 11] = [
    "--out x",
    "--quality smoke",
    "--seed 1",
    "--threads 1",
    "--width 9",
    "--height 9",
    "--spp 1",
    "--only x",
    "--format png",
    "--quiet",
    "--list",
];

fn name(flag: &str) -> &str {
    flag.split(' ').next().expect("a name").trim_start_matches('-')
}

#[test]
fn help_fits_in_100_columns_and_names_the_flags_that_have_an_effect() {
    let bench = Bench::new("help");
    for (verb, takes) in [("", "")].into_iter().chain(VERBS) {
        for flag in ["--help", "-h"] {
            let help = bench.line(&format!("{verb} {flag}")).done();
            assert_eq!(help.err, "");
            // `-h` puts all choices of a flag on one line.
            for line in help.out.lines().filter(|_| flag == "--help") {
                assert!(line.chars().count() <= 100, "{verb}: {} columns: {line}", line.chars().count());
            }
            let takes: Vec<&str> = takes.split_whitespace().chain(["help", "version"]).collect();
            for flag in FLAGS.map(name).into_iter().chain(["help", "version"]) {
                let named = |l: &str| {
                    l.trim_start()
                        .trim_start_matches("-h, ")
                        .trim_start_matches("-V, ")
                        .starts_with(&format!("--{flag}"))
                };
                let shown = help.out.lines().any(named);
                assert_eq!(shown, takes.contains(&flag), "{verb}, --{flag}:\n{}", help.out);
            }
            for code in ["0 done", "1 a claim", "2 wrong", "129, 130, 143"] {
                assert!(help.out.contains(code), "{verb} is silent about the exit code {code}");
            }
        }
    }
}

#[test]
fn a_flag_without_effect_is_refused() {
    let bench = Bench::new("no_effect");
    for (verb, takes) in VERBS {
        let takes: Vec<&str> = takes.split_whitespace().collect();
        let operands = if verb == "compare" { "a.png b.png" } else { "" };
        for flag in FLAGS {
            if !takes.contains(&name(flag)) {
                let words = [&*format!("{verb} takes no --{}", name(flag)), takes[0]];
                bench.line(&format!("{verb} {operands} {flag}")).refused(2, &words);
            }
        }
    }
    assert!(bench.files().is_empty());
}

#[test]
fn every_verb_tells_its_version() {
    let bench = Bench::new("version");
    for verb in [""].into_iter().chain(VERBS.map(|v| v.0)) {
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
        ("render s.scene --pixel 3,4 --format png", &["--format png has no effect on --pixel"]),
        ("render s.scene --pixel 3,4 --tone filmic", &["--tone filmic has no effect on --pixel"]),
        ("render s.scene --pixel 3,4 --out s.exr", &["--out s.exr", ".svg, .png"]),
        ("render s.scene --tone clamp --format hdr", &["--tone clamp has no effect on out/s.hdr"]),
        ("render s.scene --tone clamp --out s.exr", &["--tone clamp has no effect on s.exr"]),
        ("render s.scene --format exr --out s.png", &["--format exr", "ends in .exr", "found s.png"]),
        ("render s.scene --out s.gif", &["--out s.gif", ".png, .exr, .hdr"]),
        ("render s.scene --out a/s.JPG", &["--out a/s.JPG", ".png, .exr, .hdr"]),
        ("render s.scene --name s.tiff", &["--name s.tiff", ".png, .exr, .hdr"]),
        ("render s.scene --name a/b", &["--name `a/b`", "without folders"]),
        ("render s.scene --name ..", &["--name `..`"]),
        ("render s.scene --name b --out a.png", &["--name b", "found the file a.png"]),
        ("render s.scene t.scene --name b", &["--name b", "expected one scene"]),
        ("render s.scene t.scene --out b.png", &["--out b.png", "expected one scene"]),
        ("compare s.scene s.scene --out b.gif", &["--out b.gif", ".png, .exr, .hdr"]),
        ("convert s.scene --out b.png", &["--out b.png", ".csg"]),
        ("render s.scene t.csg", &["t.csg: expected a scene file", "CSG {"]),
        ("check t.obj t.csv", &["t.obj: expected a scene file", "Mesh {"]),
        ("convert t.mtl", &["t.mtl: expected a scene file"]),
        ("render s.PNG", &["s.PNG: expected a scene file, found a picture"]),
        ("list --only x", &["--only x", "number from 1"]),
        ("figures --only x", &["--only x", "number from 1"]),
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
    for line in ["list --only 02", "list --only sphere", "list --only lesson_02", "figures --list --only 2"] {
        let out = bench.line(line).done().out;
        assert!(out.contains("lesson_02") && out.lines().count() == 2, "{line}:\n{out}");
    }
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
