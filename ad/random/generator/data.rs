//! Statements on structs with operators and methods, enums, options, slices and `Vec`s; their types
//! and functions are those of `ad/random/tests/oracles/types.rs`.

use crate::text::{Both, put};
use crate::writer::{Kind, NAMES, Writer};

impl Writer {
    pub fn data(&mut self) {
        match self.random.below(10) {
            0 => self.declare_pair(),
            1..=3 => self.change_pair(),
            4 => self.option(),
            5 => self.outcome(),
            6 => self.shape(),
            7 => self.slice(),
            8 => self.vec(),
            _ => self.change_elements(),
        }
    }

    fn pair(&mut self) -> Both {
        let pairs = self.visible(|kind| kind == Kind::Pair);
        if !pairs.is_empty() && self.random.chance(60) {
            return Both::same(self.random.pick(&pairs).name);
        }
        put("Pair { a: {}, b: {} }", &[&self.bounded(1), &self.bounded(1)])
    }

    fn declare_pair(&mut self) {
        let (name, first, second) = (self.fresh("p"), self.bounded(1), self.bounded(1));
        let text = format!("let mut {name} = ") + "Pair { a: {}, b: {} };";
        self.line(&put(&text, &[&first, &second]));
        self.declare(&name, Kind::Pair);
    }

    fn change_pair(&mut self) {
        let pairs = self.visible(|kind| kind == Kind::Pair);
        if pairs.is_empty() {
            return self.declare_pair();
        }
        let name = self.random.pick(&pairs).name;
        let (a, b, number) = (self.pair(), self.pair(), self.bounded(1));
        let line = match self.random.below(8) {
            0 => put(&format!("{name} = ({name} * {{}} + {{}}).tamed();"), &[&a, &b]),
            1 => put(&format!("{name} = ({{}} - {name} * {{}}).tamed();"), &[&a, &number]),
            2 => put(&format!("{name} += {{}};"), &[&a]),
            3 => put(&format!("{name}.turn({{}});"), &[&number]),
            4 => put(&format!("{name}.b = {{}};"), &[&number]),
            5 => put(&format!("{name} = -({{}} - {{}}).tamed();"), &[&a, &b]),
            6 => {
                let target = self.random.pick(&NAMES);
                let line = put(&format!("let {target} = {name}.dot(&{{}}).sin();"), &[&a]);
                self.line(&line);
                return self.declare(target, Kind::Scalar { mutable: false });
            }
            _ => put(&format!("{name} = ({name} + {{}}) * {{}};"), &[&a, &number]),
        };
        self.line(&line);
        self.line(&Both::same(format!("{name} = {name}.tamed();")));
    }

    /// An expression in which `names` stand for numbers.
    pub fn with(&mut self, names: &[&str]) -> Both {
        self.open_scope();
        for name in names {
            self.declare(name, Kind::Scalar { mutable: false });
        }
        let value = self.expression(2);
        self.close_scope();
        value
    }

    fn option(&mut self) {
        let (name, argument) = (self.random.pick(&NAMES), self.expression(1));
        let (with, without) = (self.with(&["v"]), self.expression(1));
        let text = match self.random.below(3) {
            0 => "match root({}) { Some(v) => {}, None => {} };",
            1 => "if let Some(v) = root({}) { {} } else { {} };",
            _ => {
                let text = format!("let {name} = root({{}}).map_or({{}}, |v| {{}});");
                self.line(&put(&text, &[&argument, &without, &with]));
                return self.declare(name, Kind::Scalar { mutable: false });
            }
        };
        self.line(&put(&format!("let {name} = {text}"), &[&argument, &with, &without]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn outcome(&mut self) {
        let (name, first, second) =
            (self.random.pick(&NAMES), self.expression(1), self.expression(1));
        let (with, failed, refused) = (self.with(&["v"]), self.leaf(), self.expression(1));
        let text = "match roots({}, {}) { Ok(v) => {}, Err(true) => {}, Err(_) => {} };";
        let text = format!("let {name} = {text}");
        self.line(&put(&text, &[&first, &second, &with, &failed, &refused]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn shape(&mut self) {
        let (name, first, second) = (self.random.pick(&NAMES), self.bounded(1), self.bounded(1));
        let (point, disc, sides) = (self.expression(1), self.with(&["v"]), self.with(&["v", "h"]));
        let text = "match shape({}, {}) { Shape::Point => {}, Shape::Disc(v) => {}, \
                    Shape::Box { w: v, h } => {} };";
        let text = match self.random.chance(50) {
            true => text.to_owned(),
            false => text.replace("Shape::Point", "Point").replace("Shape::Disc", "Disc"),
        };
        let text = format!("let {name} = {text}");
        self.line(&put(&text, &[&first, &second, &point, &disc, &sides]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn slice(&mut self) {
        let arrays = self.visible(Kind::is_array);
        if arrays.is_empty() {
            return self.array();
        }
        let array = self.random.pick(&arrays);
        let (name, start) = (self.random.pick(&NAMES), self.random.below(array.length()));
        let part = match self.random.below(3) {
            0 => array.name,
            1 => format!("{}[{start}..]", array.name),
            _ => format!("{}[..{}]", array.name, start + 1),
        };
        self.line(&Both::same(format!("let {name} = mixed(&{part}).sin();")));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn vec(&mut self) {
        let arrays = self.visible(Kind::is_array);
        if arrays.is_empty() {
            return self.array();
        }
        let array = self.random.pick(&arrays).name;
        let (vec, name, value) = (self.fresh("u"), self.random.pick(&NAMES), self.bounded(1));
        let line = match self.random.chance(50) {
            true => Both::same(format!("let mut {vec} = {array}.to_vec();")),
            false => put(
                &format!("let mut {vec}: Vec<_> = {array}.iter().map(|v| *v * {{}}).collect();"),
                &[&self.leaf()],
            ),
        };
        self.line(&line);
        self.line(&put(&format!("{vec}.push({{}});"), &[&value]));
        self.line(&Both::same(format!("{vec}[0] = {vec}[1] * {vec}[{vec}.len() - 1];")));
        let line = format!("let {name} = (mixed(&{vec}) + {vec}[0]).tanh();");
        self.line(&Both::same(line));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn change_elements(&mut self) {
        let arrays = self.visible(|kind| kind.is_array() && kind.is_mutable());
        if arrays.is_empty() {
            return self.array();
        }
        let array = self.random.pick(&arrays);
        let (name, value, start) =
            (self.random.pick(&NAMES), self.bounded(1), self.random.below(array.length()));
        let (array, by) = (array.name, self.fresh("by"));
        self.line(&put(&format!("let {by} = {{}};"), &[&value]));
        if self.random.chance(40) {
            let text = format!("for v in {array}.iter_mut() {{ *v = (*v * {by}).sin(); }}");
            return self.line(&Both::same(text));
        }
        let text = format!("let {name} = shifted(&mut {array}[{start}..], {by});");
        self.line(&Both::same(text));
        self.declare(name, Kind::Scalar { mutable: false });
    }
}
