//! Variables that change and never carry a derivative: counters, generators of random numbers,
//! containers of integers.
//!
//! A variable that starts from a constant may be given a derivative later. Whether it is what follows
//! tells: each change that the variable may be made to, and what goes into it. Where that is not
//! certain the variable is taken to have one. `#[constant] let` says that it has none; what has a
//! derivative is then refused where it is assigned, by its type.

use std::collections::HashSet;

use quote::{quote, quote_spanned};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Expr, ExprCall, ExprClosure, ExprForLoop, ExprMethodCall, ExprPath, Ident, Lit, Local, Pat,
    Stmt, Token,
};

use crate::ir::primal::tangent_path;
use crate::ir::{Argument, Operand, Operation, Statement};
use crate::lower::Lowerer;
use crate::lower::place::pattern::binds_mutably;
use crate::lower::rewrite::exits;
use crate::lower::scopes::Name;
use crate::lower::search::Bound;
use crate::lower::syntax;
use crate::lower::syntax::{as_statements, root_name, split_type, strip_parens};
use crate::names::identifiers;
use crate::types::{is_constant_mark, is_discrete};

impl Lowerer<'_> {
    /// `#[constant] let name = ..;`; says whether it is that.
    pub fn constant_local(&mut self, local: &Local) -> bool {
        let Some(mark) = local.attrs.iter().find(|attribute| is_constant_mark(attribute)) else {
            return false;
        };
        let (pat, ty) = split_type(&local.pat);
        let (Pat::Ident(name), Some(init)) = (pat, &local.init) else {
            self.refuse(mark, "`#[constant]` goes on a `let` of one name");
            return true;
        };
        let mutable = name.mutability.is_some();
        let is_exclusive = |expr: &Expr| matches!(expr, Expr::Reference(reference) if reference.mutability.is_some());
        let value = match strip_parens(&init.expr) {
            Expr::Reference(reference) if is_exclusive(&init.expr) => {
                let Some(place) = self.target(&reference.expr) else { return true };
                let root = self.ident(place.root).clone();
                let place_tokens = self.place_tokens(&place);
                if self.vars[place.root].active {
                    let part = tangent_path(quote!(tangent), &place.path);
                    let part = part.map(|part| quote!(.part(|tangent| &#part)));
                    let code = quote_spanned! {init.expr.span()=>
                        ::ad::rt::space(&#root)#part.vanishes();
                    };
                    self.push_plain(code);
                }
                quote!(&mut #place_tokens)
            }
            expr => {
                let value = self.operand(expr, &name.ident.to_string());
                self.stored(&value, expr.span())
            }
        };
        let var = self.bind(&name.ident, mutable, false);
        self.vars[var].mutable |= is_exclusive(&init.expr);
        self.vars[var].exclusive = is_exclusive(&init.expr);
        let operation = Operation::Use(Operand::Constant(value));
        self.push(Statement::Define { var, ty: ty.cloned(), operation });
        true
    }

    /// Checks what a call is given that has no derivative, where others have one. The call could give
    /// it one, too, by a `&mut` into a variable that is taken for a constant.
    pub fn check_constants<'e>(
        &mut self,
        arguments: &mut [Argument],
        written: impl IntoIterator<Item = &'e Expr>,
    ) {
        for (argument, expr) in arguments.iter_mut().zip(written) {
            let Argument::Value(Operand::Constant(tokens)) = argument else { continue };
            let root = root_name(expr).and_then(|name| self.lookup(name));
            let checked = match (root, strip_parens(expr)) {
                (Some(root), _) if self.vars[root].is_binding && !self.vars[root].mutable => {
                    self.ident_at(root, expr.span())
                }
                (None, Expr::Call(_) | Expr::MethodCall(_)) if self.reads_changeable(expr) => {
                    let var = self.define_constant("constant", expr.span(), tokens.clone());
                    *argument = Argument::Value(self.constant(var));
                    self.ident_at(var, expr.span())
                }
                _ => continue,
            };
            if self.has_changing_constants() {
                let code =
                    quote_spanned!(expr.span()=> ::ad::rt::Beside(&#checked).keeps_nothing(););
                let code = quote! {{
                    use ::ad::rt::MayKeep as _;
                    #code
                }};
                self.push_plain(code);
            }
        }
    }

    fn has_changing_constants(&self) -> bool {
        self.vars.iter().any(|var| var.mutable && !var.active)
    }

    /// Whether a variable that starts from a constant stays one in the statements that follow.
    pub fn stays_constant(&self, name: &Ident, following: &[Stmt]) -> bool {
        let mut changes = Changes {
            lowerer: self,
            name: Name::of(name),
            constants: HashSet::from([Name::of(name)]),
            others: HashSet::new(),
            is_possible: false,
        };
        following.iter().for_each(|stmt| changes.visit_stmt(stmt));
        !changes.is_possible
    }

    /// Whether a name that a pattern binds to a part of a constant may get a derivative in what follows.
    pub fn may_carry(&self, pat: &Pat, following: &Expr) -> bool {
        let following = as_statements(following);
        let mut changing = Bound::by(pat).into_iter().filter(|name| name.mutability.is_some());
        changing.any(|name| !self.stays_constant(&name.ident, &following))
    }
}

/// Looks for what may give a variable a derivative.
struct Changes<'l, 'a> {
    lowerer: &'l Lowerer<'a>,
    /// The variable.
    name: Name,
    /// The names bound so far that stand for constants wherever they are bound.
    constants: HashSet<Name>,
    /// The other names bound so far.
    others: HashSet<Name>,
    is_possible: bool,
}

impl Changes<'_, '_> {
    /// Whether a place is the variable, or a part of it, or lent by it.
    fn belongs(&self, place: &Expr) -> bool {
        match strip_parens(place) {
            Expr::MethodCall(call) => self.belongs(&call.receiver),
            Expr::Field(field) => self.belongs(&field.base),
            Expr::Index(index) => self.belongs(&index.expr),
            Expr::Unary(unary) => self.belongs(&unary.expr),
            Expr::Reference(reference) => self.belongs(&reference.expr),
            Expr::Tuple(places) => places.elems.iter().any(|place| self.belongs(place)),
            Expr::Array(places) => places.elems.iter().any(|place| self.belongs(place)),
            Expr::Call(places) => places.args.iter().any(|place| self.belongs(place)),
            Expr::Struct(places) => places.fields.iter().any(|field| self.belongs(&field.expr)),
            place => root_name(place).is_some_and(|name| Name::of(name) == self.name),
        }
    }

    /// Whether no derivative can flow through an expression.
    fn is_constant(&self, expr: &Expr) -> bool {
        let mut finder = Active { changes: self, parameters: HashSet::new(), found: false };
        finder.visit_expr(expr);
        !finder.found
    }

    /// Whether a name stands for a constant.
    fn is_constant_name(&self, ident: &Ident) -> bool {
        let name = Name::of(ident);
        !self.others.contains(&name) && (self.constants.contains(&name) || !self.is_active(ident))
    }

    /// Whether a name stands, before the statements that are searched, for what a derivative may
    /// flow through.
    fn is_active(&self, ident: &Ident) -> bool {
        self.lowerer.lookup(ident).is_some_and(|var| {
            self.lowerer.vars[var].active
                || self.lowerer.closures.contains_key(&var)
                || self.lowerer.functions.contains_key(&var)
        })
    }

    /// A name is a constant only if whatever is bound to it is one, in this block and around it.
    fn bind(&mut self, pat: &Pat, is_constant: bool) {
        for name in Bound::by(pat) {
            match is_constant && !self.is_active(&name.ident) {
                true => self.constants.insert(Name::of(&name.ident)),
                false => self.others.insert(Name::of(&name.ident)),
            };
            // It may lend the variable that the pattern takes apart.
            self.is_possible |= name.by_ref.is_some() && name.mutability.is_some();
        }
    }

    /// Binds names to parts of a value, or of what a loop takes from it. Where one of them may be assigned to,
    /// or a derivative flows through one of the parts, all of them may carry one.
    fn bind_to(&mut self, pat: &Pat, value: &Expr) {
        match !binds_mutably(pat) && self.is_constant(value) {
            true => self.bind(pat, true),
            false => self.bind_by_types(pat, value),
        }
    }

    /// Binds names of which only those to parts of types without derivative stand for constants.
    fn bind_by_types(&mut self, pat: &Pat, value: &Expr) {
        match (pat, strip_parens(value)) {
            (Pat::Tuple(pats), Expr::Tuple(values)) if pats.elems.len() == values.elems.len() => {
                for (pat, value) in pats.elems.iter().zip(&values.elems) {
                    self.bind_by_types(pat, value);
                }
            }
            (pat, value) => self.bind(pat, is_discrete_value(value)),
        }
    }
}

impl<'ast> Visit<'ast> for Changes<'_, '_> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        self.is_possible |= match expr {
            Expr::Assign(assign) => self.belongs(&assign.left) && !self.is_constant(&assign.right),
            Expr::Binary(binary) if exits::is_update(&binary.op) => {
                self.belongs(&binary.left) && !self.is_constant(&binary.right)
            }
            Expr::Reference(reference) => {
                reference.mutability.is_some() && self.belongs(&reference.expr)
            }
            Expr::MethodCall(ExprMethodCall { receiver, method, args, .. }) => {
                self.belongs(receiver)
                    && (lends(method) || !args.iter().all(|argument| self.is_constant(argument)))
            }
            _ => false,
        };
        visit::visit_expr(self, expr);
    }

    fn visit_local(&mut self, local: &'ast Local) {
        let (pat, ty) = split_type(&local.pat);
        match &local.init {
            Some(init) if !ty.is_some_and(is_discrete) => self.bind_to(pat, &init.expr),
            _ => self.bind(pat, ty.is_some_and(is_discrete)),
        }
        if let Some(init) = &local.init {
            self.visit_local_init(init);
        }
    }

    fn visit_expr_for_loop(&mut self, a_loop: &'ast ExprForLoop) {
        self.bind_to(&a_loop.pat, &a_loop.expr);
        self.visit_expr(&a_loop.expr);
        self.visit_block(&a_loop.body);
    }

    fn visit_pat(&mut self, pat: &'ast Pat) {
        self.bind(pat, false);
        // A guard is part of the pattern.
        visit::visit_pat(self, pat);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        // What a macro does is not seen, but that those that print or compare evaluate their arguments.
        let is_known = syntax::standard_macro(&call.path)
            .is_some_and(|name| syntax::values_before_format(&name).is_some());
        match call.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            Ok(arguments) if is_known => {
                for argument in &arguments {
                    Visit::visit_expr(self, value_of(argument));
                }
            }
            _ => {
                let names = identifiers(call.tokens.clone());
                self.is_possible |= names.iter().any(|name| Name::of(name) == self.name);
            }
        }
    }
}

/// The value of an argument of a macro, which may be named: `name = value`.
fn value_of(argument: &Expr) -> &Expr {
    match argument {
        Expr::Assign(named) => &named.right,
        value => value,
    }
}

/// Whether a value is of a type that never has a derivative.
pub(super) fn is_discrete_value(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => !number.suffix().starts_with('f'),
            Lit::Float(_) => false,
            _ => true,
        },
        Expr::Unary(unary) => is_discrete_value(&unary.expr),
        Expr::Cast(cast) => is_discrete(&cast.ty),
        Expr::MethodCall(call) => call.method == "len" && call.args.is_empty(),
        // Both ends are of one type.
        Expr::Range(range) => {
            range.start.iter().chain(&range.end).any(|end| is_discrete_value(end))
        }
        _ => false,
    }
}

/// Whether a method may lend a part of its receiver to be changed.
fn lends(method: &Ident) -> bool {
    let name = method.to_string();
    name.split('_').any(|word| word == "mut") || matches!(&*name, "entry" | "drain")
}

/// Looks for variables through which a derivative may flow.
struct Active<'c, 'l, 'a> {
    changes: &'c Changes<'l, 'a>,
    /// The parameters of closures around.
    parameters: HashSet<Name>,
    found: bool,
}

impl Active<'_, '_, '_> {
    /// Whether a call is given a function: what it gives has a derivative then, whatever it is made of.
    fn passes_function(&self, arguments: &Punctuated<Expr, Token![,]>) -> bool {
        let is_bound = |path: &ExprPath| {
            let name = path.path.get_ident().map(Name::of);
            name.is_some_and(|name| {
                self.parameters.contains(&name)
                    || self.changes.constants.contains(&name)
                    || self.changes.others.contains(&name)
            })
        };
        arguments.iter().any(|argument| match strip_parens(argument) {
            Expr::Closure(_) => true,
            Expr::Path(path) => !is_bound(path) && self.changes.lowerer.is_named_function(path),
            _ => false,
        })
    }
}

impl<'ast> Visit<'ast> for Active<'_, '_, '_> {
    fn visit_expr_path(&mut self, path: &'ast syn::ExprPath) {
        let Some(ident) = path.path.get_ident() else { return };
        let is_parameter = self.parameters.contains(&Name::of(ident));
        self.found |= !is_parameter && !self.changes.is_constant_name(ident);
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        self.found |= self.passes_function(&call.args);
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        self.found |= self.changes.lowerer.calls_own_methods(&call.receiver)
            && self.passes_function(&call.args);
        visit::visit_expr_method_call(self, call);
    }

    fn visit_expr_closure(&mut self, closure: &'ast ExprClosure) {
        let names = closure.inputs.iter().flat_map(Bound::by);
        let mut inner = Active { parameters: self.parameters.clone(), ..*self };
        inner.parameters.extend(names.map(|name| Name::of(&name.ident)));
        inner.visit_expr(&closure.body);
        self.found |= inner.found;
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let names = identifiers(call.tokens.clone());
        self.found |= !names.iter().all(|name| self.changes.is_constant_name(name));
    }
}
