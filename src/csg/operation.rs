//! The three operations, and when one operand decides alone.

/// On which side of a solid's surface a point of the ray lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    Out,
    In,
}

impl Side {
    pub(super) fn other(self) -> Side {
        match self {
            Side::Out => Side::In,
            Side::In => Side::Out,
        }
    }

    /// `IN` or `OUT`, as the documents write it.
    pub fn word(self) -> &'static str {
        match self {
            Side::Out => "OUT",
            Side::In => "IN",
        }
    }
}

/// What is made of two solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// What lies in either.
    Union,
    /// What lies in both.
    Intersection,
    /// What lies in the first and not in the second.
    Difference,
}

impl Operation {
    pub const ALL: [Operation; 3] = [Operation::Union, Operation::Intersection, Operation::Difference];

    /// Its name in the documents' files.
    pub fn name(self) -> &'static str {
        match self {
            Operation::Union => "Union",
            Operation::Intersection => "Intersection",
            Operation::Difference => "Difference",
        }
    }

    /// Its sign between two solids.
    pub fn sign(self) -> char {
        match self {
            Operation::Union => '∪',
            Operation::Intersection => '∩',
            Operation::Difference => '−',
        }
    }

    /// On which side of the whole lies what is on these sides of the operands.
    ///
    /// - Source: [A ill. 61].
    #[inline]
    pub fn combine(self, left: Side, right: Side) -> Side {
        use Side::{In, Out};
        match (self, left, right) {
            (Operation::Union, Out, Out) => Out,
            (Operation::Union, ..) => In,
            (Operation::Intersection, In, In) => In,
            (Operation::Intersection, ..) => Out,
            (Operation::Difference, In, Out) => In,
            (Operation::Difference, ..) => Out,
        }
    }

    /// Does the left operand decide, on that side, whatever the right one says?
    #[inline]
    pub(super) fn left_decides(self, left: Side) -> bool {
        left == if self == Operation::Union { Side::In } else { Side::Out }
    }

    /// Does the right operand decide, on that side, whatever the left one says?
    #[inline]
    pub(super) fn right_decides(self, right: Side) -> bool {
        right == if self == Operation::Intersection { Side::Out } else { Side::In }
    }
}
