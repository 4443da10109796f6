//! The first reading of an OBJ file: is every line right, and what does it mean?

use super::line::{Line, Word, lines, number};
use super::mtl::{self, MtlMaterial};
use super::{Face, Library, MOST_FINDINGS};
use crate::scene_file::diagnostic::{Diagnostic, Diagnostics, Severity, Span, quoted};
use std::collections::HashSet;
use std::fmt::Write;

/// What the first reading leaves for the second.
pub struct Checked {
    /// The polygons in the plainest words.
    pub plain: String,
    pub faces: Vec<Face>,
    pub materials: Vec<MtlMaterial>,
    pub log: Vec<Diagnostic>,
    /// Of the material libraries.
    pub files: Vec<Diagnostics>,
}

impl Checked {
    pub fn is_right(&self) -> bool {
        let is_error = |d: &Diagnostic| d.severity == Severity::Error;
        !self.log.iter().any(is_error) && self.files.iter().all(|f| f.errors().next().is_none())
    }
}

/// Lists that faces count in.
const LISTS: [(&str, &str); 3] = [("v", "point"), ("vt", "texture coordinate"), ("vn", "normal")];

/// Words of the format that change no polygon.
const QUIET: &[&str] = &[
    "o",
    "g",
    "s",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "maplib",
    "usemap",
];
/// Words for things that are not polygons; their data.
const OTHER: &[&str] = &[
    "l", "p", "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
    "sp", "end", "con", "ctech", "stech", "call", "csh",
];

struct Reader<'a> {
    text: &'a str,
    out: Checked,
    /// Faces and materials in plain words; points come first, so that a face may name one that stands below it.
    faces: String,
    /// How many of each of the [`LISTS`] there are in all, and above the line at hand.
    totals: [usize; 3],
    above: [usize; 3],
    /// Words that were remarked upon; once is enough.
    remarked: HashSet<&'a str>,
}

pub fn check(text: &str, library: &dyn Fn(&str) -> Library) -> Checked {
    let mut totals = [0; 3];
    for line in lines(text) {
        if let Some(list) = LISTS.iter().position(|(word, _)| *word == line.keyword.text) {
            totals[list] += 1;
        }
    }
    let (plain, faces, files) = (String::new(), Vec::new(), Vec::new());
    let out = Checked { plain, faces, materials: Vec::new(), log: Vec::new(), files };
    let mut reader =
        Reader { text, out, faces: String::new(), totals, above: [0; 3], remarked: HashSet::new() };
    for line in lines(text) {
        if let Err(d) = reader.line(&line, library) {
            reader.out.log.push(*d);
        }
        if reader.out.log.len() >= MOST_FINDINGS {
            break;
        }
    }
    if reader.out.faces.is_empty() && reader.out.is_right() {
        let end = text.trim_end().len();
        let d = Diagnostic::error(end..end, "the file has no face");
        reader.out.log.push(d.expected("lines such as `f 1 2 3`"));
    }
    reader.out.plain.push_str("mtllib all\n"); // answered with the list at hand
    reader.out.plain.push_str(&reader.faces);
    reader.out
}

type Checks = Result<(), Box<Diagnostic>>;

impl<'a> Reader<'a> {
    fn line(&mut self, line: &Line<'a>, library: &dyn Fn(&str) -> Library) -> Checks {
        match line.keyword.text {
            "v" => self.point(line),
            "vt" => self.texture(line),
            "vn" => self.normal(line),
            "f" | "fo" => self.face(line),
            "usemtl" => self.use_material(line),
            "mtllib" => self.library(line, library),
            "s" if self.totals[2] == 0 => self.once(
                line,
                Severity::Note,
                "smoothing groups are not read: normals follow the crease angle",
                "",
            ),
            word if QUIET.contains(&word) => Ok(()),
            word if OTHER.contains(&word) => {
                let message = format!("`{word}` is left out: only polygons are read");
                self.once(line, Severity::Warning, &message, "faces, `f 1 2 3`")
            }
            word => {
                let message = format!("{} is no word of the format; the line is skipped", quoted(word));
                self.once(
                    line,
                    Severity::Warning,
                    &message,
                    "`v`, `vt`, `vn`, `f`, `g`, `o`, `s`, `usemtl`, `mtllib`",
                )
            }
        }
    }

    /// A remark about a word, the first time that it occurs.
    fn once(&mut self, line: &Line<'a>, severity: Severity, message: &str, expected: &str) -> Checks {
        if self.remarked.insert(line.keyword.text) {
            let d = Diagnostic::new(severity, line.keyword.span(), message);
            self.out.log.push(if expected.is_empty() { d } else { d.expected(expected) });
        }
        Ok(())
    }

    fn point(&mut self, line: &Line<'a>) -> Checks {
        self.above[0] += 1;
        let n = line.words.len();
        if !matches!(n, 3 | 4 | 6 | 7) {
            return Err(Box::new(
                line.miscounted("3 coordinates (and after them a weight, or 3 colours)", 7),
            ));
        }
        let mut p = [0.0; 4];
        for (i, word) in line.words.iter().enumerate() {
            let x = number(word, "as a coordinate, weight or colour")?;
            if i < 4 {
                p[i] = x;
            }
        }
        if matches!(n, 6 | 7) {
            self.once_about("colours", line, "colours of points are not read")?;
        }
        if n == 7 {
            let message = "7 numbers of a point are read as x y z w r g b";
            let help = "for x y z r g b a, leave out the last number";
            if self.remarked.insert(message) {
                self.out.log.push(Diagnostic::note(line.span(), message).help(help));
            }
        }
        let weight = if matches!(n, 4 | 7) { p[3] } else { 1.0 };
        if weight == 0.0 {
            let d =
                Diagnostic::error(line.words[3].span(), "the weight of a point is 0: it lies at infinity");
            return Err(Box::new(d.expected("a number other than 0").found(quoted(line.words[3].text))));
        }
        let [x, y, z] = [p[0], p[1], p[2]].map(|x| x / weight);
        if ![x, y, z].iter().all(|x| x.is_finite()) {
            let d = Diagnostic::error(line.span(), "divided by its weight, the point is infinitely far");
            return Err(Box::new(d.expected("a point within the range of numbers")));
        }
        if weight != 1.0 {
            self.once_about("weights", line, "points are divided by their weights")?;
        }
        let _ = writeln!(self.out.plain, "v {x} {y} {z}");
        Ok(())
    }

    fn once_about(&mut self, what: &'static str, line: &Line<'a>, message: &str) -> Checks {
        if self.remarked.insert(what) {
            self.out.log.push(Diagnostic::note(line.span(), message));
        }
        Ok(())
    }

    fn texture(&mut self, line: &Line<'a>) -> Checks {
        self.above[1] += 1;
        if !(1..=3).contains(&line.words.len()) {
            return Err(Box::new(line.miscounted("2 coordinates, u and v (1 and 3 will do)", 3)));
        }
        let mut uv = [0.0; 3];
        for (x, word) in uv.iter_mut().zip(&line.words) {
            *x = number(word, "as a texture coordinate")?;
        }
        let _ = writeln!(self.out.plain, "vt {} {}", uv[0], uv[1]);
        Ok(())
    }

    fn normal(&mut self, line: &Line<'a>) -> Checks {
        self.above[2] += 1;
        if line.words.len() != 3 {
            return Err(Box::new(line.miscounted("3 coordinates", 3)));
        }
        let mut n = [0.0; 3];
        for (x, word) in n.iter_mut().zip(&line.words) {
            *x = number(word, "as a coordinate")?;
        }
        if n == [0.0; 3] {
            self.once_about(
                "normals",
                line,
                "a normal is 0: corners that use it count as corners without a normal",
            )?;
        }
        let _ = writeln!(self.out.plain, "vn {} {} {}", n[0], n[1], n[2]);
        Ok(())
    }

    fn face(&mut self, line: &Line<'a>) -> Checks {
        if line.words.len() < 3 {
            let d = Diagnostic::error(line.span(), "a face has too few corners");
            return Err(Box::new(d.expected("at least 3 corners").found(line.words.len().to_string())));
        }
        let start = self.faces.len();
        self.faces.push('f');
        let mut given: Option<[bool; 3]> = None;
        for word in &line.words {
            let indices = self.corner(word).inspect_err(|_| self.faces.truncate(start))?;
            let has = indices.map(|i| i.is_some());
            let first = *given.get_or_insert(has);
            if first != has {
                self.faces.truncate(start);
                let d = Diagnostic::error(word.span(), "the corners of a face are not alike");
                let like = quoted(line.words[0].text);
                return Err(Box::new(d.expected(format!("parts as in {like}")).found(quoted(word.text))));
            }
            let part = |i: Option<usize>| i.map_or(String::new(), |i| i.to_string());
            let _ = write!(self.faces, " {}/{}/{}", part(indices[0]), part(indices[1]), part(indices[2]));
        }
        self.faces.push('\n');
        let [_, uvs, normals] = given.unwrap_or_default();
        self.out.faces.push(Face { span: line.span(), uvs, normals });
        Ok(())
    }

    /// The indices of a corner, `v`, `v/vt`, `v//vn` or `v/vt/vn`, counted from 1.
    fn corner(&self, word: &Word) -> Result<[Option<usize>; 3], Box<Diagnostic>> {
        let wrong = |message: String| Diagnostic::error(word.span(), message);
        let mut indices = [None; 3];
        let mut at = word.span().start;
        for (list, text) in word.text.split('/').enumerate() {
            let place = at..at + text.len();
            at = place.end + 1;
            if list == 3 {
                let d = wrong(format!("{} has too many parts", quoted(word.text)));
                return Err(Box::new(
                    d.expected("`v`, `v/vt`, `v//vn` or `v/vt/vn`").found(quoted(word.text)),
                ));
            }
            if !text.is_empty() {
                indices[list] = Some(self.index(text, place, list)?);
            }
        }
        if indices[0].is_none() {
            let d = wrong(format!("{} names no point", quoted(word.text)));
            return Err(Box::new(d.expected("the index of a point").found(quoted(word.text))));
        }
        Ok(indices)
    }

    /// An index, from 1 or, negative, backwards from the line at hand.
    fn index(&self, text: &str, place: Span, list: usize) -> Result<usize, Box<Diagnostic>> {
        let (what, total, above) = (LISTS[list].1, self.totals[list], self.above[list]);
        let Ok(index) = text.parse::<i64>() else {
            let d = Diagnostic::error(place, format!("{} is not the index of a {what}", quoted(text)));
            return Err(Box::new(d.expected("a whole number").found(quoted(text))));
        };
        let absolute = if index < 0 { above as i64 + index.max(-(1 << 40)) + 1 } else { index };
        if index != 0 && (1..=total as i64).contains(&absolute) {
            return Ok(absolute as usize);
        }
        let d = Diagnostic::error(place, format!("there is no {what} {index}"));
        let expected = match (total, index < 0) {
            (0, _) => format!("no index: the file has no {what}s (`{}`)", LISTS[list].0),
            (_, true) => format!("-1 to -{above}, or 1 to {total}"),
            (_, false) => format!("1 to {total}, or backwards from -1"),
        };
        Err(Box::new(d.expected(expected).found(quoted(text))))
    }

    fn use_material(&mut self, line: &Line<'a>) -> Checks {
        let Some((name, span)) = line.name(self.text) else {
            let d = Diagnostic::error(line.span(), "`usemtl` names no material");
            return Err(Box::new(d.expected("the name of a material")));
        };
        if !self.out.materials.iter().any(|m| m.name == name) && self.remarked.insert(name) {
            let message = format!("no material library declares {}", quoted(name));
            let d = Diagnostic::warning(span, message).expected("the name of a `newmtl`");
            self.out.log.push(d.help("its faces count as faces without a material"));
        }
        // Names may hold anything but a line's end, and no two spaces in a row get lost in one word.
        let _ = writeln!(self.faces, "usemtl {}", name.replace(['\n', '\r'], " "));
        Ok(())
    }

    /// One library, whose name may hold spaces, or several.
    fn library(&mut self, line: &Line<'a>, library: &dyn Fn(&str) -> Library) -> Checks {
        let Some((whole, span)) = line.name(self.text) else {
            let d = Diagnostic::error(line.span(), "`mtllib` names no file");
            return Err(Box::new(d.expected("the name of a material library")));
        };
        let found = library(whole);
        if found.is_some() || line.words.len() == 1 {
            self.open(whole, span, found);
        } else {
            line.words.iter().for_each(|w| self.open(w.text, w.span(), library(w.text)));
        }
        Ok(())
    }

    fn open(&mut self, name: &str, span: Span, found: Library) {
        let missing =
            |why: String| Diagnostic::note(span, why).help("faces count as faces without a material");
        match found {
            None => self.out.log.push(missing(format!("there is no material library {}", quoted(name)))),
            Some(Err(error)) => self.out.log.push(missing(error.to_string())),
            Some(Ok((path, text))) => {
                let (materials, remarks) = mtl::read(&text, &path);
                self.out.materials.extend(materials);
                self.out.files.extend(Some(remarks).filter(|r| !r.is_empty()));
            }
        }
    }
}
