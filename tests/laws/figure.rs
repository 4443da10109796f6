//! Laws of figures: the same bytes, well-formed files, labels that do not collide, no panic on any data.

use glam::{DVec2, DVec3, dvec2};
use lightbench::measure::{Failures, Method, Point, Run, Series, Spread};
use lightbench_kit::figure::drawing::{Drawing, Rect, Text};
use lightbench_kit::figure::ink::{Hue, Ink, METHOD_HUES, ROLES, contrast};
use lightbench_kit::figure::label::{Candidate, Placer, inside, pushed_apart};
use lightbench_kit::figure::{
    Axis, Bars, Chart, Diagram, ErrorPanel, FailureMap, Figure, Guide, Light, Panels, Pixels, Provenance,
    Repeats, Shades, Space, Table, bitmap, colormap, font,
};
use proptest::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, cases, ..ProptestConfig::default() }
}

fn line(from: f64, slope: f64, count: i32) -> Series {
    let point = |k: i32| {
        let error = from * 10f64.powf(slope * f64::from(k));
        let mut p =
            Point::at(2f64.powi(k)).timed(Spread::exact(1.0e-7 * 2f64.powi(k))).worked(f64::from(k) + 1.0);
        p.error = Some(Spread { mid: error, low: error * 0.8, high: error * 1.3, runs: 5 });
        p.runs = vec![Run { time: Some(1.0e-7), error: Some(error) }];
        p
    };
    Series::new((0..count).map(point).collect())
}

fn failing(mut series: Series) -> Series {
    for p in &mut series.points {
        p.failures = Failures { missed: 40, false_hits: 1, nan: 2, of: 1000 };
    }
    series
}

fn chart() -> Chart {
    let mut exact = line(1.0e-15, 0.0, 4);
    exact.points[2].error = Some(Spread::exact(0.0));
    Chart::speed_accuracy("error of t, relative")
        .title("A finding with <markup> & \"quotes\"")
        .subtitle("t_{ca} and r^{2}, seed 1")
        .line(Method::default_of("moved"), &exact)
        .line(Method::as_printed("as printed"), &failing(line(1.0e-3, 0.4, 6)))
        .line("plain", &line(1.0e-6, -0.2, 8))
        .guide(Guide::level(f64::EPSILON, "machine epsilon"))
        .guide(Guide::slope(-0.5, "slope −½"))
}

fn diagram() -> Diagram {
    let (c, p) = (dvec2(4.0, 0.5), dvec2(2.2, 0.0));
    Diagram::new(dvec2(-0.5, -2.0), dvec2(7.0, 3.0))
        .title("A ray meets a sphere")
        .half_plane(dvec2(0.0, -1.5), DVec2::Y)
        .word("glass")
        .circle(c, 1.5)
        .word("sphere")
        .ray(Light::Incident, DVec2::ZERO, dvec2(6.5, 0.0))
        .name("d")
        .hidden(&[DVec2::ZERO, c])
        .name("L")
        .normal(p, dvec2(-0.9, -0.2))
        .name_end("n")
        .dimension(DVec2::ZERO, p, -40.0)
        .name("t_{0}")
        .angle(DVec2::ZERO, DVec2::X, c)
        .name("α")
        .right_angle(dvec2(4.0, 0.0), DVec2::Y, DVec2::NEG_X)
        .point(DVec2::ZERO)
        .name("O")
        .point(c)
        .name("C")
        .point(p)
        .name("P")
        .lamp(dvec2(1.0, 2.6))
        .word("lamp")
        .eye(dvec2(6.5, 2.5), dvec2(-1.0, -0.5))
}

fn picture() -> Pixels {
    Pixels::new(6, 4, (0..72).map(|i| (i * 3) as u8).collect())
}

/// One figure of each kind.
fn all() -> Vec<Figure> {
    let axes = || (Axis::log("distance / radius").range(1.0, 1.0e6), Axis::linear("angle").range(0.0, 90.0));
    let cell = |x: f64, y: f64| (x < 1.0e4).then_some(x * y * 1.0e-12);
    let map = FailureMap::new(axes().0, axes().1, "error", (24, 12), cell).title("Where it fails");
    let error = ErrorPanel {
        width: 6,
        height: 4,
        values: (0..24).map(|i| f64::from(i) - 12.0).collect(),
        shades: Shades::Signed,
        name: "error".to_string(),
        rmse: 7.1,
        range: None,
    };
    let panels =
        Panels::new().picture(picture(), "one").picture(picture(), "two").error(error).zoom(1, 1, 2, 2);
    let table =
        Table::new(&["what", "how much"]).title("A table").row(&["a < b, \"c\"", "1.5"]).row(&["d"]).marked();
    let bars = Bars::new(Axis::linear("lost")).bar("a", 3.0).bar(Method::as_printed("b"), 0.0);
    let space = Space::axonometric(30.0, 20.0);
    let solid = Diagram::fitted()
        .solid_box(&space, DVec3::ZERO, DVec3::ONE)
        .ball(&space, DVec3::splat(2.0), 0.5, DVec3::Y)
        .axes(&space, DVec3::ZERO, 1.5)
        .pixel_grid(&space, DVec3::Z * 3.0, DVec3::X, DVec3::Y, 4, 3)
        .pyramid(&space, DVec3::ZERO, &[DVec3::X, DVec3::Y]);
    let many = (0..9).fold(Chart::speed_accuracy("error").title("Nine"), |chart, i| {
        chart.line(format!("method {i}").as_str(), &failing(line(0.1, -0.1 * f64::from(i), 5)))
    });
    vec![
        chart().into(),
        many.into(),
        map.into(),
        panels.into(),
        table.into(),
        bars.into(),
        diagram().into(),
        solid.into(),
    ]
}

/// Checks that tags nest, attributes are quoted, and text holds no bare markup.
fn well_formed(svg: &str) -> Result<(), String> {
    let mut open: Vec<String> = Vec::new();
    let mut rest = svg;
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        if text.contains('>') {
            return Err(format!("a bare > in {text:?}"));
        }
        for (i, _) in text.match_indices('&') {
            let known = ["&amp;", "&lt;", "&gt;", "&quot;"].iter().any(|e| text[i..].starts_with(e));
            if !known {
                return Err(format!("a bare & in {text:?}"));
            }
        }
        let end = rest[start..].find('>').ok_or("a tag without end")? + start;
        let tag = &rest[start + 1..end];
        if tag.matches('"').count() % 2 == 1 {
            return Err(format!("quotes of <{tag}>"));
        }
        if let Some(name) = tag.strip_prefix('/') {
            let last = open.pop();
            if last.as_deref() != Some(name) {
                return Err(format!("</{name}> closes {last:?}"));
            }
        } else if !tag.ends_with('/') {
            open.push(tag.split_whitespace().next().unwrap_or_default().to_string());
        }
        rest = &rest[end + 1..];
    }
    if open.is_empty() && rest.trim().is_empty() { Ok(()) } else { Err(format!("left open: {open:?}")) }
}

/// Pairs of texts whose letters overlap, and texts beyond the canvas.
fn collisions(drawing: &Drawing) -> Vec<String> {
    // Ascender and descender seldom meet: boxes shrink to the height of the letters.
    let tight = |t: &Text| {
        let b = t.bounds();
        Rect::new(b.min.x + 1.0, b.min.y + t.size * 0.12, b.max.x - 1.0, b.max.y - t.size * 0.2)
    };
    let texts = drawing.texts();
    let mut found = Vec::new();
    for (i, a) in texts.iter().enumerate() {
        if !drawing.bounds().covers(&tight(a)) {
            found.push(format!("{:?} leaves the canvas", a.text));
        }
        for b in &texts[i + 1..] {
            if tight(a).overlap(&tight(b)) > 0.0 {
                found.push(format!("{:?} on {:?}", a.text, b.text));
            }
        }
    }
    found
}

#[test]
fn the_same_description_gives_the_same_bytes() {
    for (a, b) in all().iter().zip(&all()) {
        assert_eq!(a.svg(), b.svg());
        assert_eq!(a.png(), b.png(), "{}", a.title);
    }
}

#[test]
fn every_svg_is_well_formed() {
    for figure in all() {
        assert_eq!(well_formed(&figure.svg()), Ok(()), "{}", figure.title);
    }
    assert!(well_formed("<a><b></a></b>").is_err() && well_formed("<a>&</a>").is_err(), "the check itself");
}

#[test]
fn no_label_covers_another() {
    for figure in all() {
        assert_eq!(collisions(&figure.drawing), Vec::<String>::new(), "{}", figure.title);
    }
}

#[test]
fn a_png_opens_again_with_its_words() {
    let provenance = Provenance {
        command: "lightbench figures --only 05".to_string(),
        parameters: "R = 1 m, θ = 40°, r = 10⁻³".to_string(),
        seed: Some(7),
        version: "0.1.0".to_string(),
    };
    let figure = Figure::from(chart()).caption("A caption").alt("What it shows").provenance(provenance);
    let decoder = png::Decoder::new(std::io::Cursor::new(figure.png()));
    let reader = decoder.read_info().expect("a PNG");
    let info = reader.info();
    assert_eq!((info.width, info.height), (1200, 800));
    let plain: Vec<(&str, &str)> =
        info.uncompressed_latin1_text.iter().map(|t| (t.keyword.as_str(), t.text.as_str())).collect();
    assert!(plain.contains(&("Command", "lightbench figures --only 05")), "{plain:?}");
    assert!(plain.contains(&("Seed", "7")) && plain.contains(&("Caption", "A caption")));
    let unicode: Vec<String> = info.utf8_text.iter().map(|t| t.get_text().expect("text")).collect();
    assert!(unicode.iter().any(|t| t.contains("θ = 40°, r = 10⁻³")), "{unicode:?}");
    let svg = figure.svg();
    assert!(
        svg.contains("<desc>What it shows</desc>") && svg.contains("Command: lightbench figures --only 05")
    );
}

#[test]
fn text_stays_text_and_no_box_hides_the_page() {
    let svg = Figure::from(chart()).svg();
    assert!(svg.contains(">as printed</text>") && svg.contains("prefers-color-scheme:dark"));
    assert!(!svg.contains("#000000") && !svg.contains("fill=\"#ffffff\""), "black or a white box");
}

#[test]
fn every_line_is_named_and_the_default_says_so() {
    let drawing = chart().draw();
    let words: Vec<&str> = drawing.texts().iter().map(|t| t.text.as_str()).collect();
    for name in ["moved (default)", "as printed", "plain", "machine epsilon", "slope −½", "exact", "failed"]
    {
        assert!(words.contains(&name), "{name} in {words:?}");
    }
    assert!(words.iter().any(|w| w.contains("240 missed, 6 false, 12 NaN")), "{words:?}");
}

#[test]
fn measured_seconds_are_kept_apart() {
    let figure = Figure::from(chart());
    assert_eq!(figure.repeats, Repeats::Timed);
    let kinds: Vec<Repeats> = figure.data.iter().map(|d| d.repeats).collect();
    assert_eq!(kinds, [Repeats::Always, Repeats::Timed]);
    let counted = Figure::from(Chart::work_accuracy("rays", "error").line("a", &line(1.0, -0.5, 4)));
    assert_eq!(counted.repeats, Repeats::Always);
}

#[test]
fn colours_can_be_read_and_told_apart() {
    for ink in ROLES {
        let (on_light, on_dark) =
            (contrast(ink.light(), Ink::Ground.light()), contrast(ink.dark(), Ink::Ground.dark()));
        // 4.5 for writing, 2 for lines (Okabe & Ito's orange and sky blue have 2.2), by WCAG's formula.
        let least = match ink {
            Ink::Text | Ink::Muted | Ink::Label(_) => 4.5,
            Ink::Line(_) | Ink::Outline => 2.0,
            _ => 1.0,
        };
        assert!(
            on_light >= least && on_dark >= least,
            "{ink:?}: {on_light:.2} on white, {on_dark:.2} on dark"
        );
    }
    let mut lines: Vec<Ink> = METHOD_HUES.iter().map(|h| Ink::Line(*h)).collect();
    lines.push(Ink::Line(Hue::Vermillion));
    for (i, a) in lines.iter().enumerate() {
        for b in &lines[i + 1..] {
            for (p, q) in [(a.light(), b.light()), (a.dark(), b.dark())] {
                let far: i32 = (0..3).map(|k| (i32::from(p[k]) - i32::from(q[k])).abs()).sum();
                assert!(far > 60, "{a:?} and {b:?} differ by {far}");
            }
        }
    }
}

#[test]
fn maps_grow_lighter_and_signed_maps_are_white_at_zero() {
    let lightness = |c: [u8; 3]| contrast(c, [0, 0, 0]);
    let steps: Vec<f64> = (0..=64).map(|i| lightness(colormap::viridis(f64::from(i) / 64.0))).collect();
    assert!(steps.windows(2).all(|w| w[1] > w[0]), "{steps:?}");
    assert_eq!(colormap::diverging(0.0), [255, 255, 255]);
    for i in 0..32 {
        let (a, b) = (f64::from(i) / 32.0, f64::from(i + 1) / 32.0);
        for sign in [1.0, -1.0] {
            assert!(lightness(colormap::diverging(sign * a)) > lightness(colormap::diverging(sign * b)));
        }
    }
    assert_eq!(
        (colormap::viridis(f64::NAN), colormap::diverging(f64::NAN)),
        (colormap::MISSING, colormap::MISSING)
    );
}

#[test]
fn the_failing_share_is_counted_and_written() {
    let axis = || Axis::linear("x").range(0.0, 1.0);
    let map = FailureMap::new(axis(), axis(), "error", (20, 10), |x, _| (x > 0.25).then_some(1.0))
        .failing("misses");
    assert_eq!(map.failing_share(), 0.25);
    assert!(map.draw().texts().iter().any(|t| t.text == "misses: 25\u{202F}%"));
}

#[test]
fn a_polygon_covers_its_area_and_letters_leave_ink() {
    let mut drawing = Drawing::new(40.0, 40.0);
    let square = Rect::new(10.25, 10.5, 20.75, 30.0);
    let black = Ink::Fixed([0, 0, 0]);
    drawing.rect(square, Some(lightbench_kit::figure::drawing::Fill::new(black)), None);
    let ink =
        |d: &Drawing| bitmap::render(d).rgb.chunks(3).map(|p| 1.0 - f64::from(p[0]) / 255.0).sum::<f64>();
    // Each of the 59 edge pixels is rounded to half a level.
    let area = square.width() * square.height();
    assert!((ink(&drawing) - area).abs() <= 62.0 * 0.5 / 255.0, "{} for {area}", ink(&drawing));
    for letter in ["Ω", "θ", "⁻", "¹", "½", "↙", "√", "∞", "₁", "ʼ", "−", "·", "µ", "≤"]
    {
        let mut drawing = Drawing::new(40.0, 40.0);
        drawing.text(Text::new(dvec2(5.0, 30.0), letter, 30.0, black));
        let mut missing = Drawing::new(40.0, 40.0);
        missing.text(Text::new(dvec2(5.0, 30.0), "\u{10FFFF}", 30.0, black));
        assert!(ink(&drawing) > 3.0, "{letter} leaves no ink");
        assert_ne!(bitmap::render(&drawing), bitmap::render(&missing), "{letter} is not in the font");
    }
}

#[test]
fn markup_lowers_raises_and_survives_mistakes() {
    assert_eq!(font::plain("t_{ca}^{2} as_printed x_{"), "tca2 as_printed x_{");
    let full = font::width("tca", lightbench_kit::figure::drawing::Face::Italic, 20.0);
    let lowered = font::width("t_{ca}", lightbench_kit::figure::drawing::Face::Italic, 20.0);
    assert!(lowered < full && lowered > 0.0);
}

#[test]
fn degenerate_charts_still_draw() {
    let nan = f64::NAN;
    let odd: [&[(f64, f64)]; 8] = [
        &[],
        &[(1.0, 1.0)],
        &[(1.0, 0.0), (2.0, 0.0)],
        &[(nan, 1.0), (1.0, nan), (f64::INFINITY, f64::NEG_INFINITY)],
        &[(5.0, 5.0), (5.0, 5.0), (5.0, 5.0)],
        &[(-1.0, -1.0), (0.0, -3.0)],
        &[(1.0e-310, 1.0e308), (1.0e308, 5.0e-324)],
        &[(1.0, f64::MAX), (2.0, f64::MIN)],
    ];
    for points in odd {
        for axis in [Axis::log as fn(&str) -> Axis, Axis::linear, Axis::time, Axis::percent] {
            let chart = Chart::new(axis("x"), axis("y")).title("Odd data").curve("the line", points);
            let figure =
                Figure::from(chart.guide(Guide::slope(nan, "a guide")).guide(Guide::level(0.0, "none")));
            let svg = figure.svg();
            assert_eq!(well_formed(&svg), Ok(()));
            assert!(!svg.contains("NaN\"") && !svg.contains("inf\""), "{points:?}");
            assert!(svg.contains("the line"), "the line is named: {points:?}");
        }
    }
}

#[test]
fn a_line_sorts_its_points_steps_keep_their_order_and_scatter_joins_none() {
    let mut sorted = line(1.0e-3, -0.4, 5);
    sorted.points.iter_mut().for_each(|p| p.runs.clear());
    let mut turned = sorted.clone();
    turned.points.swap(1, 3);
    let drawn = |chart: Chart| Figure::from(chart).svg();
    let new = || Chart::speed_accuracy("error");
    assert_eq!(drawn(new().line("a", &turned)), drawn(new().line("a", &sorted)));
    assert_eq!(drawn(new().steps("a", &sorted)), drawn(new().line("a", &sorted)));
    assert_ne!(drawn(new().steps("a", &turned)), drawn(new().line("a", &sorted)));
    let [joined, dots] = [new().line("a", &sorted), new().scatter("a", &sorted)].map(drawn);
    assert_eq!(dots.matches("<circle").count(), 5);
    assert!(dots.len() < joined.len(), "no line joins the dots");
    let noted = |x: f64| drawn(new().line("a", &sorted).note(x, 1.0e-3, "here")).contains("here");
    assert!(noted(1.0e-7) && !noted(1.0) && !noted(f64::NAN), "a note stands beside its place, or nowhere");
}

/// Half of the points failed on 1 question of 100 each; the share is that of all 800 questions, not of the 400.
#[test]
fn failures_are_counted_out_of_all_that_was_asked() {
    let mut series = line(1.0e-3, -0.4, 8);
    for (i, p) in series.points.iter_mut().enumerate() {
        p.failures = Failures { missed: u64::from(i % 2 == 0), of: 100, ..Failures::default() };
    }
    let axis = Axis::log("distance").range(1.0, 1.0e3);
    let texts: Vec<String> = Chart::error_over(axis, "error")
        .line("a", &series)
        .draw()
        .texts()
        .iter()
        .map(|t| t.text.clone())
        .collect();
    assert!(texts.iter().any(|t| t.contains("4 missed of 800")), "{texts:?}");
}

/// Times that a busy machine has shuffled must not change which points a line joins.
#[test]
fn a_line_joins_its_points_in_the_order_of_the_parameter() {
    let mut series = line(1.0e-3, -0.4, 4);
    series.points.iter_mut().for_each(|p| p.runs.clear());
    for (point, time) in series.points.iter_mut().zip([4.0e-7, 1.0e-7, 3.0e-7, 2.0e-7]) {
        point.time = Some(Spread::exact(time));
    }
    let drawn = |chart: Chart| Figure::from(chart).svg();
    let new = || Chart::speed_accuracy("error");
    assert_eq!(drawn(new().line("a", &series)), drawn(new().steps("a", &series)));
}

/// Two pixels, black and white, shrunk to one send half the light: sRGB level 188, where the mean of bytes is 128.
#[test]
fn pictures_are_shrunk_in_linear_light() {
    let mut drawing = Drawing::new(1.0, 1.0);
    drawing.image(Rect::new(0.0, 0.0, 1.0, 1.0), Pixels::new(2, 1, vec![0, 0, 0, 255, 255, 255]));
    let half = (lightbench::color::srgb_encode(0.5) * 255.0).round() as u8;
    assert_eq!(bitmap::render(&drawing).rgb, [half; 3]);
}

#[test]
fn a_figure_without_its_heading_has_its_marks_further_up_and_nothing_else_changed() {
    let whole = Figure::from(chart());
    let bare = whole.clone().without_heading();
    let texts = |f: &Figure| f.drawing.texts().len();
    assert!(texts(&bare) < texts(&whole) && bare.drawing.height < whole.drawing.height);
    assert!(bare.drawing.texts().iter().all(|t| !t.text.contains("A finding")));
    assert_eq!(whole.drawing.items.len() - bare.drawing.items.len(), whole.drawing.heading.1);
}

#[test]
fn degenerate_diagrams_maps_and_panels_still_draw() {
    let empty = [
        Figure::from(Diagram::fitted()),
        Figure::from(Diagram::fitted().point(DVec2::ZERO).name("O")),
        Figure::from(Diagram::fitted().ray(Light::Shadow, DVec2::NAN, DVec2::ONE).name("?")),
        Figure::from(Panels::new()),
        Figure::from(Table::new(&[])),
        Figure::from(Bars::new(Axis::log("x"))),
        Figure::from(Bars::new(Axis::log("x")).bar("zero", 0.0).bar("nan", f64::NAN)),
    ];
    for figure in &empty {
        assert_eq!(well_formed(&figure.svg()), Ok(()));
        assert!(!figure.png().is_empty());
    }
    let axis = || Axis::log("x").range(1.0, 10.0);
    for value in [None, Some(0.0), Some(f64::INFINITY), Some(1.0)] {
        for shades in [Shades::Decades, Shades::Linear, Shades::Signed] {
            let map = FailureMap::new(axis(), axis(), "e", (3, 2), |_, _| value).shades(shades);
            assert_eq!(well_formed(&Figure::from(map).svg()), Ok(()));
        }
    }
}

proptest! {
    #![proptest_config(config(512))]

    #[test]
    fn logarithmic_ticks_are_powers_of_ten_in_range(low in -300.0..300.0f64, decades in 0.0..250.0f64, px in 60.0..1200.0f64) {
        let (a, b) = (10f64.powf(low), 10f64.powf((low + decades).min(305.0)));
        let ruler = Axis::log("x").ruler([a, b].into_iter(), 0.0, px);
        let ticks = ruler.ticks();
        prop_assert!(!ticks.is_empty() && ticks.len() <= 9, "{} ticks", ticks.len());
        for (value, _) in &ticks {
            prop_assert_eq!(*value, 10f64.powi(value.log10().round() as i32));
            prop_assert!(ruler.inside(*value).is_some());
        }
        prop_assert!(ruler.inside(a).is_some() && ruler.inside(b).is_some(), "the data is in range");
    }

    #[test]
    fn linear_ticks_are_distinct_and_in_range(low in -1.0e6..1.0e6f64, size in 1.0e-3..1.0e6f64) {
        let ruler = Axis::linear("x").ruler([low, low + size].into_iter(), 0.0, 900.0);
        let ticks = ruler.ticks();
        prop_assert!(ticks.len() >= 2 && ticks.len() <= 13, "{} ticks", ticks.len());
        prop_assert!(ticks.iter().all(|t| ruler.inside(t.0).is_some()));
        let mut labels: Vec<&String> = ticks.iter().map(|t| &t.1).collect();
        labels.dedup();
        prop_assert_eq!(labels.len(), ticks.len(), "{:?}", ticks);
    }

    #[test]
    fn a_ruler_reads_back_what_it_places(low in -30.0..30.0f64, decades in 0.5..30.0f64, share in 0.0..1.0f64) {
        let (a, b) = (10f64.powf(low), 10f64.powf(low + decades));
        let ruler = Axis::log("x").range(a, b).ruler(std::iter::empty(), 100.0, 900.0);
        let value = ruler.value(100.0 + 800.0 * share);
        let back = ruler.at(value).expect("inside");
        // The power loses up to u per unit of its exponent's logarithm (70), over 800 px; a few roundings more.
        prop_assert!((back - 100.0 - 800.0 * share).abs() <= lightbench::measure::rounding(200, 900.0));
    }

    #[test]
    fn pushed_labels_keep_their_order_and_distance(
        wanted in prop::collection::vec(0.0..500.0f64, 1..15), height in 5.0..30.0f64
    ) {
        let heights = vec![height; wanted.len()];
        let centers = pushed_apart(&wanted, &heights, 0.0, 500.0);
        let mut order: Vec<usize> = (0..wanted.len()).collect();
        order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]).then(a.cmp(&b)));
        // Positions below 1000 come from sums of at most 15 terms.
        let slack = lightbench::measure::rounding(60, 1000.0);
        for w in order.windows(2) {
            prop_assert!(centers[w[1]] - centers[w[0]] >= height - slack, "{:?}", centers);
        }
        let inside = |c: &f64| *c >= height / 2.0 - slack && *c <= 500.0 - height / 2.0 + slack;
        prop_assert!(centers.iter().all(inside) || height * wanted.len() as f64 > 500.0);
    }

    #[test]
    fn the_length_of_a_segment_in_a_box_is_that_of_its_samples(
        a in prop::array::uniform2(-20.0..20.0f64), b in prop::array::uniform2(-20.0..20.0f64)
    ) {
        let (a, b) = (DVec2::from_array(a), DVec2::from_array(b));
        let place = Rect::new(-5.0, -3.0, 6.0, 4.0);
        let n = 4000;
        let hits = (0..n).filter(|&i| place.holds(a.lerp(b, (f64::from(i) + 0.5) / f64::from(n)))).count();
        let sampled = hits as f64 / f64::from(n) * a.distance(b);
        // Two ends, each within one sample; touching counts as one pixel.
        prop_assert!((inside(a, b, &place) - sampled).abs() <= 2.0 * a.distance(b) / f64::from(n) + 1.0);
        prop_assert!(sampled < 1.5 || inside(a, b, &place) > 0.9 * sampled);
    }

    #[test]
    fn a_placer_takes_a_free_place_if_there_is_one(spots in prop::collection::vec((0u8..10, 0u8..10), 0..60)) {
        let cell = |x: u8, y: u8| Rect::new(f64::from(x) * 10.0, f64::from(y) * 10.0, f64::from(x) * 10.0 + 9.0, f64::from(y) * 10.0 + 9.0);
        let mut placer = Placer::new(Rect::new(0.0, 0.0, 100.0, 100.0));
        spots.iter().for_each(|&(x, y)| placer.keep_clear(cell(x, y)));
        let candidates: Vec<Candidate> =
            (0..100).map(|k| Candidate { place: cell(k % 10, k / 10), penalty: f64::from(k) * 0.1 }).collect();
        let (best, cost) = placer.place(&candidates).expect("candidates");
        prop_assert_eq!(cost, 0.0);
        prop_assert!(!spots.contains(&(best as u8 % 10, best as u8 / 10)));
    }
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn labels_of_random_charts_do_not_collide(
        lines in prop::collection::vec((-12.0..0.0f64, -0.5..0.5f64, 2i32..12, 0usize..4), 1..=6)
    ) {
        let names = ["blind", "origin moved, Newton", "Sobol’ points, scrambled", "as printed [B 6.3]"];
        let chart = lines.iter().enumerate().fold(
            Chart::speed_accuracy("relative error").title("A finding").subtitle("seed 1"),
            |chart, (i, &(from, slope, count, name))| {
                let series = line(10f64.powf(from), slope, count);
                let series = if name == 3 { failing(series) } else { series };
                let name = format!("{} {i}", names[name]);
                chart.line(if i == 0 { Method::default_of(&name) } else { Method::new(&name) }, &series)
            },
        );
        prop_assert_eq!(collisions(&chart.draw()), Vec::<String>::new());
    }

    #[test]
    fn letters_of_random_diagrams_do_not_collide(
        points in prop::collection::vec((0.0..10.0f64, 0.0..6.0f64), 3..10)
    ) {
        let start = Diagram::new(dvec2(-1.0, -1.0), dvec2(11.0, 7.0)).circle(dvec2(5.0, 3.0), 2.0).word("sphere");
        let drawn = points.windows(2).enumerate().fold(start, |d, (i, w)| {
            let (a, b) = (DVec2::from(w[0]), DVec2::from(w[1]));
            let d = d.ray(Light::Incident, a, b).name(&format!("d_{{{i}}}")).point(a).name(&format!("P_{{{i}}}"));
            d.angle(a, b - a, DVec2::Y).name("θ")
        });
        prop_assert_eq!(collisions(&drawn.draw()), Vec::<String>::new());
    }
}
