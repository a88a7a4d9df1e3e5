fn reflect(ray: Ray, normal: Vec3) -> Ray {
    let cosine = ray.direction.dot(normal);
    Ray { direction: ray.direction - 2.0 * cosine * normal, ..ray }
}
