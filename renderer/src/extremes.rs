#![doc = include_str!("extremes.md")]
