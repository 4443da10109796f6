//! Values: from words to numbers, names and texts inside their domains.

use super::diagnostic::{Diagnostic, Span, quoted};
use super::format::{Domain, Kind, Param};
use super::parse::describe;
use super::token::{Token, TokenKind};

/// The values of one parameter, all of them inside its domain.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Numbers(Vec<f64>),
    Integers(Vec<i64>),
    Word(String),
}

impl Value {
    pub fn numbers(&self) -> &[f64] {
        if let Value::Numbers(values) = self { values } else { &[] }
    }

    pub fn integers(&self) -> &[i64] {
        if let Value::Integers(values) = self { values } else { &[] }
    }

    pub fn word(&self) -> &str {
        if let Value::Word(word) = self { word } else { "" }
    }
}

/// Does the word begin like a number? (Used to tell values from names where something is wrong.)
pub fn looks_like_number(word: &str) -> bool {
    let rest = word.trim_start_matches(['+', '-', '.', '−', '–']);
    rest.starts_with(|c: char| c.is_ascii_digit())
        || (rest.is_empty() && !word.is_empty())
        || not_finite(word)
}

/// The words that Rust, C and others print for what is not a finite number.
fn not_finite(word: &str) -> bool {
    let bare = word.trim_start_matches(['+', '-']).to_lowercase();
    matches!(bare.as_str(), "nan" | "inf" | "infinity")
}

/// Checks one value as far as it can be checked alone.
pub fn check_one(token: &Token, param: &Param) -> Result<(), Diagnostic> {
    match param.kind {
        Kind::Numbers { .. } => number(token, param).map(|_| ()),
        Kind::Integers { .. } => integer(token, param).map(|_| ()),
        Kind::Name | Kind::Reference(_) | Kind::Text | Kind::Choice(_) => word(token, param).map(|_| ()),
    }
}

/// The values of `param`, as many as it takes, each of them passed by [`check_one`].
pub fn value(tokens: &[Token], span: &Span, param: &Param) -> Result<Value, Diagnostic> {
    Ok(match param.kind {
        Kind::Numbers { domain, .. } => {
            let values: Vec<f64> = tokens.iter().map(|t| number(t, param)).collect::<Result<_, _>>()?;
            inside(&values, tokens, span, param, domain)?;
            Value::Numbers(values)
        }
        Kind::Integers { .. } => {
            Value::Integers(tokens.iter().map(|t| integer(t, param)).collect::<Result<_, _>>()?)
        }
        _ => Value::Word(tokens.first().map_or(Ok(""), |t| word(t, param))?.to_owned()),
    })
}

fn inside(
    values: &[f64],
    tokens: &[Token],
    span: &Span,
    param: &Param,
    domain: Domain,
) -> Result<(), Diagnostic> {
    match domain.outside(values) {
        None => Ok(()),
        Some(Some(i)) => {
            let message = format!("`{}` is out of range", param.name);
            Err(Diagnostic::error(tokens[i].span.clone(), message)
                .expected(param.kind.one())
                .found(describe(&tokens[i])))
        }
        Some(None) => {
            let message = format!("`{}` has no direction", param.name);
            Err(Diagnostic::error(span.clone(), message).expected(param.kind.all()).found("the zero vector"))
        }
    }
}

/// A finite number.
fn number(token: &Token, param: &Param) -> Result<f64, Diagnostic> {
    let wrong = |message: String| {
        Diagnostic::error(token.span.clone(), message).expected(param.kind.one()).found(describe(token))
    };
    if token.kind != TokenKind::Word {
        return Err(wrong(format!("`{}` takes numbers, not texts", param.name)));
    }
    if not_finite(token.text) {
        return Err(wrong(format!("`{}` must be finite", param.name)));
    }
    match token.text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => Err(wrong(format!("{} is too large for a number", quoted(token.text)))
            .help(format!("the largest is {:e}", f64::MAX))),
        Err(_) => {
            let d = wrong(format!("{} is not a number", quoted(token.text)));
            Err(match spelling(token.text) {
                Some(help) => d.help(help),
                None => d,
            })
        }
    }
}

/// A whole number in its range.
fn integer(token: &Token, param: &Param) -> Result<i64, Diagnostic> {
    let Kind::Integers { from, to, .. } = param.kind else { return Ok(0) };
    if let Ok(n) = token.text.parse::<i64>() {
        if token.kind == TokenKind::Word && (from..=to).contains(&n) {
            return Ok(n);
        }
        let message = format!("`{}` is out of range", param.name);
        return Err(Diagnostic::error(token.span.clone(), message)
            .expected(param.kind.one())
            .found(describe(token)));
    }
    number(token, param)?; // says what is wrong with it, if it is no number at all
    let digits = token.text.trim_start_matches(['+', '-']).bytes().all(|b| b.is_ascii_digit());
    let message = match digits {
        true => format!("`{}` is out of range", param.name),
        false => format!("{} is not a whole number", quoted(token.text)),
    };
    Err(Diagnostic::error(token.span.clone(), message).expected(param.kind.one()).found(describe(token)))
}

/// What probably went wrong in a number.
fn spelling(word: &str) -> Option<String> {
    let plain: String = word.chars().map(|c| if matches!(c, '−' | '–') { '-' } else { c }).collect();
    let fixed = plain.trim_end_matches([',', ';', 'f', 'd']).replacen(',', ".", 1);
    let good = fixed != word && fixed.parse::<f64>().is_ok_and(f64::is_finite);
    good.then(|| format!("write `{fixed}`"))
}

/// A name, a text or one of some words.
fn word<'a>(token: &Token<'a>, param: &Param) -> Result<&'a str, Diagnostic> {
    let wrong = |message: String| {
        Diagnostic::error(token.span.clone(), message).expected(param.kind.one()).found(describe(token))
    };
    match param.kind {
        Kind::Text if token.kind != TokenKind::Quoted => {
            Err(wrong(format!("`{}` needs quotes", param.name)).help(format!("write `{} \"…\"`", param.name)))
        }
        Kind::Choice(words) if !words.contains(&token.text) => {
            Err(wrong(format!("`{}` has no choice {}", param.name, quoted(token.text))))
        }
        Kind::Name | Kind::Reference(_) if token.text.contains(char::is_whitespace) => {
            Err(wrong(format!("`{}` must not hold spaces", param.name)))
        }
        _ if token.text.is_empty() => Err(wrong(format!("`{}` is empty", param.name))),
        _ => Ok(token.text),
    }
}
