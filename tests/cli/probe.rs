//! `probe`: tables in, answers out, or one clear message.

use crate::bench::{Bench, Ran};

const HEADER: &str = "cx,cy,cz,r,ox,oy,oz,dx,dy,dz";
const ROW: &str = "0,0,0,1,0.1,0.2,5,0,0,-1";

fn sphere(name: &str, table: &str) -> Ran {
    Bench::new(name).fed(&["probe", "ray_sphere"], table.as_bytes())
}

#[test]
fn answers_read_back_exactly() {
    let ran = sphere("probe_exact", &format!("{HEADER}\n{ROW}\n")).done();
    let mut lines = ran.out.lines();
    assert_eq!(lines.next(), Some("n_pos,tp0,tp1,nx,ny,nz"));
    let cells: Vec<&str> = lines.next().expect("an answer").split(',').collect();
    assert_eq!((cells[0], lines.next()), ("2", None));
    for cell in &cells[1..] {
        let x: f64 = cell.parse().expect("a number");
        let (plain, scientific) = (format!("{x}"), format!("{x:e}"));
        assert!(*cell == plain || *cell == scientific, "{cell} is not the shortest text of {x:e}");
    }
    // t = 5 ∓ √(1 − 0.05), to the rounding of two subtractions and a root at magnitude 6
    let t: f64 = cells[1].parse().expect("a number");
    assert!((t - (5.0 - 0.95f64.sqrt())).abs() <= 4.0 * f64::EPSILON * 6.0, "{t}");
    assert_eq!(ran.err, "");
}

#[test]
fn columns_in_any_order_with_others_between() {
    let plain = sphere("probe_plain", &format!("{HEADER}\n{ROW}\n")).done().out;
    let table = "note,dz,dy,dx, oz ,oy,ox,id,r,cz,cy,cx\n\"a, b\",-1,0,0, 5 ,0.2,0.1,7,1,0,0,0\n";
    assert_eq!(sphere("probe_order", table).done().out, plain);
    for (name, table) in [
        ("probe_crlf", format!("{HEADER}\r\n{ROW}\r\n")),
        ("probe_bom", format!("\u{feff}{HEADER}\n{ROW}\n")),
        ("probe_bom_crlf", format!("\u{feff}{HEADER}\r\n{ROW}")),
        ("probe_blank_lines", format!("\n{HEADER}\n\n\n{ROW}\n\n")),
    ] {
        assert_eq!(sphere(name, &table).done().out, plain, "{name}");
    }
}

#[test]
fn a_header_alone_is_an_empty_table() {
    assert_eq!(sphere("probe_header", &format!("{HEADER}\n")).done().out, "n_pos,tp0,tp1,nx,ny,nz\n");
}

#[test]
fn a_bad_row_is_named_by_line_and_column_and_nothing_is_answered() {
    let good = format!("{HEADER}\n{ROW}\n");
    for (name, table, words) in [
        (
            "word",
            format!("{good}0,0,0,one,0,0,5,0,0,-1\n"),
            &["line 3, column 4 (`r`)", "a finite number", "`one`"],
        ),
        ("blank", format!("{good}0,0,0,1,,0,5,0,0,-1\n"), &["line 3, column 5 (`ox`)", "found nothing", ""]),
        ("nan", format!("{good}0,0,0,1,0,0,5,0,0,nan\n"), &["line 3, column 10 (`dz`)", "`nan`", ""]),
        ("over", format!("{good}1e999,0,0,1,0,0,5,0,0,1\n"), &["line 3, column 1 (`cx`)", "`1e999`", ""]),
        ("zero", format!("{good}0,0,0,1,0,0,5,0,0,0\n"), &["line 3, column 8 (`dx`)", "zero vector", ""]),
        ("negative", format!("{good}0,0,0,-1,0,0,5,0,0,1\n"), &["line 3, column 4 (`r`)", "`-1`", ""]),
        ("short", format!("{good}0,0,0\n"), &["line 3: expected 10 cells", "found 3", ""]),
        ("long", format!("{good}{ROW},9\n"), &["line 3: expected 10 cells", "found 11", ""]),
        (
            "crlf",
            format!("{HEADER}\r\n{ROW}\r\n{ROW}\r\nx,0,0,1,0,0,5,0,0,1\r\n"),
            &["line 4, column 1", "`x`", ""],
        ),
        ("crlf_short", format!("{HEADER}\r\n{ROW}\r\n0\r\n"), &["line 3: expected 10", "found 1", ""]),
        (
            "after_blank",
            format!("{HEADER}\n\n{ROW}\n\n\nx,0,0,1,0,0,5,0,0,1\n"),
            &["line 6, column 1", "`x`", ""],
        ),
        ("bom", format!("\u{feff}{HEADER}\nx,0,0,1,0,0,5,0,0,1\n"), &["line 2, column 1 (`cx`)", "`x`", ""]),
        (
            "many_lines",
            format!("note,{HEADER}\n\"a\nb\",{ROW}\n\"\",x,0,0,1,0,0,5,0,0,1\n"),
            &["line 4, column 2", "", ""],
        ),
        ("empty", String::new(), &["line 1", "lacks the column `cx`", "found nothing"]),
        ("missing", HEADER.replace(",oy", "") + "\n", &["line 1", "lacks the column `oy`", "found cx, cy"]),
        ("capital", HEADER.replace("oy", "OY") + "\n", &["line 1", "lacks the column `oy`", "OY"]),
        ("twice", format!("{HEADER},r\n{ROW},2\n"), &["line 1, column 11", "`r` twice", ""]),
    ] {
        sphere(&format!("probe_bad_{name}"), &table).refused(2, words);
    }
}

/// The domain of colours is stated, and checked.
#[test]
fn a_colour_outside_the_cube_is_refused() {
    for (row, place) in
        [("-1e-20,0,0", "column 1 (`r`)"), ("0,1.5,0", "column 2 (`g`)"), ("0,0,-1", "column 3 (`b`)")]
    {
        let table = format!("r,g,b\n1,0,-0\n{row}\n");
        let ran = Bench::new("probe_colour").fed(&["probe", "colour_convert"], table.as_bytes());
        ran.refused(2, &[format!("line 3, {place}").as_str(), "[0,1]"]);
    }
}

/// What a table holds reaches the terminal escaped and shortened.
#[test]
fn cells_in_messages_are_escaped_and_shortened() {
    let bench = Bench::new("probe_escaped");
    let long = "9".repeat(1_000_000);
    for cell in ["\u{1b}[31mred", &long] {
        for table in [
            format!("{HEADER}\n{ROW}\n{cell}x{}\n", &ROW[1..]),
            format!("{cell},{HEADER}\n").replace("oy", ""),
        ] {
            let ran = bench.fed(&["probe", "ray_sphere"], table.as_bytes());
            assert_eq!(ran.code, Some(2));
            assert!(!ran.err.contains('\u{1b}') && ran.err.len() < 1000, "{} bytes", ran.err.len());
        }
    }
    let view =
        "ex,ey,ez,tx,ty,tz,ux,uy,uz,fov_deg,fov_axis,width,height,px,py\n0,0,5,0,0,0,0,1,0,60,v,2.0,2,0,0\n";
    bench.fed(&["probe", "pinhole"], view.as_bytes()).refused(2, &["(`width`)", "a whole number", "`2.0`"]);
}

#[test]
fn bytes_that_are_no_text() {
    let bench = Bench::new("probe_bytes");
    let mut table = format!("{HEADER}\n{ROW}\n0,").into_bytes();
    table.extend(b"\xff\xfe,0,1,0,0,5,0,0,1\n");
    bench.fed(&["probe", "ray_sphere"], &table).refused(2, &["line 3, column 2", "UTF-8"]);
    let noise: Vec<u8> = (0..100_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    bench.fed(&["probe", "ray_sphere"], &noise).refused(2, &["line "]);
}

#[test]
fn a_large_table_is_answered_row_by_row() {
    let rows = 100_000;
    let ran = sphere("probe_large", &format!("{HEADER}\n{}", format!("{ROW}\n").repeat(rows))).done();
    assert_eq!(ran.out.lines().count(), rows + 1);
}

#[test]
fn topics_and_methods() {
    let bench = Bench::new("probe_topics");
    bench.line("probe ray_spheer").refused(2, &["ray_spheer", "ray_sphere", "pinhole"]);
    bench.line("probe ray_sphere --method magic").refused(2, &["magic", "robust", "algebraic"]);
    bench.line("probe lookat --method magic").refused(2, &["magic", "no --method"]);
    bench.line("probe lookat --data x.csv").refused(2, &["lookat", "takes no data", "x.csv"]);
    for method in ["robust", "algebraic", "geometric"] {
        let table = format!("{HEADER}\n{ROW}\n");
        bench.fed(&["probe", "ray_sphere", "--method", method], table.as_bytes()).done();
    }
}

/// What is wrong with the command is said at once, not after all of stdin.
#[test]
fn a_wrong_command_does_not_wait_for_the_table() {
    let bench = Bench::new("probe_no_wait");
    for args in ["probe ray_sphere --method magic", "probe nothing", "probe lookat --data x"] {
        let words: Vec<&str> = args.split(' ').collect();
        let mut command = bench.command(&words);
        let mut child = command
            .stdin(std::process::Stdio::piped())
            .stderr(std::process::Stdio::null())
            .spawn()
            .expect("runs");
        let open = child.stdin.take(); // `wait` would close it
        assert_eq!(child.wait().expect("ends").code(), Some(2));
        drop(open);
    }
}

/// Extreme but finite input never ends in a panic.
#[test]
fn extreme_numbers() {
    let extremes =
        ["0", "-0", "5e-324", "1e-160", "1", "1e160", "1.7976931348623157e308", "-1.7976931348623157e308"];
    let bench = Bench::new("probe_extremes");
    for x in extremes {
        for y in extremes {
            let table = format!("{HEADER}\n{x},0,0,{},0,{y},{x},{y},1,{x}\n", y.trim_start_matches('-'));
            let ran = bench.fed(&["probe", "ray_sphere"], table.as_bytes());
            assert!(matches!(ran.code, Some(0 | 2)), "{table}{}", ran.err);
        }
    }
}
