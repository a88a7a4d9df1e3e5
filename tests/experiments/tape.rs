#[path = "../../examples/tape/experiment.rs"]
mod experiment;

use experiment::{INPUTS, image_loss};

#[test]
fn tape_and_generated_code_agree() {
    let (value, (generated, _)) = image_loss::value_and_grad::<f64>(&INPUTS, 4);
    let (taped_value, taped) = ad::tape::gradient(|x| image_loss(x, 4), &INPUTS);
    assert!((value - taped_value).abs() < 1e-14 * value.abs());
    let scale = taped.iter().fold(0.0_f64, |scale, d| scale.max(d.abs()));
    for (generated, taped) in generated.iter().zip(&taped) {
        assert!((generated - taped).abs() < 1e-12 * scale, "{generated} {taped}");
    }
    assert!(scale > 0.0);
}
