//! The floors: a module imports strictly lower floors only.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Module → floor, as the table at the head of `src/lib.rs` says.
pub fn floors() -> BTreeMap<String, u32> {
    let text = fs::read_to_string("src/lib.rs").expect("src/lib.rs");
    let mut floors = BTreeMap::new();
    for line in text.lines().filter_map(|l| l.strip_prefix("//! | ")) {
        let mut cells = line.split('|');
        let Some(Ok(floor)) = cells.next().map(|c| c.trim().parse::<u32>()) else { continue };
        let names = cells.next().unwrap_or_default();
        for name in names.split(',') {
            floors.insert(name.trim().trim_matches(['[', ']', '`', '*']).to_string(), floor);
        }
    }
    floors
}

fn rust_files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the project").flatten() {
        let path = entry.path();
        if path.is_dir() {
            rust_files(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// The top-level modules that a source text names after `root` (`crate::` or `lightbench::`).
pub fn imports(text: &str, root: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("//") {
            continue;
        }
        for (at, _) in line.match_indices(root) {
            let rest = &line[at + root.len()..];
            let names: Vec<&str> = match rest.strip_prefix('{') {
                Some(list) => list.split('}').next().unwrap_or_default().split(',').collect(),
                None => vec![rest],
            };
            for name in names {
                let name: String =
                    name.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                found.push((number + 1, name));
            }
        }
    }
    found
}

#[test]
fn every_module_stands_on_a_floor() {
    let floors = floors();
    let text = ["src/lib.rs", "src/kit/lib.rs"].map(|file| fs::read_to_string(file).expect(file)).concat();
    let mut declared: Vec<String> = text
        .lines()
        .filter_map(|l| l.strip_prefix("pub mod ").and_then(|l| l.strip_suffix(';')))
        .map(str::to_string)
        .collect();
    declared.push("command".to_string());
    assert!(!declared.is_empty());
    for module in &declared {
        assert!(
            floors.contains_key(module),
            "module `{module}` stands on no floor in the table of src/lib.rs"
        );
    }
    for module in floors.keys() {
        assert!(
            declared.contains(module),
            "the table of src/lib.rs has a module `{module}` that does not exist"
        );
    }
}

#[test]
fn modules_import_strictly_lower_floors() {
    let floors = floors();
    let mut files = Vec::new();
    rust_files(Path::new("src"), &mut files);
    let mut wrong = Vec::new();
    for file in files {
        let inside = file.strip_prefix("src/kit").or(file.strip_prefix("src")).expect("a file of src");
        let module =
            inside.components().next().expect("a name").as_os_str().to_string_lossy().replace(".rs", "");
        let Some(floor) = floors.get(&module) else { continue }; // lib.rs, main.rs
        let text = fs::read_to_string(&file).expect("a source file");
        for (line, used) in imports(&text, "crate::") {
            match floors.get(&used) {
                Some(below) if below < floor || used == module => {}
                Some(below) => wrong.push(format!(
                    "{}:{line}: floor {floor} imports `{used}` of floor {below}",
                    file.display()
                )),
                None => {} // a macro, or a name that the compiler will refuse
            }
        }
    }
    assert!(wrong.is_empty(), "imports that go up or sideways:\n{}", wrong.join("\n"));
}

#[test]
fn the_law_sees_every_way_to_import() {
    let text = "use crate::{num, ray::Ray};\n// crate::kit\nlet x = crate::render::replay();\n";
    let found: Vec<String> = imports(text, "crate::").into_iter().map(|(_, name)| name).collect();
    assert_eq!(found, ["num", "ray", "render"]);
}

#[test]
fn files_are_short_enough_to_read() {
    let mut files = Vec::new();
    rust_files(Path::new("src"), &mut files);
    for file in files {
        let lines = fs::read_to_string(&file).expect("a source file").lines().count();
        assert!(lines <= 520, "{} has {lines} lines; split it by thing", file.display());
    }
}
