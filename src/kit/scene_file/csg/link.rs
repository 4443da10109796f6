//! Who names whom, and what is wrong with it.

use super::{MOST_DEEP, MOST_SOLIDS, operation};
use crate::scene_file::diagnostic::{Diagnostic, Severity};
use crate::scene_file::parse::{Block, Parsed};

/// The operands of a file's blocks, and the block that nobody names.
#[derive(Debug)]
pub struct Links {
    /// Left and right of each operation, where they exist; of solids, none.
    pub operands: Vec<[Option<usize>; 2]>,
    pub root: Option<usize>,
    /// Blocks that nobody names, in the file's order.
    pub tops: Vec<usize>,
}

/// The block that a type and an index mean.
pub fn find(blocks: &[Block], of_type: &str, index: usize) -> Option<usize> {
    blocks.iter().enumerate().filter(|(_, b)| is_of(b, of_type)).map(|(i, _)| i).nth(index)
}

fn is_of(block: &Block, of_type: &str) -> bool {
    block.rule.name == of_type || (of_type == "Operation" && operation(block).is_some())
}

/// `Sphere 0`: type and index of a block.
pub fn title(blocks: &[Block], node: usize) -> String {
    let name = blocks[node].rule.name;
    format!("{name} {}", blocks[..node].iter().filter(|b| b.rule.name == name).count())
}

impl Links {
    pub fn new(parsed: &Parsed, source: &str, log: &mut Vec<Diagnostic>) -> Self {
        let blocks = &parsed.blocks;
        let whole = parsed.lost == 0; // else what is missed may stand in what could not be read
        let operands: Vec<_> = blocks.iter().map(|b| operands(b, blocks, whole, log)).collect();
        let named: Vec<usize> = operands.iter().flatten().flatten().copied().collect();
        let tops: Vec<usize> = (0..blocks.len()).filter(|i| !named.contains(i)).collect();
        let mut links = Links { operands, root: None, tops };
        if blocks.is_empty() && whole {
            let end = source.trim_end().len();
            let d = Diagnostic::error(end..end, "this file holds no tree");
            log.push(d.expected("solids, and operations that name them"));
        }
        let circles = links.circles(blocks, log);
        links.root = links.find_root(blocks, log);
        if circles == 0 {
            links.check_size(blocks, log);
        }
        links
    }

    /// Reports every operation that leads back to itself; their number.
    fn circles(&self, blocks: &[Block], log: &mut Vec<Diagnostic>) -> usize {
        #[derive(Clone, Copy, PartialEq)]
        enum Seen {
            Never,
            OnTheWay,
            Done,
        }
        let mut seen = vec![Seen::Never; blocks.len()];
        let mut found = 0;
        // Begun where the outline begins, so that both say of the same node that it holds itself.
        for start in self.tops.iter().copied().chain(0..blocks.len()) {
            let mut way: Vec<(usize, usize)> = Vec::new(); // a node, and how many operands are done
            if seen[start] == Seen::Never {
                way.push((start, 0));
                seen[start] = Seen::OnTheWay;
            }
            while let Some((node, done)) = way.last_mut() {
                let node = *node;
                let Some(child) = self.operands[node].get(*done).copied() else {
                    seen[node] = Seen::Done;
                    way.pop();
                    continue;
                };
                *done += 1;
                match child.map(|c| (c, seen[c])) {
                    Some((child, Seen::Never)) => {
                        seen[child] = Seen::OnTheWay;
                        way.push((child, 0));
                    }
                    // An operation that names it twice is one mistake.
                    Some((child, Seen::OnTheWay))
                        if !self.operands[node][..*done - 1].contains(&Some(child)) =>
                    {
                        found += 1;
                        let from = way.iter().position(|w| w.0 == child).unwrap_or(0);
                        let circle: Vec<_> = way[from..].iter().map(|w| title(blocks, w.0)).collect();
                        let message =
                            format!("{} holds itself: {} → {}", circle[0], circle.join(" → "), circle[0]);
                        let d = Diagnostic::error(blocks[node].keyword.clone(), message);
                        log.push(d.expected("a tree: no node below itself"));
                    }
                    _ => {}
                }
            }
        }
        found
    }

    /// The operation that nobody names, or else the solid; the others are told.
    fn find_root(&self, blocks: &[Block], log: &mut Vec<Diagnostic>) -> Option<usize> {
        let is_operation = |i: &usize| operation(&blocks[*i]).is_some();
        let (operations, solids): (Vec<usize>, Vec<usize>) =
            self.tops.iter().copied().partition(is_operation);
        let (root, others) = match (&operations[..], &solids[..]) {
            ([root, others @ ..], _) => (*root, others),
            ([], [root, others @ ..]) if blocks.iter().all(|b| operation(b).is_none()) => (*root, others),
            _ => return None, // a circle, or nothing: reported
        };
        for &other in others {
            let message = format!("{} and {} are held by none", title(blocks, root), title(blocks, other));
            let d = Diagnostic::error(blocks[other].keyword.clone(), message);
            let d = d.related(blocks[root].keyword.clone(), "this one too");
            log.push(d.expected("one whole: a single node that no other names"));
        }
        let unused = solids.iter().filter(|s| **s != root && !others.contains(s));
        log.extend(unused.map(|&s| {
            let message = format!("{} is not used: no operation names it", title(blocks, s));
            Diagnostic::new(Severity::Warning, blocks[s].keyword.clone(), message)
        }));
        others.is_empty().then_some(root)
    }

    /// A node that is named twice stands twice in the tree: doublings of doublings grow beyond all memory.
    fn check_size(&self, blocks: &[Block], log: &mut Vec<Diagnostic>) {
        let Some(root) = self.root else { return };
        let mut known: Vec<Option<(usize, usize)>> = vec![None; blocks.len()]; // solids, and operations in a row
        let mut open = vec![root];
        while let Some(&node) = open.last() {
            let unknown = |c: &usize| known[*c].is_none();
            let before = open.len();
            open.extend(self.operands[node].iter().flatten().copied().filter(unknown));
            if open.len() > before {
                continue;
            }
            let below = self.operands[node].iter().flatten().filter_map(|&c| known[c]);
            let (solids, depth) =
                below.fold((0usize, 0), |(s, d), (n, m)| (s.saturating_add(n), d.max(m + 1)));
            known[node] = Some((solids.max(1), depth));
            open.pop();
        }
        let (solids, depth) = known[root].unwrap_or((0, 0));
        let place = || blocks[root].keyword.clone();
        if solids > MOST_SOLIDS {
            let d = Diagnostic::error(place(), "the tree is too large");
            log.push(d.expected(format!("at most {MOST_SOLIDS} solids")).found(format!("{solids}")));
        } else if depth > MOST_DEEP {
            let d = Diagnostic::error(place(), "the tree is too deep");
            let expected = format!("at most {MOST_DEEP} operations inside one another");
            log.push(d.expected(expected).found(format!("{depth}")));
        }
    }
}

/// What an operation names; what is missing is told.
fn operands(block: &Block, blocks: &[Block], whole: bool, log: &mut Vec<Diagnostic>) -> [Option<usize>; 2] {
    if operation(block).is_none() {
        return [None, None];
    }
    [("LeftType", "LeftIndex"), ("RightType", "RightIndex")].map(|(of_type, index)| {
        for (name, what) in [(of_type, "the type of a block"), (index, "a whole number ≥ 0")] {
            if block.closed && block.children.is_empty() && block.entry(name).is_none() {
                let message = format!("`{}` has no `{name}`: an operand is missing", block.rule.name);
                log.push(Diagnostic::error(block.keyword.clone(), message).expected(what));
            }
        }
        let word = block.entry(of_type)?.value.as_ref()?.word();
        block.entry(index)?.value.as_ref()?;
        let [number] = block.integers(index);
        let found = usize::try_from(number).ok().and_then(|n| find(blocks, word, n));
        if found.is_none() && whole {
            let count = blocks.iter().filter(|b| is_of(b, word)).count();
            let message = format!("{word} {number} does not exist: an operand is missing");
            let d = Diagnostic::error(block.span(index), message);
            log.push(match count {
                0 => d.expected(format!("a `{word}` in this file")).found("none"),
                n => d.expected(format!("a number from 0 to {}", n - 1)).found(number.to_string()),
            });
        }
        found
    })
}
