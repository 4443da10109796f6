//! Axes: from a quantity to pixels, and the ticks on the way.

use super::heading::power_of_ten;

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    Linear,
    Log,
}

/// How the ticks are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Writing {
    Numbers,
    /// Seconds, as ns, µs, ms, s.
    Seconds,
    Percent,
}

/// A quantity along an edge of the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Quantity and unit: "error of t, relative".
    pub title: String,
    pub scale: Scale,
    writing: Writing,
    range: Option<(f64, f64)>,
    step: Option<f64>,
}

impl Axis {
    pub fn log(title: &str) -> Self {
        Axis {
            title: title.to_string(),
            scale: Scale::Log,
            writing: Writing::Numbers,
            range: None,
            step: None,
        }
    }
    pub fn linear(title: &str) -> Self {
        Axis { scale: Scale::Linear, ..Axis::log(title) }
    }
    /// A logarithmic axis of seconds, written in ns, µs, ms and s.
    pub fn time(title: &str) -> Self {
        Axis { writing: Writing::Seconds, ..Axis::log(title) }
    }
    /// A linear axis of shares, written in per cent.
    pub fn percent(title: &str) -> Self {
        Axis { writing: Writing::Percent, ..Axis::linear(title) }
    }
    /// Shows this range, whatever the data.
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Ticks this far apart, on a linear axis: 15 for degrees.
    pub fn every(mut self, step: f64) -> Self {
        self.step = Some(step);
        self
    }

    /// The axis over the values, from pixel `start` to pixel `end`. Values that it cannot show are left out.
    pub fn ruler(&self, values: impl Iterator<Item = f64>, start: f64, end: f64) -> Ruler {
        let shown = |v: &f64| v.is_finite() && (self.scale == Scale::Linear || *v > 0.0);
        let given = self.range.filter(|(a, b)| a < b && shown(a) && shown(b));
        let (low, high) = given.unwrap_or_else(|| {
            let (low, high) = values
                .filter(shown)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
            match self.scale {
                _ if low > high => (0.1, 10.0),
                Scale::Log => roomy_log(low, high),
                Scale::Linear => roomy_linear(low, high),
            }
        });
        Ruler { scale: self.scale, writing: self.writing, step: self.step, low, high, start, end }
    }
}

/// The range with some air, and wide enough for two powers of ten.
fn roomy_log(low: f64, high: f64) -> (f64, f64) {
    let (a, b) = (low.log10(), high.log10());
    let air = 0.04 * (b - a).max(1.0);
    let (a, b) = (a - air, b + air);
    let powers = b.floor() - a.ceil() + 1.0;
    let (a, b) = match ((a + air).floor(), (b - air).ceil()) {
        _ if powers >= 2.0 => (a, b),
        (floor, ceil) if floor < ceil => (floor.min(a), ceil.max(b)),
        (floor, ceil) => (floor - 1.0, ceil + 1.0),
    };
    // The ends of the number range: 10^±308 stay finite and normal.
    (10f64.powf(a.clamp(-307.0, 307.0)), 10f64.powf(b.clamp(-306.0, 308.0)))
}

fn roomy_linear(low: f64, high: f64) -> (f64, f64) {
    if low == high {
        let half = if low == 0.0 { 1.0 } else { low.abs() * 0.5 };
        return (low - half, high + half);
    }
    // Halves first: the difference of two finite numbers may overflow.
    let air = (high * 0.5 - low * 0.5) * 0.1;
    let from_zero = low >= 0.0 && low < (high - low) * 0.25;
    (if from_zero { 0.0 } else { (low - air).max(f64::MIN) }, (high + air).min(f64::MAX))
}

/// An axis laid out: values to pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruler {
    pub scale: Scale,
    writing: Writing,
    step: Option<f64>,
    pub low: f64,
    pub high: f64,
    pub start: f64,
    pub end: f64,
}

impl Ruler {
    /// The pixel of a value; `None` if the axis cannot show it (not finite; zero or negative on a logarithm).
    pub fn at(&self, value: f64) -> Option<f64> {
        let share = match self.scale {
            Scale::Log if value > 0.0 => (value / self.low).log10() / (self.high / self.low).log10(),
            Scale::Log => return None,
            Scale::Linear => (value * 0.5 - self.low * 0.5) / (self.high * 0.5 - self.low * 0.5),
        };
        // Far outside is still a place, but not one that overflows the drawing.
        share.is_finite().then(|| self.start + share.clamp(-50.0, 50.0) * (self.end - self.start))
    }

    /// The value at a pixel.
    pub fn value(&self, pixel: f64) -> f64 {
        let share = (pixel - self.start) / (self.end - self.start);
        match self.scale {
            Scale::Log => self.low * (self.high / self.low).powf(share),
            Scale::Linear => self.low + (self.high - self.low) * share,
        }
    }

    /// The pixel of a value that lies inside the range.
    pub fn inside(&self, value: f64) -> Option<f64> {
        let (a, b) = (self.start.min(self.end) - 0.5, self.start.max(self.end) + 0.5);
        self.at(value).filter(|p| (a..=b).contains(p))
    }

    /// Labelled ticks: powers of ten on a logarithmic axis, round numbers on a linear one.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Log => self.powers(),
            Scale::Linear => self.rounds(),
        }
    }

    /// The powers of ten in range.
    pub fn decades(&self) -> std::ops::RangeInclusive<i32> {
        // A rounding of the logarithm must not lose a power that is an end of the range.
        let (a, b) = (self.low.log10(), self.high.log10());
        (a - 1.0e-9).ceil() as i32..=(b + 1.0e-9).floor() as i32
    }

    fn powers(&self) -> Vec<(f64, String)> {
        let decades = self.decades();
        // Numbers are wider than high: a vertical axis (it runs upwards) holds more of them.
        let apart = if self.end < self.start { 45.0 } else { 75.0 };
        let most = ((self.end - self.start).abs() / apart).clamp(2.0, 8.0) as i32;
        let count = decades.end() - decades.start() + 1;
        let step = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 50, 100, 200]
            .into_iter()
            .find(|s| (count + s - 1) / s <= most)
            .unwrap_or(400);
        let shown: Vec<i32> = decades.filter(|e| e.rem_euclid(step) == 0).collect();
        let plain = shown.iter().all(|e| (-3..=3).contains(e));
        shown.iter().map(|&e| (10f64.powi(e), self.write_power(e, plain))).collect()
    }

    fn write_power(&self, e: i32, plain: bool) -> String {
        if self.writing == Writing::Seconds && (-12..6).contains(&e) {
            let (unit, base) = match e {
                -12..-9 => ("ps", -12),
                -9..-6 => ("ns", -9),
                -6..-3 => ("µs", -6),
                -3..0 => ("ms", -3),
                _ => ("s", 0),
            };
            return format!("{}\u{202F}{unit}", 10i64.pow((e - base) as u32));
        }
        match e {
            0 => "1".to_string(),
            1 => "10".to_string(),
            e if plain && e > 0 => 10i64.pow(e as u32).to_string(),
            e if plain => format!("{:.*}", e.unsigned_abs() as usize, 10f64.powi(e)),
            e => power_of_ten(e),
        }
    }

    fn rounds(&self) -> Vec<(f64, String)> {
        let most = ((self.end - self.start).abs() / 80.0).clamp(2.0, 8.0);
        let raw = (self.high / most - self.low / most).max(f64::MIN_POSITIVE);
        let power = 10f64.powi(raw.log10().floor() as i32);
        let step = [1.0, 2.0, 2.5, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= raw * 0.999);
        let given = self.step.filter(|s| *s > 0.0 && (self.high - self.low) / s <= 20.0);
        let step = given.or(step).unwrap_or(10.0 * power);
        if !step.is_finite() || step <= 0.0 {
            return Vec::new();
        }
        let (first, last) = ((self.low / step - 1.0e-9).ceil(), (self.high / step + 1.0e-9).floor());
        // Far from zero the steps may be finer than the numbers there: then no tick is better than equal ones.
        if last - first > 20.0 || first.abs() > 1.0e12 {
            return Vec::new();
        }
        (0..=(last - first) as i64)
            .map(|i| (first + i as f64) * step)
            .map(|v| (v, self.write_round(v, step)))
            .collect()
    }

    fn write_round(&self, value: f64, step: f64) -> String {
        let (value, step) =
            if self.writing == Writing::Percent { (value * 100.0, step * 100.0) } else { (value, step) };
        let largest = self.low.abs().max(self.high.abs());
        let text = if self.writing == Writing::Numbers && !(1.0e-4..1.0e7).contains(&largest) {
            super::heading::short(value)
        } else {
            // Two and a half needs one decimal more than its power of ten.
            let exponent = step.log10().floor();
            let whole = (step / 10f64.powf(exponent)).fract().abs() < 0.01;
            let decimals = (-exponent + if whole { 0.0 } else { 1.0 }).max(0.0) as usize;
            let text = format!("{:.decimals$}", value.abs());
            let negative = value < 0.0 && text.chars().any(|c| c.is_ascii_digit() && c != '0');
            if negative { format!("−{text}") } else { text }
        };
        match self.writing {
            Writing::Percent => format!("{text}\u{202F}%"),
            Writing::Seconds => format!("{text}\u{202F}s"),
            Writing::Numbers => text,
        }
    }

    /// Unlabelled ticks at 2 … 9 times the powers of ten, where there is room for them.
    pub fn minor(&self) -> Vec<f64> {
        let decades = self.decades();
        let count = self.high.log10() - self.low.log10();
        if self.scale == Scale::Linear || (self.end - self.start).abs() / count < 110.0 {
            return Vec::new();
        }
        (decades.start() - 1..=*decades.end())
            .flat_map(|e| (2..=9).map(move |m| f64::from(m) * 10f64.powi(e)))
            .filter(|v| (self.low..=self.high).contains(v))
            .collect()
    }
}
