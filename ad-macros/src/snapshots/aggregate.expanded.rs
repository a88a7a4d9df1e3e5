impl reflect {
    pub fn vjp_onto(
        ray: Ray,
        normal: Vec3,
    ) -> (
        Ray,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Ray>,
        ) -> (::ad::Tangent<Ray>, ::ad::Tangent<Vec3>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let normal_shape = ::ad::rt::shape(&normal);
        let (cosine, cosine_pullback) = ray.direction.dot_vjp(normal);
        let direction = ray.direction;
        let constant = 2.0;
        let product = ::ad::rt::again(&constant) * ::ad::rt::again(&cosine);
        let product_1 = product * normal;
        let field_pullback = ::ad::rt::Difference::of(&direction, &product_1);
        let field = direction - product_1;
        let field_space = ::ad::rt::space(&field);
        let value = Ray { direction: field, ..ray };
        (
            value,
            move |
                result_bar: ::ad::Tangent<Ray>,
            | -> (::ad::Tangent<Ray>, ::ad::Tangent<Vec3>) {
                let mut value_bar = result_bar;
                let mut value_bar = value_bar;
                value_bar.direction.accepts_tangents(field_space);
                let mut field_bar = field_space
                    .enter(::ad::rt::take(&mut value_bar.direction));
                let mut ray_bar = value_bar;
                let (mut direction_bar, mut product_1_bar) = field_pullback
                    .pull_back(field_bar);
                let (mut product_bar, mut normal_bar) = ::ad::rules::MulPullback::mul_pullback(
                    product,
                    normal,
                    product_1_bar,
                );
                let (_, mut cosine_bar) = ::ad::rules::MulPullback::mul_pullback(
                    constant,
                    cosine,
                    product_bar,
                );
                ::ad::rt::Absorb::absorb(&mut ray_bar.direction, direction_bar);
                let (ray_part, normal_part) = cosine_pullback(cosine_bar);
                ::ad::rt::Absorb::absorb(&mut ray_bar.direction, ray_part);
                ::ad::rt::Absorb::absorb(&mut normal_bar, normal_part);
                (ray_bar, ::ad::rt::fit(normal_shape, normal_bar))
            },
        )
    }
    pub fn vjp(
        ray: Ray,
        normal: Vec3,
    ) -> (
        Ray,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Ray>,
        ) -> (::ad::Tangent<Ray>, ::ad::Tangent<Vec3>) + use<>,
    ) {
        let shape_0 = ::ad::rt::shape(&ray);
        let (value, pullback) = Self::vjp_onto(ray, normal);
        (
            value,
            #[inline(always)]
            move |
                result_bar: ::ad::Tangent<Ray>,
            | -> (::ad::Tangent<Ray>, ::ad::Tangent<Vec3>) {
                let (part_0, part_1) = pullback(result_bar);
                (::ad::rt::fit(shape_0, part_0), part_1)
            },
        )
    }
}
