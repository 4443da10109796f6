//! Material libraries of OBJ files.

use super::MOST_FINDINGS;
use super::line::{Line, Word, lines, number};
use crate::color::Rgb;
use crate::scene_file::diagnostic::{Diagnostic, Diagnostics, quoted};
use glam::DVec3;
use std::fmt::Write;

/// A material of a library, as far as it is written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MtlMaterial {
    pub name: String,
    /// `Kd`: share of light sent back in all directions.
    pub diffuse: Option<Rgb>,
    /// `Ks`: share of light sent back about the mirror direction.
    pub specular: Option<Rgb>,
    /// `Ke`: radiance of its own [W m⁻² sr⁻¹].
    pub emissive: Option<Rgb>,
    /// `Ns`: Phong's exponent.
    pub shininess: Option<f64>,
    /// `d`, or 1 less `Tr`: 0 clear … 1 opaque.
    pub opacity: Option<f64>,
    /// `Ni`: absolute index of refraction.
    pub ior: Option<f64>,
}

/// Which numbers a word takes.
#[derive(Clone, Copy)]
enum Takes {
    /// Three shares in [0, 1].
    Shares,
    /// Three numbers from 0.
    Color,
    /// One number in a range.
    One(f64, f64),
}

/// Words whose values count here.
const NUMBERS: &[(&str, Takes)] = &[
    ("Ka", Takes::Color),
    ("Kd", Takes::Shares),
    ("Ks", Takes::Shares),
    ("Ke", Takes::Color),
    ("Ns", Takes::One(0.0, f64::MAX)),
    ("d", Takes::One(0.0, 1.0)),
    ("Tr", Takes::One(0.0, 1.0)),
    ("Ni", Takes::One(0.0, f64::MAX)),
];

/// Reads the materials of a library; `name` is what messages call it. What is wrong is left out of them.
pub fn read(text: &str, name: &str) -> (Vec<MtlMaterial>, Diagnostics) {
    let mut log = Vec::new();
    let mut plain = String::new();
    let mut declared = false;
    for line in lines(text) {
        if log.len() >= MOST_FINDINGS {
            break;
        }
        match check(&line, text, &mut declared, &mut plain) {
            Ok(None) => {}
            Ok(Some(remark)) => log.push(*remark),
            Err(error) => log.push(*error),
        }
    }
    let materials = match tobj::load_mtl_buf(&mut plain.as_bytes()) {
        Ok((materials, _)) => materials,
        Err(error) => {
            log.push(Diagnostic::error(0..0, format!("tobj refuses the library: {error}")));
            Vec::new()
        }
    };
    let color = |c: Option<[f64; 3]>| c.map(DVec3::from);
    let material = |m: tobj::Material| MtlMaterial {
        diffuse: color(m.diffuse),
        specular: color(m.specular),
        emissive: color(m.emissive),
        shininess: m.shininess,
        opacity: m.dissolve,
        ior: m.optical_density,
        name: m.name,
    };
    (materials.into_iter().map(material).collect(), Diagnostics::new(name, text, log))
}

type Remark = Option<Box<Diagnostic>>;

/// Checks a line, and writes it down in plain words if it counts.
fn check(
    line: &Line,
    text: &str,
    declared: &mut bool,
    plain: &mut String,
) -> Result<Remark, Box<Diagnostic>> {
    let word = line.keyword.text;
    if word == "newmtl" {
        let Some((name, _)) = line.name(text) else {
            let d = Diagnostic::error(line.span(), "`newmtl` names no material");
            return Err(Box::new(d.expected("a name")));
        };
        *declared = true;
        let _ = writeln!(plain, "newmtl {}", name.replace(['\n', '\r'], " "));
        return Ok(None);
    }
    let Some((_, takes)) = NUMBERS.iter().find(|(known, _)| *known == word) else {
        let is_texture = word.starts_with("map_") || matches!(word, "bump" | "disp" | "decal" | "refl");
        let d = Diagnostic::note(
            line.span(),
            format!("`{word}` is not read: textures of libraries have no effect"),
        );
        return Ok(is_texture.then(|| Box::new(d)));
    };
    if !*declared {
        let d = Diagnostic::error(line.keyword.span(), format!("`{word}` stands before any `newmtl`"));
        return Err(Box::new(d.expected("`newmtl` and a name above it")));
    }
    let values = values(line, *takes)?;
    match (word, &values[..]) {
        ("Tr", &[x]) => writeln!(plain, "d {}", 1.0 - x),
        (_, &[x]) => writeln!(plain, "{word} {x}"),
        (_, &[r, g, b]) => writeln!(plain, "{word} {r} {g} {b}"),
        _ => Ok(()),
    }
    .ok();
    Ok(None)
}

/// The numbers of a line, each in its range.
fn values(line: &Line, takes: Takes) -> Result<Vec<f64>, Box<Diagnostic>> {
    let word = line.keyword.text;
    // `d -halo 0.5`: thinner towards the rim; the number is read, the rim is not.
    let skipped = usize::from(word == "d" && line.words.first().is_some_and(|w| w.text == "-halo"));
    let words: &[Word] = &line.words[skipped..];
    let (count, low, high) = match takes {
        Takes::Shares => (3, 0.0, 1.0),
        Takes::Color => (3, 0.0, f64::MAX),
        Takes::One(low, high) => (1, low, high),
    };
    if let Some(w) = words.first().filter(|w| matches!(w.text, "spectral" | "xyz")) {
        let d = Diagnostic::error(w.span(), format!("`{word}` in {} cannot be read", quoted(w.text)));
        return Err(Box::new(d.expected("3 numbers: red, green, blue").found(quoted(w.text))));
    }
    // One number stands for all three.
    if words.len() != count && words.len() != 1 {
        let expected = if count == 1 { "1 number" } else { "3 numbers: red, green, blue" };
        return Err(Box::new(line.miscounted(expected, count)));
    }
    let mut values = Vec::new();
    for w in words {
        let x = number(w, "as a share, colour or exponent")?;
        if !(low..=high).contains(&x) {
            let d = Diagnostic::error(w.span(), format!("`{word}` is out of range"));
            let range = if high == f64::MAX {
                format!("a number ≥ {low}")
            } else {
                format!("a number in [{low}, {high}]")
            };
            return Err(Box::new(d.expected(range).found(quoted(w.text))));
        }
        values.push(x);
    }
    if count == 3 && values.len() == 1 {
        values = vec![values[0]; 3];
    }
    Ok(values)
}
