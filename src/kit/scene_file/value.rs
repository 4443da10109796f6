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
pub fn check_one(token: &Token, param: &Param) -> Result<(), Wrong> {
    match param.kind {
        Kind::Numbers { .. } => number(token, param).map(|_| ()),
        Kind::Integers { .. } => integer(token, param).map(|_| ()),
        Kind::Name | Kind::Reference(_) | Kind::Text | Kind::Choice(_) => word(token, param).map(|_| ()),
    }
}

/// The values of `param`, as many as it takes, each of them passed by [`check_one`].
pub fn value(tokens: &[Token], span: &Span, param: &Param) -> Result<Value, Wrong> {
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

/// What is wrong with one value; boxed, because that is rare and long.
type Wrong = Box<Diagnostic>;

fn wrong(token: &Token, param: &Param, message: String) -> Wrong {
    let d = Diagnostic::error(token.span.clone(), message);
    Box::new(d.expected(param.kind.one()).found(describe(token)))
}

fn out_of_range(token: &Token, param: &Param) -> Wrong {
    wrong(token, param, format!("`{}` is out of range", param.name))
}

fn inside(values: &[f64], tokens: &[Token], span: &Span, param: &Param, domain: Domain) -> Result<(), Wrong> {
    match domain.outside(values) {
        None => Ok(()),
        Some(Some(i)) => Err(out_of_range(&tokens[i], param)),
        Some(None) => {
            let message = format!("`{}` has no direction", param.name);
            let d = Diagnostic::error(span.clone(), message).expected(param.kind.all());
            Err(Box::new(d.found("the zero vector")))
        }
    }
}

/// A finite number.
fn number(token: &Token, param: &Param) -> Result<f64, Wrong> {
    if token.kind != TokenKind::Word {
        return Err(wrong(token, param, format!("`{}` takes numbers, not texts", param.name)));
    }
    if not_finite(token.text) {
        return Err(wrong(token, param, format!("`{}` must be finite", param.name)));
    }
    match token.text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => {
            let d = wrong(token, param, format!("{} is too large for a number", quoted(token.text)));
            Err(Box::new(d.help(format!("the largest is {:e}", f64::MAX))))
        }
        Err(_) => {
            let d = wrong(token, param, format!("{} is not a number", quoted(token.text)));
            Err(match spelling(token.text) {
                Some(help) => Box::new(d.help(help)),
                None => d,
            })
        }
    }
}

/// A whole number in its range.
fn integer(token: &Token, param: &Param) -> Result<i64, Wrong> {
    let Kind::Integers { from, to, .. } = param.kind else { return Ok(0) };
    number(token, param)?; // says what is wrong with it, if it is no number at all
    if let Ok(n) = token.text.parse::<i64>() {
        return if (from..=to).contains(&n) { Ok(n) } else { Err(out_of_range(token, param)) };
    }
    match token.text.trim_start_matches(['+', '-']).bytes().all(|b| b.is_ascii_digit()) {
        true => Err(out_of_range(token, param)), // more digits than fit
        false => Err(wrong(token, param, format!("{} is not a whole number", quoted(token.text)))),
    }
}

/// What was probably meant by a word that is not a number.
fn spelling(word: &str) -> Option<String> {
    let plain: String = word.chars().map(|c| if matches!(c, '−' | '–') { '-' } else { c }).collect();
    let fixed = plain.trim_end_matches([',', ';', 'f', 'd']).replacen(',', ".", 1);
    let good = fixed != word && fixed.parse::<f64>().is_ok_and(f64::is_finite);
    good.then(|| format!("write `{fixed}`"))
}

/// A name, a text or one of some words.
fn word<'a>(token: &Token<'a>, param: &Param) -> Result<&'a str, Wrong> {
    let wrong = |message: String| Err(wrong(token, param, message));
    match param.kind {
        Kind::Text if token.kind != TokenKind::Quoted => {
            wrong(format!("`{0}` needs quotes: `{0} \"…\"`", param.name))
        }
        Kind::Choice(words) if !words.contains(&token.text) => {
            wrong(format!("`{}` has no choice {}", param.name, quoted(token.text)))
        }
        Kind::Name | Kind::Reference(_) if token.text.contains(char::is_whitespace) => {
            wrong(format!("`{}` must not hold spaces", param.name))
        }
        _ if token.text.is_empty() => wrong(format!("`{}` is empty", param.name)),
        _ => Ok(token.text),
    }
}
