//! Where labels go: pushed apart along a line, or set in the best of several places in the plane.

use super::drawing::Rect;
use glam::DVec2;

/// Centres as near as possible (least squares) to the wanted ones, `heights` apart and inside `[low, high]`.
///
/// Labels keep their order. If they do not fit, they start at `low` and run beyond `high`.
///
/// - Source: pool adjacent violators; Barlow et al., *Statistical Inference under Order Restrictions* (1972).
pub fn pushed_apart(wanted: &[f64], heights: &[f64], low: f64, high: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]).then(a.cmp(&b)));
    // Blocks of touching labels: (sum of wanted starts of the block, members, total height).
    struct Block {
        sum: f64,
        members: Vec<usize>,
        height: f64,
    }
    let clamp = |start: f64, height: f64| start.min(high - height).max(low);
    let start = |b: &Block| clamp(b.sum / b.members.len() as f64, b.height);
    let mut blocks: Vec<Block> = Vec::new();
    for i in order {
        let mut block = Block { sum: wanted[i] - heights[i] / 2.0, members: vec![i], height: heights[i] };
        while let Some(last) = blocks.pop_if(|last| start(last) + last.height > start(&block)) {
            // Each member of the later block would like its block to start this much earlier.
            let shifted = block.sum - block.members.len() as f64 * last.height;
            let members: Vec<usize> = last.members.iter().chain(&block.members).copied().collect();
            block = Block { sum: last.sum + shifted, members, height: last.height + block.height };
        }
        blocks.push(block);
    }
    let mut centers = vec![0.0; wanted.len()];
    for block in &blocks {
        let mut y = start(block);
        for &i in &block.members {
            centers[i] = y + heights[i] / 2.0;
            y += heights[i];
        }
    }
    centers
}

/// A place for a label, and how little it is liked even if it is free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    pub place: Rect,
    pub penalty: f64,
}

/// Knows what has been drawn, and finds room for labels.
#[derive(Clone, Debug)]
pub struct Placer {
    bounds: Rect,
    boxes: Vec<Rect>,
    lines: Vec<(DVec2, DVec2, f64)>,
}

/// Cost of a pixel of line under a label, and of a square pixel of another label.
const LINE_COST: f64 = 4.0;
const BOX_COST: f64 = 3.0;

impl Placer {
    pub fn new(bounds: Rect) -> Self {
        Placer { bounds, boxes: Vec::new(), lines: Vec::new() }
    }
    /// Nothing may cover this.
    pub fn keep_clear(&mut self, place: Rect) {
        self.boxes.push(place);
    }
    /// A line that labels should not cross.
    pub fn avoid(&mut self, points: &[DVec2], width: f64) {
        self.lines.extend(points.windows(2).map(|w| (w[0], w[1], width / 2.0)));
    }

    /// What a label would cover there: 0 if nothing.
    pub fn cost(&self, place: &Rect) -> f64 {
        let area = place.width() * place.height();
        let outside = if self.bounds.covers(place) { 0.0 } else { area - place.overlap(&self.bounds) + 1.0 };
        let boxes: f64 = self.boxes.iter().map(|b| b.overlap(place)).sum();
        let lines: f64 = self.lines.iter().map(|(a, b, half)| inside(*a, *b, &place.grown(*half))).sum();
        100.0 * outside + BOX_COST * boxes + LINE_COST * lines
    }

    /// The best of the candidates with what it covers; the place counts as taken from then on.
    pub fn place(&mut self, candidates: &[Candidate]) -> Option<(usize, f64)> {
        let best = self.best(candidates)?;
        self.boxes.push(candidates[best.0].place);
        Some(best)
    }

    /// The best of the candidates, without taking it.
    pub fn best(&self, candidates: &[Candidate]) -> Option<(usize, f64)> {
        let mut best: Option<(usize, f64, f64)> = None;
        for (i, candidate) in candidates.iter().enumerate() {
            let cost = self.cost(&candidate.place);
            let total = cost + candidate.penalty;
            if best.is_none_or(|(_, _, t)| total < t) {
                best = Some((i, cost, total));
            }
        }
        best.map(|(i, cost, _)| (i, cost))
    }
}

/// Length of the segment inside the rectangle (Liang & Barsky 1984); a segment without length counts 1 if inside.
pub fn inside(a: DVec2, b: DVec2, rect: &Rect) -> f64 {
    let d = b - a;
    let (mut t0, mut t1) = (0.0f64, 1.0f64);
    for axis in 0..2 {
        if d[axis] == 0.0 {
            if a[axis] < rect.min[axis] || a[axis] > rect.max[axis] {
                return 0.0;
            }
            continue;
        }
        let (p, q) = ((rect.min[axis] - a[axis]) / d[axis], (rect.max[axis] - a[axis]) / d[axis]);
        t0 = t0.max(p.min(q));
        t1 = t1.min(p.max(q));
    }
    if t0 > t1 { 0.0 } else { ((t1 - t0) * d.length()).max(1.0) }
}
