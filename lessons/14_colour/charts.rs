//! Charts: speed against accuracy, where each method fails, and the printed statements beside what holds.

use super::pictures::changes;
use glam::{DVec2, dvec2, dvec3};
use lightbench::color::dominant::{Dominant, Locus, Rim, Wheel, purity_as_printed};
use lightbench::color::gamut::IntoGamut;
use lightbench::color::models::{Hsv, hls_from_rgb, hls_saturation_textbook, hue, rgb_from_hsv};
use lightbench::color::spectrum::{CONE_PEAKS_AS_PRINTED, Matching, black_body, cones};
use lightbench::color::xyz::{
    EQUAL_ENERGY, Xyy, luminance_as_printed, rgb_from_xyz, xyy_from_xyz, xyz_from_rgb, xyz_from_xyy,
};
use lightbench::color::{Rgb, srgb_decode, srgb_encode};
use lightbench::measure::{Method, Point, Series, Spread, Tally, log_spaced, time_each};
use lightbench::num::double_double::DoubleDouble;
use lightbench::sample::Sampler;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Table, short};

/// Steps at which spectra are summed [nm].
pub const STEPS: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 20.0, 40.0];

/// A spectrum at every nm from 360 on.
struct Sampled(Vec<f64>);

impl Sampled {
    fn of(spectrum: impl Fn(f64) -> f64) -> Self {
        Sampled((0..=470).map(|i| spectrum(360.0 + f64::from(i))).collect())
    }
    fn at(&self, wavelength: f64) -> f64 {
        self.0[(wavelength - 360.0) as usize]
    }
}

/// Black bodies, plain and behind filters 15 to 60 nm wide.
fn spectra(count: u32, seed: u64) -> Vec<Sampled> {
    let one = |i: u32| {
        let mut s = Sampler::new(seed, 14, i);
        let (kelvin, u) = (1800.0 * 8f64.powf(s.next_1d()), s.next_2d());
        let (mean, width, floor) = (430.0 + 210.0 * u.x, 15.0 * 4f64.powf(u.y), s.next_1d() * 0.3);
        let filter = move |w: f64| floor + (-0.5 * ((w - mean) / width).powi(2)).exp();
        Sampled::of(move |w| black_body(w, kelvin) * if i.is_multiple_of(4) { 1.0 } else { filter(w) })
    };
    (0..count).map(one).collect()
}

fn chromaticity(matching: Matching, step: f64, spectrum: impl Fn(f64) -> f64) -> DVec2 {
    xyy_from_xyz(matching.xyz(spectrum, step)).map_or(DVec2::NAN, |c| c.xy)
}

fn styled(matching: Matching) -> Method {
    match matching {
        Matching::Table1nm => Method::default_of(matching.name()).styled(0),
        other => Method::new(other.name()).styled(other as usize),
    }
}

/// Matching functions × step: time and error of a spectrum's chromaticity.
pub fn contest(steps: &[f64], count: u32, seed: u64) -> Vec<(Method, Series)> {
    let spectra = spectra(count, seed);
    let truth: Vec<DVec2> =
        spectra.iter().map(|s| chromaticity(Matching::Table1nm, 1.0, |w| s.at(w))).collect();
    let measured = |matching: Matching| {
        Series::over(steps, |step| {
            let all =
                || spectra.iter().map(|s| chromaticity(matching, step, |w| s.at(w))).collect::<Vec<_>>();
            let errors: Vec<f64> = all().iter().zip(&truth).map(|(a, b)| a.distance(*b)).collect();
            let error = Spread::rms(&errors).unwrap_or(Spread::exact(f64::NAN));
            let samples = (830.0 / step).floor() - (360.0 / step).ceil() + 1.0;
            Point::at(step).timed(time_each(spectra.len(), all)).worked(samples).erred(error)
        })
    };
    Matching::ALL.map(|m| (styled(m), measured(m))).to_vec()
}

pub fn speed(contest: &[(Method, Series)], spectra: u32) -> Figure {
    let at = |k: usize, i: usize| &contest[k].1.points[i];
    let error = |k: usize, i: usize| at(k, i).error.map_or(f64::NAN, |e| e.mid);
    let time = |k: usize, i: usize| at(k, i).time.map_or(f64::NAN, |t| t.mid);
    let steps: Vec<String> = contest[0].1.points.iter().map(|p| short(p.parameter)).collect();
    let title = format!(
        "A table at 10 nm is {:.0} × as accurate as the best fit at 1 nm, in 1/{:.0} of its time",
        error(2, 0) / error(0, 3),
        time(2, 0) / time(0, 3)
    );
    let mut chart = Chart::speed_accuracy("error of chromaticity (distance in x, y), RMS")
        .x(Axis::time("time per spectrum"))
        .title(&title)
        .subtitle(&format!(
            "{spectra} spectra, black bodies plain and filtered; each point a step: {} nm",
            steps.join(", ")
        ))
        // The semi-axes of MacAdam's ellipses (1942) are 0.0004 to 0.01 long.
        .guide(Guide::level(0.003, "about what an eye can tell apart"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    chart.into()
}

/// Chromaticity of a line of the spectrum by each approximation.
pub fn fits() -> Figure {
    // Half way between the rows of the table at 5 nm, where it is worst.
    let wavelengths: Vec<f64> = (0..62).map(|k| 382.5 + 5.0 * f64::from(k)).collect();
    let mut chart = Chart::new(
        Axis::linear("wavelength, nm").range(380.0, 692.0).every(40.0),
        Axis::log("error of chromaticity (distance in x, y)"),
    )
    .title("Fits follow the functions where they are large; where they fade, their ratio runs away")
    .subtitle("chromaticity of a single line against the table at 1 nm, half way between the rows at 5 nm");
    let at = |m: Matching, w: f64| xyy_from_xyz(m.at(w)).map(|c| c.xy);
    for matching in [Matching::Table5nm, Matching::MultiLobe, Matching::SingleLobe] {
        let error = |w: &f64| Some((*w, at(matching, *w)?.distance(at(Matching::Table1nm, *w)?)));
        chart = chart.function(styled(matching), &wavelengths.iter().filter_map(error).collect::<Vec<_>>());
    }
    chart.into()
}

/// Luminance of a narrow line, sampled at fixed steps.
pub fn narrow(centers: u32, seed: u64) -> Figure {
    let widths = log_spaced(0.1, 50.0, 15);
    let line = |center: f64, width: f64| move |w: f64| (-0.5 * ((w - center) / width).powi(2)).exp() / width;
    let mut chart = Chart::error_over(
        Axis::log("standard deviation of the line, nm"),
        "error of luminance, relative: median, worst",
    )
    .title("A step misses lines narrower than half of it; those as wide as itself it finds to two thousandths")
    .subtitle(&format!("{centers} lines at random places between 450 and 650 nm; truth: the table at 1 nm, straight between its rows"));
    let centers: Vec<f64> =
        (0..centers).map(|k| 450.0 + 200.0 * Sampler::new(seed, 140, k).next_1d()).collect();
    let luminance = |center, width, step| Matching::Table1nm.xyz(line(center, width), step).y;
    let truths: Vec<Vec<f64>> = widths
        .iter()
        .map(|width| centers.iter().map(|c| luminance(*c, *width, (width / 8.0).min(0.5))).collect())
        .collect();
    for (i, step) in [1.0, 5.0, 10.0, 20.0].into_iter().enumerate() {
        let point = |(width, truths): (&f64, &Vec<f64>)| {
            let mut tally = Tally::new();
            for (center, truth) in centers.iter().zip(truths) {
                tally.answer(Some(luminance(*center, *width, step)), Some(*truth));
            }
            tally.worst_at(*width)
        };
        let series = Series::new(widths.iter().zip(&truths).map(point).collect());
        let method = if i == 0 { Method::default_of("1 nm") } else { Method::new(&format!("{step} nm")) };
        chart = chart.line(method.styled(i), &series);
    }
    chart.guide(Guide::level(1.0, "all of it")).into()
}

/// Hue of colours near grey, stored with few digits.
pub fn grey(colours: u32, seed: u64) -> Figure {
    let chromas = log_spaced(1.0e-7, 0.5, 14);
    let levels = |n: f64| move |x: f64| srgb_decode((srgb_encode(x) * n).round() / n);
    type Store = Box<dyn Fn(f64) -> f64>;
    let stores: [(&str, Store); 4] = [
        ("8 bits, sRGB", Box::new(levels(255.0))),
        ("16 bits, sRGB", Box::new(levels(65535.0))),
        ("f32, linear", Box::new(|x| f64::from(x as f32))),
        ("f64, linear", Box::new(|x| x)),
    ];
    let mut chart =
        Chart::error_over(Axis::log("chroma, max − min, linear"), "error of hue, degrees (median, worst)")
            .title("Hue is noise once the channels differ by less than a stored level, and grey has none")
            .subtitle(&format!("{colours} random hues round grey ½; missed: the stored colour is grey"))
            .guide(Guide::slope_through(-1.0, 1.0e-3, 0.2, "∝ 1/chroma"));
    for (i, (name, store)) in stores.iter().enumerate() {
        let series = Series::over(&chromas, |chroma| {
            let mut tally = Tally::new();
            for k in 0..colours {
                let turn = 6.0 * Sampler::new(seed, 141, k).next_1d();
                let value = 0.5 + chroma / 2.0;
                let rgb = rgb_from_hsv(Hsv { hue: turn, saturation: chroma / value, value });
                match hue(rgb.map(store)) {
                    Some(found) => {
                        let off = (found - turn).rem_euclid(6.0);
                        tally.error(60.0 * off.min(6.0 - off));
                    }
                    None => tally.answer(None, Some(turn)),
                }
            }
            tally.worst_at(chroma)
        });
        let method = if i == 3 { Method::default_of(name) } else { Method::new(name) };
        chart = chart.line(method.styled([3, 2, 1, 0][i]), &series);
    }
    chart.into()
}

/// The saturation of HLS next to white, where everything is a few roundings away from 1.
pub fn white() -> Figure {
    let u = f64::EPSILON / 2.0;
    // max = 1 − m u and min = 1 − n u exactly; the saturation is (n − m)/(n + m).
    let distances: Vec<f64> = (0..=45).step_by(3).map(|k| 2f64.powi(k)).collect();
    let error = |way: &dyn Fn(Rgb) -> f64| {
        let of = |scale: &f64| {
            let worst = (1..=8).map(|k| {
                // Odd numbers, which 2 − max rounds.
                let m = 2.0 * (scale * f64::from(k)).floor() + 1.0;
                let n = 3.0 * m + f64::from(2 * k);
                let rgb = dvec3(1.0 - m * u, 1.0 - n * u, 1.0 - n * u);
                (way(rgb) * (n + m) / (n - m) - 1.0).abs()
            });
            (2.0 * scale * u, worst.fold(0.0, f64::max))
        };
        distances.iter().map(of).collect::<Vec<_>>()
    };
    Chart::new(
        Axis::log("distance from white, 1 − max"),
        Axis::log("relative error of the saturation of HLS"),
    )
    .title("Next to white 2 − max − min loses digits of the saturation, (1 − max) + (1 − min) keeps them all")
    .subtitle(
        "colours under white by whole numbers of roundings u = 2⁻⁵³, so that the saturation is known exactly",
    )
    .curve(Method::new("2 − max − min").styled(1), &error(&hls_saturation_textbook))
    .curve(Method::default_of("(1 − max) + (1 − min)").styled(0), &error(&|rgb| hls_from_rgb(rgb).saturation))
    .into()
}

/// The dominant wavelength by slope and intercept: y = m x + b through white and colour, met with every segment.
fn naive_slope(xy: DVec2, white: DVec2) -> Option<f64> {
    let m = (xy.y - white.y) / (xy.x - white.x);
    let b = white.y - m * white.x;
    let locus = Locus::of(Matching::Table1nm);
    locus.points().windows(2).enumerate().find_map(|(i, w)| {
        let slope = (w[1].y - w[0].y) / (w[1].x - w[0].x);
        let x = (w[0].y - slope * w[0].x - b) / (m - slope);
        let share = (x - w[0].x) / (w[1].x - w[0].x);
        let ahead = (x - white.x) * (xy.x - white.x) > 0.0;
        ((0.0..=1.0).contains(&share) && ahead).then(|| locus.wavelength(i) + share)
    })
}

/// The same with cross products in 106 bits, over every segment.
fn exact(xy: DVec2, white: DVec2) -> Option<f64> {
    let sub = DoubleDouble::difference;
    let (dx, dy) = (sub(xy.x, white.x), sub(xy.y, white.y));
    let locus = Locus::of(Matching::Table1nm);
    let side = |p: DVec2| sub(p.x, white.x) * dy - sub(p.y, white.y) * dx;
    locus.points().windows(2).enumerate().find_map(|(i, w)| {
        let (a, b) = (side(w[0]), side(w[1]));
        let ahead = (w[0] - white).dot((xy - white).normalize_or_zero()) > 0.0;
        let met = a.value().signum() * b.value().signum() <= 0.0 && a.value() != b.value() && ahead;
        met.then(|| locus.wavelength(i) + (a / (a - b)).value())
    })
}

/// Colours that break programs, by cross products, by slope and intercept, and in 106 bits.
pub fn edges(wheel: &Wheel) -> Figure {
    let (white, locus) = (wheel.white(), Locus::of(Matching::Table1nm));
    let [violet, red] = locus.purple_line();
    let cases = [
        ("right above white", dvec2(white.x, 0.6)),
        ("white and one rounding upwards", dvec2(white.x, white.y.next_up())),
        ("white and one rounding to the right", dvec2(white.x.next_up(), white.y)),
        ("white itself", white),
        ("on the line of purples", violet.lerp(red, 0.5)),
        ("at the red end, 780 nm", red),
        ("imaginary, far below", dvec2(-3.0, -1.0e100)),
    ];
    let mut table = Table::new(&["colour", "cross products (default)", "purity", "y = m x + b", "106 bits"])
        .title("White has no hue, one rounding off it has one; right above it a slope has none")
        .subtitle("dominant wavelength in nm as seen from D65; c marks the complementary one of purples");
    let told = |w: Option<f64>| w.map_or("–".to_string(), |w| format!("{w:.4}"));
    for (name, xy) in cases {
        let found = wheel.dominant(xy);
        let (ours, purity) = match found {
            Some(Dominant { rim: Rim::Spectral(w), purity }) => (told(Some(w)), short(purity)),
            Some(Dominant { rim: Rim::Purple(w), purity }) => (format!("c {w:.4}"), short(purity)),
            None => ("no hue".to_string(), "0".to_string()),
        };
        let opposite = || exact(white * 2.0 - xy, white).map(|w| format!("c {w:.4}"));
        let truth = exact(xy, white).map(|w| told(Some(w))).or_else(opposite);
        let truth = truth.unwrap_or_else(|| "no hue".to_string());
        table = table.row(&[name, &ours, &purity, &told(naive_slope(xy, white)), &truth]);
    }
    table.into()
}

/// What 8 bits leave of the dominant wavelength.
pub fn near_white(wheel: &Wheel, cells: (usize, usize)) -> Figure {
    let locus = Locus::of(Matching::Table1nm);
    let map = FailureMap::new(
        Axis::linear("dominant wavelength, nm").range(420.0, 660.0).every(40.0),
        Axis::log("purity").range(1.0e-3, 1.0),
        "error, nm",
        cells,
        |wavelength, purity| {
            let xy = wheel.white().lerp(locus.at(wavelength), purity);
            let rgb = rgb_from_xyz(xyz_from_xyy(Xyy { xy, luminance: 1.0 })?);
            let shown = IntoGamut::Desaturate.apply(rgb);
            let exposed = shown * (0.5 / shown.max_element());
            let stored = exposed.map(|c| srgb_decode((srgb_encode(c) * 255.0).round() / 255.0));
            match wheel.dominant(xyy_from_xyz(xyz_from_rgb(stored))?.xy)?.rim {
                Rim::Spectral(found) => Some((found - wavelength).abs().max(1.0e-3)),
                Rim::Purple(_) => None,
            }
        },
    )
    .failing_above(10.0, "off by 10 nm or grey");
    let share = map.failing_share();
    let title = format!(
        "Near white 8 bits do not know the hue: on {:.0} % of this map it is off by 10 nm or gone",
        100.0 * share
    );
    map.title(&title)
        .subtitle("colours whose largest channel is ½, desaturated into the screen's gamut, stored in 8 bits of sRGB")
        .range(1.0e-3, 1.0e2)
        .into()
}

/// Two ways into the gamut.
pub fn gamut(wheel: &Wheel) -> Figure {
    let waves: Vec<f64> = (420..=660).step_by(3).map(f64::from).collect();
    let series = |way| {
        Series::over(&waves, |w| {
            let mut tally = Tally::new();
            tally.error(changes(way, w, wheel).0);
            tally.worst_at(w)
        })
    };
    let most = waves.iter().map(|w| changes(IntoGamut::Clip, *w, wheel).0).fold(0.0, f64::max);
    Chart::error_over(
        Axis::linear("line of the spectrum, nm").range(420.0, 660.0).every(40.0),
        "change of the dominant wavelength, nm",
    )
    .title(&format!(
        "Clipping a line of the spectrum to a screen's gamut moves its hue by up to {most:.0} nm"
    ))
    .subtitle("lines of the spectrum in Rec. 709 with white D65; desaturating errs by rounding only")
    .line(Method::default_of(IntoGamut::Desaturate.name()).styled(0), &series(IntoGamut::Desaturate))
    .line(Method::new(IntoGamut::Clip.name()).styled(1), &series(IntoGamut::Clip))
    .into()
}

/// Purity of lines of equal power, on a locus seen from the white of equal energy.
pub fn purity_of(lines: &[f64]) -> f64 {
    let xyz = lines.iter().map(|w| Matching::Table1nm.at(*w)).sum();
    let wheel = Locus::of(Matching::Table1nm).wheel(EQUAL_ENERGY);
    let found = xyy_from_xyz(xyz).zip(wheel).and_then(|(c, wheel)| wheel.dominant(c.xy));
    found.map_or(0.0, |d| d.purity)
}

/// Two lines in the powers that come nearest to white.
pub fn purity_of_pair(a: f64, b: f64) -> f64 {
    let (p, q) = (Matching::Table1nm.at(a), Matching::Table1nm.at(b));
    let (p, q) = (p / p.element_sum(), q / q.element_sum());
    let (from, way) = (p.truncate(), q.truncate() - p.truncate());
    let share = (EQUAL_ENERGY - from).dot(way) / way.length_squared();
    let wheel = Locus::of(Matching::Table1nm).wheel(EQUAL_ENERGY);
    wheel.and_then(|wheel| wheel.dominant(from + way * share)).map_or(0.0, |d| d.purity)
}

/// C: fewer frequencies, purer light.
pub fn purity_printed() -> Figure {
    let counts: Vec<u32> = (0..9).map(|k| 1 << k).collect();
    let over = |way: &dyn Fn(u32) -> f64| counts.iter().map(|n| (f64::from(*n), way(*n))).collect::<Vec<_>>();
    // n lines next to each other about 600 nm, 0.25 nm apart; n lines spread over the visible range.
    let together = |n: u32| {
        purity_of(&(0..n).map(|i| 600.0 + 0.25 * (f64::from(i) - f64::from(n - 1) / 2.0)).collect::<Vec<_>>())
    };
    let spread = |n: u32| {
        purity_of(&(0..n).map(|i| 400.0 + 300.0 * (f64::from(i) + 0.5) / f64::from(n)).collect::<Vec<_>>())
    };
    let pair = purity_of_pair(490.0, 600.0);
    Chart::new(
        Axis::log("number of lines of the spectrum").range(0.8, 700.0),
        Axis::linear("purity").range(-0.06, 1.06),
    )
    .title(&format!(
        "Two lines can make white (purity {}), 256 can be nearly pure: their number says nothing",
        short(pair)
    ))
    .subtitle("seen from the white of equal energy; C orders by number alone, drawn as 1/n")
    .curve(Method::as_printed("C: fewer is purer"), &over(&purity_as_printed))
    .curve(Method::new("next to each other, at 600 nm").styled(0), &over(&together))
    .curve(Method::new("spread from 400 to 700 nm").styled(1), &over(&spread))
    .dots(Method::new("490 and 600 nm").styled(2), &[(2.0, pair)])
    .into()
}

/// C: luminance is X + Y + Z.
pub fn luminance_printed() -> Figure {
    let waves: Vec<f64> = (390..=720).step_by(2).map(f64::from).collect();
    let over = |way: &dyn Fn(f64) -> f64| waves.iter().map(|w| (*w, way(*w))).collect::<Vec<_>>();
    let table = Matching::Table1nm;
    let ratio = luminance_as_printed(table.at(450.0)) / table.at(450.0).y;
    Chart::new(
        Axis::linear("wavelength, nm").range(390.0, 720.0).every(40.0),
        Axis::linear("of a line of unit power"),
    )
    .title(&format!("Luminance is Y alone: X + Y + Z counts a blue of 450 nm {ratio:.0} times"))
    .subtitle("the sum only makes x + y + z = 1; as a measure of brightness it follows Z")
    .function(Method::as_printed("C: X + Y + Z"), &over(&|w| luminance_as_printed(table.at(w))))
    .function(Method::new("Y").styled(0), &over(&|w| table.at(w).y))
    .into()
}

/// C: cones for 630, 530 and 450 nm.
pub fn cones_printed() -> Figure {
    let waves: Vec<f64> = (390..=720).step_by(2).map(f64::from).collect();
    let over = |k: usize| waves.iter().map(|w| (*w, cones(*w)[k])).collect::<Vec<_>>();
    let peak = |k: usize| {
        let best = (390..720).map(f64::from).max_by(|a, b| cones(*a)[k].total_cmp(&cones(*b)[k]));
        best.unwrap_or(f64::NAN)
    };
    let [red, green, blue] = CONE_PEAKS_AS_PRINTED;
    Chart::new(
        Axis::linear("wavelength, nm").range(390.0, 720.0).every(40.0),
        Axis::linear("sensitivity, of its peak").range(0.0, 1.05),
    )
    .title(&format!(
        "No cone is for red: they peak at {:.0}, {:.0} and {:.0} nm; 630, 530 and 450 nm are a screen's lamps",
        peak(0),
        peak(1),
        peak(2)
    ))
    .subtitle("cones after Smith & Pokorny, from the CIE 1931 table; dotted: where C puts them")
    .function(Method::new("long").styled(3), &over(0))
    .function(Method::new("middle").styled(1), &over(1))
    .function(Method::new("short").styled(0), &over(2))
    .guide(Guide::upright(red, "C: 630"))
    .guide(Guide::upright(green, "C: 530"))
    .guide(Guide::upright(blue, "C: 450"))
    .into()
}

/// Largest change of dominant wavelength that a way into the gamut makes of the lines from 420 to 660 nm; none of purples.
pub fn largest_change(way: IntoGamut, wheel: &Wheel) -> f64 {
    (420..=660).map(|w| changes(way, f64::from(w), wheel).0).filter(|c| !c.is_nan()).fold(0.0, f64::max)
}
