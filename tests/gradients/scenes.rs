//! Small scenes with every kind of parameter.

use glam::{DVec3, dvec3};
use renderer::scene::{MaterialObject, Slot, Wrap};
use renderer::{
    Camera, DistantLight, Light, Material, Mesh, PointLight, Scene, SphereObject, Texture,
};

/// What a scene is made of, to be changed before it is put together.
#[derive(Clone)]
pub struct Parts {
    pub width: u32,
    pub height: u32,
    pub bounces: u32,
    pub camera: Camera<f64>,
    pub lights: Vec<(&'static str, Light<f64>)>,
    pub materials: Vec<MaterialObject>,
    pub textures: Vec<Texture>,
    pub spheres: Vec<SphereObject>,
    pub meshes: Vec<Mesh>,
}

impl Parts {
    pub fn scene(self) -> Scene {
        let mut scene = Scene::new(self.width, self.height, self.camera);
        scene.bounces = self.bounces;
        for (name, light) in self.lights {
            scene.add_light(name, light).unwrap();
        }
        for texture in self.textures {
            scene.add_texture(texture).unwrap();
        }
        for material in self.materials {
            scene.add_material(material.name.clone(), material).unwrap();
        }
        for sphere in self.spheres {
            scene.add_sphere(sphere).unwrap();
        }
        for mesh in self.meshes {
            scene.add_mesh(mesh).unwrap();
        }
        scene
    }
}

/// Replaces the numbers of a parameter.
#[track_caller]
pub fn set(scene: &mut Scene, path: &str, numbers: &[f64]) {
    scene.set(scene.parameter(path).unwrap(), numbers).unwrap();
}

/// Multiplies the numbers of a parameter.
#[track_caller]
pub fn multiply(scene: &mut Scene, path: &str, factor: f64) {
    let numbers = scene.get(scene.parameter(path).unwrap());
    let numbers: Vec<f64> = numbers.iter().map(|number| number * factor).collect();
    set(scene, path, &numbers);
}

/// A floor of two triangles that fills the image, a tetrahedron-like pair of triangles and a sphere
/// inside the view; two lights that cast shadows.
pub fn small_parts(size: u32) -> Parts {
    let material = |name: &str, diffuse: DVec3, specular: f64, exponent: f64| MaterialObject {
        name: name.into(),
        ..MaterialObject::from(Material {
            emission: dvec3(0.01, 0.02, 0.03),
            specular: DVec3::splat(specular),
            exponent,
            ..Material::lambertian(diffuse)
        })
    };
    let floor = [[-9.0, 0.0, 9.0], [9.0, 0.1, 9.0], [9.0, -0.1, -30.0], [-9.0, 0.05, -30.0]];
    let tent = [[0.4, 0.0, 0.6], [1.6, 0.1, 0.5], [1.0, 1.3, 0.2], [1.8, 0.9, -0.6]];
    let key = PointLight {
        position: dvec3(2.0, 4.0, 3.0),
        color: dvec3(1.0, 0.9, 0.8),
        radiant_intensity: 100.0,
    };
    let sky = DistantLight {
        direction: dvec3(-1.0, 2.0, 1.5),
        color: dvec3(0.5, 0.6, 0.9),
        irradiance: 1.25,
    };
    Parts {
        width: size,
        height: size / 2 + 3,
        bounces: 3,
        camera: Camera {
            look_from: dvec3(0.3, 2.5, 6.0),
            look_at: dvec3(0.1, 0.4, 0.0),
            up: dvec3(0.05, 1.0, 0.1),
            vfov: 35.0,
            film_scale: 0.9,
        },
        lights: vec![("key", key.into()), ("sky", sky.into())],
        materials: vec![
            material("ground", dvec3(0.6, 0.5, 0.4), 0.1, 8.0),
            material("object", dvec3(0.2, 0.7, 0.3), 0.3, 25.0),
        ],
        textures: Vec::new(),
        spheres: vec![SphereObject::new("ball", dvec3(-0.8, 0.5, 0.4), 0.5).material(1)],
        meshes: vec![
            Mesh::new("floor", floor.to_vec(), vec![[0, 1, 2], [0, 2, 3]]),
            Mesh::new("tent", tent.to_vec(), vec![[0, 1, 2], [1, 3, 2]]).material(1),
        ],
    }
}

pub fn small_scene(size: u32) -> Scene {
    small_parts(size).scene()
}

/// The small scene with floor and sphere as mirrors: the sphere shows the floor, which shows the
/// sphere again.
pub fn mirror_parts(size: u32) -> Parts {
    let mut parts = small_parts(size);
    parts.materials[0].values.mirror = dvec3(0.3, 0.2, 0.1);
    parts.materials[1].values.mirror = dvec3(0.4, 0.5, 0.3);
    parts
}

pub fn mirror_scene(size: u32) -> Scene {
    mirror_parts(size).scene()
}

/// The small scene with textures of every kind of wrapping on floor, mesh and sphere, and mirrors.
pub fn textured_parts(size: u32) -> Parts {
    let mut parts = mirror_parts(size);
    for (name, width, height, wrap) in [
        ("tiles", 3, 2, Wrap::Repeat),
        ("stripes", 4, 3, Wrap::Mirror),
        ("spot", 2, 2, Wrap::Clamp),
    ] {
        let texel = |i: u32| {
            let value =
                |channel: u32| 0.3 + 0.6 * f64::from((i * 5 + channel * 3 + i * i) % 7) / 6.0;
            [value(0), value(1), value(2)]
        };
        let texels = (0..width * height).map(texel).collect::<Vec<[f64; 3]>>().into();
        parts.textures.push(Texture { name: name.into(), width, height, wrap, texels });
    }
    let [ground, object] = [0, 1].map(|index| parts.materials[index].clone());
    parts.materials = vec![
        ground.with_texture(Slot::Diffuse, 0).with_texture(Slot::Specular, 1),
        object.with_texture(Slot::Diffuse, 2).with_texture(Slot::Emission, 1),
    ];
    let [floor, tent] = [0, 1].map(|index| parts.meshes[index].clone());
    parts.meshes = vec![
        floor.texture_coordinates(
            vec![[-2.1, -1.3], [2.2, -1.1], [2.4, 5.3], [-1.9, 5.1], [0.3, 0.2]],
            vec![[0, 1, 2], [0, 2, 3]],
        ),
        tent.texture_coordinates(
            vec![[0.13, 0.11], [1.2, -0.1], [0.61, 1.3], [1.4, 0.7]],
            vec![[0, 1, 2], [1, 3, 2]],
        ),
    ];
    parts
}

pub fn textured_scene(size: u32) -> Scene {
    textured_parts(size).scene()
}
