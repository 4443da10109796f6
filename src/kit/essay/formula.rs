//! Formulas: LaTeX as MathML for the page, and as plain Unicode for the terminal.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Where a formula stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    Inline,
    Display,
}

/// A formula that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the formula `{latex}` cannot be read: {reason}")]
pub struct FormulaError {
    pub latex: String,
    pub reason: String,
}

/// The formula as MathML.
///
/// - Errors: LaTeX that the parser does not know.
pub fn mathml(latex: &str, setting: Setting) -> Result<String, FormulaError> {
    let fail = |reason: String| FormulaError { latex: latex.to_string(), reason };
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|e| fail(e.to_string().lines().next().unwrap_or_default().to_string()))?;
    let display_mode = if setting == Setting::Display { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, annotation: None, ..RenderConfig::default() };
    let mut out = String::new();
    let good = events.into_iter().map(Ok::<_, pulldown_latex::ParserError>);
    push_mathml(&mut out, good, config).map_err(|e| fail(e.to_string()))?;
    Ok(out)
}

/// Commands and the signs they stand for.
const SIGNS: &[(&str, &str)] = &[
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("varepsilon", "ε"),
    ("epsilon", "ε"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("varphi", "φ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Omega", "Ω"),
    ("cdot", " · "),
    ("times", "×"),
    ("div", "÷"),
    ("pm", "±"),
    ("mp", "∓"),
    ("le", " ≤ "),
    ("leq", " ≤ "),
    ("ge", " ≥ "),
    ("geq", " ≥ "),
    ("ne", " ≠ "),
    ("ll", " ≪ "),
    ("gg", " ≫ "),
    ("approx", " ≈ "),
    ("propto", " ∝ "),
    ("in", " ∈ "),
    ("notin", " ∉ "),
    ("cap", " ∩ "),
    ("cup", " ∪ "),
    ("setminus", " ∖ "),
    ("to", " → "),
    ("mapsto", " ↦ "),
    ("infty", "∞"),
    ("partial", "∂"),
    ("nabla", "∇"),
    ("int", "∫"),
    ("sum", "Σ"),
    ("prod", "Π"),
    ("ldots", "…"),
    ("dots", "…"),
    ("cdots", "⋯"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("lfloor", "⌊"),
    ("rfloor", "⌋"),
    ("langle", "⟨"),
    ("rangle", "⟩"),
    ("ell", "ℓ"),
    ("circ", "°"),
    ("perp", "⊥"),
    ("parallel", "∥"),
    ("quad", "  "),
    ("qquad", "    "),
    ("left", ""),
    ("right", ""),
    ("big", ""),
    ("Big", ""),
    ("displaystyle", ""),
    ("limits", ""),
];

/// The formula as one line of Unicode: `\frac{a}{b}` is `a/b`, powers are raised where there are raised letters.
pub fn plain(latex: &str) -> String {
    let mut reader = Reader { rest: latex };
    let text = reader.until_end();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    /// The rest of the group, up to its `}`.
    fn until_end(&mut self) -> String {
        let mut out = String::new();
        while let Some(c) = self.next() {
            match c {
                '}' => break,
                '{' => out += &self.until_end(),
                '\\' => out += &self.command(),
                '^' => out += &raised(&self.argument(), SUPERSCRIPTS, '^'),
                '_' => out += &raised(&self.argument(), SUBSCRIPTS, '_'),
                '=' | '<' | '>' | '+' => out += &format!(" {c} "),
                '-' if out.trim_end().ends_with(['=', '(', '[', ',', '<', '>']) || out.trim().is_empty() => {
                    out.push('−')
                }
                '-' => out += " − ",
                '~' | '&' => out.push(' '),
                c => out.push(c),
            }
        }
        out
    }

    /// One group, command or letter.
    fn argument(&mut self) -> String {
        self.rest = self.rest.trim_start();
        match self.next() {
            Some('{') => self.until_end(),
            Some('\\') => self.command(),
            Some(c) => c.to_string(),
            None => String::new(),
        }
    }

    /// A command, after its backslash.
    fn command(&mut self) -> String {
        let length = self.rest.chars().take_while(char::is_ascii_alphabetic).count();
        if length == 0 {
            return match self.next() {
                Some(',' | ';' | ':' | ' ') => " ".to_string(),
                Some('|') => "‖".to_string(),
                Some('\\') => "; ".to_string(),
                Some('!') | None => String::new(),
                Some(c) => c.to_string(),
            };
        }
        let name = &self.rest[..length];
        self.rest = &self.rest[length..];
        match name {
            "frac" | "tfrac" | "dfrac" => {
                let (over, under) = (self.argument(), self.argument());
                format!("{}/{}", grouped(&over), grouped(&under))
            }
            "sqrt" => format!("√{}", grouped(&self.argument())),
            "hat" => format!("{}\u{302}", self.argument()),
            "bar" | "overline" => format!("{}\u{304}", self.argument()),
            "mathbf" | "mathrm" | "mathit" | "text" | "vec" | "operatorname" | "boldsymbol" => {
                self.argument()
            }
            "begin" | "end" => {
                self.argument();
                " ".to_string()
            }
            name => match SIGNS.iter().find(|(n, _)| *n == name) {
                Some((_, sign)) => {
                    // A space ends a command's name and is not shown.
                    self.rest = self.rest.strip_prefix(' ').unwrap_or(self.rest);
                    sign.to_string()
                }
                None => format!("{name} "), // cos, sin, max, log …
            },
        }
    }
}

/// In brackets if it is more than one word.
fn grouped(text: &str) -> String {
    let text = text.trim();
    let simple = text.chars().all(|c| c.is_alphanumeric() || "²³⁴′₀₁₂".contains(c));
    if simple { text.to_string() } else { format!("({text})") }
}

const SUPERSCRIPTS: (&str, &str) = ("0123456789+-−=()n i*", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁼⁽⁾ⁿ ⁱ*");
const SUBSCRIPTS: (&str, &str) = ("0123456789+-−=()aeioxhklmnpst", "₀₁₂₃₄₅₆₇₈₉₊₋₋₌₍₎ₐₑᵢₒₓₕₖₗₘₙₚₛₜ");

/// Raised or lowered letters where all have such a form, else the mark and the text.
fn raised(text: &str, (plain, shifted): (&str, &str), mark: char) -> String {
    let text: String = text.split_whitespace().collect();
    let shift = |c: char| plain.chars().position(|p| p == c).and_then(|i| shifted.chars().nth(i));
    let all: Option<String> = text.chars().map(shift).collect();
    all.unwrap_or_else(|| {
        if text.chars().count() == 1 { format!("{mark}{text}") } else { format!("{mark}{}", grouped(&text)) }
    })
}
