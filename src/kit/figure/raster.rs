//! Polygons to coverage: how much of each pixel lies inside.
//!
//! Sixteen scan lines cross each row of pixels; on each, the stretches of nonzero winding number cover pixels to
//! their exact fraction. That is all the antialiasing there is, and it is the same for lines, letters and areas.

use glam::DVec2;

const SCANS: usize = 16;

/// Coverage of a block of pixels, in [0,1].
pub struct Coverage {
    pub x0: usize,
    pub y0: usize,
    pub width: usize,
    pub values: Vec<f32>,
}

impl Coverage {
    /// The mask with a rim of `radius` pixels round everything in it, soft at its edge.
    pub fn widened(&self, radius: f64, width: usize, height: usize) -> Coverage {
        let reach = radius.ceil() as usize + 1;
        let rows = self.values.len().checked_div(self.width).unwrap_or(0);
        let (x0, y0) = (self.x0.saturating_sub(reach), self.y0.saturating_sub(reach));
        let (x1, y1) = ((self.x0 + self.width + reach).min(width), (self.y0 + rows + reach).min(height));
        let (w, h) = (x1.saturating_sub(x0), y1.saturating_sub(y0));
        let mut wide = Coverage { x0, y0, width: w, values: vec![0.0; w * h] };
        let mut kernel = Vec::new();
        for dy in -(reach as i64)..=reach as i64 {
            for dx in -(reach as i64)..=reach as i64 {
                let share = (radius + 0.5 - (dx as f64).hypot(dy as f64)).clamp(0.0, 1.0) as f32;
                kernel.extend((share > 0.0).then_some((dx, dy, share)));
            }
        }
        for (i, &value) in self.values.iter().enumerate().filter(|(_, v)| **v > 0.0) {
            let (x, y) = ((self.x0 + i % self.width) as i64, (self.y0 + i / self.width) as i64);
            for &(dx, dy, share) in &kernel {
                let (cx, cy) = (x + dx - x0 as i64, y + dy - y0 as i64);
                if (0..w as i64).contains(&cx) && (0..h as i64).contains(&cy) {
                    let cell = &mut wide.values[cy as usize * w + cx as usize];
                    *cell = cell.max(value.min(1.0) * share);
                }
            }
        }
        wide
    }
}

/// Coverage of the union (nonzero winding) of closed polygons on a canvas of `width × height` pixels.
pub fn coverage(polygons: &[Vec<DVec2>], width: usize, height: usize) -> Coverage {
    let finite = || polygons.iter().flatten().filter(|p| p.is_finite());
    let low = finite().fold(DVec2::INFINITY, |m, p| m.min(*p));
    let high = finite().fold(DVec2::NEG_INFINITY, |m, p| m.max(*p));
    let (x0, x1) = pixel_range(low.x, high.x, width);
    let (y0, y1) = pixel_range(low.y, high.y, height);
    let (w, h) = (x1.saturating_sub(x0), y1.saturating_sub(y0));
    let mut block = Coverage { x0, y0, width: w, values: vec![0.0; w * h] };
    if w == 0 || h == 0 {
        return block;
    }
    let mut crossings: Vec<Crossing> = Vec::new();
    for polygon in polygons.iter().filter(|p| p.iter().all(|q| q.is_finite())) {
        for (i, &a) in polygon.iter().enumerate() {
            cross(a, polygon[(i + 1) % polygon.len()], y0, h * SCANS, &mut crossings);
        }
    }
    for row in by_scan(crossings, h * SCANS).chunk_by_mut(|a, b| a.scan == b.scan) {
        // A total order: the sums of coverage, and with them the bytes, do not depend on the order of the edges.
        row.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.winding.cmp(&b.winding)));
        let start = row[0].scan as usize / SCANS * w;
        spans(row, x0, &mut block.values[start..start + w]);
    }
    block
}

fn pixel_range(low: f64, high: f64, size: usize) -> (usize, usize) {
    if low.is_nan() || high < low {
        return (0, 0);
    }
    // `as` saturates, so that a polygon far outside gives an empty range.
    ((low.floor().max(0.0) as usize).min(size), (high.ceil().max(0.0) as usize).min(size))
}

/// The crossings scan line by scan line, counted into place: a scan line has few, a polygon many.
fn by_scan(crossings: Vec<Crossing>, scans: usize) -> Vec<Crossing> {
    let mut next = vec![0usize; scans + 1];
    for c in &crossings {
        next[c.scan as usize + 1] += 1;
    }
    for k in 0..scans {
        next[k + 1] += next[k];
    }
    let mut sorted = crossings.clone();
    for c in crossings {
        let place = &mut next[c.scan as usize];
        sorted[*place] = c;
        *place += 1;
    }
    sorted
}

/// Where an edge crosses a scan line, and which way.
#[derive(Clone, Copy)]
struct Crossing {
    scan: u32,
    x: f64,
    winding: i32,
}

/// Notes where the edge from `a` to `b` crosses the scan lines of the block.
fn cross(a: DVec2, b: DVec2, y0: usize, scans: usize, crossings: &mut Vec<Crossing>) {
    let (top, bottom, winding) = if a.y < b.y { (a, b, 1) } else { (b, a, -1) };
    // Scan line k lies at y0 + (k + ½)/SCANS; it is crossed where top ≤ y < bottom.
    let index = |y: f64| ((y - y0 as f64) * SCANS as f64 - 0.5).ceil().max(0.0) as usize;
    let slope = (bottom.x - top.x) / (bottom.y - top.y);
    for k in index(top.y)..index(bottom.y).min(scans) {
        let y = y0 as f64 + (k as f64 + 0.5) / SCANS as f64;
        crossings.push(Crossing { scan: k as u32, x: top.x + (y - top.y) * slope, winding });
    }
}

/// Adds the covered stretches of one scan line to a row of pixels.
fn spans(crossings: &[Crossing], x0: usize, row: &mut [f32]) {
    let (mut winding, mut start) = (0, 0.0);
    for &Crossing { x, winding: step, .. } in crossings {
        if winding == 0 {
            start = x;
        }
        winding += step;
        if winding == 0 {
            span(start - x0 as f64, x - x0 as f64, row);
        }
    }
}

fn span(a: f64, b: f64, row: &mut [f32]) {
    let (a, b) = (a.max(0.0), b.min(row.len() as f64));
    if a >= b {
        return;
    }
    let (first, last) = (a as usize, (b as usize).min(row.len() - 1));
    const WEIGHT: f32 = 1.0 / SCANS as f32;
    if first == last {
        row[first] += (b - a) as f32 * WEIGHT;
        return;
    }
    row[first] += (first as f64 + 1.0 - a) as f32 * WEIGHT;
    for value in &mut row[first + 1..last] {
        *value += WEIGHT;
    }
    row[last] += (b - last as f64) as f32 * WEIGHT;
}
