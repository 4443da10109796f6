//! `lightbench render`: from scene files to pictures.

use super::Failure;
use crate::film::file::{Format, write_as};
use crate::film::tone::ToneMap;
use crate::integrator::{Local, Stage};
use crate::kit::flags::{Flags, PictureFormat};
use crate::kit::progress::{Progress, Verbosity, stop_flag};
use crate::kit::replay;
use crate::ray::RayKind;
use crate::render::{Control, Picture, RenderError, Rendered, render_with};
use crate::scene_file::{Color, SceneFile, read_file};
use clap::{Args, ValueEnum};
use std::fmt::Write;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub(super) struct RenderArgs {
    /// Scene files; each makes one picture
    #[arg(required = true)]
    scenes: Vec<PathBuf>,
    /// How a ray becomes radiance
    #[arg(long, value_enum, default_value_t)]
    integrator: IntegratorName,
    /// What happens to values over 1 in PNG files
    #[arg(long, value_enum, default_value_t)]
    tone: Tone,
    /// Instead of a picture: every ray of one pixel, as text and as a drawing
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pixel: Option<(usize, usize)>,
}

/// The integrators there are to choose from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum IntegratorName {
    /// The nearest surface in its own colour, no light
    Visibility,
    /// Lambert and ambient light, no shadows
    Unshadowed,
    /// Lambert and ambient light with shadows
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
    parts.ok_or_else(|| format!("expected column,row such as 256,128, found `{text}`"))
}

pub(super) fn render(args: &RenderArgs, flags: &Flags) -> Result<String, Failure> {
    let mut out = String::new();
    for path in &args.scenes {
        let file = open(path, flags)?;
        let picture = picture(&file, flags);
        out += &match args.pixel {
            Some(at) => replay_pixel(path, &file, picture, at, args, flags)?,
            None => render_picture(path, &file, picture, args, flags)?,
        };
    }
    Ok(out)
}

/// Reads a scene file and says on stderr what there is to say about it.
fn open(path: &Path, flags: &Flags) -> Result<SceneFile, Failure> {
    let color = stderr_color();
    let file = read_file(path).map_err(|e| Failure::input(e.render(color)))?;
    if !flags.quiet && !file.remarks.is_empty() {
        eprint!("{}", file.remarks.render(color));
    }
    Ok(file)
}

/// Colours only on a terminal that has not asked for none.
pub(super) fn stderr_color() -> Color {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty())
        || std::env::var_os("TERM").is_some_and(|t| t == "dumb");
    if std::io::stderr().is_terminal() && !refused { Color::Always } else { Color::Never }
}

/// A flag wins over the scene file.
fn picture(file: &SceneFile, flags: &Flags) -> Picture {
    let settings = &file.settings;
    let size = |flag: Option<u16>, file: u32| flag.map_or(file as usize, usize::from);
    Picture {
        width: size(flags.width, settings.width),
        height: size(flags.height, settings.height),
        samples: flags.spp.map_or(settings.samples, u32::from),
        seed: flags.seed(),
    }
}

fn render_picture(
    path: &Path,
    file: &SceneFile,
    picture: Picture,
    args: &RenderArgs,
    flags: &Flags,
) -> Result<String, Failure> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let format = match flags.format {
        None | Some(PictureFormat::Png) => Format::Png8,
        Some(PictureFormat::Png16) => Format::Png16,
        Some(PictureFormat::Exr) => Format::Exr,
        Some(PictureFormat::Hdr) => Format::Hdr,
    };
    let target = flags.out().join(format!("{name}.{}", format.extension()));
    let Rendered { image, .. } = render_scene(&name, file, picture, args, flags)?;
    let image = match format {
        Format::Png8 | Format::Png16 => args.tone.map().apply(&image),
        Format::Exr | Format::Hdr => image, // linear and unbounded
    };
    write_as(&target, &image, format, &provenance(path, picture, args, flags)).map_err(Failure::work)?;
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
        RenderError::Interrupted => Failure::interrupted(),
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

/// What a picture says about itself: the command that makes it again, byte for byte.
fn provenance(
    path: &Path,
    picture: Picture,
    args: &RenderArgs,
    flags: &Flags,
) -> Vec<(&'static str, String)> {
    let mut command = format!("lightbench render {}", path.display());
    for (name, value, default) in [
        ("integrator", args.integrator.to_possible_value(), IntegratorName::default().to_possible_value()),
        ("tone", args.tone.to_possible_value(), Tone::default().to_possible_value()),
    ] {
        if let Some(value) = value.filter(|v| Some(v) != default.as_ref()) {
            let _ = write!(command, " --{name} {}", value.get_name());
        }
    }
    command += &flags.canonical();
    vec![
        ("Software", format!("lightbench {}", env!("CARGO_PKG_VERSION"))),
        ("Command", command),
        (
            "Parameters",
            format!("{} × {} pixels, {} samples per pixel", picture.width, picture.height, picture.samples),
        ),
        ("Seed", picture.seed.to_string()),
    ]
}

fn replay_pixel(
    path: &Path,
    file: &SceneFile,
    picture: Picture,
    at: (usize, usize),
    args: &RenderArgs,
    flags: &Flags,
) -> Result<String, Failure> {
    let (x, y) = at;
    if x >= picture.width || y >= picture.height {
        let (w, h) = (picture.width - 1, picture.height - 1);
        return Err(Failure::input(format!("--pixel {x},{y}: expected a column 0…{w} and a row 0…{h}")));
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let target = flags.out().join(format!("{name}_pixel_{x}_{y}.svg"));
    let (value, rays) = crate::render::replay(&file.scene, &args.integrator.integrator(), picture, at);
    let mut out = format!("pixel {x},{y} of {}: radiance {value:.9}\n", path.display());
    for ray in &rays {
        out += &ray.text(&file.scene);
    }
    let drawing = replay::draw(&file.scene, &rays, &format!("Pixel {x},{y} of {name}"));
    crate::film::file::write_atomically(&target, drawing.as_bytes()).map_err(Failure::work)?;
    Ok(out + &format!("{}\n", target.display()))
}
