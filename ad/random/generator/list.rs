//! Statements on a type that is not `Copy`, by its operators, on parts of places, and on neighbours.

use crate::text::{Both, put};
use crate::writer::{Kind, NAMES, Writer};

impl Writer {
    /// A statement of one of these kinds, and the name that it declares.
    pub fn of_lists(&mut self) {
        match self.random.below(9) {
            0 => self.list_operators(),
            8 => self.list_moved(),
            1 => self.list_in_loop(),
            2 => self.closure_for_method(),
            3 => self.chunks(),
            4 => self.taken_apart(),
            5 | 6 => self.neighbours(),
            _ => self.cycled(),
        }
    }

    fn list(&mut self) -> Both {
        let elements = [self.bounded(1), self.expression(1), self.bounded(1)];
        put("List(vec![{}, {}, {}])", &elements.iter().collect::<Vec<_>>())
    }

    fn list_operators(&mut self) {
        let (l, m) = (self.fresh("l"), self.fresh("m"));
        let (first, second) = (self.list(), self.list());
        self.line(&put(&format!("let {l} = {{}};"), &[&first]));
        self.line(&put(&format!("let {m} = &{l} * &{{}};"), &[&second]));
        let name = self.random.pick(&NAMES);
        let value = match self.random.below(4) {
            0 => format!("(-&{m} + {l}).total()"),
            1 => format!("({l}.clone() + {m}).total()"),
            2 => format!("({m} * {l}.total()).total()"),
            _ => format!("(&(&{l} * &{m}) * &{m}).total() * {l}.total()"),
        };
        self.line(&Both::same(format!("let {name} = ({value}).tanh();")));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn list_in_loop(&mut self) {
        let (list, index) = (self.fresh("l"), self.fresh("i"));
        let (start, step) = (self.list(), self.list());
        self.line(&put(&format!("let mut {list} = {{}};"), &[&start]));
        let to = self.random.below(5);
        let (condition, factor) = (self.condition(), self.bounded(1));
        self.line(&Both::same(format!("for {index} in 0..{to}_usize {{")));
        let lines = [
            put(&format!("    {list} += &{{}};"), &[&step]),
            put("    if {} {", &[&condition]),
            Both::same("        continue;"),
            Both::same("    }"),
            match self.random.chance(50) {
                true => put(&format!("    {list} = &{list} * &{{}};"), &[&step]),
                false => put(&format!("    {list} = {list} + {{}} * {{}};"), &[&step, &factor]),
            },
            Both::same("}"),
        ];
        lines.iter().for_each(|line| self.line(line));
        let name = self.random.pick(&NAMES);
        self.line(&Both::same(format!("let {name} = {list}.total();")));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    /// A loop in which the list is moved before the exits, and given a new value by those that go on.
    fn list_moved(&mut self) {
        let (list, index, moved) = (self.fresh("l"), self.fresh("i"), self.fresh("m"));
        let (start, step, value) = (self.list(), self.list(), self.bounded(1));
        let (leaves, skips, factor) = (self.condition(), self.condition(), self.bounded(1));
        let (name, to) = (self.fresh("t"), self.random.below(5));
        let leave = match self.random.below(3) {
            0 => "break;".to_owned(),
            1 => format!("return {name};"),
            _ => format!("{{ {list} = {moved}; break; }}"),
        };
        let reads_after = leave.contains(&list) || leave.starts_with("return");
        let lines = [
            put(&format!("let mut {list} = {{}};"), &[&start]),
            put(&format!("let mut {name} = {{}};"), &[&value]),
            Both::same(format!("for {index} in 0..{to}_usize {{")),
            put(&format!("    let {moved} = {list} + {{}};"), &[&step]),
            put("    if {} {", &[&leaves]),
            Both::same(format!("        {name} = {name} + {moved}.total().sin();")),
            Both::same(format!("        {leave}")),
            Both::same("    }"),
            put("    if {} {", &[&skips]),
            Both::same(format!("        {list} = &{moved} * &{moved};")),
            Both::same("        continue;"),
            Both::same("    }"),
            put(&format!("    {list} = {moved} * {{}};"), &[&factor]),
            Both::same("}"),
        ];
        lines.iter().for_each(|line| self.line(line));
        if reads_after {
            self.line(&Both::same(format!("{name} = ({name} + {list}.total()).tanh();")));
        }
        self.declare(&name, Kind::Scalar { mutable: true });
    }

    fn closure_for_method(&mut self) {
        let (list, start, captured) = (self.list(), self.bounded(1), self.expression(1));
        let name = self.random.pick(&NAMES);
        let text = format!("let {name} = {{}}.folded({{}}, |s, v| (s * v + {{}}).sin());");
        self.line(&put(&text, &[&list, &start, &captured]));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn chunks(&mut self) {
        let targets = self.visible(|kind| kind.is_array() && kind.is_mutable());
        if targets.is_empty() {
            return self.array();
        }
        let (target, by) = (self.random.pick(&targets).name, self.expression(1));
        let method = self.random.pick(&["chunks_exact_mut", "chunks_mut"]);
        let factor = self.fresh("k");
        self.line(&put(&format!("let {factor} = {{}};"), &[&by]));
        self.line(&Both::same(format!("for part in {target}.{method}(2) {{")));
        self.line(&Both::same(format!("    part[0] = (part[0] * {factor}).sin();")));
        self.line(&Both::same("    part.reverse();"));
        self.line(&Both::same("}"));
    }

    fn taken_apart(&mut self) {
        let whole = self.fresh("w");
        let (first, second) = (self.bounded(1), self.expression(1));
        self.line(&put(&format!("let mut {whole} = ({{}}, [{{}}; 2]);"), &[&first, &second]));
        self.line(&Both::same("{"));
        let parts = match self.random.chance(50) {
            true => format!("    let (p, [q, _]) = &mut {whole};"),
            false => format!("    let (ref mut p, [ref mut q, _]) = {whole};"),
        };
        self.line(&Both::same(parts));
        self.line(&Both::same("    *p = (*p * *q).sin();"));
        self.line(&Both::same("    *q = *q * *p + *q;"));
        self.line(&Both::same("}"));
        let name = self.random.pick(&NAMES);
        let value = format!("let {name} = ({whole}.0 + {whole}.1[0] * {whole}.1[1]).tanh();");
        self.line(&Both::same(value));
        self.declare(name, Kind::Scalar { mutable: false });
    }

    fn cycled(&mut self) {
        let arrays = self.visible(Kind::is_array);
        let targets = self.visible(|kind| kind.is_scalar() && kind.is_mutable());
        if arrays.is_empty() || targets.is_empty() {
            return self.declare_mutable();
        }
        let (array, target) = (self.random.pick(&arrays).name, self.random.pick(&targets).name);
        let count = self.random.below(9);
        self.line(&Both::same(format!("for v in {array}.iter().cycle().take({count}) {{")));
        self.line(&Both::same(format!("    {target} = ({target} + *v).sin();")));
        self.line(&Both::same("}"));
    }

    fn neighbours(&mut self) {
        let arrays = self.visible(Kind::is_array);
        let targets = self.visible(|kind| kind.is_scalar() && kind.is_mutable());
        if arrays.is_empty() || targets.is_empty() {
            return self.declare_mutable();
        }
        let (array, target) = (self.random.pick(&arrays), self.random.pick(&targets).name);
        let (length, name) = (array.length(), array.name);
        let (i, step) = (self.fresh("i"), self.fresh("step"));
        let ahead = self.random.below(2);
        let (below, above) = (format!("{name}[{i}]"), format!("{name}[{i} + 1]"));
        self.line(&Both::same(format!("for {i} in 0..{}_usize {{", length - 1)));
        self.line(&Both::same(match ahead {
            0 => format!("    let {step} = {above} - {below};"),
            _ => format!("    let {step} = ({below} * {target}).sin() * {above};"),
        }));
        let condition = self.condition();
        self.line(&put("    if {} {", &[&condition]));
        self.line(&Both::same(format!("        {target} = ({target} + {step} * {above}).sin();")));
        self.line(&Both::same("    } else {"));
        self.line(&Both::same(format!("        {target} = {target} - {step}.sin() * {below};")));
        self.line(&Both::same("    }"));
        self.line(&Both::same("}"));
    }
}
