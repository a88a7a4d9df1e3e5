impl reflect {
    pub fn jvp(
        ray: Ray,
        normal: Vec3,
        ray_dot: ::ad::Tangent<Ray>,
        normal_dot: ::ad::Tangent<Vec3>,
    ) -> (Ray, ::ad::Tangent<Ray>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut slot = ::ad::rt::Slot::new();
        let argument_dot = ::ad::rt::pass_part(
            &ray.direction,
            &ray_dot.direction,
            &mut slot,
        );
        let (cosine, cosine_dot) = ray
            .direction
            .dot_jvp(normal, argument_dot, normal_dot);
        let direction = ray.direction;
        let direction_dot = ::ad::rt::read(&direction, &ray_dot.direction);
        let constant = 2.0;
        let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
            constant,
            cosine,
            ::ad::Additive::zero(),
            cosine_dot,
        );
        let (product_1, product_1_dot) = ::ad::rules::MulPullback::mul_jvp(
            product,
            normal,
            product_dot,
            normal_dot,
        );
        let (field, field_dot) = ::ad::rules::SubPullback::sub_jvp(
            direction,
            product_1,
            direction_dot,
            product_1_dot,
        );
        let value = Ray { direction: field, ..ray };
        let mut value_dot = ray_dot;
        value_dot.direction = ::ad::rt::pass(field_dot);
        (value, value_dot)
    }
}
