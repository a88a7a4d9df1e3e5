//! Statements on functions as values, and variables that get their value later; the functions are
//! those of `ad/random/tests/oracles/types.rs`.

use crate::text::{Both, put};
use crate::writer::{Kind, NAMES, Writer};

impl Writer {
    /// A function that a `macro_rules!` makes of three expressions.
    pub fn by_a_macro(&mut self, name: &str) -> String {
        let (x, y) = self.random.pick(&[("x", "y"), ("t", "a"), ("b", "sum")]);
        self.rename_parameters([x, y]);
        let part = |writer: &mut Self| {
            let (a, b) = (writer.leaf(), writer.expression(1));
            match writer.random.below(4) {
                0 => put("{} + {}", &[&a, &b]),
                1 => put("{} - {}", &[&a, &b]),
                2 => put("-{} * {}", &[&a, &b]),
                _ => put("if {} { {} } else { {} }", &[&writer.condition(), &a, &b]),
            }
        };
        let parts = [part(self), part(self), part(self)];
        let [p, q, r] = parts.each_ref().map(|part| &part.plain);
        let [gp, gq, gr] = parts.each_ref().map(|part| &part.generic);
        format!(
            "
of_parts!(#[differentiable] {name} ({x}, {y}: f64) f64::from, {p}, {q}, {r});
of_parts!({name}_of<S> ({x}, {y}: S) S::from_f64, {gp}, {gq}, {gr});
"
        )
    }

    /// A call that is given a function.
    pub fn passed(&mut self) {
        let (name, start) = (self.random.pick(&NAMES), self.bounded(1));
        let arrays = self.visible(Kind::is_array);
        match self.random.below(4) {
            0 => {
                let line = put(&format!("let {name} = summed(bent, {{}}, 3).tanh();"), &[&start]);
                self.line(&line);
            }
            1 if !arrays.is_empty() => {
                let (array, closure) = (self.random.pick(&arrays).name, self.fresh("g"));
                let body = self.with(&["t"]);
                let line = |scalar: &str, body: &str| {
                    format!(
                        "let {closure} = |t: {scalar}, v: &[{scalar}]| mixed(v) * t + ({body}).tanh();"
                    )
                };
                self.line(&Both {
                    plain: line("f64", &body.plain),
                    generic: line("S", &body.generic),
                });
                let text = format!("let {name} = folded(&{closure}, {{}}, &{array}).sin();");
                self.line(&put(&text, &[&start]));
            }
            _ => {
                let (body, times) = (self.with(&["t"]), self.random.below(4));
                let line = |scalar: &str, body: &str, start: &str| {
                    format!(
                        "let {name} = summed(|t: {scalar}| ({body} * t).sin(), {start}, {times}).tanh();"
                    )
                };
                self.line(&Both {
                    plain: line("f64", &body.plain, &start.plain),
                    generic: line("S", &body.generic, &start.generic),
                });
            }
        }
        self.declare(name, Kind::Scalar { mutable: false });
    }

    /// A variable that gets its value after its declaration.
    pub fn deferred(&mut self) {
        let name = self.fresh("z");
        let mutable = self.random.chance(30);
        let keyword = if mutable { "mut " } else { "" };
        self.line(&Both::same(format!("let {keyword}{name};")));
        let (condition, first, second) = (self.condition(), self.expression(2), self.expression(1));
        match self.random.below(3) {
            0 => {
                let text = "if {} { NAME = {}; } else { NAME = {}; }".replace("NAME", &name);
                self.line(&put(&text, &[&condition, &first, &second]));
            }
            1 => {
                let inner = self.with(&["t"]);
                let text = "if {} { let t = {}; NAME = {}; } else if {} { NAME = t_of({}); } else \
                            { NAME = {}; }"
                    .replace("t_of", "bent")
                    .replace("NAME", &name);
                let other = self.condition();
                let parts = [&condition, &first, &inner, &other, &second, &first];
                self.line(&put(&text, &parts));
            }
            _ => {
                let counter = self.fresh("n");
                let inner = self.with(&["t"]);
                self.line(&Both::same(format!("let mut {counter} = 0_usize;")));
                let text =
                    "loop { NUMBER += 1; let t = {}; if NUMBER > 2 || {} { NAME = {}; break; } }"
                        .replace("NAME", &name)
                        .replace("NUMBER", &counter);
                self.line(&put(&text, &[&first, &condition, &inner]));
            }
        }
        if mutable {
            self.line(&put(&format!("{name} = {name} * {{}};"), &[&second]));
        }
        self.declare(&name, Kind::Scalar { mutable });
    }
}
