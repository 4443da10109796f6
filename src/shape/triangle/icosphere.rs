//! A closed mesh to try tests on.

use glam::DVec3;

/// The unit sphere as triangles, counter-clockwise from outside: an icosahedron, each face split in four `levels` times.
///
/// Corners shared by faces are equal to the bit.
///
/// - Domain: `20 · 4^levels` faces; levels up to 12 fit any machine.
pub fn icosphere(levels: u32) -> Vec<[DVec3; 3]> {
    let half = |a: DVec3, b: DVec3| (a + b).normalize();
    (0..levels).fold(icosahedron(), |faces, _| {
        let quarters = faces.iter().flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (half(a, b), half(b, c), half(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        });
        quarters.collect()
    })
}

/// Corners `(0, ±1, ±φ)` and its turns, `φ = (1 + √5)/2`; faces are the triples at the length of an edge, 1.05.
fn icosahedron() -> Vec<[DVec3; 3]> {
    let golden = 0.5 + 1.25f64.sqrt();
    let corner = |i: usize| {
        let (a, b) = ([1.0, -1.0][i % 2], [golden, -golden][i / 2 % 2]);
        DVec3::from_array([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]][i / 4]).normalize()
    };
    // The next longer distance of two corners is 1.70.
    let near = |a: DVec3, b: DVec3| a.distance(b) < 1.4;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [a, b, c] = [corner(i), corner(j), corner(k)];
                if near(a, b) && near(b, c) && near(c, a) {
                    let is_outward = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if is_outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}
