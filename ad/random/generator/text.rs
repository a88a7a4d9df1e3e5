//! Pieces of programs, in two spellings.

/// Text for `f64`, and for any scalar `S`.
#[derive(Clone)]
pub struct Both {
    pub plain: String,
    pub generic: String,
}

impl Both {
    pub fn same(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { plain: text.clone(), generic: text }
    }

    /// A number that is a constant.
    pub fn number(plain: impl std::fmt::Display) -> Self {
        Self { plain: format!("{plain}"), generic: format!("S::from_f64({plain})") }
    }

    /// In parentheses for `f64`, where a cast could run into what follows.
    pub fn parenthesised(self) -> Self {
        Self { plain: format!("({})", self.plain), generic: self.generic }
    }
}

/// Puts parts into a text in place of `{}`, one after the other.
pub fn put(text: &str, parts: &[&Both]) -> Both {
    let fill = |part: fn(&Both) -> &str| {
        let mut pieces = text.split("{}");
        let mut filled = pieces.next().unwrap_or_default().to_owned();
        for (piece, both) in pieces.zip(parts) {
            filled += part(both);
            filled += piece;
        }
        filled
    };
    Both { plain: fill(|both| &both.plain), generic: fill(|both| &both.generic) }
}
