//! A tree as indented text, as the document's editor shows it.

use super::CsgFile;
use super::link::title;
use super::operation;

/// Most lines of an outline.
const MOST_LINES: usize = 200;

impl CsgFile {
    /// Every node under what holds it, also of files that are wrong: `Sphere 0`, `(missing)`, `Union 1 (holds itself)`.
    pub fn outline(&self) -> String {
        let (mut lines, mut shown) = (Vec::new(), vec![false; self.blocks.len()]);
        // What goes in circles hangs on no top; every solid hangs on a top or on a circle, or is a top.
        let rest = (0..self.blocks.len()).filter(|&i| operation(&self.blocks[i]).is_some());
        for node in self.links.tops.iter().copied().chain(rest) {
            if !shown[node] {
                self.add(Some(node), String::new(), "", &mut Vec::new(), &mut lines);
                self.mark(node, &mut shown);
            }
        }
        if lines.len() > MOST_LINES {
            lines.truncate(MOST_LINES);
            lines.push("…".to_owned());
        }
        lines.iter().map(|line| format!("  {line}\n")).collect()
    }

    /// Everything below a node has been shown with it.
    fn mark(&self, node: usize, shown: &mut [bool]) {
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            if !std::mem::replace(&mut shown[node], true) {
                open.extend(self.links.operands[node].iter().flatten());
            }
        }
    }

    fn add(
        &self,
        node: Option<usize>,
        indent: String,
        branch: &str,
        above: &mut Vec<usize>,
        out: &mut Vec<String>,
    ) {
        if out.len() > MOST_LINES {
            return;
        }
        let Some(node) = node else { return out.push(format!("{indent}{branch}(missing)")) };
        let name = title(&self.blocks, node);
        if above.contains(&node) {
            return out.push(format!("{indent}{branch}{name} (holds itself)"));
        }
        let is_operation = operation(&self.blocks[node]).is_some();
        let alone = branch.is_empty() && self.links.root != Some(node); // a top, as said above
        let remark = if alone && !is_operation { " (not used)" } else { "" };
        out.push(format!("{indent}{branch}{name}{remark}"));
        if !is_operation {
            return;
        }
        above.push(node);
        let [left, right] = self.links.operands[node];
        let further = match branch {
            "" => String::new(),
            "└─ " => indent + "   ",
            _ => indent + "│  ",
        };
        self.add(left, further.clone(), "├─ ", above, out);
        self.add(right, further, "└─ ", above, out);
        above.pop();
    }

    /// Numbers of operations and solids.
    pub fn counts(&self) -> (usize, usize) {
        let operations = self.blocks.iter().filter(|b| operation(b).is_some()).count();
        (operations, self.blocks.len() - operations)
    }
}
