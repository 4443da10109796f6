//! Trees with pictures, root diagrams, lists: what the documents draw.

use super::contestants::leaves;
use super::solids::{COLOURS, EYE, ball, camera, cube, document, portrait, ray_through, rod, solid};
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::csg::as_printed::{Mark, as_printed};
use lightbench::csg::{Csg, Operation, Side, Tree};
use lightbench::ray::{Ray, Span};
use lightbench::shape::Solid;
use lightbench::shape::cuboid::Cuboid;
use lightbench_kit::figure::drawing::{Anchor, Drawing, Face, Fill, Rect, Stroke, Text};
use lightbench_kit::figure::ink::{Hue, Ink};
use lightbench_kit::figure::{Bar, Figure, Panels, Roots, Table};

/// Box, sphere, and cylinders along x, y and z.
const NAMES: [&str; 5] = ["box", "sphere", "rod x", "rod y", "rod z"];
const HUES: [Hue; 5] = [Hue::Vermillion, Hue::Blue, Hue::Green, Hue::Orange, Hue::Purple];

/// [A ill. 61], from the function that the walk uses.
pub fn table() -> Table {
    let mut table = Table::new(&["operation", "operand 1", "operand 2", "composition", "who decides"])
        .title("Inside or outside: who decides")
        .subtitle(
            "After Sancho, illustration 61. Where one operand decides alone, a ray can skip the other.",
        );
    let sides = [Side::In, Side::Out];
    for operation in Operation::ALL {
        for (left, right) in sides.into_iter().flat_map(|l| sides.map(|r| (l, r))) {
            let both = operation.combine(left, right);
            let free = |f: &dyn Fn(Side) -> Side| sides.into_iter().all(|s| f(s) == both);
            let first = free(&|s| operation.combine(left, s));
            let second = free(&|s| operation.combine(s, right));
            let who = match (first, second) {
                (true, true) => "either",
                (true, false) => "operand 1 alone",
                (false, true) => "operand 2 alone",
                _ => "both together",
            };
            let name = if (left, right) == (Side::In, Side::In) { operation.name() } else { "" };
            table = table.row(&[name, left.word(), right.word(), both.word(), who]);
        }
    }
    table
}

/// A node of the drawn tree: its solid, its sign or name, its colours, its place, and the places of its operands.
struct Drawn {
    tree: Tree,
    label: &'static str,
    colours: Vec<DVec3>,
    at: DVec2,
    below: &'static [usize],
}

/// [A ill. 17, D fig. 17].
pub fn tree(size: usize, samples: u32) -> Figure {
    let colour = |leaves: &[usize]| leaves.iter().map(|&i| COLOURS[i]).collect();
    let drawn =
        |tree, label, leaves: &[usize], at, below| Drawn { tree, label, colours: colour(leaves), at, below };
    let (x, y, z) = (|| rod(DVec3::X), || rod(DVec3::Y), || rod(DVec3::Z));
    let ball = || ball(DVec3::ZERO, 2.0);
    let nodes = [
        drawn(document(), "−", &[0, 1, 2, 3, 4], dvec2(560.0, 0.0), &[1, 2]),
        drawn(cube().intersection(ball()), "∩", &[0, 1], dvec2(300.0, 1.0), &[3, 4]),
        drawn(x().union(y()).union(z()), "∪", &[2, 3, 4], dvec2(820.0, 1.0), &[5, 6]),
        drawn(cube(), "box", &[0], dvec2(170.0, 2.0), &[]),
        drawn(ball(), "sphere", &[1], dvec2(430.0, 2.0), &[]),
        drawn(x().union(y()), "∪", &[2, 3], dvec2(690.0, 2.0), &[7, 8]),
        drawn(z(), "cylinder", &[4], dvec2(950.0, 2.0), &[]),
        drawn(x(), "cylinder", &[2], dvec2(580.0, 3.0), &[]),
        drawn(y(), "cylinder", &[3], dvec2(800.0, 3.0), &[]),
    ];
    let (side, top, step) = (168.0, 96.0, 206.0);
    let place = |node: &Drawn| {
        let corner = dvec2(node.at.x - 0.5 * side, top + step * node.at.y);
        Rect { min: corner, max: corner + side }
    };
    let mut drawing = Drawing::new(1200.0, top + step * 4.0 + 16.0);
    let title = "Four operations and five solids make one";
    drawing.text(Text::new(dvec2(40.0, 52.0), title, 28.0, Ink::Text).face(Face::Bold));
    let words = "A tree and its solid; each leaf keeps its colour, also where it was taken away.";
    drawing.text(Text::new(dvec2(40.0, 82.0), words, 20.0, Ink::Muted));
    for node in &nodes {
        for &child in node.below {
            let (a, b) = (place(node), place(&nodes[child]));
            let towards = if b.center().x < a.center().x { a.min.x } else { a.max.x };
            let from = dvec2(towards, a.center().y);
            let to = dvec2(b.center().x, b.min.y);
            drawing.chain(&[from, dvec2(to.x, from.y), to], Stroke::new(Ink::Outline, 2.2));
        }
    }
    for node in nodes {
        let here = place(&node);
        let pixels = portrait(Box::new(solid(node.tree)), &node.colours, size, samples);
        drawing.image(here, pixels);
        drawing.rect(here, None, Some(Stroke::new(Ink::Grid, 1.5)));
        if !node.below.is_empty() {
            let at = dvec2(here.center().x, here.max.y - 2.0);
            drawing.circle(at, 21.0, Some(Fill::new(Ink::Ground)), Some(Stroke::new(Ink::Outline, 2.2)));
            let sign = Text::new(at + dvec2(0.0, 10.0), node.label, 30.0, Ink::Text).anchor(Anchor::Middle);
            drawing.text(sign.face(Face::Bold));
        } else {
            let at = dvec2(here.center().x, here.max.y + 22.0);
            drawing.text(Text::new(at, node.label, 20.0, Ink::Text).anchor(Anchor::Middle));
        }
    }
    let alt = "A tree of nine small pictures. At the top a rounded box with three round tunnels; below it a rounded box and three \
               crossed rods, joined by a minus sign; below those a box and a sphere joined by an intersection sign, and \
               the rods one by one joined by union signs.";
    Figure::new(drawing, title, alt)
        .caption("After Sancho, illustration 17, and Tomas, figure 17: the solid of every node.")
}

/// [D fig. 16].
pub fn operations(size: usize, samples: u32) -> Figure {
    let corner = || ball(dvec3(0.9, 0.9, 0.9), 1.5);
    let small = || Tree::leaf(Cuboid::new(DVec3::splat(-1.3), DVec3::splat(1.3)).expect("a box"));
    let mut panels = Panels::new()
        .columns(3)
        .title("Union, intersection and difference of a box and a sphere")
        .subtitle("red where the surface is the box's, blue where it is the sphere's")
        .alt("Three solids on a pale floor: a box with a ball at its corner, their common part, and the box with a round bite.");
    for operation in Operation::ALL {
        let tree = Tree::node(operation, small(), corner());
        let label = format!("box {} sphere", operation.sign());
        panels = panels.picture(portrait(Box::new(solid(tree)), &COLOURS[..2], size, samples), &label);
    }
    Figure::from(panels).caption(
        "After Tomas, figure 16. Each point of the surface keeps the material of the leaf it lies on.",
    )
}

fn spans(solid: &dyn Solid, ray: &Ray) -> Vec<Span> {
    let mut out = Vec::new();
    solid.spans(ray, &mut out);
    out
}

fn plain(spans: &[Span]) -> Vec<(f64, f64)> {
    spans.iter().map(|s| (s.enter.t, s.leave.t)).collect()
}

/// Its ends in the colours of the leaves on which they lie, of which `leaves` are the numbers.
fn bars(solid: &Csg, ray: &Ray, leaves: &[usize]) -> Vec<Bar> {
    let hue = |part: u32| HUES[leaves[solid.leaf(part).0]];
    let bar = |s: &Span| Bar { from: s.enter.t, to: s.leave.t, ends: [hue(s.enter.part), hue(s.leave.part)] };
    spans(solid, ray).iter().map(bar).collect()
}

/// [A ill. 62]: the solid, three rays through it, and their diagrams.
pub fn roots(size: usize, samples: u32) -> Figure {
    let picture = portrait(Box::new(solid(document())), &COLOURS, size, samples);
    let camera = camera(EYE);
    let marks = [("a", dvec2(0.395, 0.455)), ("b", dvec2(0.60, 0.47)), ("c", dvec2(0.505, 0.765))];
    let whole = document();
    let all = leaves(&whole);
    let mut figure = Roots::new()
        .title("Where a ray is inside: five lists become one")
        .subtitle("root diagrams of three rays through (box ∩ sphere) − (rod ∪ rod ∪ rod); ends in the colour of their surface")
        .picture(picture, marks.map(|(name, at)| (at, name.to_string())).to_vec())
        .alt(
            "A rounded box with three tunnels and three dots on it. Beside it, for each dot, bars on lines: where the ray is \
             inside the box, the sphere and the rods, and in the last line where it is inside the whole.",
        );
    for (name, at) in marks {
        let ray = ray_through(&camera, at);
        figure = figure.ray(&format!("ray {name}"));
        for (i, leaf) in all.iter().enumerate() {
            let spans = plain(&spans(*leaf, &ray));
            if !spans.is_empty() {
                figure = figure.operand(NAMES[i], HUES[i], &spans);
            }
        }
        figure = figure.result("the whole", bars(&solid(document()), &ray, &[0, 1, 2, 3, 4]));
    }
    Figure::from(figure).caption(
        "After Sancho, illustration 62. Lines without bars are left out: that ray misses that solid. Where the whole begins or ends on a rod, the \
         rod's normal is turned, for its inside is the whole's outside.",
    )
}

/// Solids along the x axis: what a ray along it meets.
fn on_a_line(spans: &[(f64, f64)]) -> Tree {
    let slab = |&(a, b): &(f64, f64)| {
        Tree::leaf(Cuboid::new(dvec3(a, -1.0, -1.0), dvec3(b, 1.0, 1.0)).expect("a box"))
    };
    Tree::all(Operation::Union, spans.iter().map(slab)).expect("a box at least")
}

/// [D fig. 27–29]: a case in which the pair rule is right, and one in which it is not.
pub fn lists() -> Figure {
    let ray = Ray::new(DVec3::ZERO, DVec3::X);
    let mut figure = Roots::new()
        .columns(2)
        .title("The printed rules hold only for two spans that overlap")
        .subtitle("left: the printed cases; right: cases that are not printed; > enters, < leaves")
        .alt(
            "Six root diagrams in two columns, for union, difference and intersection. In the left column the printed rules \
             agree with the root diagram; in the right column they do not.",
        );
    let pairs = [
        (Operation::Union, "A ∪ B", [(1.0, 3.0), (2.0, 4.0)], [(1.0, 2.0), (3.0, 4.0)], (1.5, 3.5)),
        (Operation::Difference, "A − B", [(1.0, 3.0), (2.0, 4.0)], [(1.0, 4.0), (1.0, 4.0)], (2.0, 3.0)),
        (Operation::Intersection, "A ∩ B", [(1.0, 3.0), (2.0, 4.0)], [(1.0, 2.0), (1.0, 2.0)], (3.0, 4.0)),
    ];
    for (operation, name, [a, b], hard, with) in pairs {
        let hard: &[(f64, f64)] = if hard[0] == hard[1] { &hard[..1] } else { &hard };
        for (a, b, what) in [(&[a][..], b, "overlap"), (hard, with, hard_name(operation))] {
            let tree = || Tree::node(operation, on_a_line(a), on_a_line(&[b]));
            figure =
                figure.ray(&format!("{name}, {what}")).operand("A", HUES[0], a).operand("B", HUES[1], &[b]);
            let (marks, solid) = (as_printed(&tree(), &ray), solid(tree()));
            let right = bars(&solid, &ray, if a.len() == 1 { &[0, 1] } else { &[0, 0, 1] });
            let printed = bars_of(&marks, a.len() as u32);
            let same = printed.len() == right.len()
                && printed.iter().zip(&right).all(|(p, r)| (p.from, p.to) == (r.from, r.to));
            figure =
                if same { figure.result("as printed", printed) } else { figure.wrong("as printed", printed) };
            let sign = |m: &Mark| if m.to == Side::In { ">" } else { "<" };
            figure = figure
                .letters(marks.iter().map(|m| (m.crossing.t, sign(m).to_string())).collect())
                .result("root diagram", right);
        }
    }
    Figure::from(figure).caption(
        "After Tomas, figures 27 to 29. Hatched: what the printed rule leaves is not the solid. A union of two spans with a third \
         keeps its gap, a difference with an inner solid loses its hole, an intersection of disjoint solids keeps both.",
    )
}

fn hard_name(operation: Operation) -> &'static str {
    match operation {
        Operation::Union => "B bridges a gap",
        Operation::Difference => "B inside A",
        Operation::Intersection => "disjoint",
    }
}

/// The spans that a list of marks leaves: from each IN to the next OUT.
fn bars_of(marks: &[Mark], of_a: u32) -> Vec<Bar> {
    let hue = |m: &Mark| HUES[usize::from(m.crossing.part >= of_a)];
    marks
        .windows(2)
        .filter(|w| w[0].to == Side::In && w[1].to == Side::Out)
        .map(|w| Bar { from: w[0].crossing.t, to: w[1].crossing.t, ends: [hue(&w[0]), hue(&w[1])] })
        .collect()
}
