//! Edges in images: silhouettes, borders, ridges, shadows, surfaces that pierce each other, and all of
//! these in mirrors and behind transparent surfaces.
//!
//! Where what a pixel shows jumps, the mean of samples says nothing about how the jump moves, and its
//! derivative lacks the boundary term. Both come from the same records here. Every sample of a regular
//! grid, with one more row and column around the image, keeps [what it sees](sight), which is
//! [recorded](record) as it is traced: the primitives of its path, and the lights that are blocked there.
//! Where neighbours differ, the [link](links) between them is [searched](crossing) for the places at which
//! edges cross it; most need no ray, because each edge is the root of a
//! [number of a ray](crate::transport::edge). In each [cell](cell) between four samples the
//! crossings are joined to pieces of edges, which say how much area of each pixel lies on which side and
//! what length of edge moves in it. The [view](view) is the image with these areas;
//! [`adjoint`](crate::adjoint) pulls cotangents of its pixels back to both sides of the edges and, by
//! their speed along their normals, to what moves them.
//!
//! The derivative of a pixel is the sum of the derivative at fixed places, and of the jump times the speed
//! of the edge over its length in the pixel (Li et al., "Differentiable Monte Carlo Ray Tracing through
//! Edge Sampling", 2018). Turned down: to sample edges of the scene, whose number grows with what is
//! hidden, and to find crossings by more rays. Both cost several images; this costs a few rays for each
//! hundred pixels.
//!
//! Next to silhouettes of smooth meshes, and of spheres and other curved surfaces, the interior term changes fast:
//! their [pixels](limb) have more rays, and [strips](strip) along the silhouette rays of their own.
//!
//! Shadow rays of smooth triangles [start above them](crate::transport::smooth): where they start beyond other
//! triangles or spheres, there are edges of shadows, too. What smooth mirrors show may [jump](lifted) between their
//! triangles.
//!
//! Edges and points are of double precision, and what lies [beside](beside) an edge is found by rays of single precision.
//! These are asked as far from it as they can [tell](rays) its sides apart.
//!
//! What is [slender](slender) lies between samples whole, and is looked for from the scene.
//!
//! What is not seen: slender shadows, slender things in mirrors, custom shapes that such rays start in, spheres between
//! samples, edges of the shadows of lights after the first 64, and steps within textures. More rays make the first
//! finer. What curved mirrors show has no strips: few of its rays may be off by much.

mod band;
mod beside;
mod cell;
mod code;
mod crossing;
mod forward;
mod geometry;
mod lifted;
mod limb;
mod links;
mod lit;
mod numbers;
mod outline;
mod own_shadow;
mod polygon;
mod projection;
mod rays;
mod record;
mod shadow;
mod sight;
mod slender;
mod strip;
mod turned;
mod view;
mod walk;

pub use crossing::{Crossing, Layer};
pub use forward::{Moving, in_lane, margin_of};
pub use geometry::{Edge, Geometry, Met};
pub use limb::{Finer, Limb, StripPaths};
pub use view::View;
