//! What a table of blocks is made of: roles, kinds of values, domains, defaults.

/// Who says that a block or parameter exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// [D §4].
    Document,
    /// This project.
    Extension,
}

/// What happens to a block once it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Supported,
    /// Known and checked, but nothing can be built from it yet: an error, because the picture would be wrong.
    Planned,
}

/// What a block describes, and how often it may stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// One; the last one wins.
    Settings,
    /// One; the last one wins.
    Camera,
    /// Any number, each with its own name.
    Named(Names),
    Object,
    /// What is made of solids: inside a `CSG`, or in a `.csg` file.
    Operation,
    Light,
}

/// A family of names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    Material,
    Texture,
}

impl Names {
    pub fn word(self) -> &'static str {
        match self {
            Names::Material => "material",
            Names::Texture => "texture",
        }
    }
}

/// Which numbers a parameter accepts. NaN and infinities are never among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    Any,
    Positive,
    NotNegative,
    Closed(f64, f64),
    Open(f64, f64),
    /// A vector, not the zero vector.
    Direction,
    /// None of them 0.
    EachNotZero,
    /// A direction, and an angle.
    AxisAngle,
}

impl Domain {
    /// The domain after "a number" or "3 numbers"; empty if any will do.
    pub fn words(self) -> String {
        match self {
            Domain::Any => String::new(),
            Domain::Positive => " > 0".to_owned(),
            Domain::NotNegative => " ≥ 0".to_owned(),
            Domain::Closed(from, to) => format!(" in [{from}, {to}]"),
            Domain::Open(from, to) => format!(" strictly between {from} and {to}"),
            Domain::Direction => ", not all 0".to_owned(),
            Domain::EachNotZero => ", none of them 0".to_owned(),
            Domain::AxisAngle => ", the axis not all 0".to_owned(),
        }
    }

    /// The first value that lies outside, by its index; for a zero vector, all of it (`Some(None)`).
    pub fn outside(self, values: &[f64]) -> Option<Option<usize>> {
        let each = |ok: &dyn Fn(f64) -> bool| values.iter().position(|&v| !ok(v)).map(Some);
        let zero = |v: &[f64]| v.iter().all(|&x| x == 0.0).then_some(None);
        match self {
            Domain::Any => each(&|v| v.is_finite()),
            Domain::Positive => each(&|v| v > 0.0),
            Domain::NotNegative => each(&|v| v >= 0.0),
            Domain::Closed(from, to) => each(&|v| from <= v && v <= to),
            Domain::Open(from, to) => each(&|v| from < v && v < to),
            Domain::EachNotZero => each(&|v| v != 0.0),
            Domain::Direction => zero(values),
            Domain::AxisAngle => zero(&values[..values.len().min(3)]),
        }
    }
}

/// What values a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Numbers {
        count: usize,
        domain: Domain,
    },
    /// Whole numbers from … to, both included.
    Integers {
        count: usize,
        from: i64,
        to: i64,
    },
    /// The name that this block declares.
    Name,
    /// A name declared above.
    Reference(Names),
    /// A text in double quotes.
    Text,
    Choice(&'static [&'static str]),
}

impl Kind {
    /// How many values.
    pub fn count(self) -> usize {
        match self {
            Kind::Numbers { count, .. } | Kind::Integers { count, .. } => count,
            _ => 1,
        }
    }

    /// One value, as messages say it.
    pub fn one(self) -> String {
        match self {
            Kind::Numbers { domain: Domain::Any | Domain::Direction | Domain::AxisAngle, .. } => {
                "a number".into()
            }
            Kind::Numbers { domain: Domain::EachNotZero, .. } => "a number other than 0".into(),
            Kind::Numbers { domain, .. } => format!("a number{}", domain.words()),
            Kind::Integers { from: i64::MIN, .. } => "a whole number".into(),
            Kind::Integers { from, to: i64::MAX, .. } => format!("a whole number ≥ {from}"),
            Kind::Integers { from, to, .. } => format!("a whole number from {from} to {to}"),
            Kind::Name => "a name without spaces".into(),
            Kind::Reference(names) => format!("the name of a {}", names.word()),
            Kind::Text => "a text in double quotes".into(),
            Kind::Choice(words) => words.join(" or "),
        }
    }

    /// All values, as messages say it.
    pub fn all(self) -> String {
        match self {
            Kind::Numbers { count, domain } if count > 1 => format!("{count} numbers{}", domain.words()),
            Kind::Integers { count, from, to } if count > 1 => {
                format!("{count} whole numbers from {from} to {to}")
            }
            _ => self.one(),
        }
    }
}

/// What holds if the parameter is not written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// It must be written.
    Required,
    /// Nothing.
    Absent,
    Numbers(&'static [f64]),
    Integers(&'static [i64]),
    Word(&'static str),
}

/// How often a parameter may stand in one block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    Once,
    /// Any number; the order counts.
    Any,
}

/// A parameter of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    pub name: &'static str,
    pub kind: Kind,
    pub default: Default,
    /// Names of the values, for messages and the reference: `x y z`.
    pub values: &'static str,
    /// Empty for pure numbers.
    pub unit: &'static str,
    pub doc: &'static str,
    pub times: Times,
    pub origin: Origin,
    /// A misprint of the document that is understood too.
    pub alias: Option<&'static str>,
}

impl Param {
    pub(super) const fn new(
        name: &'static str,
        values: &'static str,
        kind: Kind,
        default: Default,
        doc: &'static str,
    ) -> Self {
        let (times, origin, alias) = (Times::Once, Origin::Document, None);
        Param { name, kind, default, values, unit: "", doc, times, origin, alias }
    }

    pub(super) const fn unit(self, unit: &'static str) -> Self {
        Param { unit, ..self }
    }

    pub(super) const fn repeatable(self) -> Self {
        Param { times: Times::Any, ..self }
    }

    pub(super) const fn extension(self) -> Self {
        Param { origin: Origin::Extension, ..self }
    }

    pub(super) const fn alias(self, alias: &'static str) -> Self {
        Param { alias: Some(alias), ..self }
    }
}

/// A block.
#[derive(Debug, PartialEq)]
pub struct Rule {
    pub name: &'static str,
    pub role: Role,
    pub state: State,
    pub origin: Origin,
    pub doc: &'static str,
    pub params: &'static [Param],
}

impl Rule {
    /// May that block stand inside of this one?
    pub fn may_hold(&self, inner: &Rule) -> bool {
        self.holds_solids() && matches!(inner.role, Role::Operation | Role::Object)
    }

    /// May blocks stand inside of this one at all?
    pub fn holds_solids(&self) -> bool {
        self.role == Role::Operation || self.name == "CSG"
    }

    /// The parameter of that name, or with that misprint.
    pub fn param(&self, name: &str) -> Option<&'static Param> {
        self.params.iter().find(|p| p.name == name || p.alias == Some(name))
    }
}
