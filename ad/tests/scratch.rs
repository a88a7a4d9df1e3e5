#[path = "gradients/language/operators.rs"]
mod operators;
#[path = "gradients/oracle.rs"]
#[allow(dead_code, unused)]
mod oracle;
