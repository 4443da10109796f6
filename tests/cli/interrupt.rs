//! Ctrl-C and other signals to stop: nothing half-written, the shell's code.
#![cfg(unix)]

use crate::bench::{Bench, SCENE};
use crate::readme::programs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// A picture that would take hours: 65 536 shadow rays for each of 65 535 samples of each pixel.
fn endless() -> String {
    SCENE.to_string() + "AreaLight { Position 0 4 1 Direction 0 -1 0 Subdivision 256 256 }"
}

#[test]
fn signals_leave_no_trace() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let bench = Bench::with_scene(&format!("interrupt_{signal}"));
        bench.write("long.scene", endless().as_bytes());
        // One sample a pixel, for the stop is looked at between pixels.
        let words: Vec<&str> =
            "render s.scene long.scene --width 8000 --height 8000 --spp 1 --only long".split(' ').collect();
        let child =
            bench.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("runs");
        sleep(Duration::from_millis(1500)); // reading the scene takes milliseconds
        send(signal, child.id());
        let output = child.wait_with_output().expect("ends");
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{signal}: {err}");
        assert!(output.stdout.is_empty());
        assert_eq!(err.lines().last(), Some("interrupted: long was not written"));
        assert_eq!(bench.files(), ["long.scene", "s.scene"]);
    }
}

/// The lesson that runs is ended with the command that runs it.
#[test]
fn figures_are_stopped_with_their_lesson() {
    let bench = Bench::new("interrupt_figures");
    let _ = programs("lesson_09"); // which takes minutes at this quality
    let mut figures = bench.command(&["figures", "--only", "09", "--quality", "final"]);
    let figures = figures.env_remove("CARGO").stdout(Stdio::piped()).stderr(Stdio::piped()); // nothing is to be built
    let child = figures.spawn().expect("runs");
    sleep(Duration::from_millis(1500));
    let of_child =
        || Command::new("pgrep").args(["-P", &child.id().to_string()]).output().expect("pgrep").stdout;
    let lesson = String::from_utf8(of_child()).expect("a number").trim().to_string();
    assert!(lesson.parse::<u32>().is_ok(), "no lesson runs: `{lesson}`");
    send("TERM", child.id());
    let output = child.wait_with_output().expect("ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(
        (output.status.code(), err.lines().last()),
        (Some(143), Some("interrupted: lesson_09 was not written"))
    );
    let alive = Command::new("kill").args(["-0", &lesson]).stderr(Stdio::null()).status().expect("kill");
    assert!(!alive.success(), "the lesson goes on alone");
}

/// `nohup` has SIGHUP ignored; that holds for what it starts.
#[test]
fn nohup_is_respected() {
    let bench = Bench::new("interrupt_nohup");
    bench.write("long.scene", endless().as_bytes());
    let script = format!(
        "trap '' HUP; exec {} render long.scene --width 8000 --height 8000",
        env!("CARGO_BIN_EXE_lightbench")
    );
    let mut shell = Command::new("sh");
    shell.args(["-c", &script]).current_dir(&bench.folder).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = shell.spawn().expect("a shell");
    sleep(Duration::from_millis(1500));
    send("HUP", child.id());
    sleep(Duration::from_millis(300));
    assert!(child.try_wait().expect("a state").is_none(), "it goes on");
    send("TERM", child.id());
    assert_eq!(child.wait().expect("ends").code(), Some(143));
}

fn send(signal: &str, process: u32) {
    let sent =
        Command::new("kill").args([&format!("-{signal}"), &process.to_string()]).status().expect("kill");
    assert!(sent.success());
}
