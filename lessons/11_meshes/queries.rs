//! Three ways to store the same faces, and what each has to read for an answer.

use lightbench::measure::{Spread, time_each};
use lightbench::mesh::{EdgeList, HalfEdges, Polygons, Topology, tessellate};
use lightbench_kit::lesson::Lesson;

/// A question, and what its answer takes with polygons, with edges, and with half-edges.
pub struct Query {
    pub question: &'static str,
    /// Indices read for one answer.
    pub reads: [f64; 3],
    pub times: [Spread; 3],
}

pub struct Stored {
    pub topology: Topology,
    /// Memory of faces and what is between, without the points [bytes].
    pub bytes: [usize; 3],
    pub queries: Vec<Query>,
}

impl Stored {
    /// Do half-edges read less than a permille for a one-ring, and take more memory?
    pub fn half_edges_pay(&self) -> bool {
        let ring = self.queries[0].reads;
        let [polygons, _, half] = self.bytes;
        1000.0 * ring[2] < ring[0] && half > polygons
    }
}

/// Vertices and faces that are asked about.
const ASKED: usize = 8;

pub fn compare(lesson: &Lesson) -> Stored {
    let mesh = tessellate::bumpy_knot(lesson.pick([100, 1000, 1000, 1000]), 35)
        .triangulated()
        .expect("short outlines")
        .mesh;
    let (list, half) = (EdgeList::of(&mesh), HalfEdges::of(&mesh).expect("a manifold"));
    let corners = mesh.corner_count();
    let points: Vec<u32> = (0..ASKED).map(|i| (i * mesh.points.len() / ASKED) as u32).collect();
    let faces: Vec<u32> = (0..ASKED).map(|i| (i * mesh.len() / ASKED) as u32).collect();
    let spokes = points.iter().map(|&v| half.around(v).count()).sum::<usize>() as f64 / ASKED as f64;
    let sides = faces.iter().map(|&f| half.sides(f).count()).sum::<usize>() as f64 / ASKED as f64;
    let per = |work: &dyn Fn() -> usize| time_each(ASKED, work);
    let each = |all: &[u32], ask: &dyn Fn(u32) -> usize| all.iter().map(|&i| ask(i)).sum::<usize>();
    let queries = vec![
        Query {
            question: "which points are joined to a point (its one-ring)?",
            // All corners; both ends of all edges; of each spoke the twin, its next, its next's origin.
            reads: [corners as f64, 2.0 * list.edges.len() as f64, 3.0 * spokes],
            times: [
                per(&|| each(&points, &|v| ring_of_polygons(&mesh, v).len())),
                per(&|| each(&points, &|v| list.edges.iter().filter(|e| e.contains(&v)).count())),
                per(&|| each(&points, &|v| half.one_ring(v).count())),
            ],
        },
        Query {
            question: "which faces lie across the edges of a face?",
            // All corners; all sides; of each side the twin, its face, and the next side.
            reads: [corners as f64, corners as f64, 3.0 * sides],
            times: [
                per(&|| each(&faces, &|f| neighbours_of_polygons(&mesh, f as usize))),
                per(&|| each(&faces, &|f| neighbours_of_edges(&list, f as usize, mesh.len()))),
                per(&|| each(&faces, &|f| half.neighbours(f).count())),
            ],
        },
        Query {
            question: "is the surface closed?",
            // Sorting compares every side with log₂ of their number of others; else every side is read once.
            reads: [corners as f64 * (corners as f64).log2(), corners as f64, corners as f64],
            times: [
                time_each(1, || Topology::of(&mesh).is_closed()),
                time_each(1, || list.uses().iter().all(|u| u[0] == u[1])),
                time_each(1, || half.is_closed()),
            ],
        },
    ];
    let points = size_of_val(&mesh.points[..]);
    Stored {
        topology: Topology::of(&mesh),
        bytes: [mesh.bytes() - points, list.bytes(), half.bytes()],
        queries,
    }
}

/// The points next to a point in some face.
fn ring_of_polygons(mesh: &Polygons, point: u32) -> Vec<u32> {
    let mut ring: Vec<u32> = mesh
        .faces_around(point)
        .flat_map(|f| {
            let face = mesh.face(f);
            let at = face.iter().position(|p| *p == point).unwrap_or(0);
            [face[(at + 1) % face.len()], face[(at + face.len() - 1) % face.len()]]
        })
        .collect();
    ring.sort_unstable();
    ring.dedup();
    ring
}

fn neighbours_of_polygons(mesh: &Polygons, face: usize) -> usize {
    let own = mesh.face(face);
    let shares = |f: usize| mesh.face(f).iter().filter(|p| own.contains(p)).count() == 2;
    (0..mesh.len()).filter(|&f| shares(f)).count()
}

/// Faces that name one of the edges of a face: every triangle has three sides.
fn neighbours_of_edges(list: &EdgeList, face: usize, faces: usize) -> usize {
    let edge = |f: usize, k: usize| list.sides[3 * f + k] / 2;
    let own = [0, 1, 2].map(|k| edge(face, k));
    (0..faces).filter(|&f| f != face && (0..3).any(|k| own.contains(&edge(f, k)))).count()
}
