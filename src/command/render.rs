//! `lightbench render`: from scene files to pictures.

use super::check::counted;
use super::target::{self, Out};
use super::{Failure, print};
use clap::{Args, ValueEnum};
use lightbench::film::tone::ToneMap;
use lightbench::integrator::{Local, Stage};
use lightbench::ray::RayKind;
use lightbench::render::{Control, Picture, RenderError, Rendered, render_with};
use lightbench_kit::figure::Provenance;
use lightbench_kit::file::{Format, write_as, write_atomically};
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
    /// What happens to values over 1 in PNG files [default: clamp]
    #[arg(long, value_enum)]
    tone: Option<Tone>,
    /// Instead of a picture: every ray of one pixel, as text and as a drawing (.svg)
    #[arg(long, value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pixel: Option<(usize, usize)>,
    /// Name of the file in the folder, for a single scene [default: that of the scene]
    #[arg(long)]
    name: Option<String>,
    #[command(flatten)]
    pub flags: Flags,
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

/// A scene, what is to be made of it, and where that goes.
struct Job<'a> {
    path: &'a Path,
    file: SceneFile,
    picture: Picture,
    target: PathBuf,
    /// The flags as they count for this file: with the format of its ending.
    flags: Flags,
}

/// Renders one picture after the other, and prints the path of each when it stands. Nothing is rendered before all
/// scenes are read and everything that was asked for is known to be possible.
pub(super) fn render(args: &RenderArgs) -> Result<String, Failure> {
    let flags = &args.flags;
    if flags.list {
        return Ok(list());
    }
    if let Some(PictureFormat::Svg | PictureFormat::Pdf) = flags.format {
        let expected = "--format: expected png, png16, exr or hdr for a render, found a format of charts";
        return Err(Failure::input(expected));
    }
    let scenes = chosen(args, flags)?;
    scenes.iter().try_for_each(|path| target::scene(path))?;
    let mut targets: Vec<(&Path, PathBuf, Flags)> = Vec::new();
    for &path in &scenes {
        let target = target(path, args, scenes.len() == 1)?;
        if let Some((other, ..)) = targets.iter().find(|(_, same, _)| *same == target) {
            let (a, b, target) = (other.display(), path.display(), target.display());
            return Err(Failure::input(format!("{a} and {b} would both be written to {target}")));
        }
        let flags = with_format(&target, args)?;
        targets.push((path, target, flags));
    }
    let mut jobs = Vec::new();
    for (path, target, flags) in targets {
        let file = open(path, &flags)?;
        let picture = picture(&file, &flags)?;
        jobs.push(Job { path, file, picture, target, flags });
    }
    for job in &jobs {
        target::writable(&job.target)?;
    }
    for job in &jobs {
        print(&match args.pixel {
            Some(at) => replay_pixel(job, at, args)?,
            None => render_picture(job, args)?,
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
            let _ = writeln!(out, "{:<26} {help}", format!("--{flag} {}", value.get_name()));
        }
    };
    IntegratorName::value_variants().iter().for_each(|v| add("integrator", v.to_possible_value()));
    Tone::value_variants().iter().for_each(|v| add("tone", v.to_possible_value()));
    out
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Endings of the files that pictures are written in; the first is the default.
pub(super) const ENDINGS: &[&str] = &["png", "exr", "hdr"];
/// Endings of the files that drawings are written in.
const DRAWN: &[&str] = &["svg", "png"];

/// Where the picture of a scene, or the drawing of its pixel, goes.
fn target(path: &Path, args: &RenderArgs, single: bool) -> Result<PathBuf, Failure> {
    let endings = if args.pixel.is_some() { DRAWN } else { ENDINGS };
    let out = args.flags.out.as_deref();
    let for_one = |flag: &str, name: &str| {
        let message = "expected one scene for one file, found several";
        Failure::input(format!("{flag} {name}: {message}"))
    };
    let stem = match args.pixel {
        Some((x, y)) => format!("{}_pixel_{x}_{y}", stem(path)),
        None => stem(path),
    };
    let default = match args.flags.format {
        Some(format) if args.pixel.is_none() => written(format).extension(),
        _ => endings[0],
    };
    match &args.name {
        Some(name) if !single => Err(for_one("--name", name)),
        Some(name) => {
            // Without an ending of its own it gets that of the format.
            let endings = [&[default], endings].concat();
            target::in_folder(out, name, &endings)
        }
        None => match target::named(out, endings)? {
            Out::File(file) if !single => Err(for_one("--out", &file.display().to_string())),
            Out::File(file) => Ok(file),
            Out::Folder(folder) => Ok(folder.join(format!("{stem}.{default}"))),
        },
    }
}

fn written(format: PictureFormat) -> Format {
    match format {
        PictureFormat::Png => Format::Png8,
        PictureFormat::Png16 => Format::Png16,
        PictureFormat::Exr => Format::Exr,
        PictureFormat::Hdr => Format::Hdr,
        PictureFormat::Svg | PictureFormat::Pdf => Format::Png8, // refused before any render
    }
}

/// The flags with the format that a file's ending asks for; what contradicts it, or has no effect on it, is refused.
fn with_format(target: &Path, args: &RenderArgs) -> Result<Flags, Failure> {
    let flags = args.flags.clone();
    let has = |value: Option<clap::builder::PossibleValue>| {
        value.map_or(String::new(), |v| v.get_name().to_string())
    };
    let format = flags.format.map(|f| has(f.to_possible_value()));
    let tone = args.tone.map(|t| has(t.to_possible_value()));
    if args.pixel.is_some() {
        return match (&format, &tone) {
            (Some(f), _) => Err(Failure::input(format!(
                "--format {f} has no effect on --pixel: the drawing is .svg or .png"
            ))),
            (None, Some(t)) => {
                Err(Failure::input(format!("--tone {t} has no effect on --pixel: it prints radiance")))
            }
            (None, None) => Ok(flags),
        };
    }
    let ending = target::ending(target);
    let of_ending = match ending.as_str() {
        "exr" => PictureFormat::Exr,
        "hdr" => PictureFormat::Hdr,
        _ => PictureFormat::Png,
    };
    let format = flags.format.unwrap_or(of_ending);
    let expected = written(format).extension();
    if ending != expected {
        let (format, target) = (has(format.to_possible_value()), target.display());
        return Err(Failure::input(format!(
            "--format {format}: expected a file that ends in .{expected}, found {target}"
        )));
    }
    match (written(format), tone) {
        (Format::Exr | Format::Hdr, Some(tone)) => {
            let message =
                format!("has no effect on {}: .exr and .hdr hold radiance as it is", target.display());
            Err(Failure::input(format!("--tone {tone} {message}")))
        }
        _ => Ok(Flags { format: Some(format), ..flags }),
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

fn render_picture(job: &Job, args: &RenderArgs) -> Result<String, Failure> {
    let format = written(job.flags.format.unwrap_or(PictureFormat::Png));
    let Rendered { image, .. } = render_scene(job, args)?;
    let image = match format {
        Format::Png8 | Format::Png16 => args.tone.unwrap_or_default().map().apply(&image),
        Format::Exr | Format::Hdr => image, // linear and unbounded
    };
    write_as(&job.target, &image, format, &provenance(job, args)).map_err(Failure::work)?;
    Ok(format!("{}\n", job.target.display()))
}

fn render_scene(job: &Job, args: &RenderArgs) -> Result<Rendered, Failure> {
    let Job { path, file, picture, flags, .. } = job;
    let (name, picture) = (&stem(path), *picture);
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
fn command(job: &Job, args: &RenderArgs) -> String {
    let mut command = format!("lightbench render {}", quoted(&job.path.display().to_string()));
    if let Some((x, y)) = args.pixel {
        let _ = write!(command, " --pixel {x},{y}");
    }
    for (name, value, default) in [
        ("integrator", args.integrator.to_possible_value(), IntegratorName::default().to_possible_value()),
        ("tone", args.tone.unwrap_or_default().to_possible_value(), Tone::default().to_possible_value()),
    ] {
        if let Some(value) = value.filter(|v| Some(v) != default.as_ref()) {
            let _ = write!(command, " --{name} {}", value.get_name());
        }
    }
    command += &Flags { only: None, ..job.flags.clone() }.canonical(); // the scene is named already
    command
}

/// What a picture says about itself.
fn provenance(job: &Job, args: &RenderArgs) -> Vec<(&'static str, String)> {
    vec![
        ("Software", format!("lightbench {}", env!("CARGO_PKG_VERSION"))),
        ("Command", command(job, args)),
        ("Parameters", parameters(job.picture)),
        ("Seed", job.picture.seed.to_string()),
    ]
}

fn parameters(picture: Picture) -> String {
    format!(
        "{} × {} pixels, {} per pixel",
        picture.width,
        picture.height,
        counted(picture.samples as usize, "sample")
    )
}

fn replay_pixel(job: &Job, at: (usize, usize), args: &RenderArgs) -> Result<String, Failure> {
    let Job { path, file, picture, target, .. } = job;
    let ((x, y), picture) = (at, *picture);
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
            command: command(job, args),
            parameters: parameters(picture),
            seed: Some(picture.seed),
            version: env!("CARGO_PKG_VERSION").to_string(),
        });
    let bytes = if target::ending(target) == "png" { drawing.png() } else { drawing.svg().into_bytes() };
    write_atomically(target, &bytes).map_err(Failure::work)?;
    Ok(out + &format!("{}\n", target.display()))
}
