//! Laws of randomness: numbers, shuffles, point sets, warps.

mod numbers;
mod points;
mod warps;
