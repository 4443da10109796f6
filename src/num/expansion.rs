//! Exact sums and products of `f64`, for the last word on a sign.

use super::double_double::{two_product, two_sum};

/// A number kept as an unevaluated sum of `f64` that do not overlap, smallest first; no term is zero.
///
/// - Accuracy: exact, as long as no product under- or overflows (see [`two_product`]).
/// - Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*,
///   Discrete & Computational Geometry 18 (1997), Grow-Expansion with zero elimination.
#[derive(Clone, Debug, Default)]
pub struct Expansion {
    terms: Vec<f64>,
}

impl Expansion {
    /// `a − b`.
    pub fn difference(a: f64, b: f64) -> Self {
        let mut sum = Expansion::default();
        sum.add(a);
        sum.add(-b);
        sum
    }

    /// Adds `x`.
    pub fn add(&mut self, x: f64) {
        let mut carry = x;
        let mut kept = 0;
        for i in 0..self.terms.len() {
            let (sum, rest) = two_sum(carry, self.terms[i]);
            carry = sum;
            if rest != 0.0 {
                self.terms[kept] = rest;
                kept += 1;
            }
        }
        self.terms.truncate(kept);
        if carry != 0.0 {
            self.terms.push(carry);
        }
    }

    /// Adds `x y`.
    pub fn add_product(&mut self, x: &Expansion, y: &Expansion) {
        for &a in &x.terms {
            for &b in &y.terms {
                let (product, rest) = two_product(a, b);
                self.add(rest);
                self.add(product);
            }
        }
    }

    /// Adds `x y z`.
    pub fn add_triple(&mut self, [x, y, z]: [f64; 3]) {
        let (p, e) = two_product(x, y);
        for part in [e, p] {
            let (q, f) = two_product(part, z);
            self.add(f);
            self.add(q);
        }
    }

    /// `x y − z w`.
    pub fn determinant(x: &Expansion, y: &Expansion, z: &Expansion, w: &Expansion) -> Self {
        let mut sum = Expansion::default();
        sum.add_product(z, w);
        sum.terms.iter_mut().for_each(|t| *t = -*t);
        sum.add_product(x, y);
        sum
    }

    /// The nearest `f64`, to within a rounding for each term.
    pub fn value(&self) -> f64 {
        self.terms.iter().sum()
    }

    /// −1, 0 or 1: the last term outweighs all others.
    pub fn sign(&self) -> i8 {
        match self.terms.last() {
            Some(t) if *t > 0.0 => 1,
            Some(_) => -1,
            None => 0,
        }
    }
}
