//! The numbers of a scene as scalars of any kind.

use ad::tape::Var;
use ad::vector::Vector3;
use ad::{Dual, Real, Scalar, Vec3};

use crate::kernels::camera::Camera;
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::kernels::texture::Uv;
use crate::scene::{Light, ParameterId, Parameters};

/// A scalar that carries derivatives, and one number beside them.
pub(super) trait Number: Real {
    /// The number alone.
    fn number(self) -> f64;
}

impl Number for Var {
    fn number(self) -> f64 {
        self.value()
    }
}

impl<S: Scalar> Number for Dual<S> {
    fn number(self) -> f64 {
        self.value.to_f64()
    }
}

/// The parameters of a scene: those that vary as the scalars given, the others as constants.
pub(super) struct Numbers<'a, S> {
    pub parameters: &'a Parameters,
    pub varying: Vec<(ParameterId, Vec<S>)>,
}

impl<S: Real> Numbers<'_, S> {
    fn number_at(&self, id: ParameterId, index: usize) -> S {
        match self.varying.iter().find(|(varying, _)| *varying == id) {
            Some((_, block)) => block[index],
            None => S::from_f64(self.parameters.get(id)[index]),
        }
    }

    fn number(&self, id: ParameterId) -> S {
        self.number_at(id, 0)
    }

    fn vector_at(&self, id: ParameterId, index: usize) -> Vec3<S> {
        let [x, y, z] = [0, 1, 2].map(|axis| self.number_at(id, 3 * index + axis));
        Vector3::new(x, y, z)
    }

    fn vector(&self, id: ParameterId) -> Vec3<S> {
        self.vector_at(id, 0)
    }

    pub fn camera(&self) -> Camera<S> {
        Camera {
            look_from: self.vector(ParameterId::LookFrom),
            look_at: self.vector(ParameterId::LookAt),
            up: self.vector(ParameterId::Up),
            vfov: self.number(ParameterId::Vfov),
            focus: self.number(ParameterId::Focus),
        }
    }

    pub fn light(&self, index: usize) -> Light<S> {
        let color = self.vector(ParameterId::LightColor(index));
        let intensity = self.number(ParameterId::LightIntensity(index));
        match self.parameters.lights[index] {
            Light::Point(_) => {
                let position = self.vector(ParameterId::LightPosition(index));
                Light::Point(PointLight { position, color, intensity })
            }
            Light::Distant(_) => {
                let direction = self.vector(ParameterId::LightDirection(index));
                Light::Distant(DistantLight { direction, color, intensity })
            }
        }
    }

    pub fn material(&self, index: usize) -> Material<S> {
        Material {
            ambient: self.vector(ParameterId::Ambient(index)),
            diffuse: self.vector(ParameterId::Diffuse(index)),
            specular: self.vector(ParameterId::Specular(index)),
            exponent: self.number(ParameterId::Exponent(index)),
            reflection: self.vector(ParameterId::Reflection(index)),
        }
    }

    pub fn opacity(&self, index: usize) -> S {
        self.number(ParameterId::Opacity(index))
    }

    pub fn sphere(&self, index: usize) -> Sphere<S> {
        Sphere {
            center: self.vector(ParameterId::SphereCenter(index)),
            radius: self.number(ParameterId::SphereRadius(index)),
        }
    }

    pub fn vertex(&self, mesh: usize, index: u32) -> Vec3<S> {
        let single = ParameterId::Vertex { mesh, vertex: index as usize };
        match self.varying.iter().any(|(varying, _)| *varying == single) {
            true => self.vector(single),
            false => self.vector_at(ParameterId::Vertices(mesh), index as usize),
        }
    }

    pub fn uv(&self, mesh: usize, index: u32) -> Uv<S> {
        let id = ParameterId::TextureCoordinates(mesh);
        let [u, v] = [0, 1].map(|axis| self.number_at(id, 2 * index as usize + axis));
        Uv { u, v }
    }

    pub fn texel(&self, texture: usize, index: u32) -> Vec3<S> {
        self.vector_at(ParameterId::Texels(texture), index as usize)
    }
}
