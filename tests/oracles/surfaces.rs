//! Rays against surfaces, held against tables computed at 30 to 260 digits (`tests/data/ray_*.csv`).
//!
//! `margin` is the relative change of the inputs that could change hit into miss; below 10⁻¹² rows are
//! not judged. `cond` is the condition of a root: a careful method errs by less than `64 u cond`.

use glam::DVec3;
use lightbench::num::U;
use lightbench::ray::{Crossing, Ray};
use lightbench::shape::cone::{Cone, Ends};
use lightbench::shape::cylinder::{self, Cylinder, FarEnd};
use lightbench::shape::disc::Disc;
use lightbench::shape::quadric::{self, Coefficients, Quadric};
use lightbench::shape::triangle::{self, Facing, PreparedRay, Triangle};
use lightbench::shape::{Shape, Sides, cone, disc};
use std::collections::HashMap;

struct Row(HashMap<String, String>);

impl Row {
    fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", |s| s.as_str())
    }

    fn maybe(&self, column: &str) -> Option<f64> {
        let text = self.text(column);
        (!text.is_empty()).then(|| text.parse().unwrap())
    }

    fn number(&self, column: &str) -> f64 {
        self.maybe(column).unwrap_or_else(|| panic!("no number in {column}"))
    }

    fn count(&self, column: &str) -> usize {
        self.number(column) as usize
    }

    fn vector(&self, prefix: &str) -> DVec3 {
        DVec3::from_array(["x", "y", "z"].map(|axis| self.number(&format!("{prefix}{axis}"))))
    }

    fn ray(&self) -> Ray {
        Ray::new(self.vector("o"), self.vector("d"))
    }

    fn is(&self, column: &str) -> bool {
        self.text(column) == "1"
    }

    fn is_judged(&self) -> bool {
        !self.is("degenerate") && self.maybe("margin").is_none_or(|m| m >= 1e-12)
    }
}

fn table(name: &str) -> Vec<Row> {
    let path = format!("{}/tests/data/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().map(|row| Row(row.unwrap())).collect()
}

fn relative(found: f64, truth: f64) -> f64 {
    if found == truth { 0.0 } else { (found - truth).abs() / truth.abs() }
}

/// Judged rows and wrong ones.
#[derive(Debug, Default, PartialEq)]
struct Tally {
    judged: usize,
    wrong: usize,
}

impl Tally {
    fn add(&mut self, right: Option<bool>) {
        self.judged += usize::from(right.is_some());
        self.wrong += usize::from(right == Some(false));
    }

    fn of(rows: &[Row], right: impl Fn(&Row) -> Option<bool>) -> Self {
        let mut tally = Tally::default();
        rows.iter().for_each(|row| tally.add(right(row)));
        tally
    }
}

/// Side and cap ids are judged from margins of 10⁻⁹ on; `t` to `10⁻¹³/√margin`.
fn capped_is_right(row: &Row, found: &[Crossing]) -> Option<bool> {
    if !row.is_judged() || row.is("tangent") {
        return None;
    }
    let margin = row.maybe("margin").unwrap_or(1.0).clamp(1e-12, 1.0);
    let right = found.len() == row.count("n_pos")
        && found.iter().enumerate().all(|(i, c)| {
            relative(c.t, row.number(&format!("tp{i}"))) <= 1e-13 / margin.sqrt()
                && (margin <= 1e-9 || c.face as usize == row.count(&format!("face{i}")))
        });
    Some(right)
}

fn crossings(shape: &dyn Shape, ray: &Ray) -> Vec<Crossing> {
    let mut out = Vec::new();
    shape.crossings(ray, &mut out);
    out
}

fn normal_is_right(row: &Row, shape: &dyn Shape) -> Option<bool> {
    let told = row.text("cls") == "random" && row.number("margin") > 1e-6 && !row.text("nx").is_empty();
    let first = shape.nearest(&row.ray(), 0.0, f64::INFINITY)?;
    told.then(|| (shape.hit(&row.ray(), &first).ng - row.vector("n")).abs().max_element() <= 1e-9)
}

fn cylinder_of(row: &Row) -> Cylinder {
    Cylinder::new(row.vector("p0"), row.vector("p1"), row.number("r")).unwrap()
}

fn cone_of(row: &Row) -> Cone {
    Cone::new(row.vector("p0"), row.vector("p1"), row.number("r0"), row.number("r1")).unwrap()
}

#[test]
fn cylinders_are_right_in_every_row() {
    let rows = table("ray_cylinder");
    let tally = Tally::of(&rows, |row| capped_is_right(row, &crossings(&cylinder_of(row), &row.ray())));
    assert!(tally.wrong == 0 && tally.judged > 200, "{tally:?}");
    let normals = Tally::of(&rows, |row| normal_is_right(row, &cylinder_of(row)));
    assert!(normals.wrong == 0 && normals.judged > 20, "{normals:?}");
}

#[test]
fn cones_are_right_in_every_row() {
    let rows = table("ray_cone");
    let tally = Tally::of(&rows, |row| capped_is_right(row, &crossings(&cone_of(row), &row.ray())));
    assert!(tally.wrong == 0 && tally.judged > 200, "{tally:?}");
    let normals = Tally::of(&rows, |row| normal_is_right(row, &cone_of(row)));
    assert!(normals.wrong == 0 && normals.judged > 20, "{normals:?}");
}

/// The tables also hold the hits of the side alone.
#[test]
fn open_tubes_are_right_in_every_row() {
    for name in ["ray_cylinder", "ray_cone"] {
        let tally = Tally::of(&table(name), |row| {
            let tube: Box<dyn Shape> = match name {
                "ray_cylinder" => Box::new(cylinder_of(row).with_ends(Ends::Open)),
                _ => Box::new(cone_of(row).with_ends(Ends::Open)),
            };
            if !row.is_judged() || row.is("tangent") {
                return None;
            }
            let found = crossings(&*tube, &row.ray());
            let close = |(i, c): (usize, &Crossing)| relative(c.t, row.number(&format!("ts{i}"))) <= 1e-9;
            Some(found.len() == row.count("n_side") && found.iter().enumerate().all(close))
        });
        assert!(tally.wrong == 0 && tally.judged > 200, "{name}: {tally:?}");
    }
}

/// The printed formulas are not: that is what the tables are for.
#[test]
fn printed_formulas_lose_rows() {
    let rows = table("ray_cylinder");
    let by = |far_end| {
        Tally::of(&rows, |row| {
            let found =
                cylinder::textbook(row.vector("p0"), row.vector("p1"), row.number("r"), far_end, &row.ray());
            capped_is_right(row, &found)
        })
    };
    let (corrected, printed) = (by(FarEnd::Corrected), by(FarEnd::AsPrinted));
    assert!(corrected.wrong < corrected.judged / 4, "{corrected:?}");
    assert!(printed.wrong > printed.judged / 3, "{printed:?}");
    let cones = Tally::of(&table("ray_cone"), |row| {
        let (p0, p1, r0, r1) = (row.vector("p0"), row.vector("p1"), row.number("r0"), row.number("r1"));
        capped_is_right(row, &cone::textbook(p0, p1, r0, r1, &row.ray()))
    });
    assert!(cones.wrong < cones.judged / 4, "{cones:?}");
}

/// Within rounding of its input, `64 u cond`, and hit or miss exactly.
#[test]
fn discs_are_right_in_every_row() {
    let rows = table("ray_disc");
    let right = |row: &Row, found: Option<f64>| {
        if !row.is_judged() || row.is("exact_edge") {
            return None;
        }
        let cond = row.maybe("cond_t").unwrap_or(1.0).max(1.0);
        let close = |t: f64| relative(t, row.number("t")) <= 64.0 * U * cond;
        Some(found.is_some() == row.is("hit") && found.is_none_or(close))
    };
    let disc = |row: &Row| Disc::new(row.vector("c"), row.vector("n"), row.number("r")).unwrap();
    let robust = Tally::of(&rows, |row| right(row, disc(row).meeting(&row.ray()).filter(|&t| t > 0.0)));
    assert!(robust.wrong == 0 && robust.judged > 100, "{robust:?}");
    let printed = Tally::of(&rows, |row| {
        right(row, disc::as_printed(row.vector("c"), row.vector("n"), row.number("r"), &row.ray()))
    });
    assert!(printed.wrong < printed.judged / 4, "{printed:?}");
}

fn corners(row: &Row) -> [DVec3; 3] {
    ["v0", "v1", "v2"].map(|v| row.vector(v))
}

fn triangle_is_right(row: &Row, found: Option<triangle::Meeting>) -> Option<bool> {
    let on_border = row.is("exact_on_edge") || row.is("exact_on_vertex");
    if !row.is("unit_d") || !row.is_judged() || on_border {
        return None;
    }
    let found = found.filter(|m| m.t > 0.0);
    if found.is_some() != row.is("hit") {
        return Some(false);
    }
    let cond = row.maybe("cond_t").unwrap_or(1.0).max(1.0);
    Some(found.is_none_or(|m| {
        let close = cond > 1e10 || relative(m.t, row.number("t")) <= 64.0 * U * cond;
        let inner = |k: usize| (m.b[k] - row.number(&format!("b{k}"))).abs() <= 1e-10;
        let faces = (m.facing == Facing::Front) == row.is("front");
        close && (row.text("cls") != "random" || cond >= 1e4 || (faces && (0..3).all(inner)))
    }))
}

#[test]
fn triangles_are_right_in_every_row_and_do_not_leak() {
    let rows = table("ray_triangle");
    let meet = |row: &Row| {
        let [a, b, c] = corners(row);
        Triangle::new(a, b, c).ok()?.meet(&PreparedRay::new(&row.ray()))
    };
    let tally = Tally::of(&rows, |row| triangle_is_right(row, meet(row)));
    assert!(tally.wrong == 0 && tally.judged > 200, "{tally:?}");
    let mut groups: HashMap<&str, (bool, bool)> = HashMap::new();
    for row in &rows {
        let group = groups.entry(row.text("group")).or_insert((row.is("group_union_hit"), false));
        group.1 |= meet(row).is_some_and(|m| m.t > 0.0);
        // Signs are exact, so that borders are too.
        assert_eq!(meet(row).is_some_and(|m| m.t > 0.0), row.is("hit"), "group {}", row.text("group"));
        let [a, b, c] = corners(row);
        assert!(row.text("cls") != "zero_area" || Triangle::new(a, b, c).is_err());
    }
    assert!(groups.len() > 300 && groups.values().all(|(expected, met)| expected == met));
}

#[test]
fn quick_triangle_tests_are_right_away_from_slivers() {
    let rows: Vec<Row> = table("ray_triangle");
    type Method = fn(&Ray, [DVec3; 3]) -> Option<triangle::Meeting>;
    let methods: [Method; 2] = [triangle::moller_trumbore, triangle::plane_and_areas];
    for method in methods {
        let tally = Tally::of(&rows, |row| {
            if row.text("cls") == "random" {
                triangle_is_right(row, method(&row.ray(), corners(row)))
            } else {
                None
            }
        });
        assert!(tally.wrong == 0 && tally.judged > 90, "{tally:?}");
    }
    let printed = Tally::of(&rows, |row| {
        if row.text("cls") != "scale" {
            return None;
        }
        triangle_is_right(row, triangle::as_printed(&row.ray(), corners(row), Sides::Both))
    });
    // Tolerances of 10⁻⁶ lose what is small.
    assert!(printed.wrong > 5, "{printed:?}");
}

fn coefficients(row: &Row) -> Coefficients {
    let n = |column| row.number(column);
    Coefficients {
        a: n("A"),
        b: n("B"),
        c: n("C"),
        d: n("D"),
        e: n("E"),
        f: n("F"),
        g: n("G"),
        h: n("H"),
        i: n("I"),
        j: n("J"),
    }
}

/// `conditions` names the columns: of the problem, or of its expanded coefficients.
fn roots_are_right(row: &Row, found: &[f64], conditions: &str) -> Option<bool> {
    if !row.is_judged() {
        return None;
    }
    let scale = row.vector("o").abs().max_element();
    let cond = |i: usize| row.maybe(&format!("{conditions}_tp{i}")).unwrap_or(1.0).max(1.0);
    let truth: Vec<(f64, f64)> =
        (0..row.count("n_pos")).map(|i| (row.number(&format!("tp{i}")), cond(i))).collect();
    if truth.iter().any(|(_, c)| *c > 1e10) {
        return None;
    }
    // An origin on the surface up to rounding: the sign of that root is not decided by the inputs.
    let clear = |t: f64| t >= 1e-12 * scale;
    let truth: Vec<_> = truth.into_iter().filter(|(t, _)| clear(*t)).collect();
    let found: Vec<_> = found.iter().copied().filter(|&t| clear(t)).collect();
    let close = |(f, (t, c)): (&f64, &(f64, f64))| relative(*f, *t) <= 64.0 * U * c;
    Some(found.len() == truth.len() && found.iter().zip(&truth).all(close))
}

/// `Qp + l` rounds relative to the largest coefficients and to how far the ray comes; its direction, to that over its
/// length; and the point is known to the condition of its `t`.
fn gradient_rounding(row: &Row, p: DVec3, t: f64) -> f64 {
    let n = |column: &str| row.number(column);
    let [x, y, z] = p.to_array();
    let gradient = DVec3::new(
        n("A") * x + n("B") * y + n("C") * z + n("D"),
        n("B") * x + n("E") * y + n("F") * z + n("G"),
        n("C") * x + n("F") * y + n("H") * z + n("I"),
    );
    let largest = |columns: &[&'static str]| columns.iter().map(|c| n(c).abs()).fold(0.0, f64::max);
    let reach = row.vector("o").abs().max_element() + t;
    let terms = largest(&["A", "B", "C", "E", "F", "H"]) * reach + largest(&["D", "G", "I"]);
    let cond = n("cond_tp0").max(1.0);
    (64.0 * U * terms / gradient.length()).max(1e-12) * cond
}

#[test]
fn quadrics_are_right_in_every_row() {
    let rows = table("ray_quadric");
    let roots = |row: &Row| -> Vec<f64> {
        let quadric = Quadric::new(coefficients(row)).unwrap();
        crossings(&quadric, &row.ray()).iter().map(|c| c.t).collect()
    };
    let tally = Tally::of(&rows, |row| roots_are_right(row, &roots(row), "cond"));
    assert!(tally.wrong == 0 && tally.judged > 300, "{tally:?}");
    for row in &rows {
        let quadric = Quadric::new(coefficients(row)).unwrap();
        let Some(first) = quadric.nearest(&row.ray(), 0.0, f64::INFINITY) else { continue };
        let well = row.maybe("cond_tp0").is_some_and(|c| c < 1e4) && row.is_judged();
        if well && !row.text("gx").is_empty() {
            let hit = quadric.hit(&row.ray(), &first);
            let off = (hit.ng - row.vector("g")).abs().max_element();
            assert!(off <= gradient_rounding(row, hit.point, first.t), "{off} in {}", row.text("cls"));
        }
    }
}

/// The expanded polynomial is as good as its coefficients, and these are not as good as the problem.
#[test]
fn the_expanded_polynomial_is_as_good_as_its_coefficients() {
    let rows = table("ray_quadric");
    let positive = |roots: Vec<f64>| roots.into_iter().filter(|&t| t > 0.0).collect::<Vec<_>>();
    let textbook = |row: &Row| positive(quadric::textbook(&coefficients(row), &row.ray()));
    let by_cond = Tally::of(&rows, |row| roots_are_right(row, &textbook(row), "cond"));
    let by_coefficients = Tally::of(&rows, |row| roots_are_right(row, &textbook(row), "coefcond"));
    assert!(by_coefficients.wrong <= by_cond.wrong, "{by_coefficients:?} {by_cond:?}");
    let printed = Tally::of(&rows, |row| {
        let found: Vec<f64> = quadric::as_printed(&coefficients(row), &row.ray()).into_iter().collect();
        // It answers with the first hit alone.
        if row.count("n_pos") > 1 { None } else { roots_are_right(row, &found, "coefcond") }
    });
    assert!(printed.wrong > by_coefficients.wrong, "{printed:?} {by_coefficients:?}");
}
