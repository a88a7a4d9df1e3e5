//! Names for generated variables: readable, and each used once.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};

/// Every name that is taken.
pub struct Names {
    /// The names of the variables there are.
    variables: HashSet<String>,
    /// How often a name was asked for by its start, so that the search for a free one need not start
    /// from the first.
    counts: HashMap<String, usize>,
    /// Whatever the user wrote.
    written: HashSet<String>,
}

impl Names {
    /// The names for a function that the user wrote as `function`, with these parameters.
    pub fn new(function: TokenStream, parameters: impl IntoIterator<Item = Ident>) -> Self {
        let mut written = HashSet::new();
        collect(function, &mut written);
        let variables = parameters.into_iter().map(|ident| ident.to_string()).collect();
        Self { variables, counts: HashMap::new(), written }
    }

    /// A name that starts with `base`, for a generated variable. It is unique among these, and its
    /// hygiene hides it from what the user wrote, so it may be a name that the user uses too.
    /// Errors that the compiler finds in what it names point to `span`.
    pub fn fresh(&mut self, base: &str, span: Span) -> Ident {
        // Without its prefix a raw name may be a keyword.
        let (base, is_raw) = match base.strip_prefix("r#") {
            Some(base) => (base, true),
            None => (base, false),
        };
        let mut name = if is_raw { format!("{base}_0") } else { base.to_owned() };
        while self.variables.contains(&name) {
            let count = self.counts.entry(base.to_owned()).or_insert(0);
            *count += 1;
            name = format!("{base}_{count}");
        }
        self.variables.insert(name.clone());
        Ident::new(&name, Span::mixed_site().located_at(span))
    }

    /// A name to put into the user's code: it means nothing there yet.
    pub fn unwritten(&mut self, base: &str) -> Ident {
        let mut name = base.to_owned();
        let mut count = 1;
        while !self.written.insert(name.clone()) {
            name = format!("{base}_{count}");
            count += 1;
        }
        Ident::new(&name, Span::mixed_site())
    }
}

/// Collects the identifiers in `tokens` that are not those of fields or methods.
pub fn collect_variables(tokens: TokenStream, into: &mut HashSet<String>) {
    // `a.b` names a part of `a`, `a..b` names `b`.
    let mut dots = 0;
    for token in tokens {
        match token {
            TokenTree::Ident(ident) if dots != 1 => {
                into.insert(ident.to_string());
            }
            TokenTree::Punct(punct) if punct.as_char() == '.' => {
                dots += 1;
                continue;
            }
            TokenTree::Group(group) => collect_variables(group.stream(), into),
            TokenTree::Ident(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
        dots = 0;
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
    let rename = |token| match token {
        TokenTree::Ident(ident) if ident == *from => {
            let mut to = to.clone();
            to.set_span(ident.span().resolved_at(to.span()));
            TokenTree::Ident(to)
        }
        TokenTree::Group(group) => {
            let mut renamed = Group::new(group.delimiter(), renamed(group.stream(), from, to));
            renamed.set_span(group.span());
            TokenTree::Group(renamed)
        }
        other => other,
    };
    tokens.into_iter().map(rename).collect()
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

/// The tokens with `this` in place of `self`, where that is not the start of a path.
pub fn without_self(tokens: TokenStream, this: &Ident) -> TokenStream {
    let mut tokens = tokens.into_iter().peekable();
    let mut renamed = Vec::new();
    while let Some(token) = tokens.next() {
        let begins_path =
            matches!(tokens.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
        renamed.push(match token {
            TokenTree::Ident(ident) if ident == "self" && !begins_path => {
                let mut this = this.clone();
                this.set_span(ident.span().resolved_at(this.span()));
                TokenTree::Ident(this)
            }
            TokenTree::Group(group) => {
                let stream = without_self(group.stream(), this);
                let mut renamed = Group::new(group.delimiter(), stream);
                renamed.set_span(group.span());
                TokenTree::Group(renamed)
            }
            other => other,
        });
    }
    renamed.into_iter().collect()
}
