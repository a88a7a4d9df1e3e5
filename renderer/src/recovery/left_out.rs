//! What evaluations have left out.

/// The latest of what was left out, over all ranks: that of the latest evaluation, and in it of the last target.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LeftOut {
    /// How many evaluations there were.
    pub evaluations: u64,
    /// The evaluation and the target, and what is said of them.
    latest: Option<(u64, usize, String)>,
}

impl LeftOut {
    /// Something of a target was left out of this evaluation.
    pub fn tell(&mut self, target: usize, text: String) {
        self.latest = Some((self.evaluations, target, text));
    }

    /// What is said of the latest.
    pub fn text(&self) -> Option<&str> {
        self.latest.as_ref().map(|(.., text)| &text[..])
    }

    /// All of it as a line, which [`latest`](Self::latest) reads.
    pub fn to_line(&self) -> String {
        match &self.latest {
            None => self.evaluations.to_string(),
            Some((at, target, text)) => format!("{} {at} {target} {text}", self.evaluations),
        }
    }

    /// The latest of what ranks have left out, in the same evaluations.
    pub fn latest(lines: &[String]) -> Self {
        let read = |line: &String| {
            let mut parts = line.splitn(4, ' ');
            let mut number = || parts.next().and_then(|part| part.parse().ok());
            let evaluations = number().unwrap_or(0);
            let at = number().zip(number()).zip(parts.next());
            let latest = at.map(|((at, target), text)| (at, target as usize, text.to_owned()));
            Self { evaluations, latest }
        };
        let all = lines.iter().map(read);
        all.max_by(|one, other| one.latest.cmp(&other.latest)).unwrap_or_default()
    }
}
