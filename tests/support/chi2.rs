//! Does a sampler make the density it claims? The chi-square test.
//!
//! The surface is cut into cells; samples are counted in each; the claimed density, integrated over each cell,
//! says how many there should be. The sum of (observed − expected)²/expected then follows the
//! chi-square distribution if the two agree (Pearson 1900).

use super::domain::Domain;
use super::{seed, significance};
use glam::DVec2;
use lightbench::num::statistics::chi2_survival;
use lightbench::sample::Sampler;

/// Below this many expected, the counts of a cell are too far from normal, and it is pooled with others (Cochran 1954).
const MIN_EXPECTED: f64 = 5.0;
/// Samples of one law: a relative error `δ` of the density, spread over the surface, shifts chi² by `δ² SAMPLES`. Its own
/// spread is `√(2·512) = 32`, so that `δ = 4 %` fails by 10 deviations.
const SAMPLES: u32 = 200_000;
/// Rows and columns of the chart.
const CELLS: [u32; 2] = [16, 32];
/// Halvings of a cell, along either axis, before its integral is taken as it is: 40 reduce a pole like 1/√s by 2⁻²⁰.
const MAX_HALVINGS: u32 = 40;

/// Outcome of a chi-square test.
#[derive(Clone, Copy, Debug)]
pub struct Chi2 {
    pub statistic: f64,
    pub dof: u32,
    pub p_value: f64,
}

impl Chi2 {
    /// Is the difference one that a correct sampler shows once in two billion tests at most?
    pub fn passes(&self) -> bool {
        self.p_value >= significance()
    }
}

/// Tests counts against expectations whose total is that of the counts; cells that expect fewer than 5 are pooled.
pub fn chi2(observed: &[u64], expected: &[f64]) -> Chi2 {
    assert_eq!(observed.len(), expected.len());
    let mut cells: Vec<(f64, f64)> = expected.iter().zip(observed).map(|(&e, &o)| (e, o as f64)).collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pooled: Vec<(f64, f64)> = Vec::new();
    let mut pool = (0.0, 0.0);
    for (e, o) in cells {
        pool = (pool.0 + e, pool.1 + o);
        if pool.0 >= MIN_EXPECTED {
            pooled.push(std::mem::take(&mut pool));
        }
    }
    // Reached only if everything together expects too few.
    if pool.0 > 0.0 || pool.1 > 0.0 {
        pooled.push(pool);
    }
    let statistic = pooled.iter().map(|(e, o)| (o - e) * (o - e) / e).sum();
    let dof = pooled.len() as u32 - 1;
    let p_value = if dof == 0 { 1.0 } else { chi2_survival(statistic, f64::from(dof)) };
    Chi2 { statistic, dof, p_value }
}

/// Tests counts that should all be alike.
pub fn chi2_uniform(observed: &[u64]) -> Chi2 {
    let mean = observed.iter().sum::<u64>() as f64 / observed.len() as f64;
    chi2(observed, &vec![mean; observed.len()])
}

/// The law: `sample` makes points of `domain` with density `pdf`, and `pdf` integrates to 1.
///
/// `sample` may answer `None` (a lobe below the surface); then `pdf` must integrate to the probability of `Some`.
pub fn sample_matches_pdf<D: Domain>(
    name: &str,
    domain: &D,
    sample: impl Fn(&mut Sampler) -> Option<D::Point>,
    pdf: impl Fn(D::Point) -> f64,
) {
    if let Err(why) = check_sample(name, domain, sample, pdf) {
        panic!("{name}: {why}");
    }
}

/// What [`sample_matches_pdf`] asserts, as a value.
pub fn check_sample<D: Domain>(
    name: &str,
    domain: &D,
    sample: impl Fn(&mut Sampler) -> Option<D::Point>,
    pdf: impl Fn(D::Point) -> f64,
) -> Result<Chi2, String> {
    let mut observed = vec![0; (CELLS[0] * CELLS[1]) as usize];
    let mut lost = 0u64;
    for i in 0..SAMPLES {
        let Some(p) = sample(&mut Sampler::new(seed(name), 0, i)) else {
            lost += 1;
            continue;
        };
        let st = domain.chart(p).ok_or_else(|| format!("sample {i}, {p:?}, lies outside the surface"))?;
        if !(pdf(p) > 0.0) {
            return Err(format!("sample {i}, {p:?}, has density {}", pdf(p)));
        }
        observed[cell_of(st)] += 1;
    }
    let integrals: Vec<Integral> = (0..observed.len()).map(|i| cell_integral(domain, &pdf, i)).collect();
    let total: f64 = integrals.iter().map(|i| i.value).sum();
    // Rounding of a sum of 512 positive terms stays below a ten-thousandth of the quadrature's own tolerance.
    let accuracy: f64 = integrals.iter().map(|i| i.error).sum::<f64>() + CELL_TOLERANCE;
    if total > 1.0 + accuracy || (lost == 0 && total < 1.0 - accuracy) {
        return Err(format!("the density integrates to {total} ± {accuracy:.1e}, not 1"));
    }
    let n = f64::from(SAMPLES);
    let mut expected: Vec<f64> = integrals.iter().map(|i| i.value * n).collect();
    if lost as f64 > (accuracy * n).max(MIN_EXPECTED) && 1.0 - total <= accuracy {
        return Err(format!("{lost} samples lost, yet the density integrates to {total} ± {accuracy:.1e}"));
    }
    if lost > 0 {
        observed.push(lost);
        expected.push((1.0 - total).max(0.0) * n);
    }
    let result = chi2(&observed, &expected);
    if result.passes() { Ok(result) } else { Err(format!("samples do not follow the density: {result:?}")) }
}

fn cell_of(st: DVec2) -> usize {
    let place = |x: f64, n: u32| ((x * f64::from(n)) as u32).min(n - 1);
    (place(st.x, CELLS[0]) * CELLS[1] + place(st.y, CELLS[1])) as usize
}

/// An integral and a bound on its error.
#[derive(Clone, Copy)]
struct Integral {
    value: f64,
    error: f64,
}

/// Probability that the quadrature may lose in a part of a cell: a thousandth of the standard deviation of the count
/// when five are expected, `√5 / SAMPLES`. A jump in the density leaves some hundred such parts along it, each
/// off by its own rounding of the edge, so together about 1 % of the deviation.
const CELL_TOLERANCE: f64 = 1e-3 * 2.2 / SAMPLES as f64;

fn cell_integral<D: Domain>(domain: &D, pdf: &impl Fn(D::Point) -> f64, i: usize) -> Integral {
    let cell = DVec2::new((i as u32 / CELLS[1]).into(), (i as u32 % CELLS[1]).into());
    let size = DVec2::new(1.0 / f64::from(CELLS[0]), 1.0 / f64::from(CELLS[1]));
    let density = |st: DVec2| pdf(domain.point(st)) * domain.area();
    let min = cell * size;
    refine(&density, min, size, gauss(&density, min, size), MAX_HALVINGS)
}

/// Gauss–Legendre with 4 × 4 nodes, exact for polynomials of degree 7 in each coordinate.
fn gauss(f: &impl Fn(DVec2) -> f64, min: DVec2, size: DVec2) -> f64 {
    // Nodes ½(1 ± √(3/7 ∓ 2/7 √(6/5))) and weights (18 ± √30)/72 on [0,1] (Abramowitz & Stegun 25.4.30).
    let near = 0.5 * (3.0 / 7.0 - 2.0 / 7.0 * 1.2f64.sqrt()).sqrt();
    let far = 0.5 * (3.0 / 7.0 + 2.0 / 7.0 * 1.2f64.sqrt()).sqrt();
    let (heavy, light) = ((18.0 + 30f64.sqrt()) / 72.0, (18.0 - 30f64.sqrt()) / 72.0);
    let rule = [(0.5 - far, light), (0.5 - near, heavy), (0.5 + near, heavy), (0.5 + far, light)];
    let inner = |(x, wx): (f64, f64)| -> f64 {
        rule.iter().map(|(y, wy)| wx * wy * f(min + size * DVec2::new(x, *y))).sum()
    };
    rule.into_iter().map(inner).sum::<f64>() * size.x * size.y
}

/// Halves a cell, along the axis where that changes more, until the halves' sum agrees with the whole.
///
/// Next to a pole like `1/√s` a halving takes away only `1 − 1/√2` of the error, so that the change
/// understates it by 2.4; elsewhere it overstates.
fn refine(f: &impl Fn(DVec2) -> f64, min: DVec2, size: DVec2, whole: f64, halvings: u32) -> Integral {
    let split = |axis: DVec2| {
        let half = size * (DVec2::ONE - 0.5 * axis);
        let second = min + half * axis;
        let parts = [gauss(f, min, half), gauss(f, second, half)];
        (half, second, parts, (parts[0] + parts[1] - whole).abs())
    };
    let (along_x, along_y) = (split(DVec2::X), split(DVec2::Y));
    let (half, second, parts, change) = if along_x.3 > along_y.3 { along_x } else { along_y };
    if halvings == 0 || change <= CELL_TOLERANCE {
        return Integral { value: parts[0] + parts[1], error: 2.5 * change };
    }
    let low = refine(f, min, half, parts[0], halvings - 1);
    let high = refine(f, second, half, parts[1], halvings - 1);
    Integral { value: low.value + high.value, error: low.error + high.error }
}
