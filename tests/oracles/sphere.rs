//! The sphere against numbers found elsewhere: [C]'s two examples, and the table of 100 digits.

use crate::support::table::Table;
use glam::DVec3;
use lightbench::num::real::dot;
use lightbench::num::{U, gamma};
use lightbench::shape::sphere::method::{algebraic, algebraic_first};
use lightbench::shape::sphere::reference::Meeting;

/// Examples (a) and (b): every step of the algebraic method.
#[test]
fn the_worked_examples_come_out() {
    let table = Table::read("worked_examples.csv");
    let value = |id: &str, quantity: &str| {
        let mut rows = table.rows().filter(|r| r.text("id") == id && r.text("quantity") == quantity);
        rows.next().unwrap_or_else(|| panic!("no {id} {quantity}")).f64("value_with_f64_rounded_direction")
    };
    let examples = [
        ("a", [1.0, -2.0, -1.0], [3.0, 0.0, 5.0], [1.0, 2.0, 4.0], 3.0, "normal_outward", 1.0),
        ("b", [3.0, -2.0, 2.0], [4.0, 1.0, 3.0], [1.0, 2.0, 3.0], 4.0, "normal_inward", -1.0),
    ];
    for (id, o, c, d, r, normal, side) in examples {
        let (o, c, d) = (DVec3::from(o), DVec3::from(c), DVec3::from(d).normalize());
        let f = (o - c).to_array();
        let (t0, t1) = algebraic(f, d.to_array(), r).expect("a hit");
        let t = algebraic_first(f, d.to_array(), r).expect("a hit");
        let (b, constant) = (2.0 * dot(f, d.to_array()), dot(f, f) - r * r);
        let p = o + d * t;
        let n = (p - c) / r * side;
        // Numbers up to 200 (B²) after some ten roundings each; roots divide their error by 2√D > 11.
        let found = [
            ("B=2 d.(o-c)", b),
            ("C", constant),
            ("disc=B^2-4C", b * b - 4.0 * constant),
            ("t0", t0),
            ("t1", t1),
            ("t_first_positive", t),
            ("dir_x", d.x),
            ("dir_y", d.y),
            ("dir_z", d.z),
            ("point_x", p.x),
            ("point_y", p.y),
            ("point_z", p.z),
        ];
        for (quantity, found) in found {
            let truth = value(id, quantity);
            assert!((found - truth).abs() <= gamma(10) * 200.0, "{id} {quantity}: {found} is not {truth}");
        }
        for (axis, found) in ["x", "y", "z"].iter().zip(n.to_array()) {
            let truth = value(id, &format!("{normal}_{axis}"));
            assert!(
                (found - truth).abs() <= gamma(10) * 200.0 / r,
                "{id} normal {axis}: {found} is not {truth}"
            );
        }
    }
}

/// What lessons measure errors against, against the table: its roots are rounded once, `u |t|`.
#[test]
fn the_reference_agrees_with_the_table() {
    let table = Table::read("ray_sphere.csv");
    let mut judged = 0;
    for row in table.rows() {
        let vector = |p: &str| {
            DVec3::new(row.f64(&format!("{p}x")), row.f64(&format!("{p}y")), row.f64(&format!("{p}z")))
        };
        let (c, o, d, r) = (vector("c"), vector("o"), vector("d"), row.f64("r"));
        let f = o - c;
        // The reference starts from f: rows whose difference rounds ask another question.
        let exact = (0..3).all(|i| {
            let (s, e) = lightbench::num::double_double::two_sum(o[i], -c[i]);
            s == f[i] && e == 0.0
        });
        let (Some(t0), Some(t1)) = (row.optional("t0"), row.optional("t1")) else { continue };
        let range = 1.0e-70..1.0e70;
        if !exact || !range.contains(&f.length()) || !range.contains(&r) || row.f64("margin") < 1.0e-12 {
            continue;
        }
        let truth = Meeting::of(f.to_array(), d.to_array(), r);
        let h = truth.half_chord.expect("a hit") * d.length();
        let own = gamma(12) * (h + truth.impact * truth.impact / h) / d.length();
        for (t, behind) in [(t0, truth.behind_first(t0)), (t1, truth.behind_second(t1))] {
            assert!(behind.expect("a hit").abs() <= U * t.abs() + own, "{t}: {behind:?} beyond {own}");
        }
        judged += 1;
    }
    assert!(judged > 100, "only {judged} rows judged");
}
