//! What `#[differentiable]` refuses, and what it says.

#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("tests/refusals/*/*.rs");
}
