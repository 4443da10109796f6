//! The chromaticity diagrams of document C, and its family of colour models.

use super::horseshoe::{Horseshoe, Rim, colours};
use glam::{DVec2, dvec2};
use lightbench::color::dominant::{Locus, Rim as On, Wheel};
use lightbench::color::gamut::{area, largest_triangle};
use lightbench::color::spectrum::{CONE_PEAKS_AS_PRINTED, Matching};
use lightbench::color::xyz::{D65, Primaries};
use lightbench_kit::figure::Figure;
use lightbench_kit::figure::drawing::{Anchor, Drawing, Face, Fill, Pixels, Rect, Stroke, Text};
use lightbench_kit::figure::heading::Heading;
use lightbench_kit::figure::ink::{Hue, Ink};
use lightbench_kit::lesson::{Lesson, Result};

/// C's three lines, the screen, and the largest triangle of lines, with their shares of the diagram.
pub struct Gamuts {
    pub lines: f64,
    pub screen: f64,
    pub largest: f64,
    pub corners: [f64; 3],
}

pub fn gamuts() -> Gamuts {
    let locus = Locus::of(Matching::Table1nm);
    let whole = area(locus.points());
    let corners = largest_triangle(Locus::of(Matching::Table5nm));
    let share = |c: [f64; 3]| area(&c.map(|w| locus.at(w))) / whole;
    Gamuts {
        lines: share(CONE_PEAKS_AS_PRINTED),
        screen: area(&Primaries::REC_709.corners()) / whole,
        largest: share(corners),
        corners,
    }
}

pub fn save(lesson: &Lesson, wheel: &Wheel, gamuts: &Gamuts) -> Result {
    let fill = colours(lesson.pick([60, 480, 600, 900]));
    lesson.save("diagram", whole(&fill))?;
    lesson.save("dominant", dominant(&fill, wheel))?;
    lesson.save("mixtures", mixtures(&fill, wheel, gamuts))?;
    lesson.save("gamuts", triangles(&fill, gamuts))?;
    lesson.save("family", family())
}

fn sheet(title: &str, subtitle: &str, height: f64) -> (Drawing, f64) {
    let mut drawing = Drawing::new(1200.0, height);
    let heading = Heading { title: title.to_string(), subtitle: subtitle.to_string() };
    let top = heading.draw(&mut drawing);
    (drawing, top)
}

fn note(drawing: &mut Drawing, at: DVec2, words: &str, ink: Ink) {
    drawing.text(Text::new(at, words, 20.0, ink).halo(6.0));
}

/// C, figure 10.
fn whole(fill: &Pixels) -> Figure {
    let title = "All colours of light on one sheet: the spectrum bends round them, purples close the gap";
    let (mut d, top) =
        sheet(title, "CIE 1931 matching functions, 1 nm; B is daylight white, D65 (0.3127, 0.3290)", 1180.0);
    let s = Horseshoe::draw(&mut d, Rect::new(110.0, top + 10.0, 1130.0, 1120.0), fill, Rim::Ruled);
    s.point(&mut d, D65, "B", dvec2(12.0, 4.0));
    let purple = s.at(dvec2(0.47, 0.125)) + dvec2(14.0, 22.0);
    note(&mut d, purple, "line of purples: no line of the spectrum", Ink::Muted);
    note(&mut d, s.at(dvec2(0.40, 0.80)), "the curve: lines of the spectrum, in nm", Ink::Muted);
    note(&mut d, s.at(dvec2(0.40, 0.765)), "inside: their mixtures, on straight lines", Ink::Muted);
    Figure::new(d, title, "The horseshoe of the CIE 1931 diagram filled with its colours: green at the top, red at the right, blue at the lower left, white B in the middle; wavelengths from 460 to 700 nm stand along the curve, a dashed line closes it below.")
        .caption("The CIE 1931 chromaticity diagram (after C, figure 10). No screen shows the colours outside its own triangle: they are drawn mixed with white until it can.")
}

/// C, figures 11 to 13: the colour A, its purity, its dominant wavelength.
fn dominant(fill: &Pixels, wheel: &Wheel) -> Figure {
    let rim = Locus::of(Matching::Table1nm).at(505.0);
    let a = D65.lerp(rim, 0.4);
    let found = wheel.dominant(a).expect("a colour beside white");
    let On::Spectral(wavelength) = found.rim else { unreachable!("the colour points to a line") };
    let title = format!(
        "Colour A has dominant wavelength {wavelength:.0} nm and purity {:.0} %",
        found.purity * 100.0
    );
    let (mut d, top) =
        sheet(&title, "the ray from white B through A meets the spectrum in C; purity is |BA| / |BC|", 570.0);
    let words = ["the colour A", "purity: 40 of 100 parts of the way", "dominant wavelength: that of C"];
    for (i, words) in words.iter().enumerate() {
        let x = 70.0 + 378.0 * i as f64;
        let s = Horseshoe::draw(&mut d, Rect::new(x, top + 14.0, x + 330.0, 560.0), fill, Rim::Sparse);
        if i > 0 {
            s.line(&mut d, D65, if i == 1 { a } else { rim });
            s.dashed(&mut d, a, rim);
            s.point(&mut d, rim, "C", dvec2(-16.0, -14.0));
        }
        if i == 1 {
            part(&mut d, s.at(D65), s.at(a), "40");
            part(&mut d, s.at(a), s.at(rim), "60");
        }
        s.point(&mut d, D65, "B", dvec2(10.0, 10.0));
        s.point(&mut d, a, "A", dvec2(6.0, -20.0));
        let at = dvec2(s.place().center().x, s.place().max.y + 34.0);
        d.text(Text::new(at, *words, 20.0, Ink::Text).anchor(Anchor::Middle));
    }
    Figure::new(d, &title, "Three small chromaticity diagrams: a point A between white B and the green side of the curve; the way from B to A is 40 parts and on to the curve 60; the ray through A ends at C, whose wavelength is the dominant one.")
        .caption("A colour, its purity and its dominant wavelength (after C, figures 11, 12 and 13).")
}

/// A stretch of a line named above it.
fn part(drawing: &mut Drawing, a: DVec2, b: DVec2, words: &str) {
    let across = (b - a).perp().normalize_or(DVec2::Y) * 20.0;
    let at = (a + b) * 0.5 + across + dvec2(0.0, 6.0);
    drawing.text(Text::new(at, words, 18.0, Ink::Text).anchor(Anchor::Middle).halo(4.0));
}

/// C, figures 14 to 17: two colours, three, too few, and two that make white.
fn mixtures(fill: &Pixels, wheel: &Wheel, gamuts: &Gamuts) -> Figure {
    let locus = Locus::of(Matching::Table1nm);
    let title = "Mixtures lie on straight lines: two lamps make a line, three a triangle";
    let (mut d, top) = sheet(title, "each corner is a lamp; what they can make lies between them", 1230.0);
    let (e, f, g) = (dvec2(0.20, 0.16), dvec2(0.58, 0.34), dvec2(0.28, 0.60));
    let partner = wheel.complementary(490.0).unwrap_or(f64::NAN);
    let height = (1200.0 - top) / 2.0;
    for i in 0..4 {
        let (x, y) = (90.0 + 570.0 * (i % 2) as f64, top + 10.0 + height * (i / 2) as f64);
        let s = Horseshoe::draw(&mut d, Rect::new(x, y, x + 470.0, y + height - 66.0), fill, Rim::Sparse);
        let words = match i {
            0 => {
                s.line(&mut d, e, f);
                s.point(&mut d, f, "E", dvec2(14.0, -4.0));
                s.point(&mut d, e, "D", dvec2(-14.0, 4.0));
                "two lamps: the line between them".to_string()
            }
            1 => {
                s.gamut(&mut d, &[e, f, g], None);
                s.point(&mut d, f, "E", dvec2(14.0, -4.0));
                s.point(&mut d, e, "D", dvec2(-14.0, 4.0));
                s.point(&mut d, g, "F", dvec2(0.0, -24.0));
                "three lamps: the triangle".to_string()
            }
            2 => {
                s.gamut(&mut d, &gamuts.corners.map(|w| locus.at(w)), None);
                s.point(&mut d, dvec2(0.06, 0.48), "G", dvec2(0.0, -24.0));
                let missing = 100.0 * (1.0 - gamuts.largest);
                format!("the largest triangle of lines misses {missing:.0} %: G for one")
            }
            _ => {
                s.line(&mut d, locus.at(490.0), locus.at(partner));
                s.point(&mut d, locus.at(490.0), "C_{1}", dvec2(16.0, -20.0));
                s.point(&mut d, locus.at(partner), "C_{2}", dvec2(-18.0, -18.0));
                s.point(&mut d, D65, "B", dvec2(4.0, 22.0));
                format!("complementary: 490 and {partner:.1} nm make white")
            }
        };
        let at = dvec2(s.place().center().x, s.place().max.y + 36.0);
        d.text(Text::new(at, words, 20.0, Ink::Text).anchor(Anchor::Middle));
    }
    Figure::new(d, title, "Four small chromaticity diagrams: a line between two colours D and E; a triangle D, E, F; the largest triangle of spectral lines with a colour G outside it; a line from 490 nm through white to the orange side.")
        .caption("Mixing two colours, the gamut of three, why no triangle covers all, and complementary colours (after C, figures 14 to 17).")
}

/// C, figure 18, with the screen and the largest triangle.
fn triangles(fill: &Pixels, gamuts: &Gamuts) -> Figure {
    let locus = Locus::of(Matching::Table1nm);
    let title = format!(
        "No three lamps make every colour: the best three lines reach {:.0} % of the diagram, a screen {:.0} %",
        100.0 * gamuts.largest,
        100.0 * gamuts.screen
    );
    let (mut d, top) = sheet(
        &title,
        "shares of the area in x and y, which is no measure of how many colours an eye tells apart",
        1180.0,
    );
    let s = Horseshoe::draw(&mut d, Rect::new(110.0, top + 10.0, 1130.0, 1120.0), fill, Rim::Ruled);
    s.gamut(&mut d, &gamuts.corners.map(|w| locus.at(w)), Some(Hue::Grey));
    s.gamut(&mut d, &CONE_PEAKS_AS_PRINTED.map(|w| locus.at(w)), Some(Hue::Vermillion));
    s.gamut(&mut d, &Primaries::REC_709.corners(), Some(Hue::Blue));
    s.point(&mut d, D65, "B", dvec2(12.0, 4.0));
    let [a, b, c] = gamuts.corners;
    let keys = [
        (Hue::Grey, format!("largest triangle, {a:.0}, {b:.0}, {c:.0} nm: {:.1} %", 100.0 * gamuts.largest)),
        (Hue::Vermillion, format!("C's 630, 530, 450 nm: {:.1} %", 100.0 * gamuts.lines)),
        (Hue::Blue, format!("screen, Rec. 709: {:.1} %", 100.0 * gamuts.screen)),
    ];
    for (i, (hue, words)) in keys.iter().enumerate() {
        let at = s.at(dvec2(0.42, 0.82 - 0.036 * i as f64));
        d.line(at, at + dvec2(34.0, 0.0), Stroke::new(Ink::Line(*hue), 4.0));
        note(&mut d, at + dvec2(46.0, 7.0), words, Ink::Label(*hue));
    }
    Figure::new(d, &title, "The chromaticity diagram with three triangles: the largest of three lines, the one of 630, 530 and 450 nm, and the smaller one of a screen.")
        .caption("The gamut of 630, 530 and 450 nm (after C, figure 18), of a screen, and of the three lines that span the largest triangle; all leave the green and blue-green side uncovered.")
}

/// A box of the family tree.
struct Member(f64, f64, f64, &'static str, &'static str);

/// C, diagram 1.
fn family() -> Figure {
    let title = "Colour models by what they are for: devices mix, painters choose, the CIE measures";
    let (mut d, top) =
        sheet(title, "the models of the last row are linked by formulas in both directions", 700.0);
    let rows = [top + 10.0, top + 150.0, top + 290.0, top + 430.0];
    let members = [
        Member(600.0, rows[0], 260.0, "colour models", ""),
        Member(200.0, rows[1], 280.0, "the standard observer", "three imaginary colours"),
        Member(600.0, rows[1], 260.0, "mixtures of three", "for devices"),
        Member(1000.0, rows[1], 260.0, "the painter's palette", "for people who choose"),
        Member(490.0, rows[2], 190.0, "additive", "lamps: add to black"),
        Member(710.0, rows[2], 190.0, "subtractive", "inks: take from white"),
        Member(110.0, rows[3], 130.0, "XYZ", "amounts"),
        Member(280.0, rows[3], 150.0, "xyY", "diagram, Y"),
        Member(490.0, rows[3], 150.0, "RGB", "cube, screens"),
        Member(710.0, rows[3], 170.0, "CMY, CMYK", "cube, printers"),
        Member(910.0, rows[3], 150.0, "HSV", "cone"),
        Member(1090.0, rows[3], 150.0, "HLS", "double cone"),
    ];
    for (parent, child) in
        [(0, 1), (0, 2), (0, 3), (2, 4), (2, 5), (1, 6), (1, 7), (4, 8), (5, 9), (3, 10), (3, 11)]
    {
        let (p, c) = (&members[parent], &members[child]);
        let (from, to) = (dvec2(p.0, p.1 + 76.0), dvec2(c.0, c.1));
        let middle = (rows[3].min(to.y) + (to.y - 64.0)) * 0.5 + 10.0;
        let bend = [from, dvec2(from.x, middle), dvec2(to.x, middle), to];
        d.chain(&bend, Stroke::new(Ink::Muted, 1.8));
    }
    for Member(x, y, width, name, words) in members {
        let place = Rect::new(x - width / 2.0, y, x + width / 2.0, y + 76.0);
        d.rect(place, Some(Fill::new(Ink::Surface)), Some(Stroke::new(Ink::Outline, 1.6)));
        let rise = if words.is_empty() { 46.0 } else { 33.0 };
        d.text(Text::new(dvec2(x, y + rise), name, 22.0, Ink::Text).face(Face::Bold).anchor(Anchor::Middle));
        d.text(Text::new(dvec2(x, y + 60.0), words, 18.0, Ink::Muted).anchor(Anchor::Middle));
    }
    Figure::new(d, title, "A tree: colour models split into the standard observer with XYZ and xyY, mixtures of three colours with RGB and CMY, and the painter's palette with HSV and HLS.")
        .caption("A family tree of colour models (after C, diagram 1, whose drawing is lost; redrawn from its text).")
}
