//! `render`: pictures, paths, provenance, refusals.

use crate::bench::{Bench, SCENE};
use std::collections::BTreeMap;
use std::io::Cursor;
use std::process::Stdio;

const SMALL: &str = "--width 40 --height 24";

/// The text chunks of a PNG.
fn texts(png: &[u8]) -> BTreeMap<String, String> {
    let reader = png::Decoder::new(Cursor::new(png)).read_info().expect("a PNG");
    let info = reader.info();
    let latin = info.uncompressed_latin1_text.iter().map(|t| (t.keyword.clone(), t.text.clone()));
    let utf8 = info.utf8_text.iter().map(|t| (t.keyword.clone(), t.get_text().expect("text")));
    latin.chain(utf8).collect()
}

#[test]
fn stdout_is_the_paths_and_stderr_ends_with_the_work() {
    let bench = Bench::with_scene("paths");
    bench.write("deep/t.scene", SCENE.as_bytes());
    let ran = bench.line(&format!("render s.scene deep/t.scene {SMALL}")).done();
    assert_eq!(ran.out, "out/s.png\nout/t.png\n");
    let last = ran.err.lines().last().expect("a last line");
    for word in ["t: ", " s, ", "960 samples", "960 camera rays", "shadow rays"] {
        assert!(last.contains(word), "`{word}` is not in `{last}`");
    }
    assert!(
        !ran.err.contains('\u{1b}') && !ran.err.contains('\r'),
        "no escapes off a terminal:\n{}",
        ran.err
    );
    assert_eq!(bench.files(), ["deep/t.scene", "out/s.png", "out/t.png", "s.scene"]);
}

#[test]
fn quiet_is_silent() {
    let bench = Bench::with_scene("quiet");
    let noted = SCENE.to_string() + "SceneSettings { Antialiasing 7 }"; // a warning
    bench.write("noted.scene", noted.as_bytes());
    assert!(bench.line(&format!("render noted.scene {SMALL}")).done().err.contains("Antialiasing"));
    assert_eq!(bench.line(&format!("render noted.scene s.scene {SMALL} --quiet")).done().err, "");
}

#[test]
fn same_seed_same_bytes_whatever_the_threads() {
    let bench = Bench::with_scene("threads");
    let jittered = SCENE.to_string()
        + "AreaLight { Position 0 4 1 Direction 0 -1 0 Width 2 Height 2 Subdivision 4 4 Placement jittered }";
    bench.write("s.scene", jittered.as_bytes());
    let mut pictures = Vec::new();
    for threads in [1, 2, 7, 1024] {
        let out = format!("out{threads}");
        bench
            .line(&format!("render s.scene {SMALL} --seed 5 --threads {threads} --out {out} --quiet"))
            .done();
        pictures.push(bench.read(&format!("{out}/s.png")));
    }
    assert!(pictures.iter().all(|p| *p == pictures[0]));
    bench.line(&format!("render s.scene {SMALL} --seed 6 --out other")).done();
    assert_ne!(bench.read("other/s.png"), pictures[0], "the seed does nothing");
}

#[test]
fn the_command_in_a_picture_makes_it_again() {
    let bench = Bench::new("provenance");
    bench.write("it's a scène.scene", SCENE.as_bytes());
    let flags =
        "--tone filmic --integrator unshadowed --seed 3 --width 20 --height 10 --spp 2 --format png16";
    let mut args = vec!["render", "it's a scène.scene"];
    args.extend(flags.split(' '));
    args.extend("--out first --threads 3 --quiet --only sc".split(' '));
    bench.run(&args).done();
    let first = bench.read("first/it's a scène.png");
    let texts = texts(&first);
    let command = &texts["Command"];
    assert_eq!(
        command,
        "lightbench render 'it'\\''s a scène.scene' --integrator unshadowed --tone filmic --seed 3 --width 20 \
         --height 10 --spp 2 --format png16"
    );
    assert_eq!(texts["Seed"], "3");
    assert_eq!(texts["Parameters"], "20 × 10 pixels, 2 samples per pixel");
    assert!(texts["Software"].contains(env!("CARGO_PKG_VERSION")));
    let script = command.replacen("lightbench", env!("CARGO_BIN_EXE_lightbench"), 1);
    let again = std::process::Command::new("sh").args(["-c", &script]).current_dir(&bench.folder).output();
    assert!(again.expect("a shell").status.success());
    assert_eq!(bench.read("out/it's a scène.png"), first);
}

#[test]
fn what_is_the_default_anyway_changes_no_byte() {
    let bench = Bench::with_scene("defaults");
    bench.line(&format!("render s.scene {SMALL}")).done();
    let plain = bench.read("out/s.png");
    let spelled = "--quality draft --seed 0 --format png --tone clamp --integrator local";
    bench.line(&format!("render s.scene {SMALL} {spelled}")).done();
    assert_eq!(bench.read("out/s.png"), plain);
}

#[test]
fn every_format_tone_and_integrator() {
    let bench = Bench::with_scene("formats");
    let begins = |name: &str, magic: &[u8]| assert_eq!(&bench.read(name)[..magic.len()], magic, "{name}");
    for (format, file, magic) in [
        ("png", "out/s.png", &b"\x89PNG"[..]),
        ("png16", "out/s.png", b"\x89PNG"),
        ("exr", "out/s.exr", b"\x76\x2f\x31\x01"),
        ("hdr", "out/s.hdr", b"#?RADIANCE"),
    ] {
        assert_eq!(
            bench.line(&format!("render s.scene {SMALL} --format {format}")).done().out,
            format!("{file}\n")
        );
        begins(file, magic);
    }
    let bright = SCENE.replace("Position", "Color 9 9 9 Position");
    bench.write("s.scene", bright.as_bytes());
    let mut pictures = Vec::new();
    for choice in ["--tone clamp", "--tone divide", "--tone filmic", "--integrator visibility"] {
        bench.line(&format!("render s.scene {SMALL} {choice}")).done();
        pictures.push(bench.read("out/s.png"));
    }
    for i in 0..pictures.len() {
        assert!(!pictures[..i].contains(&pictures[i]), "choice {i} draws what another draws");
    }
}

#[test]
fn a_black_picture_can_be_divided_by_its_maximum() {
    let bench = Bench::with_scene("black");
    bench.write("s.scene", SCENE.replace("Position", "Color 0 0 0 Position").as_bytes());
    for tone in ["clamp", "divide", "filmic"] {
        bench.line(&format!("render s.scene {SMALL} --tone {tone}")).done();
    }
}

#[test]
fn only_chooses_among_scenes() {
    let bench = Bench::with_scene("only");
    bench.write("other.scene", SCENE.as_bytes());
    let ran = bench.line(&format!("render s.scene other.scene {SMALL} --only oth")).done();
    assert_eq!(ran.out, "out/other.png\n");
    bench.line("render s.scene other.scene --only x").refused(2, &["--only x", "s, other"]);
}

#[test]
fn bad_scenes_stop_before_anything_is_rendered() {
    let bench = Bench::with_scene("bad_scenes");
    bench.write("wrong.scene", b"Camera { POV 0 0 5 }\nSphere { Radius x }\n");
    bench.write("latin.scene", b"# caf\xe9\n");
    bench.write("folder.scene/x", b"");
    bench.line("render s.scene missing.scene").refused(2, &["missing.scene: cannot be read"]);
    bench.line("render s.scene folder.scene").refused(2, &["folder.scene: cannot be read"]);
    bench.line("render s.scene wrong.scene").refused(2, &["wrong.scene:2:17: error", "expected", "`x`"]);
    bench.line("render latin.scene").refused(2, &["latin.scene:1:6", "UTF-8", "0xE9"]);
    bench.run(&["render", ""]).refused(2, &["a value is required"]);
    assert!(!bench.folder.join("out").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_file_is_no_scene() {
    Bench::new("endless").line("render /dev/zero").refused(2, &["/dev/zero", "longer than"]);
}

#[test]
fn scenes_of_one_name_do_not_overwrite_each_other() {
    let bench = Bench::with_scene("one_name");
    bench.write("a/s.scene", SCENE.as_bytes());
    bench
        .line(&format!("render s.scene a/s.scene {SMALL}"))
        .refused(2, &["s.scene and a/s.scene would both be written to out/s.png"]);
}

/// At final quality each of these would take minutes.
#[test]
fn where_nothing_can_be_written_is_known_before_the_work() {
    let bench = Bench::with_scene("out_file");
    for out in ["s.scene", "s.scene/deeper", "s.scene/s.png"] {
        bench
            .line(&format!("render s.scene --quality final --out {out}"))
            .refused(1, &["expected a folder", "found the file s.scene"]);
    }
    assert_eq!(bench.read("s.scene"), SCENE.as_bytes());
    bench.write("taken/s.png/x", b"");
    for line in ["--out taken", "--out taken/s.png", "--out taken --name s"] {
        bench
            .line(&format!("render s.scene --quality final {line}"))
            .refused(1, &["taken/s.png", "expected a file, found a folder"]);
    }
    assert_eq!(bench.files(), ["s.scene", "taken/s.png/x"]);
}

/// Nobody, not even root, creates files in `/proc`.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_refuses_files_is_known_before_the_work() {
    let bench = Bench::with_scene("out_refused");
    for out in ["/proc", "/proc/new", "/proc/s.png"] {
        bench
            .line(&format!("render s.scene --quality final --out {out}"))
            .refused(1, &["cannot create a file in /proc"]);
    }
    bench.line("figures --out /proc/new").refused(1, &["cannot create a file in /proc"]);
}

#[test]
fn out_may_be_a_file_and_name_names_it() {
    let bench = Bench::with_scene("out_names");
    for (line, file, magic) in [
        ("--out a.png", "a.png", &b"\x89PNG"[..]),
        ("--out new/deep/A.EXR", "new/deep/A.EXR", b"\x76\x2f\x31\x01"),
        ("--out a.png --format png16", "a.png", b"\x89PNG"),
        ("--out pictures.v2", "pictures.v2/s.png", b"\x89PNG"),
        ("--out pictures.png/", "pictures.png/s.png", b"\x89PNG"),
        ("--name b", "out/b.png", b"\x89PNG"),
        ("--name b.v2 --out new", "new/b.v2.png", b"\x89PNG"),
        ("--name b --format hdr", "out/b.hdr", b"#?RADIANCE"),
        ("--name b.exr", "out/b.exr", b"\x76\x2f\x31\x01"),
        ("--pixel 3,4 --out ray.svg", "ray.svg", b"<svg"),
        ("--pixel 3,4 --name ray", "out/ray.svg", b"<svg"),
        ("--pixel 3,4 --out ray.png", "ray.png", b"\x89PNG"),
    ] {
        let ran = bench.line(&format!("render s.scene {SMALL} {line}")).done();
        assert_eq!(ran.out.lines().last(), Some(file), "{line}");
        assert_eq!(&bench.read(file)[..magic.len()], magic, "{line}");
    }
    // The command in the file makes a file of the same format.
    bench.line(&format!("render s.scene {SMALL} --out c.hdr")).done();
    let hdr = bench.read("c.hdr");
    let command = format!("lightbench render s.scene {SMALL} --format hdr\n");
    assert!(hdr.windows(command.len()).any(|w| w == command.as_bytes()));
}

#[test]
fn too_large_a_picture_is_refused_before_memory_is_asked_for() {
    let bench = Bench::with_scene("too_large");
    let ran = bench.line("render s.scene --width 65535 --height 65535");
    ran.refused(2, &["expected at most 67108864 pixels", "found 65535 × 65535 = 4294836225"]);
    bench.line("render s.scene --width 65535 --height 65535 --pixel 0,0").refused(2, &["4294836225"]);
}

#[test]
fn a_pixel_is_replayed() {
    let bench = Bench::with_scene("pixel");
    let ran = bench.line(&format!("render s.scene {SMALL} --pixel 20,12")).done();
    assert!(ran.out.starts_with("pixel 20,12 of s.scene: radiance "), "{}", ran.out);
    assert!(ran.out.contains("camera ray") && ran.out.contains("hits Sphere"), "{}", ran.out);
    assert_eq!(ran.out.lines().last(), Some("out/s_pixel_20_12.svg"));
    let svg = String::from_utf8(bench.read("out/s_pixel_20_12.svg")).expect("text");
    assert!(svg.contains("</svg>") && svg.contains("--pixel 20,12"), "a drawing with its command");
    bench.line(&format!("render s.scene {SMALL} --pixel 40,0")).refused(2, &["--pixel 40,0", "0…39", "0…23"]);
    bench.line(&format!("render s.scene {SMALL} --pixel 0,24")).refused(2, &["0…23"]);
}

#[test]
fn a_pixel_of_too_many_rays_is_refused() {
    let bench = Bench::with_scene("pixel_many");
    let light = "AreaLight { Position 0 4 1 Direction 0 -1 0 Subdivision 256 256 }";
    bench.write("s.scene", (SCENE.to_string() + light).as_bytes());
    bench.line("render s.scene --pixel 0,0 --spp 65535").refused(2, &["at most 262144 rays", "--spp"]);
}

#[test]
fn two_renders_into_one_folder_leave_a_whole_picture() {
    let bench = Bench::with_scene("two_at_once");
    let words: Vec<&str> = "render s.scene --width 64 --height 64 --quiet".split(' ').collect();
    let mut children: Vec<_> =
        (0..4).map(|_| bench.command(&words).stdout(Stdio::null()).spawn().expect("runs")).collect();
    for child in &mut children {
        assert!(child.wait().expect("ends").success());
    }
    assert_eq!(texts(&bench.read("out/s.png"))["Parameters"], "64 × 64 pixels, 1 sample per pixel");
    assert_eq!(bench.files(), ["out/s.png", "s.scene"]);
}

#[test]
fn a_dumb_terminal_and_no_color_get_no_escapes() {
    let bench = Bench::with_scene("no_color");
    bench.write("wrong.scene", b"Sphere { Radius x }");
    for (name, value) in [("NO_COLOR", "1"), ("TERM", "dumb")] {
        for args in [["render", "wrong.scene"], ["check", "wrong.scene"]] {
            let ran = bench.command(&args).env(name, value).output().expect("runs");
            assert!(!ran.stderr.contains(&0x1b));
        }
    }
}
