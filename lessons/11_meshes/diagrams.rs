//! The two hierarchies of A's chapter on polygons.

use glam::{DVec2, dvec2};
use lightbench_kit::figure::{Diagram, Figure, Light};

/// Two triangles that share the edge V₁V₂.
const CORNERS: [DVec2; 4] = [dvec2(0.0, 0.0), dvec2(2.1, -0.35), dvec2(1.5, 1.9), dvec2(3.6, 1.6)];
const FACES: [[usize; 3]; 2] = [[0, 1, 2], [1, 3, 2]];
/// Edges by their ends, and the edges of the two faces; E₂ belongs to both.
const EDGES: [[usize; 2]; 5] = [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]];
const SIDES: [[usize; 3]; 2] = [[0, 2, 1], [3, 4, 2]];

fn middle(points: &[usize]) -> DVec2 {
    points.iter().map(|&i| CORNERS[i]).sum::<DVec2>() / points.len() as f64
}

/// The object itself, on the left.
fn object(mut diagram: Diagram) -> Diagram {
    for face in FACES {
        diagram = diagram.polygon(&face.map(|i| CORNERS[i]));
    }
    for (i, face) in FACES.iter().enumerate() {
        diagram = diagram.note(middle(face), &format!("P{}", subscript(i)));
    }
    let outward = [dvec2(-0.25, -0.1), dvec2(0.1, -0.25), dvec2(-0.1, 0.25), dvec2(0.25, 0.1)];
    for (i, corner) in CORNERS.iter().enumerate() {
        diagram = diagram.point(*corner).note(*corner + outward[i], &format!("V{}", subscript(i)));
    }
    diagram
}

fn subscript(i: usize) -> char {
    ['₀', '₁', '₂', '₃', '₄'][i]
}

const HALF: DVec2 = dvec2(0.42, 0.2);

/// A box with a name.
fn cell(diagram: Diagram, at: DVec2, name: &str) -> Diagram {
    let corner = |x: f64, y: f64| at + dvec2(x, y) * HALF;
    diagram
        .polygon(&[corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
        .note(at, name)
}

/// Places of the `n` entries of a list in the column at `x`, from the top.
fn column(x: f64, n: usize) -> impl Fn(usize) -> DVec2 {
    move |i| dvec2(x, 0.8 + 0.62 * ((n - 1) as f64 / 2.0 - i as f64))
}

/// An arrow from the right of one cell to the left of another; arrows from above arrive above the middle.
fn names(diagram: Diagram, light: Light, from: DVec2, to: DVec2) -> Diagram {
    let height = (0.2 * (from.y - to.y)).clamp(-0.11, 0.11);
    diagram.ray(light, from + dvec2(HALF.x, 0.0), to + dvec2(-HALF.x - 0.03, height))
}

const TOP: f64 = 2.72;

/// [A ill. 5].
pub fn polygons() -> Figure {
    let (whole, faces, points) = (dvec2(5.4, 0.8), column(7.4, 2), column(9.6, 4));
    let mut d = object(Diagram::fitted());
    for (i, face) in FACES.iter().enumerate() {
        d = names(d, Light::Normal, whole, faces(i));
        for &v in face {
            d = names(d, if i == 0 { Light::Incident } else { Light::Reflected }, faces(i), points(v));
        }
    }
    d = cell(d, whole, "object");
    for i in 0..2 {
        d = cell(d, faces(i), &format!("P{}", subscript(i)));
    }
    for i in 0..4 {
        d = cell(d, points(i), &format!("V{}", subscript(i)));
    }
    let d = d
        .note(dvec2(7.4, TOP), "polygons")
        .note(dvec2(9.6, TOP), "vertices")
        .title("Polygons name vertices; that two share an edge is not said")
        .subtitle("an object of two triangles, and its lists; each arrow is one index that is stored")
        .alt("An object of two triangles; a tree from the object to the polygons P0 and P1 and from each to three of the vertices V0 to V3.");
    Figure::from(d).caption(
        "The hierarchy object → polygons → vertices (after A, illustration 5). The edge between V₁ and V₂ occurs twice, once in each \
         polygon: to find out takes a search.",
    )
}

/// [A ill. 6].
pub fn edges() -> Figure {
    let (whole, faces, edges, points) = (dvec2(5.2, 0.8), column(6.9, 2), column(8.9, 5), column(11.0, 4));
    let mut d = object(Diagram::fitted())
        .path(Light::Other, &[CORNERS[1], CORNERS[2]])
        .note(middle(&EDGES[2]) + dvec2(0.26, 0.05), "E₂");
    for (i, sides) in SIDES.iter().enumerate() {
        d = names(d, Light::Normal, whole, faces(i));
        for &e in sides {
            let pen = if e == 2 {
                Light::Other
            } else if i == 0 {
                Light::Incident
            } else {
                Light::Reflected
            };
            d = names(d, pen, faces(i), edges(e));
        }
    }
    for (e, ends) in EDGES.iter().enumerate() {
        for &v in ends {
            d = names(d, if e == 2 { Light::Other } else { Light::Normal }, edges(e), points(v));
        }
    }
    d = cell(d, whole, "object");
    for i in 0..2 {
        d = cell(d, faces(i), &format!("P{}", subscript(i)));
    }
    for i in 0..5 {
        d = cell(d, edges(i), &format!("E{}", subscript(i)));
    }
    for i in 0..4 {
        d = cell(d, points(i), &format!("V{}", subscript(i)));
    }
    let d = d
        .note(dvec2(6.9, TOP), "polygons")
        .note(dvec2(8.9, TOP), "edges")
        .note(dvec2(11.0, TOP), "vertices")
        .title("With edges the shared one is stored once: 16 indices, not 6")
        .subtitle("the same object; purple: the edge that both polygons name")
        .alt("The two triangles with their shared edge E2 marked; a tree from the object by polygons and five edges to four vertices.");
    Figure::from(d).caption(
        "The hierarchy object → polygons → edges → vertices (after A, illustration 6). The shared edge E₂ is stored once and named \
         twice: what A calls an advantage in storage takes more of it.",
    )
}
