//! Statements in which something happens beside: calls that change what they are given, in conditions,
//! bounds, indices and declarations with a type; random numbers; guards; names that mean several
//! things. The functions are those of `ad/random/tests/oracles/effects.rs`.

use crate::text::{Both, put};
use crate::writer::{Kind, NAMES, Variable, Writer};

impl Writer {
    pub fn effects(&mut self) {
        match self.random.below(9) {
            0 | 1 => self.changed_by_a_condition(),
            2 => self.changed_by_a_number(),
            3 => self.changed_by_name(),
            4 => self.methods_of_places(),
            5 => self.changed_by_a_closure(),
            6 => self.guard(),
            7 => self.clashing_names(),
            _ => self.constants_in_patterns(),
        }
    }

    /// A constant that is another one each time.
    pub fn drawn(&mut self) -> Both {
        let call = self.random.pick(&["draw()", "scale()"]);
        Both { plain: call.to_owned(), generic: format!("S::from_f64({call})") }
    }

    fn changeable_array(&mut self) -> Option<Variable> {
        let arrays = self.visible(|kind| kind.is_array() && kind.is_mutable());
        (!arrays.is_empty()).then(|| self.random.pick(&arrays))
    }

    fn changed_by_a_condition(&mut self) {
        let Some(array) = self.changeable_array() else { return self.array() };
        let array = array.name;
        let (name, condition) = (self.random.pick(&NAMES), self.condition());
        let (first, second) = (self.expression(1), self.expression(2));
        let text = match self.random.below(5) {
            0 => "if raises(&mut ARRAY) { {} } else { {} };",
            1 => "if {} && raises(&mut ARRAY) || !raises(&mut ARRAY[1..]) { {} } else { {} };",
            2 => "match raises(&mut ARRAY) { true => {}, false => {} };",
            3 => {
                let counter = self.fresh("n");
                self.line(&Both::same(format!("let mut {counter} = 0_usize;")));
                self.line(&Both::same(format!(
                    "while raises(&mut {array}) && {counter} < 3 {{ {counter} += 1; }}"
                )));
                return self.declare(&counter, Kind::Integer);
            }
            _ => {
                let line =
                    format!("assert!(raises(&mut {array}) || true, \"{{}}\", {array}.len());");
                return self.line(&Both::same(line));
            }
        };
        let text = format!("let {name} = {}", text.replace("ARRAY", &array));
        let parts: Vec<&Both> = match text.contains("&&") {
            true => vec![&condition, &first, &second],
            false => vec![&first, &second],
        };
        self.line(&put(&text, &parts));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn changed_by_a_number(&mut self) {
        let Some(array) = self.changeable_array() else { return self.array() };
        let (array, length) = (array.name.clone(), array.length());
        let counter = self.fresh("k");
        match self.random.below(3) {
            0 => {
                let line = format!("let {counter}: usize = raised(&mut {array}) % {length};");
                self.line(&Both::same(line));
                self.declare(&counter, Kind::Integer);
            }
            1 => {
                let name = self.random.pick(&NAMES);
                let value = self.expression(1);
                let text = format!("let {name} = {array}[raised(&mut {array}) % {length}] * {{}};");
                self.line(&put(&text, &[&value]));
                self.declare(name, Kind::Scalar { mutable: false });
            }
            _ => {
                let value = self.bounded(1);
                let text = format!("for {counter} in 0..raised(&mut {array}) % {length} ");
                let text =
                    text + &format!("{{ {array}[{counter}] = {{}}; }}").replace("{{}}", "{}");
                self.line(&put(&text, &[&value]));
            }
        }
    }

    fn changed_by_name(&mut self) {
        let Some(array) = self.changeable_array() else { return self.array() };
        let (array, by, name) = (array.name, self.fresh("by"), self.fresh("m"));
        let value = self.bounded(1);
        self.line(&put(&format!("let {by} = {{}};"), &[&value]));
        self.line(&Both::same(format!("let {name} = &mut {array};")));
        self.line(&Both::same(format!(
            "if raises({name}) && !raises({name}) {{ {name}[0] = {by} * {name}[1]; }}"
        )));
        if self.random.chance(50) {
            let told = self.random.pick(&NAMES);
            self.line(&Both::same(format!(
                "let {told} = (mixed({name}) + shifted({name}, {by}) * mixed({name})).sin();"
            )));
            return self.declare(told, Kind::Scalar { mutable: false });
        }
        let counter = self.fresh("k");
        self.line(&Both::same(format!("let {counter}: usize = raised({name});")));
        self.declare(&counter, Kind::Integer);
    }

    fn methods_of_places(&mut self) {
        let (balls, up, name) = (self.fresh("q"), self.fresh("up"), self.random.pick(&NAMES));
        let parts: Vec<_> = (0..4).map(|_| self.bounded(1)).collect();
        let parts: Vec<_> = parts.iter().collect();
        let text = format!("let mut {balls} = ")
            + "[Ball { height: {}, speed: {} }, Ball { height: {}, speed: {} }];";
        self.line(&put(&text, &parts));
        let index = self.index(2);
        self.line(&Both::same(format!("let {up} = {balls}[{index}].bounce();")));
        let (steps, value) = (self.random.below(4), self.expression(1));
        let text = format!("let {name} = if {up} ") + "{ RUN } else { {} };";
        let text = text.replace("RUN", &format!("{balls}[1].run({steps})"));
        self.line(&put(&text, &[&value]));
        self.declare(name, Kind::Scalar { mutable: false });
        let other = self.random.pick(&NAMES);
        self.line(&Both::same(format!(
            "let {other} = {balls}[0].height * {balls}[1].speed - {balls}[0].speed;"
        )));
        self.declare(other, Kind::Scalar { mutable: false });
    }

    fn changed_by_a_closure(&mut self) {
        let (total, closure, name) = (self.fresh("t"), self.fresh("add"), self.random.pick(&NAMES));
        let (start, body) = (self.bounded(1), self.with(&["v"]));
        let (first, second) = (self.expression(1), self.expression(1));
        self.line(&put(&format!("let mut {total} = {{}};"), &[&start]));
        let line = |scalar: &str, greater: &str, body: &str| {
            format!(
                "let mut {closure} = |v: {scalar}| {{ {total} = ({total} * v + {body}).sin(); {greater} }};"
            )
        };
        self.line(&Both {
            plain: line("f64", &format!("{total} > 0.25"), &body.plain),
            generic: line("S", &format!("{total}.cmpgt(S::from_f64(0.25))"), &body.generic),
        });
        let text =
            format!("let {name} = if CLOSURE({{}}) || !CLOSURE({{}}) ") + "{ {} } else { {} };";
        let text = text.replace("CLOSURE", &closure);
        let (then, otherwise) = (self.leaf(), self.expression(1));
        self.line(&put(&text, &[&first, &second, &then, &otherwise]));
        self.declare(name, Kind::Scalar { mutable: false });
        self.declare(&total, Kind::Scalar { mutable: true });
    }

    fn guard(&mut self) {
        if self.is_pure() {
            return self.array();
        }
        let quarters = self.random.below(8) as f64;
        let guard = format!("Guard::set({:?})", quarters / 4.0 - 1.0);
        let (name, value) = (self.random.pick(&NAMES), self.expression(2));
        if self.random.chance(40) {
            let (names, kept) = (["_guard", "guard"], self.fresh("guard"));
            let kept = self.random.pick(&names).replace("guard", &kept);
            return self.line(&Both::same(format!("let {kept} = {guard};")));
        }
        let text = format!("let {name} = {{{{ let _guard = {guard}; VALUE }}}} * scale_of;")
            .replace("{{", "{")
            .replace("}}", "}");
        let factor =
            Both { plain: "scale()".to_owned(), generic: "S::from_f64(scale())".to_owned() };
        let text = text.replace("VALUE", "{}").replace("scale_of", "{}");
        // The block has braces of its own.
        let (head, rest) = text.split_once("= {").expect("a block");
        let line = put(&format!("{head}= BLOCK{rest}"), &[&value, &factor]);
        let block = |text: &str| text.replace("BLOCK", "{");
        self.line(&Both { plain: block(&line.plain), generic: block(&line.generic) });
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn clashing_names(&mut self) {
        let name = self.random.pick(&NAMES);
        let (first, second) = (self.expression(1), self.bounded(1));
        if self.random.chance(50) {
            let text =
                format!("let {name} = left::curved({{}}) * right::curved({{}}) - curved({{}});");
            self.line(&put(&text, &[&first, &second, &first]));
            return self.declare(name, Kind::Scalar { mutable: false });
        }
        let pair = self.fresh("p");
        let text = format!("let {pair} = ") + "Pair { a: {}, b: {} };";
        self.line(&put(&text, &[&first, &second]));
        let line = |scalar: &str| {
            format!(
                "let {name} = (<Pair<{scalar}> as Soft>::pressed(&{pair}) + Hard::pressed(&{pair}) * {pair}.pressed()).tamed().a;"
            )
        };
        self.line(&Both { plain: line("f64"), generic: line("S") });
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn constants_in_patterns(&mut self) {
        let integers = self.integers();
        if integers.is_empty() {
            return self.array();
        }
        let (name, integer) = (self.random.pick(&NAMES), self.random.pick(&integers));
        let parts: Vec<_> = (0..3).map(|_| self.expression(1)).collect();
        let parts: Vec<_> = parts.iter().collect();
        let text = match self.random.chance(50) {
            true => "match NUMBER % 4 { two => {}, k if k > two => {}, _ => {} };",
            false => {
                "if let two = NUMBER % 3 { {} } else if matches!(NUMBER, two) { {} } else { {} };"
            }
        };
        let text = format!("let {name} = {}", text.replace("NUMBER", &integer));
        self.line(&put(&text, &parts));
        self.declare(name, Kind::Scalar { mutable: false });
    }
}
