//! What is written, and the names that are visible where it goes on.

use crate::random::Random;
use crate::text::{Both, put};

pub const NAMES: [&str; 6] = ["a", "b", "c", "d", "e", "f"];

/// What a name stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Scalar { mutable: bool },
    Array { length: usize, mutable: bool },
    Integer,
    Pair,
}

impl Kind {
    pub fn is_scalar(self) -> bool {
        matches!(self, Self::Scalar { .. })
    }

    pub fn is_array(self) -> bool {
        matches!(self, Self::Array { .. })
    }

    pub fn is_mutable(self) -> bool {
        matches!(self, Self::Scalar { mutable: true } | Self::Array { mutable: true, .. })
    }
}

#[derive(Clone)]
pub struct Variable {
    pub name: String,
    pub kind: Kind,
}

impl Variable {
    pub fn length(&self) -> usize {
        match self.kind {
            Kind::Array { length, .. } => length,
            Kind::Scalar { .. } | Kind::Integer | Kind::Pair => 1,
        }
    }
}

pub struct Writer {
    pub random: Random,
    /// The number of the program: it may call earlier ones.
    pub index: u64,
    plain: String,
    generic: String,
    indent: usize,
    scopes: Vec<Vec<Variable>>,
    /// The labels of the loops around, innermost last.
    pub loops: Vec<String>,
    /// How many names were made that are not shadowed.
    fresh: usize,
    /// How many more statements the program may have.
    pub budget: usize,
    /// In how many loops it lies that run twice.
    pub repeated: usize,
}

impl Writer {
    pub fn new(random: Random, index: u64) -> Self {
        let parameter =
            |name: &str| Variable { name: name.to_owned(), kind: Kind::Scalar { mutable: false } };
        Self {
            random,
            index,
            plain: String::new(),
            generic: String::new(),
            indent: 1,
            scopes: vec![vec![parameter("x"), parameter("y")]],
            loops: Vec::new(),
            fresh: 0,
            budget: 14,
            repeated: 0,
        }
    }

    /// Gives the parameters other names.
    pub fn rename_parameters(&mut self, names: [&str; 2]) {
        for (parameter, name) in self.scopes[0].iter_mut().zip(names) {
            parameter.name = name.to_owned();
        }
    }

    pub fn finish(self) -> (String, String) {
        (self.plain, self.generic)
    }

    pub fn line(&mut self, line: &Both) {
        let indent = "    ".repeat(self.indent);
        for (text, part) in [(&mut self.plain, &line.plain), (&mut self.generic, &line.generic)] {
            *text += &indent;
            *text += part;
            text.push('\n');
        }
    }

    /// The variables that names stand for here, of some kind.
    pub fn visible(&self, wanted: fn(Kind) -> bool) -> Vec<Variable> {
        let mut seen = Vec::new();
        for variable in self.scopes.iter().rev().flat_map(|scope| scope.iter().rev()) {
            if !seen.iter().any(|seen: &Variable| seen.name == variable.name) {
                seen.push(variable.clone());
            }
        }
        seen.retain(|variable| wanted(variable.kind));
        seen
    }

    pub fn integers(&self) -> Vec<String> {
        let integers = self.visible(|kind| kind == Kind::Integer);
        integers.into_iter().map(|variable| variable.name).collect()
    }

    pub fn declare(&mut self, name: &str, kind: Kind) {
        let variable = Variable { name: name.to_owned(), kind };
        self.scopes.last_mut().expect("a scope is open").push(variable);
    }

    pub fn fresh(&mut self, base: &str) -> String {
        self.fresh += 1;
        format!("{base}{}", self.fresh)
    }

    pub fn open_scope(&mut self) {
        self.scopes.push(Vec::new());
    }

    pub fn close_scope(&mut self) {
        self.scopes.pop();
    }

    /// A block in braces; `head` stands before it.
    pub fn block(&mut self, head: &Both, fill: impl FnOnce(&mut Self), end: &str) {
        self.line(&put("{} {", &[head]));
        self.rest_of_block(fill, end);
    }

    /// What stands behind the brace that opens a block.
    pub fn rest_of_block(&mut self, fill: impl FnOnce(&mut Self), end: &str) {
        self.indent += 1;
        self.open_scope();
        fill(self);
        self.close_scope();
        self.indent -= 1;
        self.line(&Both::same(format!("}}{end}")));
    }

    /// Whether the statement being written may run twice, and has to do the same both times.
    pub fn is_pure(&self) -> bool {
        self.repeated > 0
    }
}
