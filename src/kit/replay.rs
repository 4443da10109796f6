//! A replayed pixel as a drawing: its rays in space, the objects of the scene in outline, and its lights.

pub mod outline;

use super::figure::{Diagram, Figure, Light as Line, Space};
use crate::bounds::Aabb;
use crate::light::{Emitter, Light};
use crate::ray::RayKind;
use crate::render::Traced;
use crate::scene::Scene;
use glam::{DVec2, DVec3};
use outline::{Outlines, Paper};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Degrees from the camera's side from which the drawing may be seen, and degrees above the ground.
const TURNS: [f64; 4] = [35.0, -35.0, 60.0, -60.0];
const PITCH: f64 = 20.0;
/// How far a ray that hits nothing is drawn [share of the scene's extent].
const BEYOND: f64 = 0.3;
/// Objects, lights and ends of rays farther than this from the rays [extents of what they pass] are left out: the scene would
/// shrink to a dot.
const FAR: f64 = 3.0;
/// Cells of an outline along the drawing's longer side: about three pixels each.
const FINE: f64 = 300.0;
/// Objects that are drawn beside those that the rays hit or that block them; more lines than these hide the rays.
const OTHERS: usize = 64;
/// Shadow rays that are drawn from one point; the text has all.
const SHADOWS: usize = 36;
/// Shadow rays from one point that are drawn as arrows; more become thin lines.
const ARROWS: usize = 9;

/// Draws the rays of one pixel.
///
/// Camera rays are blue, reflected ones orange, refracted ones green; shadow rays are grey and dashed where they
/// reach the light, purple where an object blocks them. Objects appear in outline, in bold those that the rays hit or that
/// block them; lights as they are.
pub fn draw(scene: &Scene, rays: &[Traced], title: &str) -> Figure {
    let drawn = Drawn::new(scene, rays);
    let hidden = if drawn.every > 1 {
        format!("; one in {} shadow rays is drawn", drawn.every)
    } else {
        String::new()
    };
    let mut diagram = Diagram::fitted().title(title).subtitle(&format!(
        "camera rays blue, reflected orange, refracted green; shadow rays grey, blocked ones purple{hidden}"
    ));
    diagram = drawn.objects(diagram);
    diagram = drawn.lights(diagram);
    for ray in &drawn.rays {
        diagram = drawn.ray(diagram, ray);
    }
    let camera = scene.camera.position();
    let ahead = drawn.space.at(scene.camera.frame().forward); // the projection is linear
    if drawn.room.contains(camera) && ahead.length() > 0.0 {
        diagram = diagram.eye(drawn.space.at(camera), ahead.normalize());
    }
    Figure::from(diagram.alt(&format!("{title}: {} rays from the camera, and what they caused", rays.len())))
}

/// What is drawn, and how it is seen.
struct Drawn<'a> {
    scene: &'a Scene,
    rays: Vec<&'a Traced>,
    /// Of so many shadow rays one is drawn.
    every: usize,
    /// Most shadow rays from one point.
    most: usize,
    /// Objects that a ray hits or that block one.
    involved: BTreeSet<usize>,
    /// All that is drawn lies in it.
    room: Aabb,
    extent: f64,
    space: Space,
}

impl<'a> Drawn<'a> {
    fn new(scene: &'a Scene, rays: &'a [Traced]) -> Self {
        let (mut all, mut involved, mut points) = (Vec::new(), BTreeSet::new(), Vec::new());
        let mut most = 0;
        for ray in rays {
            visit(ray, &mut |r| {
                all.push(r);
                involved.extend(r.hit.map(|(i, _)| i).into_iter().chain(r.blocker));
                points.push(r.ray.origin);
                points.extend(r.hit.map(|(_, hit)| hit.point));
                most = most.max(r.children.iter().filter(|c| c.kind == RayKind::Shadow).count());
            });
        }
        let every = most.div_ceil(SHADOWS).max(1);
        let mut number = 0;
        all.retain(|r| {
            number += usize::from(r.kind == RayKind::Shadow);
            r.kind != RayKind::Shadow || (number - 1) % every == 0
        });
        let room = room(scene, &involved, points);
        let extent = (room.max - room.min).max_element();
        let mut drawn = Drawn {
            scene,
            rays: all,
            every,
            most,
            involved,
            room,
            extent,
            space: Space::axonometric(0.0, PITCH),
        };
        drawn.space = drawn.best_view();
        drawn
    }

    /// The side from which the rays are seen longest.
    fn best_view(&self) -> Space {
        let back = -self.scene.camera.frame().forward;
        let camera = back.x.atan2(back.z).to_degrees();
        let length = |space: &Space| -> f64 {
            self.rays.iter().map(|r| space.at(r.ray.origin).distance(space.at(self.end(r)))).sum()
        };
        let views = TURNS.map(|turn| Space::axonometric(camera + turn, PITCH));
        let longer = |a: Space, b: Space| if length(&b) > length(&a) { b } else { a };
        views.into_iter().reduce(longer).unwrap_or(self.space)
    }

    fn objects(&self, mut diagram: Diagram) -> Diagram {
        let paper = Paper::new(&self.space, self.room);
        let pen = self.extent / FINE;
        let objects = &self.scene.objects;
        let others = (0..objects.len())
            .filter(|i| !self.involved.contains(i) && objects[*i].bounds().overlaps(&self.room));
        for i in others.take(OTHERS) {
            for line in paper.outlines(objects[i].shape(), pen).lines {
                diagram = diagram.thin(&line);
            }
        }
        let mut names = BTreeSet::new();
        for &i in &self.involved {
            let Outlines { mut lines, are_dense } = paper.outlines(objects[i].shape(), pen);
            lines.sort_by_key(Vec::len);
            let last = lines.len().saturating_sub(1);
            for (k, line) in lines.iter().enumerate() {
                diagram = if are_dense { diagram.thin(line) } else { diagram.curve(line) };
                if k == last && names.insert(&objects[i].name) {
                    diagram = diagram.word(&objects[i].name);
                }
            }
        }
        diagram
    }

    fn lights(&self, mut diagram: Diagram) -> Diagram {
        for light in &self.scene.lights {
            let near = |p: DVec3| self.room.contains(p);
            diagram = match light {
                Light::Point(point) if near(point.position) => diagram.lamp(self.space.at(point.position)),
                Light::Spot(spot) if near(spot.point().position) => {
                    let at = spot.point().position;
                    let tip = at + spot.axis() * (0.1 * self.extent);
                    diagram.ray(Line::Normal, self.space.at(at), self.space.at(tip)).lamp(self.space.at(at))
                }
                Light::Area(area) if near(area.emitter.ball().0) => self.emitter(diagram, &area.emitter),
                Light::Directional(sun) => {
                    let middle = self.room.center();
                    let [a, b] =
                        [0.7, 0.5].map(|far| self.space.at(middle - sun.direction() * (far * self.extent)));
                    diagram.ray(Line::Reflected, a, b).word("directional light")
                }
                _ => diagram,
            };
        }
        diagram
    }

    fn emitter(&self, diagram: Diagram, emitter: &Emitter) -> Diagram {
        let at = |p: &DVec3| self.space.at(*p);
        let (center, radius) = emitter.ball();
        let rim: Vec<DVec2> = match emitter {
            Emitter::Rectangle(r) => r.corners().iter().map(at).collect(),
            Emitter::Triangle(t) => t.corners().iter().map(at).collect(),
            Emitter::Sphere(_) => {
                let turns = (0..48).map(|i| DVec2::from_angle(TAU * f64::from(i) / 48.0));
                turns.map(|way| at(&center) + way * radius).collect()
            }
        };
        let closed: Vec<DVec2> = rim.iter().chain(rim.first()).copied().collect();
        diagram.region(Line::Reflected, &rim).path(Line::Reflected, &closed).word("light")
    }

    /// Where the drawn ray ends.
    fn end(&self, traced: &Traced) -> DVec3 {
        let ray = &traced.ray;
        let blocked = |i: usize| self.scene.objects[i].shape().nearest(ray, 0.0, traced.t_max).map(|c| c.t);
        match (&traced.hit, traced.blocker.and_then(blocked)) {
            (Some((_, hit)), _) => hit.point,
            (None, Some(t)) => ray.at(t),
            (None, None) if self.room.contains(ray.at(traced.t_max)) => ray.at(traced.t_max),
            (None, None) => ray.origin + ray.direction.normalize_or_zero() * (self.extent * BEYOND),
        }
    }

    fn ray(&self, diagram: Diagram, traced: &Traced) -> Diagram {
        let line = match (traced.kind, traced.blocker) {
            (RayKind::Shadow, None) => Line::Shadow,
            (RayKind::Shadow, Some(_)) => Line::Other,
            (RayKind::Reflected, _) => Line::Reflected,
            (RayKind::Refracted, _) => Line::Transmitted,
            _ => Line::Incident,
        };
        let [a, b] = [traced.ray.origin, self.end(traced)].map(|p| self.space.at(p));
        match (line, self.most > ARROWS) {
            _ if !(a.distance(b) > 0.0) => diagram,
            (Line::Shadow, true) => diagram.hidden(&[a, b]),
            (Line::Other, true) => diagram.path(line, &[a, b]),
            _ => diagram.ray(line, a, b),
        }
    }
}

fn visit<'a>(ray: &'a Traced, see: &mut impl FnMut(&'a Traced)) {
    see(ray);
    for child in &ray.children {
        visit(child, see);
    }
}

/// What is drawn of space: the rays, the lights and objects that are not far from them, and a little air.
fn room(scene: &Scene, involved: &BTreeSet<usize>, points: Vec<DVec3>) -> Aabb {
    let mut room = Aabb::of_points(points);
    for &i in involved {
        let bounds = scene.objects[i].bounds();
        if bounds.is_finite() && !is_far(&room, bounds) {
            room = room.union(bounds);
        }
    }
    let lights = scene.lights.iter().filter_map(|light| match light {
        Light::Point(point) => Some(Aabb::of_points([point.position])),
        Light::Spot(spot) => Some(Aabb::of_points([spot.point().position])),
        Light::Area(area) => {
            let (center, radius) = area.emitter.ball();
            Some(Aabb::new(center - radius, center + radius))
        }
        Light::Directional(_) => None,
    });
    let others = scene.objects.iter().map(|o| *o.bounds()).filter(Aabb::is_finite);
    for bounds in lights.chain(others) {
        if !is_far(&room, &bounds) {
            room = room.union(&bounds);
        }
    }
    let air = 0.05 * (room.max - room.min).max_element();
    Aabb::new(room.min - air, room.max + air)
}

/// Would the whole be many times as large with it?
fn is_far(room: &Aabb, bounds: &Aabb) -> bool {
    let size = |b: &Aabb| (b.max - b.min).max_element();
    size(room) > 0.0 && size(&room.union(bounds)) > FAR * size(room)
}
