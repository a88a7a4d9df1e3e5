//! Random statements: declarations, shadowing, mutation, branches, loops with jumps, calls.

use crate::text::{Both, put};
use crate::writer::{Kind, NAMES, Writer};

impl Writer {
    /// The body of a function of `x` and `y`.
    pub fn body(&mut self) {
        self.declare_mutable();
        self.array();
        while self.budget > 0 {
            self.statement(3);
        }
        let value = self.expression(2);
        let rest: Vec<_> = self.visible(Kind::is_scalar).into_iter().map(|v| v.name).collect();
        let sum =
            rest.iter().fold(value, |sum, name| put("{} + {}", &[&sum, &Both::same(name.clone())]));
        self.line(&sum);
    }

    fn statement(&mut self, depth: usize) {
        self.budget = self.budget.saturating_sub(1);
        let in_loop = !self.loops.is_empty();
        if self.random.chance(30) {
            return self.data();
        }
        if self.random.chance(10) {
            return self.of_lists();
        }
        if self.random.chance(25) {
            return self.effects();
        }
        match self.random.below(if depth > 0 { 24 } else { 11 }) {
            0 => self.declare_scalar(),
            1 => self.declare_mutable(),
            2..=4 => self.assign(),
            5 => self.array(),
            6..=8 => self.assign_element(),
            9 => self.tuple(),
            10 => self.call(),
            11 | 12 => self.branch(depth),
            13 => self.branch_value(),
            14..=17 => self.range_loop(depth),
            18 => self.while_loop(depth),
            19 => self.loop_over_elements(),
            20 => self.closure(),
            21 => self.passed(),
            22 => self.deferred(),
            _ if in_loop => self.jump(),
            _ => self.early_return(),
        }
    }

    fn declare_scalar(&mut self) {
        let (name, value) = (self.random.pick(&NAMES), self.expression(2));
        self.line(&put(&format!("let {name} = {{}};"), &[&value]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    pub fn declare_mutable(&mut self) {
        let (name, value) = (self.random.pick(&NAMES), self.bounded(1));
        self.line(&put(&format!("let mut {name} = {{}};"), &[&value]));
        self.declare(name, Kind::Scalar { mutable: true });
    }

    pub fn array(&mut self) {
        let (name, length) = (self.fresh("r"), 2 + self.random.below(4));
        let value = match self.random.chance(50) {
            true => put(&format!("[{{}}; {length}]"), &[&self.bounded(1)]),
            false => {
                let elements: Vec<_> = (0..length).map(|_| self.bounded(1)).collect();
                let list = vec!["{}"; length].join(", ");
                put(&format!("[{list}]"), &elements.iter().collect::<Vec<_>>())
            }
        };
        let mutable = self.random.chance(70);
        let keyword = if mutable { "mut " } else { "" };
        self.line(&put(&format!("let {keyword}{name} = {{}};"), &[&value]));
        self.declare(&name, Kind::Array { length, mutable });
    }

    /// `place op= value` for `f64`, `place = place op value` for other scalars.
    fn change(&mut self, place: &str) {
        let value = self.bounded(2);
        if self.random.chance(40) {
            self.line(&put(&format!("{place} = {{}};"), &[&value]));
            return;
        }
        let operator = self.random.pick(&["+", "-", "*"]);
        self.line(&Both {
            plain: format!("{place} {operator}= {};", value.plain),
            generic: format!("{place} = {place} {operator} {};", value.generic),
        });
    }

    fn assign(&mut self) {
        let targets = self.visible(|kind| kind.is_scalar() && kind.is_mutable());
        if targets.is_empty() {
            return self.declare_mutable();
        }
        let target = self.random.pick(&targets).name;
        self.change(&target);
    }

    fn assign_element(&mut self) {
        let targets = self.visible(|kind| kind.is_array() && kind.is_mutable());
        if targets.is_empty() {
            return self.assign();
        }
        let target = self.random.pick(&targets);
        let index = self.index(target.length());
        self.change(&format!("{}[{index}]", target.name));
    }

    fn tuple(&mut self) {
        let (first, second) = (self.bounded(1), self.expression(1));
        self.line(&put("let (a, mut b) = ({}, {});", &[&first, &second]));
        self.declare("a", Kind::Scalar { mutable: false });
        self.declare("b", Kind::Scalar { mutable: true });
    }

    /// A call of an earlier program.
    fn call(&mut self) {
        if self.index == 0 || self.is_pure() {
            return self.declare_scalar();
        }
        let callee = self.random.below(self.index.min(1000) as usize);
        let (name, first, second) = (self.random.pick(&NAMES), self.bounded(1), self.bounded(1));
        let call = |function: &str, part: fn(&Both) -> &str| {
            let value = format!("{function}({}, {})", part(&first), part(&second));
            format!("let {name} = {value}.tanh();")
        };
        self.line(&Both {
            plain: call(&format!("program_{callee}"), |both| &both.plain),
            generic: call(&format!("program_{callee}_of"), |both| &both.generic),
        });
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn statements(&mut self, depth: usize) {
        for _ in 0..1 + self.random.below(3) {
            self.statement(depth - 1);
        }
    }

    fn branch(&mut self, depth: usize) {
        let condition = self.condition();
        let has_else = self.random.chance(50);
        let end = if has_else { " else {" } else { "" };
        self.block(&put("if {}", &[&condition]), |writer| writer.statements(depth), end);
        if has_else {
            self.rest_of_block(|writer| writer.statements(depth), "");
        }
    }

    fn branch_value(&mut self) {
        let (name, condition) = (self.random.pick(&NAMES), self.condition());
        let (then, otherwise) = (self.expression(2), self.expression(2));
        let text = format!("let {name} = ") + "if {} { {} } else { {} };";
        self.line(&put(&text, &[&condition, &then, &otherwise]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn range_loop(&mut self, depth: usize) {
        let (label, index) = (self.fresh("'l"), self.fresh("i"));
        let integers = self.integers();
        let from = match integers.is_empty() || self.random.chance(60) {
            true => self.random.below(3).to_string(),
            false => self.random.pick(&integers),
        };
        let to = self.random.below(6);
        let range = match self.random.below(4) {
            0 => format!("({from}..{to}_usize).rev()"),
            1 => format!("{from}..={to}_usize"),
            2 => format!("({from}..{to}_usize).step_by(2)"),
            _ => format!("{from}..{to}_usize"),
        };
        let head = Both::same(format!("{label}: for {index} in {range}"));
        let is_checkpointed = self.random.chance(20);
        if is_checkpointed {
            let attribute = "#[differentiable(checkpoint)]".to_owned();
            self.line(&Both { plain: attribute, generic: String::new() });
        }
        self.repeated += usize::from(is_checkpointed);
        self.loops.push(label);
        self.block(
            &head,
            |writer| {
                writer.declare(&index, Kind::Integer);
                writer.statements(depth);
            },
            "",
        );
        self.loops.pop();
        self.repeated -= usize::from(is_checkpointed);
    }

    fn while_loop(&mut self, depth: usize) {
        let (label, counter, limit) = (self.fresh("'l"), self.fresh("n"), 1 + self.random.below(5));
        self.line(&Both::same(format!("let mut {counter} = 0_usize;")));
        let head = Both::same(format!("{label}: while {counter} < {limit}"));
        self.loops.push(label);
        self.block(
            &head,
            |writer| {
                writer.line(&Both::same(format!("{counter} += 1;")));
                writer.declare(&counter, Kind::Integer);
                writer.statements(depth);
            },
            "",
        );
        self.loops.pop();
    }

    fn loop_over_elements(&mut self) {
        let arrays = self.visible(Kind::is_array);
        let targets = self.visible(|kind| kind.is_scalar() && kind.is_mutable());
        if arrays.is_empty() || targets.is_empty() {
            return self.declare_mutable();
        }
        let (array, target) = (self.random.pick(&arrays).name, self.random.pick(&targets).name);
        let factor = self.bounded(1);
        if self.random.chance(50) {
            let head = Both::same(format!("for v in {array}.iter()"));
            let change =
                put(&format!("{target} = {target} * {{}} + *v * {{}};"), &[&factor, &factor]);
            self.block(&head, |writer| writer.line(&change), "");
            return;
        }
        let name = self.random.pick(&NAMES);
        self.line(&Both {
            plain: format!("let {name}: f64 = {array}.iter().map(|v| v * {}).sum();", factor.plain),
            generic: format!(
                "let {name} = {array}.iter().fold(S::from_f64(-0.0), |s, v| s + *v * {});",
                factor.generic
            ),
        });
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn closure(&mut self) {
        let (closure, name) = (self.fresh("g"), self.random.pick(&NAMES));
        let body = self.with(&["t"]);
        let (first, second) = (self.expression(1), self.expression(1));
        self.line(&Both {
            plain: format!("let {closure} = |t: f64| {} * t;", body.plain),
            generic: format!("let {closure} = |t: S| {} * t;", body.generic),
        });
        let call = format!("let {name} = ({closure}({{}}) + {closure}({{}})).sin();");
        self.line(&put(&call, &[&first, &second]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    /// `break` or `continue`, of a loop around, if a condition holds.
    fn jump(&mut self) {
        let (condition, label) = (self.condition(), self.random.pick(&self.loops.clone()));
        let jump = match self.random.below(4) {
            0 => "break".to_owned(),
            1 => "continue".to_owned(),
            2 => format!("break {label}"),
            _ => format!("continue {label}"),
        };
        let line = Both::same(format!("{jump};"));
        self.block(&put("if {}", &[&condition]), |writer| writer.line(&line), "");
    }

    fn early_return(&mut self) {
        let (condition, value) = (self.condition(), self.expression(2));
        let line = put("return {};", &[&value]);
        self.block(&put("if {}", &[&condition]), |writer| writer.line(&line), "");
    }
}
