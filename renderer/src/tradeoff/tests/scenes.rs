//! Generated problems.

use std::path::Path;

use crate::experiment::{Experiment, Target, TunedParameter};
use crate::scene::{Object, ParameterId};

/// Numbers that look random (Knuth's linear congruential generator, the upper bits).
pub struct Random(pub u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn color(&mut self, most: f64) -> String {
        let channel = |_| format!("{:.3}", self.between(0.0, most));
        let channels: Vec<String> = (0..3).map(channel).collect();
        format!("[{}]", channels.join(", "))
    }

    fn happens(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }
}

/// A problem that only its number decides: spheres before a floor, some of them mirrors, some with a
/// texture, under point and distant lights, seen by a small image; some of the parameters vary, and
/// the target is the image with them moved a little.
pub fn random_experiment(number: u64) -> Experiment {
    let mut random = Random(number.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    let size = |random: &mut Random| random.between(12.0, 72.0) as u32;
    let (width, height) = (size(&mut random), size(&mut random));
    let bounces = random.between(0.0, 5.0) as u32;
    let mut text = format!(
        "bounces = {bounces}\n[camera]\nlook_from = [{}, 1.5, 6.0]\nlook_at = [0.0, 0.5, 0.0]\nwidth = {width}\nheight = {height}\n",
        random.between(-2.0, 2.0)
    );
    for light in 0..1 + random.between(0.0, 2.5) as usize {
        let color = random.color(1.0);
        let (x, y, z) =
            (random.between(-4.0, 4.0), random.between(3.0, 7.0), random.between(2.0, 6.0));
        let numbers = match random.happens(0.7) {
            true => {
                format!("type = \"point\"\nposition = [{x}, {y}, {z}]\nradiant_intensity = 175.0")
            }
            false => {
                format!("type = \"distant\"\ndirection = [{x}, {y}, {z}]\nirradiance = 4.7124")
            }
        };
        text += &format!("[[light]]\nname = \"light{light}\"\n{numbers}\ncolor = {color}\n");
    }
    text += "[[sphere]]\nname = \"floor\"\ncenter = [0.0, -40.0, 0.0]\nradius = 40.0\nmaterial = \"paint0\"\n";
    let count = 1 + random.between(0.0, 4.0) as usize;
    for sphere in 0..count {
        let (x, z) = (random.between(-2.0, 2.0), random.between(-2.0, 1.5));
        let radius = random.between(0.3, 0.8);
        text += &format!(
            "[[sphere]]\nname = \"ball{sphere}\"\ncenter = [{x}, {radius}, {z}]\nradius = {radius}\nmaterial = \"paint{}\"\n",
            sphere + 1
        );
    }
    for material in 0..=count {
        let mirror = if random.happens(0.5) { random.color(0.9) } else { "[0.0, 0.0, 0.0]".into() };
        let texture = if random.happens(0.3) { "diffuse_texture = \"marble\"\n" } else { "" };
        text += &format!(
            "[material.paint{material}]\ndiffuse = {}\nspecular = {}\nexponent = {}\nmirror = {mirror}\n{texture}",
            random.color(0.8),
            random.color(0.5),
            random.between(1.0, 60.0),
        );
    }
    text += "[texture.marble]\nsize = [8, 8]\ncolor = [0.8, 0.6, 0.7]\n";
    let mut experiment = Experiment::parse(&text, Path::new(""), "a generated scene").unwrap();
    let texels = ParameterId::new(Object::Texture(0), "texels");
    let mut values = experiment.scene.get(texels).into_owned();
    values.iter_mut().for_each(|value| *value *= random.between(0.5, 1.0));
    experiment.scene.assign(texels, &values);
    tune(&mut experiment, &mut random);
    experiment
}

/// Chooses what varies: what images depend on, and smoothly without exception in half of the
/// problems.
fn tune(experiment: &mut Experiment, random: &mut Random) {
    let scene = &experiment.scene;
    let all_kinds = random.happens(0.5);
    let mut ids = scene.parameters();
    ids.retain(|&id| {
        let possible = all_kinds || !scene.moves_edges(id);
        // Nothing shows how most spheres are turned.
        possible && !["up", "rotation"].contains(&id.field) && random.happens(0.25)
    });
    if ids.is_empty() {
        ids.push(ParameterId::new(Object::Light(0), "color"));
    }
    let mut target = |&id: &ParameterId| {
        let step = 0.03 * scene.natural_scale(id);
        let values = scene.get(id).into_owned().into_iter();
        (id, values.map(|value| value + step * random.between(0.2, 1.0)).collect())
    };
    let values = ids.iter().map(&mut target).collect();
    let tuned = TunedParameter::new;
    let section = experiment.optimize.get_or_insert_default();
    section.target = Some(Target::Values(values));
    section.parameters = ids.into_iter().map(tuned).collect();
}
