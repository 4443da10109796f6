//! Lines with a width, as polygons to fill: one quadrilateral a segment, round joints, dashes.

use super::drawing::{Chain, Ends};
use glam::{DVec2, dvec2};
use std::f64::consts::TAU;

/// The polygons whose union is the line; all wind the same way, so that overlaps stay inside.
pub fn outline(chain: &Chain, width: f64, dash: &[f64]) -> Vec<Vec<DVec2>> {
    let mut points = chain.points.clone();
    if chain.ends == Ends::Closed {
        points.extend(chain.points.first());
    }
    points.dedup_by(|a, b| a.distance_squared(*b) < 1.0e-12);
    let period: f64 = dash.iter().sum();
    if dash.is_empty() || period <= 0.0 || !period.is_finite() {
        let mut polygons = solid(&points, width);
        for &end in [points.first(), points.last()].into_iter().flatten() {
            polygons.push(disk(end, width / 2.0));
        }
        return polygons;
    }
    dashes(&points, dash).iter().flat_map(|piece| solid(piece, width)).collect()
}

/// Segments with round joints and flat ends.
fn solid(points: &[DVec2], width: f64) -> Vec<Vec<DVec2>> {
    let half = width / 2.0;
    let mut polygons = Vec::with_capacity(points.len() * 2);
    for pair in points.windows(2) {
        let along = pair[1] - pair[0];
        let side = dvec2(-along.y, along.x).normalize_or_zero() * half;
        polygons.push(vec![pair[0] + side, pair[0] - side, pair[1] - side, pair[1] + side]);
    }
    for triple in points.windows(3) {
        let turn = (triple[1] - triple[0]).angle_to(triple[2] - triple[1]).abs();
        // Under 0.02 rad the gap at the joint is below 0.02 · half pixels.
        if turn > 0.02 {
            polygons.push(disk(triple[1], half));
        }
    }
    polygons.iter_mut().for_each(|p| wind(p));
    polygons
}

fn disk(center: DVec2, radius: f64) -> Vec<DVec2> {
    let n = (8.0 + 3.0 * radius) as usize;
    let mut polygon: Vec<DVec2> =
        (0..n).map(|i| center + radius * DVec2::from_angle(TAU * i as f64 / n as f64)).collect();
    wind(&mut polygon);
    polygon
}

/// A circle as a polygon fine enough that no corner shows.
pub fn circle(center: DVec2, radius: f64) -> Vec<DVec2> {
    let n = ((TAU * radius / 2.0) as usize).clamp(16, 512);
    (0..n).map(|i| center + radius * DVec2::from_angle(TAU * i as f64 / n as f64)).collect()
}

/// Turns a polygon so that its signed area is positive.
fn wind(polygon: &mut [DVec2]) {
    let area: f64 = (0..polygon.len()).map(|i| polygon[i].perp_dot(polygon[(i + 1) % polygon.len()])).sum();
    if area < 0.0 {
        polygon.reverse();
    }
}

/// Cuts a chain of points into its dashes.
fn dashes(points: &[DVec2], dash: &[f64]) -> Vec<Vec<DVec2>> {
    let mut pieces = Vec::new();
    let mut current: Vec<DVec2> = points.first().copied().into_iter().collect();
    let (mut index, mut left) = (0, dash[0]);
    for pair in points.windows(2) {
        let length = pair[0].distance(pair[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let p = pair[0].lerp(pair[1], done / length);
            if index % 2 == 0 {
                current.push(p);
                pieces.push(std::mem::take(&mut current));
            } else {
                current = vec![p];
            }
            index += 1;
            // A dash of no length would never end; a hundredth of a pixel moves on.
            left = dash[index % dash.len()].max(0.01);
        }
        left -= length - done;
        if index % 2 == 0 {
            current.push(pair[1]);
        }
    }
    pieces.extend((index % 2 == 0 && current.len() > 1).then_some(current));
    pieces
}
