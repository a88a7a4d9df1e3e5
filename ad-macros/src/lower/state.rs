//! What is known while a function is being lowered.

use std::collections::{HashMap, HashSet};

use syn::{ExprClosure, Item, Lifetime, Path, Type, UseTree};

use super::scopes::Scopes;
use crate::ir::Place;
use crate::parse::options::is_own;

/// A name for a reference to a place: reading it reads the place.
#[derive(Clone)]
pub(super) struct Alias {
    pub place: Place,
    /// How many times the place is referred to: 1 for `&place`, 2 for `&&place`.
    pub depth: usize,
    /// Whether it is a `&mut`.
    pub is_exclusive: bool,
}

/// What the form of an expression tells of its type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Container {
    Array,
    Option,
    Result,
}

impl Container {
    /// What a type is.
    pub fn of(ty: &Type) -> Option<Self> {
        match ty {
            Type::Array(_) => Some(Self::Array),
            Type::Paren(inner) => Self::of(&inner.elem),
            Type::Path(path) if path.path.segments.last()?.ident == "Option" => Some(Self::Option),
            Type::Path(path) if path.path.segments.last()?.ident == "Result" => Some(Self::Result),
            _ => None,
        }
    }
}

/// A closure that has a name.
pub(super) struct Closure {
    pub body: ExprClosure,
    /// What names mean where it was written.
    pub scopes: Scopes,
}

/// Identifies what a jump leaves: a function, a loop, a labelled block.
pub(super) type JumpId = usize;

/// Identifies what tells by a `ControlFlow` how it ended: a loop, a branch.
pub(super) type Fork = usize;

/// What jumps can leave.
pub(super) struct Jump {
    pub id: JumpId,
    pub label: Option<Lifetime>,
    pub kind: JumpKind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum JumpKind {
    Function,
    /// A loop that the user wrote.
    Loop,
    /// The loop of an iterator, which no jump leads to.
    Chain,
    Block,
}

/// The functions that the body of a function brings along.
#[derive(Clone, Default)]
pub(super) struct LocalFunctions {
    /// Those that it declares without the attribute.
    pub plain: HashSet<String>,
    /// Those that it declares with it.
    pub derived: HashSet<String>,
    /// The paths of those that it imports, by their names.
    pub imported: HashMap<String, Path>,
}

impl LocalFunctions {
    /// Those of the items of a body.
    pub fn of<'i>(items: impl IntoIterator<Item = &'i Item>) -> Self {
        let mut functions = Self::default();
        for item in items {
            match item {
                Item::Fn(function) => {
                    let declared = match function.attrs.iter().any(is_own) {
                        true => &mut functions.derived,
                        false => &mut functions.plain,
                    };
                    declared.insert(function.sig.ident.to_string());
                }
                Item::Use(import) if !import.attrs.iter().any(is_own) => {
                    let start =
                        Path { leading_colon: import.leading_colon, segments: Default::default() };
                    functions.import(&import.tree, start);
                }
                _ => {}
            }
        }
        functions
    }

    fn import(&mut self, tree: &UseTree, mut path: Path) {
        match tree {
            UseTree::Path(step) => {
                path.segments.push(step.ident.clone().into());
                self.import(&step.tree, path);
            }
            UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.import(tree, path.clone()));
            }
            UseTree::Name(name) => {
                path.segments.push(name.ident.clone().into());
                self.imported.insert(name.ident.to_string(), path);
            }
            UseTree::Rename(name) => {
                path.segments.push(name.ident.clone().into());
                self.imported.insert(name.rename.to_string(), path);
            }
            UseTree::Glob(_) => {}
        }
    }
}
