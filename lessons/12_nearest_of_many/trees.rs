//! Trees on paper: A's quadtree, and D's octree flattened into a list.

use glam::{DVec2, DVec3, dvec2};
use lightbench::accel::{Octree, Splitting};
use lightbench::bounds::Aabb;
use lightbench_kit::figure::{Diagram, Figure, Light};

/// Balls of a flat scene: centre and radius, in a square of side 8.
const BALLS: [(f64, f64, f64); 7] = [
    (1.2, 6.6, 0.7),
    (2.7, 4.9, 0.45),
    (5.2, 6.2, 0.5),
    (6.55, 7.45, 0.3),
    (7.45, 6.6, 0.35),
    (6.3, 2.0, 1.1),
    (1.9, 1.7, 0.8),
];
const NAMES: [&str; 7] = ["a", "b", "c", "d", "e", "f", "g"];
const SIDE: f64 = 8.0;

/// A square of the quadtree.
struct Square {
    low: DVec2,
    side: f64,
    held: Vec<usize>,
    parts: Vec<Square>,
    /// Where it stands in the drawing of the tree.
    x: f64,
}

impl Square {
    /// Splits while more than one thing reaches in.
    fn new(low: DVec2, side: f64, depth: usize) -> Square {
        let reaches = |&(x, y, r): &(f64, f64, f64)| {
            let c = dvec2(x, y);
            c.distance(c.clamp(low, low + side)) <= r
        };
        let held: Vec<usize> = (0..BALLS.len()).filter(|&i| reaches(&BALLS[i])).collect();
        let half = side / 2.0;
        let corners = [(0.0, half), (half, half), (0.0, 0.0), (half, 0.0)];
        let is_split = held.len() > 1 && depth > 0;
        let part = |(x, y): (f64, f64)| Square::new(low + dvec2(x, y), half, depth - 1);
        let parts = if is_split { corners.into_iter().map(part).collect() } else { Vec::new() };
        Square { low, side, held, parts, x: 0.0 }
    }

    /// Places leaves one beside the other and parents above their middle.
    fn spread(&mut self, next: &mut f64) {
        if self.parts.is_empty() {
            self.x = *next;
            *next += 1.0;
            return;
        }
        self.parts.iter_mut().for_each(|p| p.spread(next));
        self.x = (self.parts[0].x + self.parts[self.parts.len() - 1].x) / 2.0;
    }
}

fn node(d: Diagram, at: DVec2, size: f64, light: Option<Light>) -> Diagram {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| at + dvec2(x, y) * size);
    let d = d.polygon(&corners);
    match light {
        Some(light) => d.region(light, &corners),
        None => d,
    }
}

/// A, illustration 71: a flat scene, its squares, and the tree of them.
pub fn quadtree() -> Figure {
    let mut root = Square::new(DVec2::ZERO, SIDE, 3);
    let mut leaves = 0.0;
    root.spread(&mut leaves);
    let wide = 15.0 / (leaves - 1.0);
    let place = |s: &Square, level: f64| dvec2(9.6 + s.x * wide, 7.6 - 2.3 * level);
    let mut d = Diagram::fitted();
    let mut squares = Vec::new();
    let mut waiting = vec![(&root, 0.0)];
    while let Some((square, level)) = waiting.pop() {
        squares.push((square, level));
        waiting.extend(square.parts.iter().map(|p| (p, level + 1.0)));
    }
    for (i, (x, y, r)) in BALLS.into_iter().enumerate() {
        d = d.circle(dvec2(x, y), r).name(NAMES[i]);
    }
    for (square, level) in &squares {
        let (a, b) = (square.low, square.low + square.side);
        d = d.thin(&[a, dvec2(b.x, a.y), b, dvec2(a.x, b.y), a]);
        for part in &square.parts {
            d = d.thin(&[place(square, *level), place(part, level + 1.0)]);
        }
    }
    for (square, level) in &squares {
        let at = place(square, *level);
        let is_leaf = square.parts.is_empty();
        let light = match (is_leaf, square.held.is_empty()) {
            (false, _) => Some(Light::Incident),
            (true, false) => Some(Light::Reflected),
            (true, true) => None,
        };
        d = node(d, at, 0.17, light);
        if is_leaf && !square.held.is_empty() {
            let names: Vec<&str> = square.held.iter().map(|&i| NAMES[i]).collect();
            d = d.note(at - dvec2(0.0, 0.55), &names.join(" "));
        }
    }
    Figure::from(
        d.title("Squares are quartered until each holds one thing at most, or is small enough")
            .subtitle("children in the order upper left, upper right, lower left, lower right; blue: split, orange: holds things, white: empty; after A, ill. 71"),
    )
    .caption("A scene in two dimensions with its quadtree (after A, illustration 71). Things that reach into several squares stand in several leaves.")
}

/// D, figures 22 and 23: an octree, the order of its cubes, and the list that they become.
pub fn flattened() -> Figure {
    let ball = |&(x, y, r): &(f64, f64, f64)| {
        let c = DVec3::new(x, y, (x * 3.0 + y).rem_euclid(SIDE));
        Aabb::new(c - r * 0.6, c + r * 0.6)
    };
    let boxes: Vec<Aabb> = BALLS.iter().map(ball).collect();
    let octree = Octree::build(&boxes, Splitting { threshold: 1, depth: 2 });
    let cubes = octree.cubes();
    let last = cubes.len() as f64 - 1.0;
    // In the list children stand side by side, level by level; in the tree each stands under its parent.
    let mut x = vec![0.0; cubes.len()];
    let mut next = 0.0f64;
    let mut order = vec![0usize];
    let mut walk = Vec::new();
    while let Some(at) = order.pop() {
        walk.push(at);
        let cube = &cubes[at];
        if cube.is_leaf {
            x[at] = next;
            next += 1.0;
        } else {
            order.extend((cube.first..cube.first + cube.count).rev().map(|c| c as usize));
        }
    }
    for at in walk.iter().rev().copied().filter(|&at| !cubes[at].is_leaf) {
        let (first, count) = (cubes[at].first as usize, cubes[at].count as usize);
        x[at] = (x[first] + x[first + count - 1]) / 2.0;
    }
    let wide = 16.0 / (next - 1.0).max(1.0);
    let tree = |at: usize| dvec2(x[at] * wide, 5.4 - 1.6 * f64::from(cubes[at].level));
    let step = 16.0 / last.max(1.0);
    let half = (step * 0.48).min(0.4);
    let list = |at: usize| dvec2(at as f64 * step, 0.4);
    let light = |at: usize| if cubes[at].is_leaf { Light::Reflected } else { Light::Incident };
    let mut d = Diagram::fitted();
    for (at, cube) in cubes.iter().enumerate().filter(|(_, c)| !c.is_leaf) {
        for child in cube.first..cube.first + cube.count {
            d = d.thin(&[tree(at), tree(child as usize)]);
        }
    }
    for at in 0..cubes.len() {
        d = node(d, tree(at), 0.36, Some(light(at)));
        d = d.note(tree(at), &at.to_string());
        d = node(d, list(at), half, Some(light(at)));
        d = d.note(list(at), &at.to_string());
    }
    for (k, (at, cube)) in cubes.iter().enumerate().filter(|(_, c)| !c.is_leaf).enumerate() {
        let (from, low) = (list(at), 0.4 - half);
        let drop = low - 0.5 - 0.42 * k as f64;
        let (first, end) = (
            list(cube.first as usize).x - half * 0.9,
            list((cube.first + cube.count - 1) as usize).x + half * 0.9,
        );
        d = d.thin(&[dvec2(from.x, low), dvec2(from.x, drop), dvec2((first + end) * 0.5, drop)]);
        d = d.ray(
            Light::Transmitted,
            dvec2((first + end) * 0.5, drop),
            dvec2((first + end) * 0.5, low - 0.06),
        );
        d = d.path(Light::Transmitted, &[dvec2(first, low - 0.06), dvec2(end, low - 0.06)]);
    }
    Figure::from(
        d.title("A tree becomes a list: each cube says where its children begin, and how many there are")
            .subtitle("above the tree with the cubes' numbers, below the list; green: a parent's children; blue: split, orange: leaf; after D, figs. 22 and 23"),
    )
    .caption("An octree flattened into an array (after D, figures 22 and 23); empty cubes are left out. The tree is that of seven boxes, one to a cube, two levels deep.")
}
