//! Running the command in a folder of its own.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A scene that renders at once: a sphere and a point light. It says nothing about the picture's size.
pub const SCENE: &str = "Camera { POV 0 0 5 POI 0 0 0 }\nMaterial { Name m }\n\
                         Sphere { Material m Radius 1 }\nPointLight { Position 3 4 5 }\n";

/// The project's own folder: the nearest above that has a README.
pub fn root() -> PathBuf {
    let above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    above
        .into_iter()
        .find(|folder| folder.join("README.md").exists())
        .expect("the project's folder")
        .to_path_buf()
}

/// A fresh empty folder, named after the test.
pub struct Bench {
    pub folder: PathBuf,
}

/// How a run ended.
pub struct Ran {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Bench {
    pub fn new(name: &str) -> Bench {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli_{name}"));
        let _ = fs::remove_dir_all(&folder); // left by an earlier run
        fs::create_dir_all(&folder).expect("a folder for the test");
        Bench { folder }
    }

    /// As [`Bench::new`], with the scene `s.scene` in it.
    pub fn with_scene(name: &str) -> Bench {
        let bench = Bench::new(name);
        bench.write("s.scene", SCENE.as_bytes());
        bench
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder for the file");
        fs::write(path, bytes).expect("a file for the test");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Every file below the folder, sorted.
    pub fn files(&self) -> Vec<String> {
        let (mut found, mut open) = (Vec::new(), vec![self.folder.clone()]);
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(folder).expect("a folder").flatten() {
                let path = entry.path();
                if path.is_dir() {
                    open.push(path);
                } else {
                    let inside = path.strip_prefix(&self.folder).expect("inside");
                    found.push(inside.display().to_string());
                }
            }
        }
        found.sort();
        found
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lightbench"));
        command.current_dir(&self.folder).args(args).stdin(Stdio::null());
        command.env_remove("RUST_BACKTRACE").env("TERM", "xterm");
        command
    }

    pub fn run(&self, args: &[&str]) -> Ran {
        ran(args, self.command(args).output().expect("the command runs"))
    }

    /// Splits a line at its spaces.
    pub fn line(&self, line: &str) -> Ran {
        self.run(&line.split_whitespace().collect::<Vec<_>>())
    }

    pub fn fed(&self, args: &[&str], input: &[u8]) -> Ran {
        let mut command = self.command(args);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the command runs");
        let mut stdin = child.stdin.take().expect("a pipe");
        let input = input.to_vec();
        let feeder = std::thread::spawn(move || {
            let _ = stdin.write_all(&input); // it may stop reading early
        });
        let output = child.wait_with_output().expect("the command ends");
        feeder.join().expect("the feeder ends");
        ran(args, output)
    }
}

fn ran(args: &[&str], output: Output) -> Ran {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the command speaks UTF-8");
    let ran = Ran { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) };
    for word in ["panicked", "RUST_BACKTRACE", "stack backtrace"] {
        assert!(!ran.err.contains(word), "{args:?} panics:\n{}", ran.err);
    }
    ran
}

impl Ran {
    /// Ended well.
    #[track_caller]
    pub fn done(self) -> Ran {
        assert_eq!(self.code, Some(0), "stderr:\n{}", self.err);
        self
    }

    /// Ended with a code and nothing on stdout; the message contains every word.
    #[track_caller]
    pub fn refused(self, code: i32, words: &[&str]) -> Ran {
        assert_eq!(self.code, Some(code), "stderr:\n{}", self.err);
        assert_eq!(self.out, "", "a refusal prints no result");
        for word in words {
            assert!(self.err.contains(word), "`{word}` is not in the message:\n{}", self.err);
        }
        self
    }
}
