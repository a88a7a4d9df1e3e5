//! Cells: the squares between four samples, in which crossings are joined to the edges that they are on.
//!
//! Two crossings on the sides of a cell are the ends of one edge, or of two that meet at a corner, where
//! their tangents cut; more are the ends of edges that meet in one point. The edges cut the cell into
//! regions. Each quarter of the cell belongs to the pixel of its sample, which sees one of the regions:
//! where another one reaches into the quarter, the pixel gets that area of the difference. When an edge
//! moves, pixels gain and lose along its length. Crossings that cannot be joined count one by one, by
//! the mean length of an edge for each crossing of a grid (Crofton).

use super::crossing::Crossing;
use super::geometry::Edge;
use super::polygon::{Point, area_in_quadrant};

/// What one crossing gives one pixel.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    pub crossing: u32,
    pub pixel: u32,
    /// The area with the radiance of each side of the crossing, in pixels; the pixel's own radiance is
    /// in it with a negative sign.
    pub areas: [f64; 2],
    /// The length of edge that moves as the crossing does, in pixels.
    pub length: f64,
}

/// A crossing on the border of a cell.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    pub index: u32,
    pub crossing: &'a Crossing,
    /// 0 to 3: above, to the right, below, to the left.
    pub of: usize,
}

/// The square between four samples.
pub struct Cell<'a> {
    /// The place of the upper left sample, in pixels.
    pub start: Point,
    /// The length of a side in pixels.
    pub length: f64,
    /// The pixels of the four samples, clockwise from the upper left one.
    pub pixels: [Option<u32>; 4],
    /// Whether all four see the same surfaces.
    pub is_uniform: &'a dyn Fn() -> bool,
    /// The size of the image in pixels.
    pub size: [u32; 2],
    /// Whether two edges share a vertex.
    pub adjacent: &'a dyn Fn(Edge, Edge) -> bool,
    /// Whether the cell with a point has no crossing on its sides.
    pub is_quiet: &'a dyn Fn(Point) -> bool,
}

/// Room for the work on cells.
#[derive(Default)]
pub struct Workspace<'a> {
    stops: Vec<Stop<'a>>,
    region: Vec<Point>,
    shares: Vec<Share>,
}

impl Workspace<'_> {
    /// Adds to what a crossing gives a pixel.
    fn add(&mut self, crossing: u32, pixel: u32, areas: [f64; 2], length: f64) {
        let is_it = |share: &&mut Share| (share.crossing, share.pixel) == (crossing, pixel);
        match self.shares.iter_mut().find(is_it) {
            Some(share) => {
                share.areas[0] += areas[0];
                share.areas[1] += areas[1];
                share.length += length;
            }
            None => self.shares.push(Share { crossing, pixel, areas, length }),
        }
    }
}

/// A crossing on the way around a cell.
#[derive(Clone, Copy)]
struct Stop<'a> {
    /// From 0 to 4, clockwise from the upper left sample.
    at: f64,
    side: Side<'a>,
    /// Which sides of the crossing are before and after it on the way around.
    order: [usize; 2],
}

/// The most edges that meet in a point: ridges at a vertex.
const MOST_JOINED: usize = 8;

/// Below this sine of an angle, and this part of a cell between their lines, two edges are one.
const PARALLEL: f64 = 0.02;

/// How far outside of a cell the corner that two edges share may be, in sides of the cell: a tip that
/// slipped between samples.
pub const FARTHEST_CORNER: f64 = 6.0;

/// The same for the point in which more edges meet.
const FARTHEST_JUNCTION: f64 = 3.0;

/// By how much the lines of edges may miss their meeting point, in sides of the cell. Those of three may
/// miss it by more within the cell.
const JUNCTION_ERROR: f64 = 1e-4;

impl Cell<'_> {
    /// Appends what the crossings on the sides of the cell give to pixels.
    pub fn shares<'a>(&self, sides: &[Side<'a>], work: &mut Workspace<'a>, to: &mut Vec<Share>) {
        work.shares.clear();
        let family = |side: &Side<'_>| side.crossing.layer.family();
        let mut last = None;
        // The families in their order, most often one.
        while let Some(next) = sides.iter().map(family).filter(|next| Some(*next) > last).min() {
            last = Some(next);
            work.stops.clear();
            for side in sides.iter().filter(|side| family(side) == next) {
                match side.crossing.is_short {
                    true => self.single(side, work),
                    false => work.stops.push(self.stop(*side)),
                }
            }
            work.stops.sort_by(|a, b| a.at.total_cmp(&b.at));
            let mut stops = std::mem::take(&mut work.stops);
            // Shadows are independent of each other where all samples see the same surface.
            let joined = match next.is_none() || (self.is_uniform)() {
                true => self.joint(&stops),
                false => None,
            };
            match joined {
                Some(joint) => self.join(&stops, joint, work),
                None => self.pairs(&mut stops, work),
            }
            work.stops = stops;
        }
        to.append(&mut work.shares);
    }

    fn stop<'a>(&self, side: Side<'a>) -> Stop<'a> {
        let [x, y] = side.crossing.place;
        let (x, y) = ((x - self.start[0]) / self.length, (y - self.start[1]) / self.length);
        let along = match side.of {
            0 => x,
            1 => y,
            2 => 1.0 - x,
            _ => 1.0 - y,
        };
        let order = if side.of < 2 { [0, 1] } else { [1, 0] };
        Stop { at: side.of as f64 + along.clamp(1e-9, 1.0 - 1e-9), side, order }
    }

    /// How the edges through these stops meet: directly, or in a point. Nothing if that is not clear.
    fn joint(&self, stops: &[Stop<'_>]) -> Option<Option<Point>> {
        match stops {
            [a, b] => {
                let (a, b) = (a.side.crossing, b.side.crossing);
                if self.is_same_edge(a, b) || self.are_one_line(a, b) {
                    return Some(None);
                }
                let corner = meeting(&[a, b])?;
                let is_corner = self.holds(corner)
                    || a.layer == b.layer
                        && (self.adjacent)(a.edge, b.edge)
                        && self.is_near(corner, FARTHEST_CORNER)
                        && self.is_quiet_to(corner, &[a, b]);
                is_corner.then_some(Some(corner))
            }
            [_, _, _, ..] if stops.len() <= MOST_JOINED => {
                let mut edges = [stops[0].side.crossing; MOST_JOINED];
                edges.iter_mut().zip(stops).for_each(|(edge, stop)| *edge = stop.side.crossing);
                let edges = &edges[..stops.len()];
                let junction = meeting(edges)?;
                // Three that meet almost do so in the cell; that more do is no chance.
                let is_junction = stops.len() == 3 && self.holds(junction)
                    || self.miss(edges, junction) < JUNCTION_ERROR
                        && self.is_near(junction, FARTHEST_JUNCTION)
                        && self.is_quiet_to(junction, edges);
                is_junction.then_some(Some(junction))
            }
            _ => None,
        }
    }

    /// Whether two crossings are of one edge in one place: an edge and its image in a mirror are not.
    fn is_same_edge(&self, a: &Crossing, b: &Crossing) -> bool {
        a.edge == b.edge && (a.layer == b.layer || self.are_one_line(a, b))
    }

    /// Whether two edges are parts of one line: those of faces that share it.
    fn are_one_line(&self, a: &Crossing, b: &Crossing) -> bool {
        let [x, y] = [b.place[0] - a.place[0], b.place[1] - a.place[1]];
        let sine = a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
        let off = a.normal[0] * x + a.normal[1] * y;
        sine.abs() < PARALLEL && off.abs() < PARALLEL * self.length
    }

    fn holds(&self, point: Point) -> bool {
        (0..2).all(|axis| {
            let within = (point[axis] - self.start[axis]) / self.length;
            (-1e-9..=1.0 + 1e-9).contains(&within)
        })
    }

    /// Whether no samples see edges on their way to a point outside of the cell.
    fn is_quiet_to(&self, point: Point, edges: &[&Crossing]) -> bool {
        edges.iter().all(|edge| {
            let way = [0, 1].map(|axis| point[axis] - edge.place[axis]);
            let steps = (way[0].hypot(way[1]) / self.length).ceil() as usize;
            (1..=steps).all(|step| {
                let part = step as f64 / steps as f64;
                let on_way = [0, 1].map(|axis| edge.place[axis] + part * way[axis]);
                self.holds(on_way) || (self.is_quiet)(on_way)
            })
        })
    }

    fn is_near(&self, point: Point, most: f64) -> bool {
        let off = |axis: usize| (point[axis] - self.start[axis] - 0.5 * self.length).powi(2);
        off(0) + off(1) < (most * self.length).powi(2)
    }

    /// The largest distance between the lines of edges and a point, in sides of the cell.
    fn miss(&self, edges: &[&Crossing], point: Point) -> f64 {
        let off = |edge: &&Crossing| {
            let along = |axis: usize| (point[axis] - edge.place[axis]) * edge.normal[axis];
            (along(0) + along(1)).abs() / self.length
        };
        edges.iter().map(off).fold(0.0, f64::max)
    }

    /// Adds what edges give that meet directly or in a point.
    fn join(&self, stops: &[Stop<'_>], joint: Option<Point>, work: &mut Workspace<'_>) {
        self.lengths(stops, joint, work);
        self.areas(stops, joint, work);
    }

    /// The lengths of edge that move with each crossing.
    fn lengths(&self, stops: &[Stop<'_>], joint: Option<Point>, work: &mut Workspace<'_>) {
        match joint {
            Some(joint) => {
                for Stop { side, .. } in stops {
                    self.segment(side.crossing.place, [side.index; 2], joint, work);
                }
            }
            None => {
                let [a, b] = [&stops[0].side, &stops[1].side];
                self.segment(a.crossing.place, [a.index, b.index], b.crossing.place, work);
            }
        }
    }

    /// The length of a straight piece of edge, whose ends move with two crossings, by pixel.
    fn segment(&self, from: Point, crossings: [u32; 2], end: Point, work: &mut Workspace<'_>) {
        let (dx, dy) = (end[0] - from[0], end[1] - from[1]);
        let length = (dx * dx + dy * dy).sqrt();
        let mut cuts = [0.0, 1.0, 1.0, 1.0];
        for (cut, (start, step)) in cuts[1..3].iter_mut().zip([(from[0], dx), (from[1], dy)]) {
            let border = start.max(start + step).floor();
            if border > start.min(start + step) {
                *cut = (border - start) / step;
            }
        }
        if cuts[1] > cuts[2] {
            cuts.swap(1, 2);
        }
        // Outside of a cell an edge may cross more borders than one of each kind.
        let pieces = if length < 1.5 { 1 } else { length.ceil() as usize };
        for cut in cuts.windows(2) {
            let part = (cut[1] - cut[0]) / pieces as f64;
            for piece in 0..pieces {
                let middle = cut[0] + part * (piece as f64 + 0.5);
                let Some(pixel) = self.pixel([from[0] + middle * dx, from[1] + middle * dy]) else {
                    continue;
                };
                let length = length * part;
                if length > 0.0 {
                    let [first, last] = crossings;
                    work.add(first, pixel, [0.0; 2], length * (1.0 - middle));
                    work.add(last, pixel, [0.0; 2], length * middle);
                }
            }
        }
    }

    fn pixel(&self, [x, y]: Point) -> Option<u32> {
        let [width, height] = self.size;
        let is_inside = x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height);
        is_inside.then_some(y as u32 * width + x as u32)
    }

    /// The areas that regions have in quarters of the cell whose samples see others.
    fn areas(&self, stops: &[Stop<'_>], joint: Option<Point>, work: &mut Workspace<'_>) {
        let half = 0.5 * self.length;
        let middle = self.start.map(|start| start + half);
        let from_middle = |[x, y]: Point| [x - middle[0], y - middle[1]];
        // On which side of the middle a sample is.
        let signs = |sample: usize| {
            let sign = |is_after: bool| if is_after { 1.0 } else { -1.0 };
            [sign(matches!(sample % 4, 1 | 2)), sign(sample % 4 >= 2)]
        };
        let count = stops.len();
        let after = |index: usize| if index + 1 == count { 0 } else { index + 1 };
        // The region after each stop, and the one that each sample sees.
        let region_of = |sample: usize| {
            let before = |stop: &&Stop<'_>| stop.at < sample as f64;
            stops.iter().filter(before).count().checked_sub(1).unwrap_or(count - 1)
        };
        let seen: [usize; 4] = std::array::from_fn(region_of);
        // By stop and quarter: the areas before and after it on the way around.
        let mut given = [[[0.0; 2]; 4]; MOST_JOINED];
        for (index, stop) in stops.iter().enumerate() {
            let next = &stops[after(index)];
            let end = if index + 1 == count { next.at + 4.0 } else { next.at };
            let region = &mut work.region;
            region.clear();
            region.push(from_middle(stop.side.crossing.place));
            let passed =
                (0..8).filter(|&passed| (passed as f64) > stop.at && (passed as f64) < end);
            region.extend(passed.map(|passed| signs(passed).map(|sign| sign * half)));
            region.push(from_middle(next.side.crossing.place));
            region.extend(joint.map(from_middle));
            for (quarter, &own) in seen.iter().enumerate().filter(|&(_, &own)| own != index) {
                let area = area_in_quadrant(region, signs(quarter));
                // The radiance of a region is the mean of those at both of its ends.
                for (region, area) in [(index, 0.5 * area), (own, -0.5 * area)] {
                    given[region][quarter][1] += area;
                    given[after(region)][quarter][0] += area;
                }
            }
        }
        for (stop, given) in stops.iter().zip(given) {
            for (pixel, areas) in self.pixels.into_iter().zip(given) {
                if let Some(pixel) = pixel.filter(|_| areas != [0.0; 2]) {
                    let [before, after] = stop.order;
                    work.add(stop.side.index, pixel, [areas[before], areas[after]], 0.0);
                }
            }
        }
    }

    /// Joins crossings of the same edge, and then the rest if they meet; otherwise those count one by one.
    /// What lies beyond several edges differs by the sum of what changes at each.
    fn pairs(&self, stops: &mut Vec<Stop<'_>>, work: &mut Workspace<'_>) {
        let of_surfaces = |stop: &Stop<'_>| stop.side.crossing.layer.family().is_none();
        if stops.iter().all(of_surfaces) || (self.is_uniform)() {
            let mut are_joined = false;
            while let Some((a, b)) = self.same_edge(stops) {
                are_joined = true;
                let (b, a) = (stops.remove(b), stops.remove(a));
                self.join(&[a, b], None, work);
            }
            // What is left may end at those, and goes no farther.
            let ends_within =
                |joint: &Option<Point>| !are_joined || joint.is_none_or(|at| self.holds(at));
            if let Some(joint) = self.joint(stops).filter(ends_within) {
                return self.join(stops, joint, work);
            }
        }
        for stop in stops {
            self.single(&stop.side, work);
        }
    }

    /// Two stops of the same edge.
    fn same_edge(&self, stops: &[Stop<'_>]) -> Option<(usize, usize)> {
        (0..stops.len()).find_map(|a| {
            let is_same =
                |b: &usize| self.is_same_edge(stops[a].side.crossing, stops[*b].side.crossing);
            (a + 1..stops.len()).find(is_same).map(|b| (a, b))
        })
    }

    /// Half of what a crossing counts on its own; the other half is that of the cell beyond.
    fn single(&self, side: &Side<'_>, work: &mut Workspace<'_>) {
        let Crossing { place, normal, .. } = side.crossing;
        let weight = normal[axis(side)].abs();
        if let Some(pixel) = self.pixel(*place) {
            let length = 0.5 * self.length * weight;
            work.add(side.index, pixel, [0.0; 2], length);
        }
        self.single_areas(side, work);
    }

    /// Half of the area by which a crossing is off the middle of its link.
    fn single_areas(&self, side: &Side<'_>, work: &mut Workspace<'_>) {
        let Crossing { at, normal, .. } = side.crossing;
        let axis = axis(side);
        // The samples at the start and at the end of the link.
        let samples = [[0, 1], [1, 2], [3, 2], [0, 3]][side.of];
        let area = 0.5 * (at - 0.5) * self.length * self.length * normal[axis] * normal[axis];
        let nearer = samples[usize::from(*at > 0.5)];
        if let Some(pixel) = self.pixels[nearer] {
            work.add(side.index, pixel, [area, -area], 0.0);
        }
    }
}

/// 0 if the link of a side runs to the right, 1 if it runs downwards.
fn axis(side: &Side<'_>) -> usize {
    side.of % 2
}

/// The point that is closest to the lines of edges; nothing if they are nearly parallel.
fn meeting(edges: &[&Crossing]) -> Option<Point> {
    let (mut xx, mut xy, mut yy, mut x, mut y) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let origin = edges.first()?.place;
    for Crossing { place, normal: [nx, ny], .. } in edges {
        let along = (place[0] - origin[0]) * nx + (place[1] - origin[1]) * ny;
        xx += nx * nx;
        xy += nx * ny;
        yy += ny * ny;
        x += along * nx;
        y += along * ny;
    }
    let determinant = xx * yy - xy * xy;
    (determinant >= 1e-4).then(|| {
        [origin[0] + (x * yy - y * xy) / determinant, origin[1] + (y * xx - x * xy) / determinant]
    })
}
