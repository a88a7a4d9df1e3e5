//! Strips along silhouettes of smooth meshes, which samples leave.

/// A piece of the inner side of a silhouette.
#[derive(Clone, Copy, Debug)]
pub struct Strip {
    /// A place on the silhouette, in pixels.
    pub place: [f64; 2],
    /// The unit normal of the silhouette into the mesh.
    pub inward: [f64; 2],
}

impl Strip {
    /// The place at a depth, in pixels.
    pub fn at(&self, depth: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.place[axis] + depth * self.inward[axis])
    }
}

/// The strips of the pixels of an image.
#[derive(Default)]
pub struct Strips {
    /// How wide they are, and how far they reach along the silhouette to either side of their place, in pixels.
    size: [f64; 2],
    strips: Vec<Strip>,
    /// Where those of each pixel start in the list, then its length; nothing if there are none.
    starts: Vec<u32>,
}

impl Strips {
    /// Strips of this `size`, each with its pixel, of so many pixels.
    pub fn new(size: [f64; 2], mut strips: Vec<(u32, Strip)>, pixels: usize) -> Self {
        strips.sort_by_key(|&(pixel, _)| pixel);
        let mut starts = vec![0; pixels + 1];
        strips.iter().for_each(|&(pixel, _)| starts[pixel as usize + 1] += 1);
        (0..pixels).for_each(|pixel| starts[pixel + 1] += starts[pixel]);
        Self { size, strips: strips.into_iter().map(|(_, strip)| strip).collect(), starts }
    }

    /// Where a sample of a pixel goes: out of strips, to their inner borders. Places are in pixels.
    pub fn leave(&self, pixel: usize, place: [f64; 2]) -> [f64; 2] {
        let [width, reach] = self.size;
        let of_pixel = match self.starts.get(pixel..pixel + 2) {
            Some(&[start, end]) => &self.strips[start as usize..end as usize],
            _ => &[],
        };
        of_pixel.iter().fold(place, |place, Strip { place: [x, y], inward: [u, v] }| {
            let [x, y] = [place[0] - x, place[1] - y];
            let depth = x * u + y * v;
            let is_within = depth > 0.0 && depth < width && (x * v - y * u).abs() < reach;
            let by = if is_within { width - depth } else { 0.0 };
            [place[0] + by * u, place[1] + by * v]
        })
    }
}
