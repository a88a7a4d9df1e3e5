//! What the user's names mean.

use std::collections::HashMap;

use proc_macro2::{Ident, Span};

use crate::ir::VarId;

/// A name as the compiler tells names apart: two that read the same are two names where different
/// expansions of a `macro_rules!` wrote them.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name {
    text: String,
    context: String,
}

impl Name {
    /// The name that an identifier is.
    pub fn of(ident: &Ident) -> Self {
        Self { text: ident.to_string(), context: context(ident.span()) }
    }
}

/// The expansion that a span is from. The interface of procedural macros tells it by the printed form
/// of spans alone: `#3 bytes(10..12)` is from expansion 3. Where it is printed otherwise all names are
/// taken to be from one.
fn context(span: Span) -> String {
    let printed = format!("{span:?}");
    let context = printed.split(' ').next().filter(|context| context.starts_with('#'));
    context.unwrap_or_default().to_owned()
}

/// The meanings of names, innermost scope last.
#[derive(Clone, Default)]
pub struct Scopes(Vec<HashMap<Name, VarId>>);

impl Scopes {
    /// Opens a scope.
    pub fn open(&mut self) {
        self.0.push(HashMap::new());
    }

    /// Closes the innermost scope.
    pub fn close(&mut self) {
        self.0.pop();
    }

    /// Forgets what the innermost scope binds.
    pub fn clear(&mut self) {
        self.innermost().clear();
    }

    /// Lets `name` mean `var` from here on.
    pub fn bind(&mut self, name: &Ident, var: VarId) {
        self.innermost().insert(Name::of(name), var);
    }

    /// What a name means.
    pub fn lookup(&self, name: &Ident) -> Option<VarId> {
        let name = Name::of(name);
        self.0.iter().rev().find_map(|scope| scope.get(&name).copied())
    }

    /// The number of scopes.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Whether one of the scopes from number `start` on binds a name.
    pub fn binds_within(&self, start: usize, name: &Ident) -> bool {
        let name = Name::of(name);
        self.0.iter().skip(start).any(|scope| scope.contains_key(&name))
    }

    /// What a name means that the innermost scope binds.
    pub fn lookup_innermost(&self, name: &Ident) -> Option<VarId> {
        self.0.last()?.get(&Name::of(name)).copied()
    }

    /// The names whose meanings have others in `meanings`, with these.
    pub fn renamed(&self, meanings: &HashMap<VarId, VarId>) -> Self {
        let mut names = HashMap::new();
        for (name, var) in self.0.iter().flatten() {
            match meanings.get(var) {
                Some(&meaning) => names.insert(name.clone(), meaning),
                None => names.remove(name),
            };
        }
        Self(vec![names])
    }

    fn innermost(&mut self) -> &mut HashMap<Name, VarId> {
        self.0.last_mut().expect("a scope is open")
    }
}
