//! Lesson 14. What do three numbers keep of a colour, and what does each shortcut lose?
//!
//! Builds on:  03 (a first picture: radiance in three channels).
//! New here:   the matching functions; the chromaticity diagram, dominant wavelength and purity; gamuts; RGB, CMY, HSV,
//!             HLS, XYZ and the matrices between them; the curve of stored bytes.
//! Notation:   X, Y, Z tristimulus values; x, y chromaticity; λ wavelength [nm]; B white; ρ reflectance.
//! Predict:    a pixel is half magenta, half green, and its stored bytes are averaged. How much of the light is lost?
//! Figure:     14_colour_diagram.svg, 14_colour_matching_time.svg, 14_colour_near_white.svg, 14_colour_rgb_cube.svg

#[path = "14_colour/charts.rs"]
mod charts;
#[path = "14_colour/diagrams.rs"]
mod diagrams;
#[path = "14_colour/horseshoe.rs"]
mod horseshoe;
#[path = "14_colour/pictures.rs"]
mod pictures;
#[path = "14_colour/solids.rs"]
mod solids;

use charts::{STEPS, contest, largest_change, purity_of, purity_of_pair};
use lightbench::color::dominant::{Locus, Rim, Wheel};
use lightbench::color::gamut::IntoGamut;
use lightbench::color::models::{complement, degrees, hls_from_rgb, hsv_from_rgb};
use lightbench::color::spectrum::Matching;
use lightbench::color::xyz::{D65, xyy_from_xyz, xyz_from_rgb};
use lightbench::color::{luminance, srgb_decode};
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use pictures::ORANGE;
use solids::Model;

const PAIR: [f64; 2] = [490.0, 600.0]; // nm, two lines that make white
const NEIGHBOURS: u32 = 256; // lines, a quarter of a nm apart, at 600 nm

fn main() -> Result {
    let lesson = Lesson::without_essay(14)?;

    // 1. The truth: the standard's table at 1 nm, its diagram as seen from daylight, and areas in it.
    let locus = Locus::of(Matching::Table1nm);
    let wheel = locus.wheel(D65).ok_or_else(|| LessonError("daylight is no colour".into()))?;
    let gamuts = diagrams::gamuts();
    orange_by_numbers(&lesson, &wheel);

    // 2. The contestants: tables and fits of the matching functions at six steps.
    let spectra = lesson.pick([4, 64, 256, 512]);
    let steps = lesson.pick([&STEPS[..4], &STEPS, &STEPS, &STEPS]);
    let contest = contest(steps, spectra, lesson.seed());

    // 3. The figures: the diagram and its uses, the models as solids, pictures, and where methods fail.
    diagrams::save(&lesson, &wheel, &gamuts)?;
    shown(&lesson, &wheel)?;
    lesson.save("matching", charts::speed(&contest, spectra))?;
    failures(&lesson, &wheel)?;
    lesson.save("purity_printed", charts::purity_printed())?;
    lesson.save("luminance_printed", charts::luminance_printed())?;
    lesson.save("cones_printed", charts::cones_printed())?;

    // 4. What the figures show, checked.
    let ordered = gamuts.screen < gamuts.lines && gamuts.lines < gamuts.largest && gamuts.largest < 1.0;
    let [best, lines, screen] = [gamuts.largest, gamuts.lines, gamuts.screen].map(|share| 100.0 * share);
    lesson.claim(
        &format!("no triangle covers the diagram: three lines reach {best:.1} % of it at best, C's 630, 530 and 450 nm {lines:.1} %, a screen {screen:.1} %"),
        ordered,
    );
    let (pair, many) = (purity_of_pair(PAIR[0], PAIR[1]), neighbours());
    lesson.claim(
        &format!("lines at 490 and 600 nm make white (purity {}), {NEIGHBOURS} neighbouring lines a purity of {many:.3}: their number does not decide", short(pair)),
        pair < 1.0e-3 && many > 0.9,
    );
    let [kept, moved] = IntoGamut::ALL.map(|way| largest_change(way, &wheel));
    lesson.claim(
        &format!("mixed with white until a screen can show it a line keeps its dominant wavelength to {} nm; clipped it moves by up to {moved:.0} nm", short(kept)),
        kept < 1.0e-9 && moved > 1.0,
    );
    let error = |k: usize, i: usize| contest[k].1.points[i].error.map_or(f64::NAN, |e| e.mid);
    lesson.answer(&format!(
        "a luminance and a point of a diagram of which three lamps make at most {best:.0} %. A table at 10 nm finds that point to {}, the best fit to {}; \
         averaging bytes loses {:.0} % of the light; clipping turns hues by up to {moved:.0} nm.",
        short(error(0, 3)), short(error(2, 0)), 100.0 * (1.0 - 2.0 * srgb_decode(0.5))
    ))
}

/// The models as solids, lamps and inks, an orange, a mean of bytes, a spectrum on a screen.
fn shown(lesson: &Lesson, wheel: &Wheel) -> Result {
    // 552 pixels is the size at which two pictures stand side by side.
    let [solid, small, samples] = lesson.pick([[24, 16, 1], [552, 280, 4], [552, 400, 16], [1104, 560, 64]]);
    lesson.save("rgb_cube", solids::cube(solid, Model::Rgb))?;
    lesson.save("cmy_cube", solids::cube(solid, Model::Cmy))?;
    lesson.save("painters", solids::cones(solid))?;
    lesson.save("discs", pictures::discs(solid))?;
    lesson.save("orange", pictures::orange(small, samples as u32, lesson.seed()))?;
    lesson.save("averages", pictures::averages(lesson.pick([16, 90, 90, 90])))?;
    lesson.save("spectrum", pictures::spectrum(lesson.pick([60, 560, 560, 1120]), wheel))
}

/// Where methods fail: fits, steps, few bits, whites, slopes, the screen's gamut.
fn failures(lesson: &Lesson, wheel: &Wheel) -> Result {
    let cells = lesson.pick([(12, 9), (120, 90), (240, 180), (240, 180)]);
    lesson.save("fits", charts::fits())?;
    lesson.save("narrow", charts::narrow(lesson.pick([1, 24, 64, 128]), lesson.seed()))?;
    lesson.save("grey", charts::grey(lesson.pick([16, 400, 2000, 4000]), lesson.seed()))?;
    lesson.save("white", charts::white())?;
    lesson.save("edges", charts::edges(wheel))?;
    lesson.save("near_white", charts::near_white(wheel, cells))?;
    lesson.save("gamut", charts::gamut(wheel))
}

fn neighbours() -> f64 {
    let lines = (0..NEIGHBOURS).map(|i| 600.0 + 0.25 * (f64::from(i) - f64::from(NEIGHBOURS - 1) / 2.0));
    purity_of(&lines.collect::<Vec<_>>())
}

/// B's orange in every model of this lesson.
fn orange_by_numbers(lesson: &Lesson, wheel: &Wheel) {
    let (hsv, hls, xyz) = (hsv_from_rgb(ORANGE), hls_from_rgb(ORANGE), xyz_from_rgb(ORANGE));
    let seen = xyy_from_xyz(xyz).and_then(|c| Some((c.xy, wheel.dominant(c.xy)?)));
    let Some((xy, dominant)) = seen else { return };
    let named = match dominant.rim {
        Rim::Spectral(w) => format!("dominant wavelength {w:.1} nm"),
        Rim::Purple(w) => format!("complementary wavelength {w:.1} nm"),
    };
    lesson.say(&format!(
        "B's orange, reflectances 0.9, 0.6, 0.1 for red, green and blue, under daylight:\n  \
         HSV {:.1}° {:.3} {:.3}   HLS {:.1}° {:.3} {:.3}   CMY {}\n  \
         X, Y, Z {:.4} {:.4} {:.4}   x, y {:.4} {:.4}   {named}, purity {:.3}\n\
         Of white light it sends back {:.1} % as the eye counts.",
        degrees(hsv.hue),
        hsv.saturation,
        hsv.value,
        degrees(hls.hue),
        hls.lightness,
        hls.saturation,
        complement(ORANGE).to_array().map(|c| format!("{c:.1}")).join(" "),
        xyz.x,
        xyz.y,
        xyz.z,
        xy.x,
        xy.y,
        dominant.purity,
        100.0 * luminance(ORANGE)
    ));
}
