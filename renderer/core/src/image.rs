//! The image: what a camera records.

/// Linear RGB radiance, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` pixels.
    pub pixels: Vec<[f32; 3]>,
}

impl Image {
    /// An image of `width` by `height` black pixels.
    pub fn black(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[0.0; 3]; width as usize * height as usize] }
    }

    /// Returns `true` if every channel of every pixel is finite.
    pub fn is_finite(&self) -> bool {
        self.pixels.as_flattened().iter().all(|value| value.is_finite())
    }

    /// Makes pixels black that are not finite.
    pub fn blacken_non_finite(&mut self) {
        let finite = |pixel: &&mut [f32; 3]| pixel.iter().all(|value| value.is_finite());
        self.pixels.iter_mut().filter(|pixel| !finite(pixel)).for_each(|pixel| *pixel = [0.0; 3]);
    }

    /// A smaller image, whose pixels are the means of those that they cover.
    ///
    /// # Panics
    ///
    /// If its width and height do not divide this image's.
    pub fn reduced(&self, width: u32, height: u32) -> Self {
        let divides = |small: u32, large: u32| small > 0 && large.is_multiple_of(small);
        assert!(divides(width, self.width) && divides(height, self.height), "the size divides");
        let (columns, rows) = (self.width / width, self.height / height);
        let mut sums = vec![[0.0_f64; 3]; width as usize * height as usize];
        for (index, pixel) in self.pixels.iter().enumerate() {
            let (x, y) = (index as u32 % self.width / columns, index as u32 / self.width / rows);
            let sum = &mut sums[y as usize * width as usize + x as usize];
            sum.iter_mut().zip(pixel).for_each(|(sum, &value)| *sum += f64::from(value));
        }
        let mean = |sum: [f64; 3]| sum.map(|sum| (sum / f64::from(columns * rows)) as f32);
        Self { width, height, pixels: sums.into_iter().map(mean).collect() }
    }

    /// The absolute difference of every channel; nothing if the sizes differ.
    pub fn absolute_difference(&self, other: &Self) -> Option<Self> {
        if (self.width, self.height) != (other.width, other.height) {
            return None;
        }
        let difference = |(a, b): (&[f32; 3], &[f32; 3])| {
            [(a[0] - b[0]).abs(), (a[1] - b[1]).abs(), (a[2] - b[2]).abs()]
        };
        let pixels = self.pixels.iter().zip(&other.pixels).map(difference).collect();
        Some(Self { pixels, ..*self })
    }
}

#[cfg(test)]
mod tests {
    use super::Image;

    #[test]
    fn pixels_of_a_reduced_image_are_means() {
        let values = [1.0, 3.0, 10.0, 20.0, 5.0, 7.0, 30.0, 40.0];
        let image = Image { width: 4, height: 2, pixels: values.map(|v| [v, 0.0, -v]).to_vec() };
        let reduced = image.reduced(2, 1);
        assert_eq!(reduced.pixels, [[4.0, 0.0, -4.0], [25.0, 0.0, -25.0]]);
        assert_eq!(image.reduced(4, 2), image);
    }

    #[test]
    fn absolute_difference_needs_equal_sizes() {
        let a = Image { width: 1, height: 2, pixels: vec![[1.0, 2.0, 3.0], [0.0; 3]] };
        let b = Image { pixels: vec![[3.0, 2.0, 1.0], [0.5; 3]], ..a };
        let difference = a.absolute_difference(&b).unwrap();
        assert_eq!(difference.pixels, [[2.0, 0.0, 2.0], [0.5; 3]]);
        assert_eq!(a.absolute_difference(&Image::black(2, 1)), None);
    }
}
