//! The binary as people run it: files in, files and tables out, one clear line for bad input.

mod bad_input;
mod bench;
mod changes;
mod defaults;
mod export;
mod extremes;
mod gradient;
mod live;
#[cfg(feature = "mpi")]
mod mpi;
mod optimize;
mod out_folder;
mod params;
mod passes;
mod paths;
mod render;
mod resume;
mod sandbox;
mod shape;
mod stats;
mod tradeoff;
mod unlucky;
mod views;
