//! From spectra to three numbers: the matching functions, as a table and as fits.
//!
//! ```text
//! (X, Y, Z) = ∫ L(λ) (x̄, ȳ, z̄)(λ) dλ / ∫ ȳ(λ) dλ
//! ```
//!
//! so that a spectrum of 1 at every wavelength has `Y = 1`.

use super::xyz::Xyz;
use glam::{DMat3, DVec3, dvec3};
use std::sync::LazyLock;

/// First and last wavelength of the table \[nm\].
pub const VISIBLE: (f64, f64) = (360.0, 830.0);

/// A way to evaluate the CIE 1931 matching functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Matching {
    /// The standard's table at 1 nm, linear between its rows.
    #[default]
    Table1nm,
    /// Every fifth row, from 380 to 780 nm, linear between.
    Table5nm,
    /// Sums of Gaussians with different widths on either side.
    MultiLobe,
    /// A Gaussian each, two for x̄.
    SingleLobe,
}

struct Table {
    first: f64,
    step: f64,
    rows: Vec<Xyz>,
}

static TABLE_1NM: LazyLock<Table> = LazyLock::new(|| {
    let rows = include_str!("cie1931.csv").lines().filter_map(|line| {
        let mut cells = line.split(',').map(|c| c.parse::<f64>());
        let (Some(Ok(_)), Some(Ok(x)), Some(Ok(y)), Some(Ok(z))) =
            (cells.next(), cells.next(), cells.next(), cells.next())
        else {
            return None; // the comment and the header
        };
        Some(dvec3(x, y, z))
    });
    Table { first: VISIBLE.0, step: 1.0, rows: rows.collect() }
});

static TABLE_5NM: LazyLock<Table> = LazyLock::new(|| {
    let rows = TABLE_1NM.rows.iter().skip(20).step_by(5).take(81).copied().collect();
    Table { first: 380.0, step: 5.0, rows }
});

impl Table {
    #[inline]
    fn at(&self, wavelength: f64) -> Xyz {
        let place = (wavelength - self.first) / self.step;
        if place.is_nan() {
            return Xyz::NAN;
        }
        let last = self.rows.len() - 1;
        if place < 0.0 || place > last as f64 {
            return Xyz::ZERO;
        }
        let i = (place as usize).min(last - 1);
        self.rows[i].lerp(self.rows[i + 1], place - i as f64)
    }
}

impl Matching {
    pub const ALL: [Matching; 4] =
        [Matching::Table1nm, Matching::Table5nm, Matching::MultiLobe, Matching::SingleLobe];

    pub fn name(self) -> &'static str {
        match self {
            Matching::Table1nm => "table, 1 nm",
            Matching::Table5nm => "table, 5 nm",
            Matching::MultiLobe => "multi-lobe fit",
            Matching::SingleLobe => "single-lobe fit",
        }
    }

    /// First and last wavelength \[nm\] of the chromaticity diagram: the usual 380 to 780 nm, beyond which the table's
    /// points curl within 2e-3 of its ends. The fits follow the functions where those are large; where they fade, the
    /// quotients of two small numbers run away.
    pub fn range(self) -> (f64, f64) {
        match self {
            Matching::Table1nm | Matching::Table5nm => (380.0, 780.0),
            Matching::MultiLobe | Matching::SingleLobe => (400.0, 640.0),
        }
    }

    /// Distance of the points of a locus \[nm\].
    pub fn step(self) -> f64 {
        if self == Matching::Table5nm { 5.0 } else { 1.0 }
    }

    /// `(x̄, ȳ, z̄)` at a wavelength \[nm\].
    ///
    /// - Domain: all numbers; 0 outside the table's range.
    /// - Accuracy: the tables are the standard's numbers, of 7 to 12 digits; against them, where they are largest, the
    ///   multi-lobe fit errs by some hundredths, the single lobes by a tenth.
    /// - NaN in, NaN out.
    /// - Source: CIE 018:2019; Wyman, Sloan & Shirley, *Simple analytic approximations to the CIE XYZ color matching
    ///   functions*, JCGT 2(2) (2013).
    #[inline]
    pub fn at(self, wavelength: f64) -> Xyz {
        match self {
            Matching::Table1nm => TABLE_1NM.at(wavelength),
            Matching::Table5nm => TABLE_5NM.at(wavelength),
            Matching::MultiLobe => multi_lobe(wavelength),
            Matching::SingleLobe => single_lobe(wavelength),
        }
    }

    /// Tristimulus values of a spectrum, by the midpoint rule with cells of `step` nm: the samples lie at whole
    /// multiples of the step within the table's range.
    ///
    /// - Domain: `step > 0`; a spectrum of 1 has `Y = 1`. A line narrower than the step may fall between two
    ///   samples.
    /// - Accuracy: of the sampling, see lesson 14; rounding is `γ_n` of `n` samples.
    /// - NaN of the spectrum goes through.
    pub fn xyz(self, spectrum: impl Fn(f64) -> f64, step: f64) -> Xyz {
        debug_assert!(step > 0.0, "a step of {step} nm");
        let (first, last) = ((VISIBLE.0 / step).ceil() as i64, (VISIBLE.1 / step).floor() as i64);
        let (mut sum, mut white) = (Xyz::ZERO, 0.0);
        for i in first..=last {
            let wavelength = i as f64 * step;
            let matching = self.at(wavelength);
            sum += matching * spectrum(wavelength);
            white += matching.y;
        }
        sum / white
    }
}

/// A Gaussian with one width on each side, as its inverse standard deviations.
#[inline]
fn lobe(wavelength: f64, mean: f64, left: f64, right: f64) -> f64 {
    let t = (wavelength - mean) * if wavelength < mean { left } else { right };
    (-0.5 * t * t).exp()
}

fn multi_lobe(w: f64) -> Xyz {
    dvec3(
        0.362 * lobe(w, 442.0, 0.0624, 0.0374) + 1.056 * lobe(w, 599.8, 0.0264, 0.0323)
            - 0.065 * lobe(w, 501.1, 0.0490, 0.0382),
        0.821 * lobe(w, 568.8, 0.0213, 0.0247) + 0.286 * lobe(w, 530.9, 0.0613, 0.0322),
        1.217 * lobe(w, 437.0, 0.0845, 0.0278) + 0.681 * lobe(w, 459.0, 0.0385, 0.0725),
    )
}

fn single_lobe(w: f64) -> Xyz {
    let gauss = |t: f64| (-0.5 * t * t).exp();
    let log = w.ln();
    dvec3(
        1.065 * gauss((w - 595.8) / 33.33) + 0.366 * gauss((w - 446.8) / 19.44),
        1.014 * gauss((log - 556.3f64.ln()) / 0.075),
        1.839 * gauss((log - 449.8f64.ln()) / 0.051),
    )
}

/// Spectral radiance of a black body, as a multiple of its radiance at 560 nm.
///
/// ```text
/// (560/λ)⁵ (exp(c₂/(560 nm T)) − 1) / (exp(c₂/(λ T)) − 1),    c₂ = 1.438776877e7 nm K
/// ```
///
/// - Domain: wavelength \[nm\] and temperature \[K\] above 0.
/// - Source: Planck's law; c₂ = hc/k of the SI (2019).
pub fn black_body(wavelength: f64, temperature: f64) -> f64 {
    const C2: f64 = 1.438776877e7;
    let bose = |w: f64| (C2 / (w * temperature)).exp_m1();
    (560.0 / wavelength).powi(5) * bose(560.0) / bose(wavelength)
}

/// Wavelengths \[nm\] at which C says that the three kinds of cones are sensitive, red, green and blue.
///
/// They are lamps of a display: the cones peak near 566, 543 and 440 nm (DeMarco, Pokorny & Smith, JOSA A 9, 1992), and what
/// they tell apart are the overlaps.
///
/// - Source: [C §1.7.5 E], an erratum.
pub const CONE_PEAKS_AS_PRINTED: [f64; 3] = [630.0, 530.0, 450.0];

/// Sensitivities of the long-, middle- and short-wave cones at a wavelength \[nm\], each 1 at its peak.
///
/// ```text
/// L = 0.15514 X + 0.54312 Y − 0.03286 Z,   M = −0.15514 X + 0.45684 Y + 0.03286 Z,   S = Z
/// ```
///
/// - Domain: all numbers; 0 outside the table.
/// - Accuracy: the matrix is made for Judd's and Vos' revision of the table, which differs below 460 nm: there the
///   short-wave cone peaks at 440 nm, here at 446.
/// - NaN in, NaN out.
/// - Source: Smith & Pokorny, Vision Research 15 (1975); Vos, Color Research & Application 3 (1978).
pub fn cones(wavelength: f64) -> DVec3 {
    static PEAKS: LazyLock<DVec3> =
        LazyLock::new(|| TABLE_1NM.rows.iter().map(|xyz| cones_from_xyz(*xyz)).fold(DVec3::ZERO, DVec3::max));
    cones_from_xyz(Matching::Table1nm.at(wavelength)) / *PEAKS
}

fn cones_from_xyz(xyz: Xyz) -> DVec3 {
    const ROWS: [[f64; 3]; 3] = [[0.15514, 0.54312, -0.03286], [-0.15514, 0.45684, 0.03286], [0.0, 0.0, 1.0]];
    // The difference of two small numbers in the tails may come out below 0 by the matrix' own rounding.
    (DMat3::from_cols_array_2d(&ROWS).transpose() * xyz).max(DVec3::ZERO)
}
