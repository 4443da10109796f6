//! Ctrl-C: nothing half-written, the shell's code.
#![cfg(unix)]

use crate::bench::{Bench, SCENE};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// A picture that would take hours: 65 536 shadow rays for each of 65 535 samples of each pixel.
fn endless() -> String {
    SCENE.to_string() + "AreaLight { Position 0 4 1 Direction 0 -1 0 Subdivision 256 256 }"
}

#[test]
fn ctrl_c_leaves_no_trace() {
    let bench = Bench::with_scene("interrupt");
    bench.write("long.scene", endless().as_bytes());
    // One sample a pixel, for the stop is looked at between pixels.
    let words: Vec<&str> =
        "render s.scene long.scene --width 8000 --height 8000 --spp 1 --only long".split(' ').collect();
    let child = bench.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("runs");
    sleep(Duration::from_millis(1500)); // reading the scene takes milliseconds
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(killed.success());
    let output = child.wait_with_output().expect("ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{err}");
    assert!(output.stdout.is_empty());
    assert_eq!(err.lines().last(), Some("interrupted: long was not written"));
    assert_eq!(bench.files(), ["long.scene", "s.scene"]);
}
