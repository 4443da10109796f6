//! `compare`: two pictures in numbers and as a picture.

use crate::bench::Bench;

fn with_pictures(name: &str) -> Bench {
    let bench = Bench::with_scene(name);
    bench.line("render s.scene --width 24 --height 16 --out a").done();
    bench.line("render s.scene --width 24 --height 16 --out b --integrator visibility").done();
    bench.line("render s.scene --width 16 --height 24 --out c").done();
    bench
}

#[test]
fn identical_and_different_pictures() {
    let bench = with_pictures("compare");
    let same = bench.line("compare a/s.png a/s.png").done();
    assert!(same.out.contains("inf (identical)") && same.out.contains("1.000000"), "{}", same.out);
    assert_eq!(same.out.lines().last(), Some("out/s_minus_s.png"));
    let other = bench.line("compare a/s.png b/s.png --out errors").done();
    assert!(!other.out.contains("identical"));
    assert_eq!(other.out.lines().last(), Some("errors/s_minus_s.png"));
    assert_eq!(&bench.read("errors/s_minus_s.png")[..4], b"\x89PNG");
}

#[test]
fn what_cannot_be_compared() {
    let bench = with_pictures("compare_wrong");
    bench.write("empty.png", b"");
    let half = bench.read("a/s.png");
    bench.write("half.png", &half[..half.len() / 2]);
    bench.line("compare a/s.png c/s.png").refused(2, &["24 × 16", "16 × 24"]);
    bench.line("compare a/s.png none.png").refused(2, &["none.png: cannot read it"]);
    bench.line("compare none.png a/s.png").refused(2, &["none.png: cannot read it"]);
    bench.line("compare a/s.png s.scene").refused(2, &["s.scene: no picture in a known format"]);
    bench.line("compare a/s.png empty.png").refused(2, &["empty.png: "]);
    bench.line("compare a/s.png half.png").refused(2, &["half.png: "]);
    bench.line("compare a/s.png a").refused(2, &["a: "]);
    let ran = bench.line("compare a/s.png b/s.png --out s.scene");
    assert!(
        ran.code == Some(1) && ran.out.contains("RMSE") && ran.err.contains("s.scene"),
        "{}{}",
        ran.out,
        ran.err
    );
    assert!(!bench.folder.join("out").exists());
}

#[test]
fn names_of_any_kind() {
    let bench = with_pictures("compare_names");
    let bytes = bench.read("a/s.png");
    for name in ["my picture.png", "größe.png", "光.PNG", "no_ending"] {
        bench.write(name, &bytes);
        let ran = bench.run(&["compare", name, "b/s.png"]).done();
        let last = ran.out.lines().last().expect("a path").to_string();
        assert!(bench.folder.join(&last).exists(), "{last}");
    }
    let flag = bench.run(&["compare", "--", "-x.png", "b/s.png"]);
    flag.refused(2, &["-x.png: cannot read it"]);
}
