//! The flags that lessons and commands share.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// How much work a run may do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Quality {
    /// Under a second: is everything there? Tests use it.
    Smoke,
    /// Seconds: the default.
    #[default]
    Draft,
    /// A minute: figures to show.
    Standard,
    /// As long as it takes: figures to print.
    Final,
}

impl Quality {
    /// The word for it on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Quality::Smoke => "smoke",
            Quality::Draft => "draft",
            Quality::Standard => "standard",
            Quality::Final => "final",
        }
    }
}

/// Flags that mean the same everywhere. A flag wins over a scene file, a scene file over the quality's defaults.
#[derive(Args, Clone, Debug, Default)]
pub struct Flags {
    /// Folder for the files that are written [default: out]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How much work to do [default: draft]
    #[arg(long, value_enum)]
    pub quality: Option<Quality>,
    /// Seed of every random number: same seed, same bytes [default: 0]
    #[arg(long, value_name = "N", value_parser = seed, allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Number of threads, at most 1024 [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Width of pictures in pixels
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u16).range(1..))]
    pub width: Option<u16>,
    /// Height of pictures in pixels
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u16).range(1..))]
    pub height: Option<u16>,
    /// Camera rays a pixel
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub spp: Option<u16>,
    /// Make only what has this in its name or number
    #[arg(long, value_name = "NAME")]
    pub only: Option<String>,
    /// File format of pictures
    #[arg(long, value_enum)]
    pub format: Option<PictureFormat>,
    /// No progress, notes or warnings
    #[arg(long)]
    pub quiet: bool,
    /// List what there is to choose from, and stop
    #[arg(long)]
    pub list: bool,
}

/// File formats that pictures are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    /// 8 bits a channel, sRGB
    Png,
    /// 16 bits a channel, sRGB
    Png16,
    /// OpenEXR, linear 32-bit floats
    Exr,
    /// Radiance HDR, linear, 8 bits and a shared exponent
    Hdr,
    /// Vectors, for charts and diagrams of lessons
    Svg,
    /// Vectors for LaTeX, for charts and diagrams of lessons
    Pdf,
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("expected a whole number from 0 to {}", u64::MAX))
}

impl Flags {
    /// The quality asked for, or draft.
    pub fn quality(&self) -> Quality {
        self.quality.unwrap_or_default()
    }

    /// The seed asked for, or 0.
    pub fn seed(&self) -> u64 {
        self.seed.unwrap_or(0)
    }

    /// The folder asked for, or `out`.
    pub fn out(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| PathBuf::from("out"))
    }

    /// The names of the flags that were given, without their dashes.
    pub fn given(&self) -> Vec<&'static str> {
        let all = [
            ("out", self.out.is_some()),
            ("quality", self.quality.is_some()),
            ("seed", self.seed.is_some()),
            ("threads", self.threads.is_some()),
            ("width", self.width.is_some()),
            ("height", self.height.is_some()),
            ("spp", self.spp.is_some()),
            ("only", self.only.is_some()),
            ("format", self.format.is_some()),
            ("quiet", self.quiet),
            ("list", self.list),
        ];
        all.into_iter().filter(|(_, given)| *given).map(|(name, _)| name).collect()
    }

    /// The flags that decide what is computed, as they would be typed: without `--out`, `--threads`,
    /// `--quiet`, which change nothing in the result, and without those that say what is the default anyway.
    pub fn canonical(&self) -> String {
        let mut out = String::new();
        let mut add = |name: &str, value: Option<String>| {
            if let Some(value) = value {
                out += &format!(" --{name} {value}");
            }
        };
        add("quality", self.quality.filter(|q| *q != Quality::default()).map(|q| q.name().to_string()));
        add("seed", self.seed.filter(|n| *n != 0).map(|n| n.to_string()));
        add("width", self.width.map(|n| n.to_string()));
        add("height", self.height.map(|n| n.to_string()));
        add("spp", self.spp.map(|n| n.to_string()));
        add("only", self.only.as_deref().map(quoted));
        let format = |f: PictureFormat| f.to_possible_value().map(|v| v.get_name().to_string());
        add("format", self.format.and_then(format));
        out
    }
}

/// A word as a shell takes it back: in quotes if it has to be.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+,:=@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_string();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}
