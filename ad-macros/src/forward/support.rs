//! What has no forward mode: functions that are passed on.

use crate::ir::{Argument, Block, Lowered, Operation, Statement};
use crate::signature::Parameter;

/// Whether a function can be written in forward mode. One that takes functions, or passes closures
/// on, cannot: their objects have derivatives in reverse mode.
pub fn is_supported(lowered: &Lowered, parameters: &[Parameter]) -> bool {
    parameters.iter().all(|parameter| parameter.arity.is_none()) && is_plain(&lowered.body)
}

fn is_plain(block: &Block) -> bool {
    block.statements.iter().all(|statement| match statement {
        Statement::Define { operation, .. } => match operation {
            Operation::Closure(_) => false,
            Operation::Call { arguments, .. } => {
                !arguments.iter().any(|argument| matches!(argument, Argument::Function(_)))
            }
            _ => true,
        },
        Statement::Branch(branch) => branch.arms.iter().all(|arm| is_plain(&arm.body)),
        Statement::Loop(a_loop) => is_plain(&a_loop.body),
        Statement::Build(build) => is_plain(&build.body),
        Statement::Plain { .. }
        | Statement::Destructure { .. }
        | Statement::Assign { .. }
        | Statement::Update { .. } => true,
    })
}
