//! The chromaticity diagram: the curve of the spectrum, and colours as seen from a white [C §1.7.5 D].
//!
//! The points of all lines of the spectrum make a horseshoe, closed by the straight line of purples. From a white
//! inside it, a ray through a colour meets the horseshoe once: on the curve at the colour's *dominant wavelength*, or on
//! the purple line, and then the ray the other way names the *complementary* one.
//!
//! ```text
//! purity = |xy − white| / |rim − white|
//! ```

use super::spectrum::Matching;
use super::xyz::xyy_from_xyz;
use glam::DVec2;
use std::sync::LazyLock;

/// The spectrum in the chromaticity diagram: a polyline from violet to red, clockwise.
#[derive(Clone, Debug)]
pub struct Locus {
    first: f64,
    step: f64,
    points: Vec<DVec2>,
}

impl Locus {
    /// The locus of some matching functions, over the range where they have one.
    pub fn of(matching: Matching) -> &'static Locus {
        static LOCI: [LazyLock<Locus>; 4] = [
            LazyLock::new(|| Locus::new(Matching::Table1nm)),
            LazyLock::new(|| Locus::new(Matching::Table5nm)),
            LazyLock::new(|| Locus::new(Matching::MultiLobe)),
            LazyLock::new(|| Locus::new(Matching::SingleLobe)),
        ];
        &LOCI[matching as usize]
    }

    fn new(matching: Matching) -> Locus {
        let ((first, last), step) = (matching.range(), matching.step());
        let count = ((last - first) / step) as usize;
        let xyz = (0..=count).map(|i| matching.at(first + i as f64 * step));
        Locus { first, step, points: xyz.filter_map(xyy_from_xyz).map(|c| c.xy).collect() }
    }

    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Wavelength of a point \[nm\].
    pub fn wavelength(&self, i: usize) -> f64 {
        self.first + i as f64 * self.step
    }

    /// Chromaticity of a line of the spectrum, linear between the points; the ends beyond them.
    pub fn at(&self, wavelength: f64) -> DVec2 {
        let last = self.points.len() - 1;
        let place = ((wavelength - self.first) / self.step).clamp(0.0, last as f64);
        let i = (place as usize).min(last - 1);
        self.points[i].lerp(self.points[i + 1], place - i as f64)
    }

    /// Violet and red end of the line of purples.
    pub fn purple_line(&self) -> [DVec2; 2] {
        [self.points[0], self.points[self.points.len() - 1]]
    }

    /// Is the chromaticity that of some light? Up to rounding at the rim.
    ///
    /// - NaN: no.
    /// - Source: crossing number; the red end curls within 1e-7 of one point, so half-planes would not do.
    pub fn contains(&self, xy: DVec2) -> bool {
        let before = self.points.iter().rev().take(1).chain(&self.points);
        let crossed = |(a, b): &(&DVec2, &DVec2)| {
            (a.y > xy.y) != (b.y > xy.y) && xy.x < a.x + (b.x - a.x) * ((xy.y - a.y) / (b.y - a.y))
        };
        before.zip(&self.points).filter(crossed).count() % 2 == 1
    }

    /// The diagram as seen from a white; `None` of a white outside.
    pub fn wheel(&self, white: DVec2) -> Option<Wheel<'_>> {
        let spokes = self.points.iter().map(|p| p - white).collect();
        let mut wheel = Wheel { locus: self, white, spokes, farthest: Vec::new() };
        let mut far = 0;
        for i in 0..wheel.spokes.len() {
            far = if wheel.precedes(far, wheel.spokes[i]) { i } else { far };
            wheel.farthest.push(far);
        }
        self.contains(white).then_some(wheel)
    }
}

/// Where on the rim of the diagram a colour points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rim {
    /// On the spectrum, at the dominant wavelength \[nm\].
    Spectral(f64),
    /// On the line of purples; the complementary wavelength \[nm\].
    Purple(f64),
}

/// A chromaticity as a hue and its strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dominant {
    pub rim: Rim,
    /// Share of the way from white to the rim, in `[0,1]` for real colours; imaginary ones lie beyond 1. The table's curve is
    /// not quite convex: mixtures of neighbouring lines reach 1.0003.
    pub purity: f64,
}

/// The rim of the diagram as spokes from a white, in the order of wavelengths.
#[derive(Clone, Debug)]
pub struct Wheel<'a> {
    locus: &'a Locus,
    white: DVec2,
    spokes: Vec<DVec2>,
    /// Which of the spokes up to each one has turned farthest; but for the curl at the red end, it is that one.
    farthest: Vec<usize>,
}

impl Wheel<'_> {
    pub fn white(&self) -> DVec2 {
        self.white
    }

    /// Dominant wavelength and purity of a chromaticity.
    ///
    /// ```text
    /// s = (a × d) / (a × d − b × d),    λ = λ_a + s Δλ,    a, b the spokes on either side of d = xy − white
    /// ```
    ///
    /// The spokes are searched by halving, with signs of cross products: no angle is computed, no slope divided, and
    /// the difference from a nearby white is exact.
    ///
    /// - Domain: finite; the white itself has no hue: `None`. From 699 nm on the table's points lie within 1e-7
    ///   of each other in no order: there the shortest of the wavelengths that fit is taken.
    /// - Accuracy: purity `γ₁₆` (and the rounding of `d`, `u·(|xy| + |w|)/|d|`); wavelength the same over the spokes'
    ///   angle: below 1e-10 nm between 400 and 690 nm.
    /// - NaN: `None`.
    /// - Source: CIE 015:2018 (dominant wavelength, excitation purity); [C §1.7.5 D].
    pub fn dominant(&self, xy: DVec2) -> Option<Dominant> {
        let (d, length) = self.direction(xy)?;
        let dominant = |rim, reach: f64| Dominant { rim, purity: length / reach };
        if let Some((wavelength, reach)) = self.spectral(d) {
            return Some(dominant(Rim::Spectral(wavelength), reach));
        }
        let [violet, red] = [self.spokes[0], self.spokes[self.spokes.len() - 1]];
        let reach = reach(red, violet, d)?;
        Some(dominant(Rim::Purple(self.spectral(-d)?.0), reach))
    }

    /// The direction from white, its larger coordinate ±1, and its length in that unit.
    fn direction(&self, xy: DVec2) -> Option<(DVec2, f64)> {
        // The difference of two huge numbers overflows, that of their halves does not.
        let part = if (xy - self.white).is_finite() { 1.0 } else { 0.5 };
        let d = xy * part - self.white * part;
        let scale = d.abs().max_element();
        let unit = d / scale;
        (scale > 0.0 && unit.is_finite()).then_some((unit, scale / part))
    }

    /// The wavelength where direction `d` meets the curve first, and how often `d` goes into the way there.
    fn spectral(&self, d: DVec2) -> Option<(f64, f64)> {
        // The first spoke at `d` or beyond; none where `d` points to the line of purples.
        let high = self.farthest.partition_point(|far| self.precedes(*far, d));
        if high == self.spokes.len() {
            return None;
        }
        let (low, high) = (high.saturating_sub(1), high.max(1));
        let (a, b) = (self.spokes[low], self.spokes[high]);
        let (from, to) = (a.perp_dot(d), b.perp_dot(d));
        // Both 0 where two points of the table lie in one direction.
        let share = if from == to { 0.0 } else { (from / (from - to)).clamp(0.0, 1.0) };
        let reach = a.lerp(b, share).dot(d) / d.length_squared();
        (reach > 0.0).then(|| (self.locus.wavelength(low) + share * self.locus.step, reach))
    }

    /// Does the spoke come before direction `d` on the way clockwise from the violet end?
    fn precedes(&self, i: usize, d: DVec2) -> bool {
        let (start, spoke) = (self.spokes[0], self.spokes[i]);
        let is_past_half = |v: DVec2| {
            let turn = start.perp_dot(v);
            turn > 0.0 || (turn == 0.0 && start.dot(v) < 0.0)
        };
        match (is_past_half(spoke), is_past_half(d)) {
            (false, true) => true,
            (true, false) => false,
            _ => spoke.perp_dot(d) < 0.0,
        }
    }

    /// The line of the spectrum that makes white together with this one \[nm\]; `None` if only a purple does.
    ///
    /// - Domain: wavelengths of the locus \[nm\].
    /// - Accuracy: as [`Wheel::dominant`]; twice gives the first wavelength back.
    /// - Source: [C §1.7.5 D].
    pub fn complementary(&self, wavelength: f64) -> Option<f64> {
        let (d, _) = self.direction(self.locus.at(wavelength))?;
        Some(self.spectral(-d)?.0)
    }
}

/// How often `d` goes into the way from the origin to the line through `a` and `b`.
fn reach(a: DVec2, b: DVec2, d: DVec2) -> Option<f64> {
    let edge = b - a;
    let reach = a.perp_dot(edge) / d.perp_dot(edge);
    (reach > 0.0 && reach.is_finite()).then_some(reach)
}

/// Purity by C's rule that fewer frequencies make a purer light, as a number with this order: `1 / lines`.
///
/// What counts is where the mixture lies: lines at 490 and 600 nm make a white of purity 0, twenty lines next to each
/// other a purity of nearly 1.
///
/// - Domain: at least one line.
/// - Source: [C §1.7.5 B], an erratum.
pub fn purity_as_printed(lines: u32) -> f64 {
    1.0 / f64::from(lines.max(1))
}
