//! Which names of constructors mean variants of an enum where the enum is not named with them.
//!
//! `Disc(r)` may be a tuple struct or, behind `use Shape::*`, a variant of an enum, and the cotangent
//! of `r` lies in another place then. What stands around it tells: a value that other constructors
//! match too, or that may be none of this one, is that of an enum, and so are values of one type that several
//! constructors make, as the elements of an array. A guess that is wrong does not
//! compile, for the field of the tangent that it names is not there.

use std::collections::{HashMap, HashSet};

use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{
    Block, Expr, ExprLet, GenericArgument, Local, Pat, Path, PathArguments, Stmt, Type, UseTree,
};

use crate::lower::syntax::{is_type_name, standard_macro};

/// The names that mean variants in a function with this body and this result, and these types of
/// parameters.
pub fn of<'t>(
    types: impl IntoIterator<Item = &'t Type>,
    result: &'t Type,
    body: &Block,
) -> HashSet<String> {
    let mut variants = Variants::default();
    types.into_iter().chain([result]).for_each(|ty| variants.visit_type(ty));
    variants.visit_block(body);
    variants.made_by_block(result, body);
    variants.returned(result, body);
    let Variants { mut known, constructors, values, types, imports_all } = variants;
    // A struct has one constructor.
    known.extend(values.into_values().filter(|names| names.len() > 1).flatten());
    if imports_all {
        known.extend(constructors);
    }
    // A variant is no type.
    known.retain(|name| !types.contains(name));
    known
}

#[derive(Default)]
struct Variants {
    /// The names found.
    known: HashSet<String>,
    /// The constructors that are used without an enum.
    constructors: HashSet<String>,
    /// The constructors of values that are declared to be of a type, by its name.
    values: HashMap<String, HashSet<String>>,
    /// The names of types.
    types: HashSet<String>,
    /// Whether there is a `use Enum::*` in the function.
    imports_all: bool,
}

impl Variants {
    /// Looks through the patterns that one value is matched against, in their order. `is_partial`
    /// says that something follows for a value that none of them matches.
    fn patterns(&mut self, pats: &[&Pat], is_partial: bool) {
        self.column(pats);
        // What matches every value if its constructors are those of structs, and yet is not the last.
        let last = if is_partial { pats.len() } else { pats.len().saturating_sub(1) };
        for pat in &pats[..last] {
            let mut names = Vec::new();
            if is_whole(pat, &mut names) {
                names.dedup();
                if let [name] = &names[..] {
                    self.known.insert(name.clone());
                }
            }
        }
    }

    /// Looks for values that several constructors match.
    fn column(&mut self, pats: &[&Pat]) {
        let mut alternatives = Vec::new();
        pats.iter().for_each(|pat| flatten(pat, &mut alternatives));
        let constructors: Vec<_> = alternatives.iter().filter_map(|pat| constructor(pat)).collect();
        // `Self` beside the name of a struct is the same constructor.
        let names = constructors.iter().map(|(name, _)| name);
        let mut names: Vec<_> = names.filter(|name| *name != "Self").collect();
        names.sort();
        names.dedup();
        if names.len() > 1 {
            let bare = constructors.iter().filter(|(_, is_bare)| *is_bare);
            self.known.extend(bare.map(|(name, _)| name.clone()));
        }
        for (name, _) in &constructors {
            let same = alternatives.iter().filter_map(|pat| match pat {
                Pat::TupleStruct(pattern) if last_name(&pattern.path) == *name => {
                    Some(&pattern.elems)
                }
                _ => None,
            });
            self.columns(&same.collect::<Vec<_>>());
        }
        let tuples = alternatives.iter().filter_map(|pat| match pat {
            Pat::Tuple(tuple) => Some(&tuple.elems),
            _ => None,
        });
        self.columns(&tuples.collect::<Vec<_>>());
    }

    /// The same for the parts of a value.
    fn columns(&mut self, rows: &[&syn::punctuated::Punctuated<Pat, syn::Token![,]>]) {
        let Some(width) = rows.first().map(|row| row.len()) else { return };
        let has_rest = |pat: &Pat| matches!(pat, Pat::Rest(_));
        if rows.iter().any(|row| row.len() != width || row.iter().any(has_rest)) {
            return;
        }
        for index in 0..width {
            let column: Vec<_> = rows.iter().map(|row| &row[index]).collect();
            self.column(&column);
        }
    }

    /// Looks for several constructors among values of one type.
    fn alike<'e>(&mut self, values: impl IntoIterator<Item = &'e Expr>) {
        let mut names = HashSet::new();
        values.into_iter().for_each(|value| made_by(value, &mut names));
        if names.len() > 1 {
            self.known.extend(names);
        }
    }

    /// Looks for the constructors of a value that is declared to be of a type.
    fn made(&mut self, ty: &Type, value: &Expr) {
        match value {
            Expr::Paren(inner) => self.made(ty, &inner.expr),
            Expr::Block(block) => self.made_by_block(ty, &block.block),
            Expr::If(branch) => {
                self.made_by_block(ty, &branch.then_branch);
                if let Some((_, otherwise)) = &branch.else_branch {
                    self.made(ty, otherwise);
                }
            }
            Expr::Match(branch) => branch.arms.iter().for_each(|arm| self.made(ty, &arm.body)),
            Expr::Struct(literal) => self.declared(ty, &literal.path),
            Expr::Call(call) => {
                let Expr::Path(function) = &*call.func else { return };
                match (content(ty), call.args.first()) {
                    (Some(content), Some(value)) if wraps(&function.path) => {
                        self.made(content, value);
                    }
                    (None, _) => self.declared(ty, &function.path),
                    _ => {}
                }
            }
            _ => {}
        }
    }

    fn made_by_block(&mut self, ty: &Type, block: &Block) {
        if let Some(value) = last_value(block) {
            self.made(ty, value);
        }
    }

    /// The same for what is returned early.
    fn returned(&mut self, ty: &Type, body: &Block) {
        struct Returns<'v>(&'v mut Variants, &'v Type);

        impl<'ast> Visit<'ast> for Returns<'_> {
            fn visit_expr_return(&mut self, jump: &'ast syn::ExprReturn) {
                if let Some(value) = &jump.expr {
                    self.0.made(self.1, value);
                }
                visit::visit_expr_return(self, jump);
            }

            // Those of closures and items are theirs.
            fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}

            fn visit_item(&mut self, _: &'ast syn::Item) {}
        }

        Returns(self, ty).visit_block(body);
    }

    /// Notes a constructor of a value that is declared to be of a type.
    fn declared(&mut self, ty: &Type, constructor: &Path) {
        let Type::Path(ty) = ty else { return };
        let (owner, Some(name)) = (last_name(&ty.path), constructor.get_ident()) else { return };
        if is_type_name(name) && name != "Self" {
            self.values.entry(owner).or_default().insert(name.to_string());
        }
    }

    /// Notes a constructor in an expression.
    fn used(&mut self, path: &Path) {
        if let Some(name) = path.get_ident()
            && is_type_name(name)
        {
            self.constructors.insert(name.to_string());
        }
    }

    fn imported(&mut self, tree: &UseTree) {
        match tree {
            UseTree::Path(path) => self.imported(&path.tree),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.imported(tree)),
            UseTree::Name(name) => self.known.extend([name.ident.to_string()]),
            UseTree::Glob(_) => self.imports_all = true,
            UseTree::Rename(_) => {}
        }
    }
}

impl<'ast> Visit<'ast> for Variants {
    fn visit_expr_match(&mut self, branch: &'ast syn::ExprMatch) {
        self.patterns(&branch.arms.iter().map(|arm| &arm.pat).collect::<Vec<_>>(), false);
        self.alike(branch.arms.iter().map(|arm| &*arm.body));
        visit::visit_expr_match(self, branch);
    }

    fn visit_expr_if(&mut self, branch: &'ast syn::ExprIf) {
        let otherwise = branch.else_branch.as_ref().map(|(_, otherwise)| &**otherwise);
        self.alike(last_value(&branch.then_branch).into_iter().chain(otherwise));
        visit::visit_expr_if(self, branch);
    }

    fn visit_expr_array(&mut self, array: &'ast syn::ExprArray) {
        self.alike(&array.elems);
        visit::visit_expr_array(self, array);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let elements = Punctuated::<Expr, syn::Token![,]>::parse_terminated;
        if let (Some("vec"), Ok(elements)) =
            (standard_macro(&call.path).as_deref(), call.parse_body_with(elements))
        {
            self.alike(&elements);
        }
    }

    fn visit_expr_let(&mut self, condition: &'ast ExprLet) {
        self.patterns(&[&condition.pat], true);
        visit::visit_expr_let(self, condition);
    }

    fn visit_local(&mut self, local: &'ast Local) {
        let is_partial = local.init.as_ref().is_some_and(|init| init.diverge.is_some());
        self.patterns(&[&local.pat], is_partial);
        if let (Pat::Type(typed), Some(init)) = (&local.pat, &local.init) {
            self.made(&typed.ty, &init.expr);
        }
        visit::visit_local(self, local);
    }

    fn visit_type_path(&mut self, path: &'ast syn::TypePath) {
        self.types.insert(last_name(&path.path));
        visit::visit_type_path(self, path);
    }

    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        if let Expr::Path(path) = &*call.func {
            self.used(&path.path);
        }
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_struct(&mut self, literal: &'ast syn::ExprStruct) {
        self.used(&literal.path);
        visit::visit_expr_struct(self, literal);
    }

    fn visit_pat(&mut self, pat: &'ast Pat) {
        if let Some((name, true)) = constructor(pat) {
            self.constructors.insert(name);
        }
        visit::visit_pat(self, pat);
    }

    fn visit_item_use(&mut self, import: &'ast syn::ItemUse) {
        // Of an enum, which has the name of a type.
        if let UseTree::Path(path) = &import.tree {
            let mut tree = &*path.tree;
            let mut owner = &path.ident;
            while let UseTree::Path(path) = tree {
                (owner, tree) = (&path.ident, &*path.tree);
            }
            if is_type_name(owner) {
                self.imported(tree);
            }
        }
    }
}

/// The value of a block that ends with one.
fn last_value(block: &Block) -> Option<&Expr> {
    match block.stmts.last() {
        Some(Stmt::Expr(value, None)) => Some(value),
        _ => None,
    }
}

/// The constructors, named without an enum, that an expression may be made by. A name in capitals may be that of a
/// constant.
fn made_by(value: &Expr, names: &mut HashSet<String>) {
    let mut add = |path: &Path| {
        let name = path.get_ident().filter(|name| is_type_name(name) && *name != "Self");
        names.extend(name.filter(|_| !wraps(path)).map(ToString::to_string));
    };
    match value {
        Expr::Paren(inner) => made_by(&inner.expr, names),
        Expr::Call(call) => {
            if let Expr::Path(function) = &*call.func {
                add(&function.path);
            }
        }
        Expr::Struct(literal) => add(&literal.path),
        Expr::Path(path) if last_name(&path.path).contains(char::is_lowercase) => add(&path.path),
        Expr::Block(block) => {
            if let Some(value) = last_value(&block.block) {
                made_by(value, names);
            }
        }
        Expr::If(branch) => {
            let otherwise = branch.else_branch.as_ref().map(|(_, otherwise)| &**otherwise);
            last_value(&branch.then_branch)
                .into_iter()
                .chain(otherwise)
                .for_each(|value| made_by(value, names));
        }
        Expr::Match(branch) => branch.arms.iter().for_each(|arm| made_by(&arm.body, names)),
        _ => {}
    }
}

/// Whether a constructor is `Some` or `Ok`.
fn wraps(function: &Path) -> bool {
    function.segments.last().is_some_and(|last| last.ident == "Some" || last.ident == "Ok")
}

/// `T` of `Option<T>` and `Result<T, E>`.
pub(super) fn content(ty: &Type) -> Option<&Type> {
    let Type::Path(path) = ty else { return None };
    match &path.path.segments.last()?.arguments {
        PathArguments::AngleBracketed(arguments) => match arguments.args.first()? {
            GenericArgument::Type(content) => Some(content),
            _ => None,
        },
        _ => None,
    }
}

/// The alternatives of a pattern, without what does not tell constructors apart.
fn flatten<'p>(pat: &'p Pat, into: &mut Vec<&'p Pat>) {
    match pat {
        Pat::Paren(inner) => flatten(&inner.pat, into),
        Pat::Reference(inner) => flatten(&inner.pat, into),
        Pat::Type(inner) => flatten(&inner.pat, into),
        Pat::Guard(inner) => flatten(&inner.pat, into),
        Pat::Ident(syn::PatIdent { subpat: Some((_, inner)), .. }) => flatten(inner, into),
        Pat::Or(or) => or.cases.iter().for_each(|case| flatten(case, into)),
        pat => into.push(pat),
    }
}

/// The name of the constructor that a pattern asks for, and whether it stands alone.
fn constructor(pat: &Pat) -> Option<(String, bool)> {
    let of_path = |path: &Path| (last_name(path), path.segments.len() == 1);
    match pat {
        Pat::TupleStruct(pattern) => Some(of_path(&pattern.path)),
        Pat::Struct(pattern) => Some(of_path(&pattern.path)),
        Pat::Path(path) => Some(of_path(&path.path)),
        Pat::Ident(ident) if is_type_name(&ident.ident) => Some((ident.ident.to_string(), true)),
        _ => None,
    }
}

fn last_name(path: &Path) -> String {
    path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default()
}

/// Whether a pattern matches every value of its type, if its constructors, which are noted, are those
/// of structs.
fn is_whole(pat: &Pat, names: &mut Vec<String>) -> bool {
    match pat {
        Pat::Wild(_) | Pat::Rest(_) => true,
        Pat::Ident(ident) => ident.subpat.is_none() && !is_type_name(&ident.ident),
        Pat::Paren(inner) => is_whole(&inner.pat, names),
        Pat::Reference(inner) => is_whole(&inner.pat, names),
        Pat::Type(inner) => is_whole(&inner.pat, names),
        Pat::Tuple(tuple) => tuple.elems.iter().all(|part| is_whole(part, names)),
        Pat::TupleStruct(pattern) if pattern.path.segments.len() == 1 => {
            names.push(last_name(&pattern.path));
            pattern.elems.iter().all(|part| is_whole(part, names))
        }
        Pat::Struct(pattern) if pattern.path.segments.len() == 1 => {
            names.push(last_name(&pattern.path));
            pattern.fields.iter().all(|field| is_whole(&field.pat, names))
        }
        _ => false,
    }
}
