//! Where the printed pair rules go wrong: five solids, as printed and as they are.

use super::contestants::{Way, agree, truth};
use super::printed::AsPrinted;
use super::solids::{COLOURS, EYE, ball, block, camera, cube, document, portrait, rays, solid};
use glam::{DVec3, dvec3};
use lightbench::csg::Tree;
use lightbench_kit::figure::{Figure, Panels};

type Make = fn() -> Tree;
/// Name and solid.
type Row = (&'static str, Make);

/// A case, and the pixels that the printed rules and the root diagram get wrong, of those where truth or rules see the solid.
pub struct Case {
    pub name: &'static str,
    pub tree: Make,
    pub printed: usize,
    pub diagram: usize,
    pub seen: usize,
}

/// Two balls, one behind the other, with nothing in common.
fn disjoint() -> Tree {
    let away = EYE.normalize() * 1.2;
    ball(away, 1.0).intersection(ball(-away, 1.2))
}

/// A hollow ball, opened where the viewer can look in.
fn hollow() -> Tree {
    let opening = block(DVec3::ZERO, DVec3::splat(2.0));
    ball(DVec3::ZERO, 1.7).difference(ball(DVec3::ZERO, 1.2)).difference(opening)
}

/// A pocket whose rim lies in the top of the block.
fn pocket() -> Tree {
    cube().difference(block(dvec3(-0.9, 0.0, -0.9), dvec3(0.9, 1.5, 0.9)))
}

/// A bite out of the cube by a ball that holds the camera.
fn bite() -> Tree {
    cube().difference(ball(EYE, EYE.length() - 1.2))
}

pub fn cases(size: usize) -> Vec<Case> {
    let list: [Row; 5] = [
        ("disjoint solids, ∩", disjoint),
        ("an inner solid taken away", hollow),
        ("three that overlap (fig. 17)", document),
        ("faces that coincide", pocket),
        ("the camera inside", bite),
    ];
    let rays = rays(&camera(EYE), size);
    let judge = |(name, tree): Row| {
        let (described, made) = (tree(), solid(tree()));
        let mut case = Case { name, tree, printed: 0, diagram: 0, seen: 0 };
        for ray in &rays {
            let right = truth(&described, ray);
            let [printed, diagram] = [Way::AsPrinted, Way::Diagram].map(|w| w.first(&described, &made, ray));
            case.printed += usize::from(!agree(printed, right));
            case.diagram += usize::from(!agree(diagram, right));
            case.seen += usize::from(printed.is_some() || right.is_some());
        }
        case
    };
    list.into_iter().map(judge).collect()
}

/// Above as printed, below as it is.
pub fn pictures(cases: &[Case], size: usize, samples: u32) -> Figure {
    let share =
        |wrong: usize, case: &Case| format!("{:.0} % wrong", 100.0 * wrong as f64 / case.seen.max(1) as f64);
    let broken = cases.iter().filter(|c| c.printed > 0).count();
    let mut panels = Panels::new()
        .columns(cases.len())
        .title(&format!("Rules for neighbours break {broken} of {} solids", cases.len()))
        .subtitle("above by the printed rules, below by root diagrams; each colour is a leaf")
        .alt(
            "Two rows of five solids. Above, by the printed rules: balls that should not be there, a hollow ball that is \
             filled, a box with rods taken away that keeps parts of them, a pocket that is closed, a bitten cube \
             that has vanished. Below, the same solids as they are.",
        );
    for case in cases {
        let picture = portrait(Box::new(AsPrinted((case.tree)())), &COLOURS, size, samples);
        panels = panels.picture(picture, &share(case.printed, case));
    }
    for case in cases {
        let picture = portrait(Box::new(solid((case.tree)())), &COLOURS, size, samples);
        panels = panels.picture(picture, case.name);
    }
    Figure::from(panels).caption(
        "After Tomas §5.9.1.6: the printed rule sorts the ends of both operands, drops negative ones, gives up on an odd count and deletes neighbours by their \
         marks alone. Shares are of pixels where the solid is, or is said to be. The last camera stands inside the ball that bites.",
    )
}
