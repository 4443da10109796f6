//! `lightbench render`: from scene files to pictures.

use super::{Failure, print};
use clap::{Args, ValueEnum};
use lightbench::film::tone::ToneMap;
use lightbench::integrator::{Local, Stage};
use lightbench::ray::RayKind;
use lightbench::render::{Control, Picture, RenderError, Rendered, render_with};
use lightbench_kit::figure::Provenance;
use lightbench_kit::file::{Format, write_as};
use lightbench_kit::flags::{Flags, PictureFormat, Quality, quoted};
use lightbench_kit::progress::{Progress, Verbosity, say, stop_flag};
use lightbench_kit::replay;
use lightbench_kit::scene_file::{self, Color, MOST_PIXELS, SceneFile, read_file};
use std::fmt::Write;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub(super) struct RenderArgs {
    /// Scene files; each makes one picture
    scenes: Vec<PathBuf>,
    /// How a ray becomes radiance (`--list` shows the ways)
    #[arg(long, value_enum, default_value_t)]
    integrator: IntegratorName,
    /// What happens to values over 1 in PNG files
    #[arg(long, value_enum, default_value_t)]
    tone: Tone,
    /// Instead of a picture: every ray of one pixel, as text and as a drawing
    #[arg(long, value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pixel: Option<(usize, usize)>,
}

/// The integrators there are to choose from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum IntegratorName {
    /// The nearest surface in its own colour, no light
    Visibility,
    /// The light of lamps and ambient light as materials reflect them, no shadows
    Unshadowed,
    /// The same with shadows
    #[default]
    Local,
}

impl IntegratorName {
    fn integrator(self) -> Local {
        let stage = match self {
            IntegratorName::Visibility => Stage::Visibility,
            IntegratorName::Unshadowed => Stage::Unshadowed,
            IntegratorName::Local => Stage::Shadowed,
        };
        Local { stage, ..Local::default() }
    }
}

/// The tone maps there are to choose from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Tone {
    /// Cut off at 1
    #[default]
    Clamp,
    /// Divide everything by the largest value
    Divide,
    /// A filmic curve
    Filmic,
}

impl Tone {
    fn map(self) -> ToneMap {
        match self {
            Tone::Clamp => ToneMap::Clamp,
            Tone::Divide => ToneMap::DivideByMaximum,
            Tone::Filmic => ToneMap::Filmic,
        }
    }
}

fn pixel(text: &str) -> Result<(usize, usize), String> {
    let parts: Option<(usize, usize)> =
        text.split_once(',').and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    parts.ok_or_else(|| {
        format!("expected column,row such as 256,128, both from 0; found {}", scene_file::quoted(text))
    })
}

/// Most rays that `--pixel` keeps; about 40 MB of text.
const MOST_REPLAYED: u64 = 1 << 18;

/// Renders one picture after the other, and prints the path of each when it stands. Nothing is rendered before all
/// scenes are read and everything that was asked for is known to be possible.
pub(super) fn render(args: &RenderArgs, flags: &Flags) -> Result<String, Failure> {
    if flags.list {
        return Ok(list());
    }
    let scenes = chosen(args, flags)?;
    let mut jobs = Vec::new();
    for path in scenes {
        let file = open(path, flags)?;
        let picture = picture(&file, flags)?;
        jobs.push((path, file, picture, target(path, args, flags)?));
    }
    for (i, job) in jobs.iter().enumerate() {
        if let Some(same) = jobs[..i].iter().find(|other| other.3 == job.3) {
            let (a, b, target) = (same.0.display(), job.0.display(), job.3.display());
            return Err(Failure::input(format!("{a} and {b} would both be written to {target}")));
        }
    }
    writable(&flags.out())?;
    for (path, file, picture, target) in &jobs {
        print(&match args.pixel {
            Some(at) => replay_pixel(path, file, *picture, at, target, args, flags)?,
            None => render_picture(path, file, *picture, target, args, flags)?,
        })?;
    }
    Ok(String::new())
}

/// The scenes that `--only` lets through.
fn chosen<'a>(args: &'a RenderArgs, flags: &Flags) -> Result<Vec<&'a Path>, Failure> {
    if args.scenes.is_empty() {
        return Err(Failure::input("render: expected scene files, found none"));
    }
    let wanted = |path: &&Path| flags.only.as_ref().is_none_or(|only| stem(path).contains(only.as_str()));
    let chosen: Vec<&Path> = args.scenes.iter().map(PathBuf::as_path).filter(wanted).collect();
    if chosen.is_empty() {
        let only = flags.only.as_deref().unwrap_or_default();
        let names: Vec<String> = args.scenes.iter().map(|path| stem(path)).collect();
        return Err(Failure::input(format!(
            "--only {only}: expected part of a name among {}",
            names.join(", ")
        )));
    }
    Ok(chosen)
}

/// What `render --list` prints.
fn list() -> String {
    let mut out = String::new();
    let mut add = |flag: &str, value: Option<clap::builder::PossibleValue>| {
        if let Some(value) = value {
            let help = value.get_help().map(ToString::to_string).unwrap_or_default();
            let _ = writeln!(out, "--{flag} {:<12} {help}", value.get_name());
        }
    };
    IntegratorName::value_variants().iter().for_each(|v| add("integrator", v.to_possible_value()));
    Tone::value_variants().iter().for_each(|v| add("tone", v.to_possible_value()));
    out
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Where the picture of a scene, or the drawing of its pixel, goes.
fn target(path: &Path, args: &RenderArgs, flags: &Flags) -> Result<PathBuf, Failure> {
    Ok(flags.out().join(match args.pixel {
        Some((x, y)) => format!("{}_pixel_{x}_{y}.svg", stem(path)),
        None => format!("{}.{}", stem(path), format(flags)?.extension()),
    }))
}

fn format(flags: &Flags) -> Result<Format, Failure> {
    Ok(match flags.format {
        None | Some(PictureFormat::Png) => Format::Png8,
        Some(PictureFormat::Png16) => Format::Png16,
        Some(PictureFormat::Exr) => Format::Exr,
        Some(PictureFormat::Hdr) => Format::Hdr,
        Some(PictureFormat::Svg | PictureFormat::Pdf) => {
            return Err(Failure::input(
                "--format: expected png, png16, exr or hdr for a render, found a format of charts",
            ));
        }
    })
}

/// Refuses, before the work, a folder that is or lies in something else.
fn writable(folder: &Path) -> Result<(), Failure> {
    match folder.ancestors().find(|f| f.exists()) {
        Some(found) if !found.is_dir() => {
            let found = found.display();
            Err(Failure::work(format!(
                "--out {}: expected a folder, found the file {found}",
                folder.display()
            )))
        }
        _ => Ok(()),
    }
}

/// Reads a scene file and says on stderr what there is to say about it.
fn open(path: &Path, flags: &Flags) -> Result<SceneFile, Failure> {
    let color = stderr_color();
    let file = read_file(path).map_err(|e| Failure::input(e.render(color)))?;
    if !flags.quiet && !file.remarks.is_empty() {
        say(&file.remarks.render(color));
    }
    Ok(file)
}

/// Colours only on a terminal that has not asked for none.
pub(super) fn stderr_color() -> Color {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty())
        || std::env::var_os("TERM").is_some_and(|t| t == "dumb");
    if std::io::stderr().is_terminal() && !refused { Color::Always } else { Color::Never }
}

/// A flag wins over the scene file, the scene file over the quality's defaults.
fn picture(file: &SceneFile, flags: &Flags) -> Result<Picture, Failure> {
    let (settings, given) = (&file.settings, &file.settings.given);
    let (side, samples) = match flags.quality() {
        Quality::Smoke => (64, 1),
        Quality::Draft => (512, 1), // the document's own defaults [D §4.3]
        Quality::Standard => (1024, 4),
        Quality::Final => (2048, 16),
    };
    let choose = |flag: Option<u16>, (given, file): (bool, u32), quality: u32| match flag {
        Some(flag) => u32::from(flag),
        None => {
            if given {
                file
            } else {
                quality
            }
        }
    };
    let width = choose(flags.width, (given.width, settings.width), side);
    let height = choose(flags.height, (given.height, settings.height), side);
    let pixels = u64::from(width) * u64::from(height);
    if pixels > MOST_PIXELS {
        let found = format!("found {width} × {height} = {pixels}");
        return Err(Failure::input(format!(
            "picture too large: expected at most {MOST_PIXELS} pixels, {found}"
        )));
    }
    Ok(Picture {
        width: width as usize,
        height: height as usize,
        samples: choose(flags.spp, (given.samples, settings.samples), samples),
        seed: flags.seed(),
    })
}

fn render_picture(
    path: &Path,
    file: &SceneFile,
    picture: Picture,
    target: &Path,
    args: &RenderArgs,
    flags: &Flags,
) -> Result<String, Failure> {
    let format = format(flags)?;
    let Rendered { image, .. } = render_scene(&stem(path), file, picture, args, flags)?;
    let image = match format {
        Format::Png8 | Format::Png16 => args.tone.map().apply(&image),
        Format::Exr | Format::Hdr => image, // linear and unbounded
    };
    write_as(target, &image, format, &provenance(path, picture, args, flags)).map_err(Failure::work)?;
    Ok(format!("{}\n", target.display()))
}

fn render_scene(
    name: &str,
    file: &SceneFile,
    picture: Picture,
    args: &RenderArgs,
    flags: &Flags,
) -> Result<Rendered, Failure> {
    let verbosity = if flags.quiet { Verbosity::Quiet } else { Verbosity::Normal };
    let progress = Progress::start(name, verbosity);
    let control = Control {
        threads: flags.threads.map_or(0, usize::from),
        stop: stop_flag(),
        progress: &|share| progress.set(share),
    };
    let done = render_with(&file.scene, &args.integrator.integrator(), picture, control);
    let rendered = done.map_err(|e| match e {
        RenderError::Interrupted => Failure::interrupted(name),
        RenderError::Threads(_) => Failure::work(e),
    })?;
    let pixels = (picture.width * picture.height) as u64;
    let mut work = format!("{} samples", pixels * u64::from(picture.samples));
    for kind in RayKind::ALL {
        if rendered.tally.rays(kind) > 0 {
            // Writing to a string cannot fail.
            let _ = write!(work, ", {} {} rays", rendered.tally.rays(kind), kind.name());
        }
    }
    progress.finish(&work);
    Ok(rendered)
}

/// The command that makes a picture again, byte for byte.
fn command(path: &Path, args: &RenderArgs, flags: &Flags) -> String {
    let mut command = format!("lightbench render {}", quoted(&path.display().to_string()));
    if let Some((x, y)) = args.pixel {
        let _ = write!(command, " --pixel {x},{y}");
    }
    for (name, value, default) in [
        ("integrator", args.integrator.to_possible_value(), IntegratorName::default().to_possible_value()),
        ("tone", args.tone.to_possible_value(), Tone::default().to_possible_value()),
    ] {
        if let Some(value) = value.filter(|v| Some(v) != default.as_ref()) {
            let _ = write!(command, " --{name} {}", value.get_name());
        }
    }
    command += &Flags { only: None, ..flags.clone() }.canonical(); // the scene is named already
    command
}

/// What a picture says about itself.
fn provenance(
    path: &Path,
    picture: Picture,
    args: &RenderArgs,
    flags: &Flags,
) -> Vec<(&'static str, String)> {
    vec![
        ("Software", format!("lightbench {}", env!("CARGO_PKG_VERSION"))),
        ("Command", command(path, args, flags)),
        ("Parameters", parameters(picture)),
        ("Seed", picture.seed.to_string()),
    ]
}

fn parameters(picture: Picture) -> String {
    format!("{} × {} pixels, {} samples per pixel", picture.width, picture.height, picture.samples)
}

fn replay_pixel(
    path: &Path,
    file: &SceneFile,
    picture: Picture,
    at: (usize, usize),
    target: &Path,
    args: &RenderArgs,
    flags: &Flags,
) -> Result<String, Failure> {
    let (x, y) = at;
    if x >= picture.width || y >= picture.height {
        let (w, h) = (picture.width - 1, picture.height - 1);
        return Err(Failure::input(format!("--pixel {x},{y}: expected a column 0…{w} and a row 0…{h}")));
    }
    let per_sample = file.rays_per_pixel() / u64::from(file.settings.samples);
    let rays = per_sample.saturating_mul(u64::from(picture.samples));
    if rays > MOST_REPLAYED {
        let message = format!(
            "expected at most {MOST_REPLAYED} rays to keep, found {rays}; lower --spp, or the Samples or Subdivision of lights"
        );
        return Err(Failure::input(format!("--pixel {x},{y}: {message}")));
    }
    let name = stem(path);
    let (value, rays) = lightbench::render::replay(&file.scene, &args.integrator.integrator(), picture, at);
    let mut out = format!("pixel {x},{y} of {}: radiance {value:.9}\n", path.display());
    for ray in &rays {
        out += &ray.text(&file.scene);
    }
    let drawing =
        replay::draw(&file.scene, &rays, &format!("Pixel {x},{y} of {name}")).provenance(Provenance {
            command: command(path, args, flags),
            parameters: parameters(picture),
            seed: Some(picture.seed),
            version: env!("CARGO_PKG_VERSION").to_string(),
        });
    lightbench_kit::file::write_atomically(target, drawing.svg().as_bytes()).map_err(Failure::work)?;
    Ok(out + &format!("{}\n", target.display()))
}
