//! From tokens to blocks with checked values; every mistake is reported once, and reading goes on.

use super::blocks::{rule, rules};
use super::diagnostic::{Diagnostic, Span, quoted};
use super::format::{Default, Kind, Param, Rule, Times};
use super::suggest::nearest;
use super::token::{Token, TokenKind};
use super::value::{self, Value};

/// A parameter as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    pub param: &'static Param,
    /// The parameter's name.
    pub keyword: Span,
    /// Its values.
    pub span: Span,
    /// `None` if they are wrong, which is already reported.
    pub value: Option<Value>,
}

/// A block as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    pub rule: &'static Rule,
    /// The block's name.
    pub keyword: Span,
    /// The line of the block's name, from 1.
    pub line: usize,
    pub entries: Vec<Entry>,
    /// The solids inside.
    pub children: Vec<Block>,
    /// Was its `}` there? If not, parameters may be missing without anybody's fault.
    pub closed: bool,
}

impl Block {
    /// The last entry of that name.
    pub fn entry(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().rev().find(|e| e.param.name == name)
    }

    /// Where the parameter's values stand; the block's name if it is not written.
    pub fn span(&self, name: &str) -> Span {
        self.entry(name).map_or(self.keyword.clone(), |e| e.span.clone())
    }

    /// Was some value wrong?
    pub fn is_broken(&self) -> bool {
        self.entries.iter().any(|e| e.value.is_none())
    }

    /// The numbers of a parameter, or else its default; zeros where neither exists.
    pub fn numbers<const N: usize>(&self, name: &str) -> [f64; N] {
        let written = self.entry(name).and_then(|e| e.value.as_ref()).map(Value::numbers);
        let default = match self.rule.param(name).map(|p| p.default) {
            Some(Default::Numbers(values)) => values,
            _ => &[],
        };
        let values = written.unwrap_or(default);
        std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
    }

    /// The whole numbers of a parameter, or else its default; zeros where neither exists.
    pub fn integers<const N: usize>(&self, name: &str) -> [i64; N] {
        let written = self.entry(name).and_then(|e| e.value.as_ref()).map(Value::integers);
        let default = match self.rule.param(name).map(|p| p.default) {
            Some(Default::Integers(values)) => values,
            _ => &[],
        };
        let values = written.unwrap_or(default);
        std::array::from_fn(|i| values.get(i).copied().unwrap_or(0))
    }

    /// The word of a parameter, or else its default.
    pub fn word(&self, name: &str) -> Option<&str> {
        let written = self.entry(name).and_then(|e| e.value.as_ref()).map(Value::word);
        written.or(match self.rule.param(name).map(|p| p.default) {
            Some(Default::Word(word)) => Some(word),
            _ => None,
        })
    }
}

/// A file as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    pub blocks: Vec<Block>,
    /// Pieces of the file of which nobody knows what they were to be.
    pub lost: usize,
}

/// Reads all blocks of a file.
pub fn parse(source: &str, tokens: &[Token], log: &mut Vec<Diagnostic>) -> Parsed {
    let mut parser =
        Parser { source, tokens, at: 0, log, lines: LineCounter::default(), depth: 0, cut: false };
    let mut parsed = Parsed { blocks: Vec::new(), lost: 0 };
    while parser.peek().is_some() {
        match parser.block() {
            Some(block) => parsed.blocks.push(block),
            None => parsed.lost += 1,
        }
    }
    parsed
}

/// Counts lines up to growing offsets, each byte once.
#[derive(Default)]
struct LineCounter {
    offset: usize,
    line: usize,
}

impl LineCounter {
    fn at(&mut self, source: &str, offset: usize) -> usize {
        let part = &source[self.offset..offset];
        // A lone `\r` breaks lines too; the `\n` of a pair is counted, its `\r` is not.
        let pairs = part.matches("\r\n").count();
        self.line += part.matches(['\n', '\r']).count() - pairs;
        self.offset = offset;
        1 + self.line
    }
}

struct Parser<'a, 'l> {
    source: &'a str,
    tokens: &'a [Token<'a>],
    at: usize,
    log: &'l mut Vec<Diagnostic>,
    lines: LineCounter,
    /// Blocks around this place.
    depth: usize,
    /// Was what stood too deep left out, and its braces with it?
    cut: bool,
}

/// Most blocks inside one another.
const DEEPEST: usize = 256;

impl<'a> Parser<'a, '_> {
    fn peek(&self) -> Option<&'a Token<'a>> {
        self.tokens.get(self.at)
    }

    fn next_is(&self, ahead: usize, kind: TokenKind) -> bool {
        self.tokens.get(self.at + ahead).is_some_and(|t| t.kind == kind)
    }

    /// Does the word here open a block?
    fn at_block(&self) -> bool {
        self.next_is(1, TokenKind::Open)
            && self.peek().is_some_and(|t| t.kind == TokenKind::Word && !value::looks_like_number(t.text))
    }

    /// Does a new block begin here, inside of another? On the same line as what stands before it, only
    /// the name of a block is believed to.
    fn at_next_block(&self) -> bool {
        let named = |t: &Token| t.starts_line || rule(t.text).is_some();
        self.at_block() && self.peek().is_some_and(named)
    }

    /// Does a block begin here that belongs inside of that one? An unknown name may have been meant so.
    fn at_inner_block(&self, outer: &Rule) -> bool {
        let belongs = |t: &Token| rule(t.text).is_none_or(|inner| outer.may_hold(inner));
        outer.holds_solids() && self.at_block() && self.peek().is_some_and(belongs)
    }

    /// What stands here, for messages.
    fn found(&self) -> String {
        self.peek().map_or("the end of the file".to_owned(), describe)
    }

    /// One block, or one mistake.
    fn block(&mut self) -> Option<Block> {
        let token = self.peek()?;
        let known = if token.kind == TokenKind::Word { rule(token.text) } else { None };
        match known {
            _ if self.at_block() => self.block_of(token, known),
            Some(rule) => self.block_without_brace(token, rule),
            None => {
                self.stray(token);
                None
            }
        }
    }

    /// A name with its `{`.
    fn block_of(&mut self, name: &'a Token, known: Option<&'static Rule>) -> Option<Block> {
        self.at += 2;
        let rule = match known {
            Some(rule) => rule,
            None => match self.unknown_block(name) {
                Some(rule) => rule,
                None => {
                    self.skip_braces();
                    return None;
                }
            },
        };
        Some(self.body(name, rule))
    }

    fn unknown_block(&mut self, name: &Token) -> Option<&'static Rule> {
        let near = nearest(name.text, rules().map(|r| r.name));
        let all: Vec<_> = rules().map(|r| r.name).collect();
        let mut d = Diagnostic::error(name.span.clone(), format!("unknown block {}", quoted(name.text)))
            .expected("the name of a block");
        d = match near {
            Some(near) => d.help(did_you_mean(name.text, near)),
            None => d.help(format!("blocks are {}", all.join(", "))),
        };
        self.log.push(d);
        near.and_then(rule)
    }

    /// The name of a block, and then something else.
    fn block_without_brace(&mut self, name: &'a Token, rule: &'static Rule) -> Option<Block> {
        self.at += 1;
        let d = Diagnostic::error(name.span.clone(), format!("block `{}` does not begin", rule.name))
            .expected("`{` after it")
            .found(self.found());
        self.log.push(d);
        let goes_on = self.peek().is_some_and(|t| t.kind == TokenKind::Word && rule.param(t.text).is_some());
        (goes_on && !self.at_next_block()).then(|| self.body(name, rule))
    }

    /// Something that belongs to no block; everything up to the next block goes with it.
    fn stray(&mut self, token: &Token) {
        let d = match token.kind {
            TokenKind::Close => Diagnostic::error(token.span.clone(), "this `}` closes nothing")
                .expected("the name of a block")
                .found("`}`"),
            TokenKind::Open => Diagnostic::error(token.span.clone(), "this `{` belongs to no block")
                .expected("a name before it"),
            _ => {
                let home = rules().find(|r| r.param(token.text).is_some());
                let d = Diagnostic::error(
                    token.span.clone(),
                    format!("{} stands outside of any block", describe(token)),
                )
                .expected("the name of a block, and `{`");
                match (home, nearest(token.text, rules().map(|r| r.name))) {
                    (Some(home), _) => d.help(format!("it is a parameter of `{}`", home.name)),
                    (None, Some(near)) => d.help(did_you_mean(token.text, near)),
                    _ => d,
                }
            }
        };
        self.log.push(d);
        while let Some(token) = self.peek() {
            let begins = token.kind == TokenKind::Word && rule(token.text).is_some();
            if self.at_block() || (begins && token.starts_line) {
                break;
            }
            self.at += 1;
            if token.kind == TokenKind::Open {
                self.skip_braces();
            }
        }
    }

    /// Behind a `{`: goes behind its `}`.
    fn skip_braces(&mut self) {
        let mut depth = 1;
        while let Some(token) = self.peek() {
            self.at += 1;
            match token.kind {
                TokenKind::Open => depth += 1,
                TokenKind::Close => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
    }

    /// The parameters, and the `}`.
    fn body(&mut self, name: &Token, rule: &'static Rule) -> Block {
        let line = self.lines.at(self.source, name.span.start);
        let (keyword, entries, children) = (name.span.clone(), Vec::new(), Vec::new());
        let mut block = Block { rule, keyword, line, entries, children, closed: false };
        loop {
            match self.peek() {
                Some(token) if token.kind == TokenKind::Close => {
                    self.at += 1;
                    block.closed = true;
                    break;
                }
                Some(token) if self.at_inner_block(rule) => self.inner_block(token, &mut block),
                Some(_) if !self.at_next_block() => self.entry(&mut block),
                None if self.cut => break,
                next => {
                    self.log.push(unclosed(&block, next));
                    break;
                }
            }
        }
        block
    }

    /// A block inside of a block, unless there are too many around it.
    fn inner_block(&mut self, name: &Token, outer: &mut Block) {
        if self.depth == DEEPEST {
            let d = Diagnostic::error(name.span.clone(), format!("`{}` stands too deep", name.text));
            self.log.push(d.expected(format!("at most {DEEPEST} blocks inside one another")));
            self.at += 2;
            self.skip_braces();
            self.cut = true;
            return;
        }
        self.depth += 1;
        outer.children.extend(self.block());
        self.depth -= 1;
    }

    /// One parameter with its values, or one mistake.
    fn entry(&mut self, block: &mut Block) {
        let Some(token) = self.peek() else { return };
        self.at += 1;
        let known = if token.kind == TokenKind::Word { block.rule.param(token.text) } else { None };
        let Some(param) = known else {
            self.unknown_entry(token, block);
            return;
        };
        if param.name != token.text {
            let message = format!("{} is read as `{}`", quoted(token.text), param.name);
            self.log.push(Diagnostic::note(token.span.clone(), message).help("the document misprints it so"));
        }
        let entry = self.values(token, param, block.rule);
        let first = block.entries.iter().find(|e| e.param.name == param.name);
        if let Some(first) = first.filter(|_| param.times == Times::Once) {
            let d = Diagnostic::error(
                token.span.clone(),
                format!("`{}` is given twice in one block", param.name),
            )
            .expected("it once")
            .related(first.keyword.clone(), "first given here");
            self.log.push(d);
            return;
        }
        block.entries.push(entry);
    }

    fn unknown_entry(&mut self, token: &'a Token, block: &mut Block) {
        let rule = block.rule;
        let names: Vec<_> = rule.params.iter().map(|p| p.name).collect();
        let message = match token.kind {
            TokenKind::Word if !value::looks_like_number(token.text) => {
                format!("`{}` has no parameter {}", rule.name, quoted(token.text))
            }
            _ => format!("{} belongs to no parameter of `{}`", describe(token), rule.name),
        };
        let near = nearest(token.text, names.iter().copied()).filter(|_| token.kind == TokenKind::Word);
        let d = Diagnostic::error(token.span.clone(), message)
            .expected(format!("a parameter of `{}`", rule.name));
        self.log.push(match near {
            Some(near) => d.help(did_you_mean(token.text, near)),
            None => d.help(format!("its parameters are {}", names.join(", "))),
        });
        self.at -= usize::from(token.kind == TokenKind::Open); // so that its `}` is skipped as well
        self.resume(rule);
        // Whoever misspells a required parameter has given it.
        let meant = near.and_then(|n| rule.param(n)).filter(|p| block.entry(p.name).is_none());
        if let Some(param) = meant {
            block.entries.push(Entry {
                param,
                keyword: token.span.clone(),
                span: token.span.clone(),
                value: None,
            });
        }
    }

    /// The values behind a parameter's name.
    fn values(&mut self, name: &Token, param: &'static Param, rule: &Rule) -> Entry {
        let first = self.at;
        let mut entry = Entry { param, keyword: name.span.clone(), span: name.span.clone(), value: None };
        while self.at - first < param.kind.count() {
            let Some(token) = self.peek().filter(|t| self.is_value(t, param, rule)) else {
                let given = &self.tokens[first..self.at];
                self.log.push(missing(name, param, given, self.found()));
                self.resume(rule);
                return entry;
            };
            self.at += 1;
            if let Err(d) = value::check_one(token, param) {
                self.log.push(*d);
                self.resume(rule);
                return entry;
            }
        }
        let given = &self.tokens[first..self.at];
        let extra = self.tokens[self.at..].iter().take_while(|t| is_surplus(t, rule)).count();
        if extra > 0 {
            self.log.push(surplus(param, given.len() + extra, &self.tokens[self.at..self.at + extra]));
            self.resume(rule);
            return entry;
        }
        entry.span = given.first().map_or(0, |t| t.span.start)..given.last().map_or(0, |t| t.span.end);
        entry.value = value::value(given, &entry.span, param).map_err(|d| self.log.push(*d)).ok();
        entry
    }

    /// Can the token here be meant as a value? Braces, parameters and blocks are not, and where
    /// numbers are wanted, neither is a word on a new line.
    fn is_value(&self, token: &Token, param: &Param, rule: &Rule) -> bool {
        let numeric = matches!(param.kind, Kind::Numbers { .. } | Kind::Integers { .. });
        match token.kind {
            TokenKind::Open | TokenKind::Close => false,
            TokenKind::Quoted => true,
            TokenKind::Word if rule.param(token.text).is_some() || self.at_next_block() => false,
            TokenKind::Word => !(numeric && token.starts_line && !value::looks_like_number(token.text)),
        }
    }

    /// Goes to where the next parameter may begin.
    fn resume(&mut self, rule: &Rule) {
        let first = self.at;
        while let Some(token) = self.peek() {
            let word = token.kind == TokenKind::Word && !value::looks_like_number(token.text);
            let known = word && rule.param(token.text).is_some();
            if known || token.kind == TokenKind::Close || self.at_next_block() {
                break;
            }
            if word && (token.starts_line || self.at > first) {
                break;
            }
            self.at += 1;
            if token.kind == TokenKind::Open {
                self.skip_braces();
            }
        }
    }
}

/// A value behind the last one that a parameter takes.
fn is_surplus(token: &Token, rule: &Rule) -> bool {
    match token.kind {
        TokenKind::Open | TokenKind::Close => false,
        TokenKind::Quoted => true,
        TokenKind::Word => rule.param(token.text).is_none() && value::looks_like_number(token.text),
    }
}

/// A token, for messages.
pub fn describe(token: &Token) -> String {
    match token.kind {
        TokenKind::Quoted => format!("the text {}", quoted(token.text)),
        _ => quoted(token.text),
    }
}

fn did_you_mean(written: &str, near: &str) -> String {
    let same = written.to_lowercase() == near.to_lowercase();
    let hint = if same { " (capital letters count)" } else { "" };
    format!("did you mean `{near}`?{hint}")
}

fn unclosed(block: &Block, next: Option<&Token>) -> Diagnostic {
    let message = format!("block `{}` is never closed", block.rule.name);
    let d = Diagnostic::error(block.keyword.clone(), message);
    match next {
        Some(t) => {
            d.expected("`}` before the next block").related(t.span.clone(), "the next block begins here")
        }
        None => d.expected("`}` before the end of the file"),
    }
}

fn missing(name: &Token, param: &Param, given: &[Token], found: String) -> Diagnostic {
    let span = name.span.start..given.last().map_or(name.span.end, |t| t.span.end);
    let message = match given.len() {
        0 => format!("`{}` has no value", param.name),
        n => format!("`{}` has {n} of its {} values", param.name, param.kind.count()),
    };
    Diagnostic::error(span, message)
        .expected(param.kind.all())
        .found(found)
        .help(format!("write `{} {}`", param.name, param.values))
}

fn surplus(param: &Param, given: usize, extra: &[Token]) -> Diagnostic {
    let span = extra[0].span.start..extra[extra.len() - 1].span.end;
    Diagnostic::error(span, format!("`{}` has too many values", param.name))
        .expected(param.kind.all())
        .found(format!("{given} values"))
        .help(format!("write `{} {}`", param.name, param.values))
}
