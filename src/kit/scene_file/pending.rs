//! What a file asks for in so many words that is read and checked, but has no effect yet: one note names it.
//!
//! Defaults are no requests, and neither is what the material's own model does not use: `Model lambert` is documented to
//! use `DiffuseColor` alone. A feature that arrives takes its row out of [`PENDING`].

use super::Settings;
use super::diagnostic::{Diagnostic, Span};
use super::parse::Block;
use crate::color::Rgb;
use crate::scene::Material;

/// A parameter of a material without effect, and when it asks for one.
struct Pending {
    param: &'static str,
    asks: fn(&Material, &Settings) -> bool,
}

/// A material mirrors only if all of this holds [D §5.9.6].
fn mirrors(m: &Material, s: &Settings) -> bool {
    let wanted = m.specular != Rgb::ZERO && m.reflection_amount > 0.0 && m.opacity > 0.0;
    wanted && s.reflection_quality > 0 && s.reflection_steps > 0
}

const PENDING: &[Pending] = &[
    Pending { param: "Opacity", asks: |m, _| m.opacity < 1.0 },
    Pending { param: "RefractionIndex", asks: |m, _| m.opacity < 1.0 && m.ior != 1.0 },
    Pending { param: "ReflectionAmount", asks: mirrors },
    Pending { param: "ReflectionAngle", asks: |m, s| mirrors(m, s) && m.reflection_angle > 0.0 },
];

/// Settings without effect.
const PENDING_SETTINGS: &[&str] =
    &["ReflectionQuality", "ReflectionSteps", "IndirectQuality", "ColorBleeding"];

/// Has this parameter of a block no effect yet, whatever its value?
pub fn is_pending(block: &str, param: &str) -> bool {
    match block {
        "SceneSettings" => PENDING_SETTINGS.contains(&param),
        "Material" => PENDING.iter().any(|p| p.param == param),
        _ => false,
    }
}

/// Most materials named for one parameter.
const NAMED: usize = 4;

/// The note, if anything asks for what has no effect yet.
pub fn note(
    settings: &Settings,
    settings_block: Option<&Block>,
    materials: &[(&Block, Material)],
) -> Option<Diagnostic> {
    let mut asked = Vec::new();
    let mut places = Vec::new();
    for pending in PENDING {
        let asks = |(block, m): &&(&Block, Material)| {
            block.entry(pending.param).is_some() && (pending.asks)(m, settings)
        };
        let who: Vec<_> = materials.iter().filter(asks).collect();
        if who.is_empty() {
            continue;
        }
        places.extend(who.iter().map(|(block, _)| place(block, pending.param)));
        let mut names: Vec<_> = who.iter().take(NAMED).map(|(_, m)| m.name.clone()).collect();
        if who.len() > NAMED {
            names.push(format!("{} more", who.len() - NAMED));
        }
        asked.push(format!("{} ({})", pending.param, names.join(", ")));
    }
    if let Some(block) = settings_block.filter(|_| settings.indirect_quality > 2) {
        for (param, value) in [
            ("IndirectQuality", settings.indirect_quality.to_string()),
            ("ColorBleeding", settings.color_bleeding.to_string()),
        ] {
            if block.entry(param).is_some() {
                places.push(place(block, param));
                asked.push(format!("{param} {value}"));
            }
        }
    }
    if asked.is_empty() {
        return None;
    }
    let span = places.into_iter().min_by_key(|s| s.start).unwrap_or(0..0);
    Some(Diagnostic::note(span, format!("read, but without effect yet: {}", asked.join("; "))))
}

fn place(block: &Block, param: &str) -> Span {
    block.entry(param).map_or(block.keyword.clone(), |e| e.keyword.clone())
}
