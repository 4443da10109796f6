//! The only list of lessons, and what each leaves behind when it has run.

mod record;

pub use record::{ClaimRecord, FigureRecord, LessonRecord};

/// A lesson's place in the course.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    pub number: u32,
    /// The word in file names: `lessons/02_sphere.rs`, `figures/02_sphere_…`.
    pub name: &'static str,
    pub question: &'static str,
    pub chapter: &'static str,
    /// Modules that appear for the first time; a lesson may import these, those of earlier lessons, and
    /// what every lesson may: floors 0–2, `scene`, `render`, `kit`.
    pub introduces: &'static [&'static str],
    /// Numbers of the lessons to read before, and what each one gave.
    pub builds_on: &'static [(u32, &'static str)],
}

/// Every lesson, in order.
pub const SYLLABUS: &[Entry] = &[
    Entry {
        number: 1,
        name: "pinhole",
        question: "How does a hole make a picture, and why do we trace light backwards?",
        chapter: "Seeing",
        introduces: &[],
        builds_on: &[],
    },
    Entry {
        number: 2,
        name: "sphere",
        question: "Which of three formulas for a ray and a sphere survives distance, and what does it cost?",
        chapter: "Seeing",
        introduces: &["shape::sphere", "shape"],
        builds_on: &[(1, "a pixel becomes a ray")],
    },
    Entry {
        number: 3,
        name: "first_picture",
        question: "What does each stage of a first picture cost, and what does it buy?",
        chapter: "Seeing",
        introduces: &["integrator", "light", "scene_file", "shape::cuboid"],
        builds_on: &[(1, "a pixel becomes a ray"), (2, "a ray meets a sphere")],
    },
    Entry {
        number: 4,
        name: "flat_things",
        question: "Which ray–triangle test lets no ray through a closed surface, and what does it cost?",
        chapter: "Surfaces",
        introduces: &["shape::plane", "shape::disc", "shape::polygon", "shape::triangle"],
        builds_on: &[(2, "a ray meets a sphere"), (3, "a light, a shadow and a first picture")],
    },
    Entry {
        number: 5,
        name: "torus",
        question: "Which quartic solver should a torus use?",
        chapter: "Surfaces",
        introduces: &["shape::torus", "shape::instance"],
        builds_on: &[(2, "moving the origin saves the quadratic"), (3, "shadow rays start on surfaces")],
    },
    Entry {
        number: 6,
        name: "quadrics",
        question: "When does the general quadric lose to a dedicated shape, in time and in digits?",
        chapter: "Surfaces",
        introduces: &[],
        builds_on: &[(2, "a ray meets a sphere"), (3, "a scene, a light, a picture")],
    },
    Entry {
        number: 7,
        name: "frames",
        question: "What does it cost to move, turn and stretch a shape, and where do frames break?",
        chapter: "Surfaces",
        introduces: &[],
        builds_on: &[(1, "the camera's right, up and forward"), (6, "shapes along the axes")],
    },
    Entry {
        number: 8,
        name: "marching",
        question: "When may a ray leap, how far, and what does it miss?",
        chapter: "Surfaces",
        introduces: &["sdf", "shape::cylinder", "shape::cone"],
        builds_on: &[
            (2, "a ray meets a sphere"),
            (5, "a surface of degree four"),
            (6, "cylinders and cones"),
        ],
    },
    Entry {
        number: 9,
        name: "julia",
        question: "How far may a ray leap towards a fractal before it leaps too far?",
        chapter: "Surfaces",
        introduces: &["sdf"],
        builds_on: &[
            (2, "a ray meets a sphere"),
            (5, "certified signs; missed and false hits"),
            (8, "rays that march"),
        ],
    },
    Entry {
        number: 10,
        name: "csg",
        question: "How does a ray find its way through solids made of solids, and which rules break?",
        chapter: "Surfaces",
        introduces: &["csg", "shape::cylinder"],
        builds_on: &[(3, "a scene, a light, a picture"), (4, "rays along faces"), (7, "a shape under a map")],
    },
    Entry {
        number: 11,
        name: "meshes",
        question: "How many triangles is a round thing worth, and what breaks a mesh?",
        chapter: "Surfaces",
        introduces: &["mesh"],
        builds_on: &[(4, "a ray meets a triangle"), (6, "a ray meets a cylinder")],
    },
    Entry {
        number: 12,
        name: "nearest_of_many",
        question: "How does a ray find the nearest of a million things, and from how many on does it pay to ask?",
        chapter: "Surfaces",
        introduces: &["accel"],
        builds_on: &[(4, "the watertight triangle"), (11, "meshes")],
    },
    Entry {
        number: 13,
        name: "lambert",
        question: "What does each simplification of local light cost the picture, and what does it save?",
        chapter: "Light and matter",
        introduces: &["bsdf"],
        builds_on: &[(3, "a light, a shadow and a first picture")],
    },
    Entry {
        number: 14,
        name: "colour",
        question: "What do three numbers keep of a colour, and what does each shortcut lose?",
        chapter: "Light and matter",
        introduces: &[],
        builds_on: &[(3, "a first picture: radiance in three channels")],
    },
    Entry {
        number: 15,
        name: "highlights",
        question: "Which formula for a highlight is worth its time, and what do the others get wrong?",
        chapter: "Light and matter",
        introduces: &[],
        builds_on: &[(13, "Lambert's law and ambient light")],
    },
    Entry {
        number: 16,
        name: "reflection_models",
        question: "Which reflection models create or lose light, where, and what does the exact one cost?",
        chapter: "Light and matter",
        introduces: &["fresnel"],
        builds_on: &[(3, "a light, a shadow and a first picture")],
    },
    Entry {
        number: 17,
        name: "lights",
        question: "What does each kind of light ask of a shadow ray, and what does remembering the last blocker save?",
        chapter: "Light and matter",
        introduces: &[],
        builds_on: &[(3, "a light, a shadow and a first picture"), (13, "Lambert's law")],
    },
    Entry {
        number: 18,
        name: "self_intersection",
        question: "How far off its surface must a ray start, so that it meets no shadow of its own and lets no light leak?",
        chapter: "Light and matter",
        introduces: &[],
        builds_on: &[
            (2, "a ray meets a sphere"),
            (3, "shadow rays start on surfaces"),
            (17, "lights and hard shadows"),
        ],
    },
    Entry {
        number: 19,
        name: "area_lights",
        question: "How many shadow rays does a soft shadow need, and where on the light should they end?",
        chapter: "Light and matter",
        introduces: &[],
        builds_on: &[(17, "lights and hard shadows"), (18, "where shadow rays start")],
    },
];

impl Entry {
    /// `02_sphere`: the stem of the lesson's source and the prefix of its files.
    pub fn stem(&self) -> String {
        format!("{:02}_{}", self.number, self.name)
    }

    /// `lesson_02`: the program.
    pub fn program(&self) -> String {
        format!("lesson_{:02}", self.number)
    }
}

/// The entry of a lesson.
pub fn entry(number: u32) -> Option<&'static Entry> {
    SYLLABUS.iter().find(|e| e.number == number)
}
