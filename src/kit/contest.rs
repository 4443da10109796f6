//! Methods that answer the same questions, held against one truth.
//!
//! A contest is methods by name, a truth, and a judge. It is held on a set of questions ([`Contest::at`]), over an axis of
//! difficulty ([`Contest::over`]), or over two ([`Contest::map`]). What comes out is read by name, never by position.
//!
//! ```
//! use lightbench::measure::Method;
//! use lightbench_kit::contest::Contest;
//! use lightbench_kit::figure::{Axis, Chart};
//! let contest = Contest::new(|x: &f64| x.exp_m1(), |_, truth, found, tally| tally.answer(Some(*found), Some(*truth)))
//!     .with(Method::default_of("expm1"), |x: &f64| x.exp_m1())
//!     .with("exp − 1", |x: &f64| x.exp() - 1.0);
//! let results = contest.over(&[1.0e-12, 1.0e-6, 1.0], |x| vec![x, 1.5 * x]);
//! assert_eq!(results.of("expm1").failures().total(), 0);
//! let chart = Chart::error_over(Axis::log("x"), "relative error").lines(&results);
//! ```

use crate::figure::{Axis, FailureMap};
use crate::measure::{Failures, Interleaved, Method, Point, Ratio, Series, Spread, Tally, interleaved};
use std::hint::black_box;

/// How a method answers a whole set: one call through a pointer, whatever the number of questions.
type Answers<'a, Q, A> = Box<dyn Fn(&[Q], &mut Vec<A>) + 'a>;
type Judge<'a, Q, T, A> = Box<dyn Fn(&Q, &T, &A, &mut Tally) + 'a>;

/// Methods of answering questions `Q` by answers `A`, whose truth is `T`.
pub struct Contest<'a, Q, T, A> {
    truth: Box<dyn Fn(&Q) -> T + 'a>,
    judge: Judge<'a, Q, T, A>,
    methods: Vec<(Method, Answers<'a, Q, A>)>,
    rounds: usize,
    summary: fn(Tally, f64) -> Point,
}

impl<'a, Q, T, A> Contest<'a, Q, T, A> {
    /// A contest without methods. The truth is found once for each question; `judge` reports a question, its truth and an
    /// answer to the tally, once or several times.
    pub fn new(truth: impl Fn(&Q) -> T + 'a, judge: impl Fn(&Q, &T, &A, &mut Tally) + 'a) -> Self {
        Contest {
            truth: Box::new(truth),
            judge: Box::new(judge),
            methods: Vec::new(),
            rounds: 0,
            summary: Tally::rms_at,
        }
    }

    /// Adds a method.
    ///
    /// # Panics
    /// If the name is taken.
    pub fn with(mut self, method: impl Into<Method>, answer: impl Fn(&Q) -> A + 'a) -> Self {
        let method = method.into();
        let is_new = self.methods.iter().all(|(m, _)| m.name != method.name);
        assert!(is_new, "two methods of the name “{}”", method.name);
        let all = move |questions: &[Q], out: &mut Vec<A>| {
            out.clear();
            out.extend(questions.iter().map(&answer));
        };
        self.methods.push((method, Box::new(all)));
        self
    }

    /// Measures time as well, in so many rounds in which the methods take turns; 0, the default, measures none.
    pub fn rounds(self, rounds: usize) -> Self {
        Contest { rounds, ..self }
    }

    /// What a point's error is: [`Tally::rms_at`] (the default), [`Tally::median_at`] or [`Tally::worst_at`].
    pub fn summary(self, summary: fn(Tally, f64) -> Point) -> Self {
        Contest { summary, ..self }
    }

    /// Holds the contest on one set of questions: one point for each method, at the parameter 1.
    pub fn at(&self, questions: &[Q]) -> Results {
        let mut results = Results::of_methods(self.methods.iter().map(|m| &m.0));
        self.hold(1.0, questions, &mut results);
        results
    }

    /// Holds the contest on the questions of each value of the parameter.
    pub fn over(&self, parameters: &[f64], questions: impl Fn(f64) -> Vec<Q>) -> Results {
        let mut results = Results::of_methods(self.methods.iter().map(|m| &m.0));
        for &parameter in parameters {
            self.hold(parameter, &questions(parameter), &mut results);
        }
        results
    }

    /// Where the method of that name fails: a map over two axes with ranges, each cell on its own questions. A cell fails if
    /// one answer of its does; else it has the median error, 0 where the truth has no answer either.
    ///
    /// # Panics
    /// If there is no such method.
    pub fn map(
        &self,
        name: &str,
        (x, y): (Axis, Axis),
        value: &str,
        cells: (usize, usize),
        questions: impl Fn(f64, f64) -> Vec<Q>,
    ) -> FailureMap {
        let names = self.methods.iter().map(|m| m.0.name.as_str());
        let (_, answers) = &self.methods[position(names, name)];
        let mut found = Vec::new();
        FailureMap::new(x, y, value, cells, |x, y| {
            let questions = questions(x, y);
            let truths: Vec<T> = questions.iter().map(&self.truth).collect();
            answers(&questions, &mut found);
            let tally = self.judged(&questions, &truths, &found);
            let error = Spread::median(&tally.errors()).map_or(0.0, |e| e.mid);
            (tally.failures().total() == 0).then_some(error)
        })
    }

    /// Adds a point to each method's series.
    fn hold(&self, parameter: f64, questions: &[Q], results: &mut Results) {
        let truths: Vec<T> = questions.iter().map(&self.truth).collect();
        let mut found = Vec::new();
        let times = self.times(questions);
        for (k, (_, answers)) in self.methods.iter().enumerate() {
            answers(questions, &mut found);
            let mut point = (self.summary)(self.judged(questions, &truths, &found), parameter);
            let each = 1.0 / questions.len().max(1) as f64;
            point.time = times.time(k).map(|seconds| seconds.times(each));
            results.all[k].1.points.push(point);
        }
        for (all, new) in results.seconds.iter_mut().zip(times.seconds) {
            all.extend(new);
        }
    }

    fn judged(&self, questions: &[Q], truths: &[T], found: &[A]) -> Tally {
        let mut tally = Tally::new();
        for ((question, truth), answer) in questions.iter().zip(truths).zip(found) {
            (self.judge)(question, truth, answer, &mut tally);
        }
        tally
    }

    /// All methods in turn over all questions; without rounds, or questions, no times.
    fn times(&self, questions: &[Q]) -> Interleaved {
        if self.rounds == 0 || questions.is_empty() {
            return Interleaved { seconds: vec![Vec::new(); self.methods.len()] };
        }
        let mut works: Vec<_> = self
            .methods
            .iter()
            .map(|(_, answers)| {
                let mut out = Vec::with_capacity(questions.len());
                move || {
                    answers(black_box(questions), &mut out);
                    black_box(&out);
                }
            })
            .collect();
        let mut works: Vec<&mut dyn FnMut()> = works.iter_mut().map(|w| w as &mut dyn FnMut()).collect();
        interleaved(&mut works, self.rounds)
    }
}

/// What a contest found, by the names of its methods.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    all: Vec<(Method, Series)>,
    /// Of each method, its seconds over a set of questions in every round.
    seconds: Vec<Vec<f64>>,
}

impl Results {
    fn of_methods<'m>(methods: impl Iterator<Item = &'m Method>) -> Self {
        let all: Vec<_> = methods.map(|m| (m.clone(), Series::default())).collect();
        Results { seconds: vec![Vec::new(); all.len()], all }
    }

    /// The series of a method.
    ///
    /// # Panics
    /// If there is no method of that name, as in all that follow: it is misspelt in the program.
    pub fn of(&self, name: &str) -> &Series {
        &self.all[self.position(name)].1
    }

    /// The point of a method at this value of the parameter; a contest at one set has it at 1.
    ///
    /// # Panics
    /// Also if no point was measured there.
    pub fn point(&self, name: &str, parameter: f64) -> &Point {
        let point = self.of(name).at(parameter);
        point.unwrap_or_else(|| panic!("“{name}” was not measured at {parameter}"))
    }

    /// Error of a method at this value of the parameter; NaN if no answer could be compared.
    pub fn error(&self, name: &str, parameter: f64) -> f64 {
        self.point(name, parameter).error.map_or(f64::NAN, |e| e.mid)
    }

    /// The failures of a method over all that it was asked.
    pub fn failures(&self, name: &str) -> Failures {
        self.of(name).failures()
    }

    /// How many times as long the one method takes as the other, over all rounds; `None` without a round.
    pub fn ratio(&self, name: &str, reference: &str) -> Option<Ratio> {
        let seconds = |name| self.seconds[self.position(name)].iter().copied();
        Ratio::of_pairs(&seconds(name).zip(seconds(reference)).collect::<Vec<_>>())
    }

    /// The same results with those of another contest, as of the same formulas in another precision. Times are compared
    /// within a contest only: those of the other are dropped from [`Results::ratio`].
    ///
    /// # Panics
    /// If a name is in both.
    pub fn and(mut self, other: Results) -> Self {
        for (method, series) in other.all {
            let is_new = self.all.iter().all(|(m, _)| m.name != method.name);
            assert!(is_new, "two methods of the name “{}”", method.name);
            self.all.push((method, series));
            self.seconds.push(Vec::new());
        }
        self
    }

    /// The methods with their series, in the order in which they were added.
    pub fn iter(&self) -> impl Iterator<Item = (&Method, &Series)> {
        self.all.iter().map(|(method, series)| (method, series))
    }

    fn position(&self, name: &str) -> usize {
        position(self.all.iter().map(|(m, _)| m.name.as_str()), name)
    }
}

impl<'a> IntoIterator for &'a Results {
    type Item = (&'a Method, &'a Series);
    type IntoIter = Box<dyn Iterator<Item = Self::Item> + 'a>;

    fn into_iter(self) -> Self::IntoIter {
        Box::new(self.iter())
    }
}

fn position<'n>(names: impl Iterator<Item = &'n str> + Clone, name: &str) -> usize {
    let found = names.clone().position(|n| n == name);
    found.unwrap_or_else(|| panic!("no method “{name}” among: {}", names.collect::<Vec<_>>().join(", ")))
}
