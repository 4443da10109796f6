//! A flag wins over the scene file, the scene file over the quality's defaults.

use crate::bench::{Bench, SCENE};
use std::io::{BufRead, BufReader};
use std::process::Stdio;

/// Size and samples of what is rendered, as `--pixel` far outside and the last line of progress tell.
#[track_caller]
fn work(bench: &Bench, flags: &str) -> String {
    let ran = bench.line(&format!("render s.scene --pixel 65535,65535 {flags}"));
    let ran = ran.refused(2, &["expected a column"]);
    ran.err.split("column ").nth(1).expect("a range").trim().to_string()
}

#[test]
fn quality_decides_where_scene_and_flags_are_silent() {
    let bench = Bench::with_scene("quality_size");
    for (quality, last) in [("smoke", 63), ("draft", 511), ("standard", 1023), ("final", 2047)] {
        assert_eq!(work(&bench, &format!("--quality {quality}")), format!("0…{last} and a row 0…{last}"));
    }
    assert_eq!(work(&bench, ""), "0…511 and a row 0…511");
    assert_eq!(work(&bench, "--quality smoke --width 9"), "0…8 and a row 0…63");
    bench.write("s.scene", (SCENE.to_string() + "SceneSettings { RenderHeight 30 }").as_bytes());
    assert_eq!(work(&bench, "--quality smoke"), "0…63 and a row 0…29");
    assert_eq!(work(&bench, "--quality smoke --height 7"), "0…63 and a row 0…6");
}

#[test]
fn quality_decides_the_samples_too() {
    let bench = Bench::with_scene("quality_samples");
    let samples = |flags: &str| {
        let ran = bench.line(&format!("render s.scene --width 10 --height 10 {flags}")).done();
        let last = ran.err.lines().last().expect("a last line").to_string();
        last.split(" samples").next().and_then(|l| l.rsplit(' ').next()).map(str::to_string)
    };
    for (quality, expected) in [("smoke", "100"), ("draft", "100"), ("standard", "400"), ("final", "1600")] {
        assert_eq!(samples(&format!("--quality {quality}")).as_deref(), Some(expected), "{quality}");
    }
    assert_eq!(samples("--quality final --spp 3").as_deref(), Some("300"));
    bench.write("s.scene", (SCENE.to_string() + "SceneSettings { Antialiasing 4 }").as_bytes());
    assert_eq!(samples("--quality final").as_deref(), Some("400"));
    assert_eq!(samples("--quality final --spp 3").as_deref(), Some("300"));
}

/// A plain line every few seconds says how much is done and how long the rest takes, in words.
#[test]
fn progress_is_told_in_plain_lines() {
    let bench = Bench::with_scene("progress");
    let light = "AreaLight { Position 0 4 1 Direction 0 -1 0 Subdivision 64 64 }";
    bench.write("s.scene", (SCENE.to_string() + light).as_bytes());
    let words = "render s.scene --width 3000 --height 3000 --spp 16".split(' ').collect::<Vec<_>>();
    let mut child = bench.command(&words).stderr(Stdio::piped()).spawn().expect("runs");
    let mut line = String::new();
    let mut err = BufReader::new(child.stderr.take().expect("a pipe"));
    err.read_line(&mut line).expect("a line");
    child.kill().and_then(|()| child.wait()).expect("ends");
    let (share, rest) =
        line.trim_end().strip_prefix("s: ").and_then(|l| l.split_once(" % after ")).expect("a share");
    assert!(share.parse::<u32>().is_ok_and(|share| share < 100), "{line}");
    let (after, left) = rest.split_once(", ").expect("a time left");
    assert!(after.ends_with(" s") && left.ends_with(" left") && !left.contains("inf"), "{line}");
}
