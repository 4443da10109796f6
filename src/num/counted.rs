//! Counted work: a number that reports every operation done with it.
//!
//! Any formula generic over [`Real`] runs with [`Counted`] unchanged; what it costs then is a count, the same on
//! every machine.

use super::real::Real;
use std::cell::Cell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Operations by kind. Changes of sign and comparisons are free here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Sums and differences.
    pub sums: u64,
    pub products: u64,
    pub quotients: u64,
    pub roots: u64,
}

impl Operations {
    const NONE: Operations = Operations { sums: 0, products: 0, quotients: 0, roots: 0 };

    /// All operations together.
    pub fn total(&self) -> u64 {
        self.sums + self.products + self.quotients + self.roots
    }
}

thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

fn note(change: impl FnOnce(&mut Operations)) {
    DONE.with(|done| {
        let mut operations = done.get();
        change(&mut operations);
        done.set(operations);
    });
}

/// The operations that `work` does with [`Counted`] numbers on this thread, and its result.
pub fn count<T>(work: impl FnOnce() -> T) -> (Operations, T) {
    let before = DONE.replace(Operations::NONE);
    let result = work();
    (DONE.replace(before), result)
}

/// An `f64` whose operations are counted; its results are those of `f64` to the bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counted(pub f64);

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

macro_rules! counted {
    ($operator:ident, $method:ident, $kind:ident) => {
        impl $operator for Counted {
            type Output = Counted;
            fn $method(self, other: Counted) -> Counted {
                note(|o| o.$kind += 1);
                Counted(self.0.$method(other.0))
            }
        }
    };
}
counted!(Add, add, sums);
counted!(Sub, sub, sums);
counted!(Mul, mul, products);
counted!(Div, div, quotients);

impl Neg for Counted {
    type Output = Counted;
    fn neg(self) -> Counted {
        Counted(-self.0)
    }
}

impl Real for Counted {
    const ZERO: Self = Counted(0.0);
    const ROUNDOFF: f64 = super::U;
    fn from_f64(x: f64) -> Self {
        Counted(x)
    }
    fn to_f64(self) -> f64 {
        self.0
    }
    fn sqrt(self) -> Self {
        note(|o| o.roots += 1);
        Counted(self.0.sqrt())
    }
    fn with_sign_of(self, sign: Self) -> Self {
        Counted(self.0.copysign(sign.0))
    }
}
