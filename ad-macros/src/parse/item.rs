//! The annotated item as the user wrote it.
//!
//! The function itself is emitted from the user's own tokens: a tree that was parsed and printed
//! again has lost the invisible groups that keep `t * $factor` of a `macro_rules!` apart from
//! `t * a + b`. What is taken out are the marks that the compiler does not know: `#[constant]` of
//! parameters and variables, `#[differentiable(..)]` of loops and methods. Streams without marks are
//! passed on untouched, and nested functions are, for their attribute has not seen them yet.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use super::groups::explicit;
use crate::names::regrouped;

/// What marks mean in a stream of tokens.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// Outside of a body.
    Items {
        /// Whether methods may be unused: their gradients may be all that is used of them.
        allows_unused: bool,
    },
    /// Between the parentheses of a function.
    Parameters,
    /// Statements and expressions.
    Body,
}

/// A free function without its marks.
pub fn function(item: TokenStream) -> TokenStream {
    without_marks(item, Part::Items { allows_unused: false })
}

/// An `impl` block or a trait without its marks, and with further members at its end.
pub fn block(item: TokenStream, members: &TokenStream, allows_unused: bool) -> TokenStream {
    let mut tokens: Vec<_> = item.into_iter().collect();
    if let Some(TokenTree::Group(body)) = tokens.pop() {
        let own = without_marks(body.stream(), Part::Items { allows_unused });
        tokens.push(regrouped(&body, Delimiter::Brace, quote!(#own #members)));
    }
    tokens.into_iter().collect()
}

fn without_marks(tokens: TokenStream, part: Part) -> TokenStream {
    changed(tokens.clone(), part).unwrap_or(tokens)
}

/// The tokens without marks; `None` if there are none.
fn changed(tokens: TokenStream, part: Part) -> Option<TokenStream> {
    let tokens: Vec<_> = tokens.into_iter().collect();
    let mut cleaner = Cleaner { tokens: &tokens, part, cleaned: Vec::new(), is_changed: false };
    cleaner.run();
    let Cleaner { cleaned, is_changed, .. } = cleaner;
    is_changed.then(|| explicit(cleaned.into_iter().collect()))
}

struct Cleaner<'t> {
    tokens: &'t [TokenTree],
    part: Part,
    cleaned: Vec<TokenTree>,
    is_changed: bool,
}

impl Cleaner<'_> {
    fn run(&mut self) {
        let mut at = 0;
        // Where the member begins that is being read.
        let mut start = 0;
        while at < self.tokens.len() {
            if let Some(function) = Function::at(self.tokens, at) {
                self.function(&function, at, start);
                at = function.end;
                start = self.cleaned.len();
            } else if self.is_mark(at) {
                self.is_changed = true;
                at += 2;
            } else {
                match &self.tokens[at] {
                    TokenTree::Group(group) if self.part != Part::Parameters => {
                        self.group(group, Part::Body);
                    }
                    token => {
                        if is_punct(token, ';') {
                            start = self.cleaned.len() + 1;
                        }
                        self.cleaned.push(token.clone());
                    }
                }
                at += 1;
            }
        }
    }

    /// A function whose `fn` stands at `at`, of a member that begins at `start`.
    fn function(&mut self, function: &Function, at: usize, start: usize) {
        let tokens = &self.tokens[at..function.end];
        let Part::Items { allows_unused } = self.part else {
            return self.cleaned.extend_from_slice(tokens);
        };
        let parameters = match &self.tokens[function.parameters] {
            TokenTree::Group(group) => group,
            _ => unreachable!("the parameters are a group"),
        };
        if allows_unused && !parameters.stream().is_empty() {
            self.is_changed = true;
            self.cleaned.splice(start..start, quote!(#[allow(dead_code)]));
        }
        for (index, token) in (at..).zip(tokens) {
            match token {
                TokenTree::Group(group) if index == function.parameters => {
                    self.group(group, Part::Parameters);
                }
                TokenTree::Group(group) if index + 1 == function.end => {
                    self.group(group, Part::Body);
                }
                token => self.cleaned.push(token.clone()),
            }
        }
    }

    fn group(&mut self, group: &Group, part: Part) {
        let changed = changed(group.stream(), part);
        self.is_changed |= changed.is_some();
        self.cleaned.push(match changed {
            Some(content) => regrouped(group, group.delimiter(), content),
            None => TokenTree::Group(group.clone()),
        });
    }

    /// Whether an attribute stands at `at` that has been seen to.
    fn is_mark(&self, at: usize) -> bool {
        let Some(name) = attribute(self.tokens, at) else { return false };
        match self.part {
            Part::Items { .. } => name == "differentiable",
            Part::Parameters => name == "constant",
            Part::Body => match &*name {
                "differentiable" => begins(&self.tokens[at + 2..], &["for", "while", "loop"]),
                "constant" => begins(&self.tokens[at + 2..], &["let"]),
                _ => false,
            },
        }
    }
}

/// The last name in the path of the attribute that begins at `at`.
fn attribute(tokens: &[TokenTree], at: usize) -> Option<String> {
    let [hash, TokenTree::Group(group), ..] = tokens.get(at..)? else { return None };
    if !is_punct(hash, '#') || group.delimiter() != Delimiter::Bracket {
        return None;
    }
    let path = explicit(group.stream()).into_iter().map_while(|token| match token {
        TokenTree::Ident(name) => Some(Some(name.to_string())),
        TokenTree::Punct(punct) if punct.as_char() == ':' => Some(None),
        _ => None,
    });
    path.flatten().last()
}

/// Whether one of these words follows, behind more attributes and a label.
fn begins(following: &[TokenTree], words: &[&str]) -> bool {
    match following {
        [hash, TokenTree::Group(_), rest @ ..] if is_punct(hash, '#') => begins(rest, words),
        [quote, TokenTree::Ident(_), colon, rest @ ..]
            if is_punct(quote, '\'') && is_punct(colon, ':') =>
        {
            begins(rest, words)
        }
        [TokenTree::Ident(name), ..] => words.iter().any(|word| name == word),
        _ => false,
    }
}

fn is_punct(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// The positions of the parts of a function.
struct Function {
    parameters: usize,
    /// Behind its body, or the `;` in place of one.
    end: usize,
}

impl Function {
    /// The function whose `fn` stands at `at`.
    fn at(tokens: &[TokenTree], at: usize) -> Option<Self> {
        let [TokenTree::Ident(keyword), TokenTree::Ident(_), ..] = tokens.get(at..)? else {
            return None;
        };
        if keyword != "fn" {
            return None;
        }
        let mut parameters = None;
        let mut angles = 0;
        for (index, token) in tokens.iter().enumerate().skip(at + 2) {
            match token {
                TokenTree::Punct(punct) => match punct.as_char() {
                    '<' => angles += 1,
                    '>' if !is_punct(&tokens[index - 1], '-') => angles -= 1,
                    ';' => return Some(Self { parameters: parameters?, end: index + 1 }),
                    _ => {}
                },
                TokenTree::Group(group) if angles == 0 => match group.delimiter() {
                    Delimiter::Parenthesis if parameters.is_none() => parameters = Some(index),
                    _ if is_body(group) => {
                        return Some(Self { parameters: parameters?, end: index + 1 });
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        None
    }
}

/// Whether a group is a block, or `$body` of a `macro_rules!` that is one.
fn is_body(group: &Group) -> bool {
    match group.delimiter() {
        Delimiter::Brace => true,
        Delimiter::None => {
            let mut tokens = group.stream().into_iter();
            let first = tokens.next();
            tokens.next().is_none()
                && matches!(first, Some(TokenTree::Group(inner)) if is_body(&inner))
        }
        Delimiter::Parenthesis | Delimiter::Bracket => false,
    }
}
