//! Names for generated variables: readable, and each used once.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Delimiter, Group, Ident, Spacing, Span, TokenStream, TokenTree};

/// A name that users cannot write.
pub fn own(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// Whether a list of names, separated by spaces, holds one.
pub fn is_in(list: &str, name: &str) -> bool {
    list.split_ascii_whitespace().any(|listed| listed == name)
}

/// Every name that is taken.
pub struct Names {
    /// The names of the variables there are.
    variables: Taken,
    /// The names of the parameters, as the user wrote them.
    parameters: HashSet<String>,
    /// Whatever the user wrote.
    written: HashSet<String>,
    /// The same, and the names that were put into it.
    unwritten: Taken,
}

/// Names of one kind.
#[derive(Default)]
struct Taken {
    names: HashSet<String>,
    /// How often a name was asked for by its start, so that the search for a free one need not start
    /// from the first.
    counts: HashMap<String, usize>,
}

impl Taken {
    /// Takes a name, or, if it is taken, one that starts with `base`.
    fn take(&mut self, mut name: String, base: &str) -> String {
        while self.names.contains(&name) {
            let count = self.counts.entry(base.to_owned()).or_insert(0);
            *count += 1;
            name = format!("{base}_{count}");
        }
        self.names.insert(name.clone());
        name
    }
}

impl Names {
    /// The names for a function that the user wrote as `function`, with these parameters.
    pub fn new(function: TokenStream, parameters: impl IntoIterator<Item = Ident>) -> Self {
        let mut written = HashSet::new();
        collect(function, &mut written);
        let unwritten = Taken { names: written.clone(), ..Taken::default() };
        let parameters: HashSet<_> = parameters.into_iter().map(|p| p.to_string()).collect();
        let variables = Taken { names: parameters.clone(), ..Taken::default() };
        Self { variables, parameters, written, unwritten }
    }

    /// A name that starts with `base`, for a generated variable. It is unique among these, and its
    /// hygiene hides it from what the user wrote, so it may be a name that the user uses too.
    /// Errors that the compiler finds in what it names point to `span`.
    pub fn fresh(&mut self, base: &str, span: Span) -> Ident {
        // Without its prefix a raw name may be a keyword, and so may a name of an older edition.
        let (base, is_raw) = match base.strip_prefix("r#") {
            Some(base) => (base, true),
            None => (base, base == "gen"),
        };
        let first = if is_raw { format!("{base}_0") } else { base.to_owned() };
        let name = self.variables.take(first, base);
        Ident::new(&name, Span::mixed_site().located_at(span))
    }

    /// A name to put into the user's code: it means nothing there yet.
    pub fn unwritten(&mut self, base: &str) -> Ident {
        Ident::new(&self.unwritten.take(base.to_owned(), base), Span::mixed_site())
    }

    /// A name in a pattern that the user wrote, which may turn out to be that of a constant. As a variable it
    /// hides none that is named in generated code.
    pub fn in_pattern(&self, name: &Ident) -> Option<Ident> {
        let text = name.to_string();
        // No generated variable has the name of a parameter, and of what the user named only parameters are
        // variables in generated code.
        let site = match self.parameters.contains(&text) {
            true => Span::mixed_site(),
            false => Span::call_site(),
        };
        let mut name = name.clone();
        name.set_span(site.located_at(name.span()));
        self.written.contains(&text).then_some(name)
    }
}

/// Collects the identifiers in `tokens` that may be those of variables: none of a field or a method, and no
/// part of a path.
pub fn collect_variables(tokens: TokenStream, into: &mut HashSet<String>) {
    // `a.b` names a part of `a`, `a..b` names `b`; `a: ::b` has colons that belong to no path with `a`.
    let mut dots = 0;
    let mut is_in_path = false;
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(ident) => {
                let begins_path = matches!(tokens.peek(), Some(TokenTree::Punct(punct))
                    if punct.as_char() == ':' && punct.spacing() == Spacing::Joint);
                if dots != 1 && !is_in_path && !begins_path {
                    into.insert(ident.to_string());
                }
            }
            TokenTree::Punct(punct) if punct.as_char() == '.' => {
                dots += 1;
                continue;
            }
            TokenTree::Punct(punct) if punct.as_char() == ':' => {
                is_in_path |= punct.spacing() == Spacing::Joint;
                continue;
            }
            TokenTree::Group(group) => collect_variables(group.stream(), into),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
        (dots, is_in_path) = (0, false);
    }
}

/// Collects the texts of the identifiers in `tokens`.
pub fn collect(tokens: TokenStream, into: &mut HashSet<String>) {
    into.extend(identifiers(tokens).iter().map(Ident::to_string));
}

/// The identifiers in `tokens`.
pub fn identifiers(tokens: TokenStream) -> Vec<Ident> {
    let within = |token| match token {
        TokenTree::Ident(ident) => vec![ident],
        TokenTree::Group(group) => identifiers(group.stream()),
        TokenTree::Punct(_) | TokenTree::Literal(_) => Vec::new(),
    };
    tokens.into_iter().flat_map(within).collect()
}

/// The tokens with one name in place of another.
pub fn renamed(tokens: TokenStream, from: &Ident, to: &Ident) -> TokenStream {
    renamed_where(tokens, to, &|ident, _| ident == from)
}

/// The tokens with `this` in place of `self`, where that is not the start of a path.
pub fn without_self(tokens: TokenStream, this: &Ident) -> TokenStream {
    renamed_where(tokens, this, &|ident, begins_path| ident == "self" && !begins_path)
}

/// The tokens with a name in place of those of which `is_such` holds, which is told whether they begin a path.
fn renamed_where(
    tokens: TokenStream,
    to: &Ident,
    is_such: &dyn Fn(&Ident, bool) -> bool,
) -> TokenStream {
    let mut tokens = tokens.into_iter().peekable();
    let mut renamed = TokenStream::new();
    while let Some(token) = tokens.next() {
        let begins_path =
            matches!(tokens.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
        renamed.extend([match token {
            TokenTree::Ident(ident) if is_such(&ident, begins_path) => {
                let mut to = to.clone();
                to.set_span(ident.span().resolved_at(to.span()));
                TokenTree::Ident(to)
            }
            TokenTree::Group(group) => {
                let content = renamed_where(group.stream(), to, is_such);
                regrouped(&group, group.delimiter(), content)
            }
            other => other,
        }]);
    }
    renamed
}

/// A group with other content.
pub fn regrouped(group: &Group, delimiter: Delimiter, content: TokenStream) -> TokenTree {
    let mut regrouped = Group::new(delimiter, content);
    regrouped.set_span(group.span());
    TokenTree::Group(regrouped)
}

/// The tokens as if they stood at `span`, for errors about them.
pub fn located(tokens: TokenStream, span: Span) -> TokenStream {
    let at_span = |token: TokenTree| {
        let mut token = match token {
            TokenTree::Group(group) => {
                TokenTree::Group(Group::new(group.delimiter(), located(group.stream(), span)))
            }
            token => token,
        };
        token.set_span(span.resolved_at(token.span()));
        token
    };
    tokens.into_iter().map(at_span).collect()
}
