//! Phase 1, collect: how each name is found, and what is tested.

use super::words;
use crate::check::matching::{self, Bound, Claim, Source};
use crate::diagram::{Drawing, Kind, NameId, Pointer};

/// Matching: the names are bound in order, then paths are checked for being empty, then all tests
/// are made.
#[derive(Clone, Debug)]
pub struct Matching {
    pub steps: Vec<Step>,
    pub empty_paths: Vec<EmptyPath>,
    pub tests: Vec<Test>,
}

/// A step that binds names.
#[derive(Clone, Debug)]
pub enum Step {
    /// The name of a parameter.
    Given(NameId),
    Begin(Begin),
    Walk(Walk),
    Bind {
        bound: Bound,
        source: Source,
        at_each_index: bool,
    },
}

/// The halfedge to begin with at an edge, vertex or face that is given.
#[derive(Clone, Debug)]
pub struct Begin {
    pub element: NameId,
    /// The halfedge that is bound; for a family, that at index 0; for a path, its first.
    pub halfedge: NameId,
    /// The pointer of the element to the first halfedge that is tried.
    pub first: Pointer,
    /// The pointers from one halfedge that is tried to the next.
    pub step: &'static [Pointer],
    pub tries: Tries,
    /// The reason to refuse an element without halfedges, if there can be one.
    pub isolated: Option<String>,
    /// The halfedges that it may be: `e.halfedge, or its twin`.
    pub claim: String,
}

/// The number of halfedges of an element that are tried until the rule is not refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tries {
    All,
    /// All if the new values are refused; only one if matching or the guard fails, which would fail
    /// for the others too.
    AllForValues,
    /// Only this many: further ones would match alike.
    Some(u16),
}

/// An orbit that is walked once around, to deal its halfedges out to the families of a period.
#[derive(Clone, Debug)]
pub struct Walk {
    pub orbit: NameId,
    /// True for the star of a vertex, false for a loop.
    pub around_vertex: bool,
    /// The families of a period, that of the known halfedge first, each with its offset.
    pub families: Vec<(NameId, i64)>,
    /// The test that the halfedges make whole periods, if a period is longer than one.
    pub is_whole: Option<WalkTest>,
    /// The test that the orbit is as long as the families bound before; `None` for the first walk.
    pub fits: Option<WalkTest>,
}

/// A test of a walk, in words: the condition, without backticks, and the reason to refuse.
#[derive(Clone, Debug)]
pub struct WalkTest {
    pub claim: String,
    pub refusal: String,
}

/// A path that may be empty: it is if its first halfedge is what follows it.
#[derive(Clone, Copy, Debug)]
pub struct EmptyPath {
    pub path: NameId,
    pub next: NameId,
    pub at_each_index: bool,
}

/// A test of what is drawn.
#[derive(Clone, Debug)]
pub struct Test {
    pub condition: Claim,
    pub at_each_index: bool,
    /// The condition, without backticks.
    pub claim: String,
    pub refusal: String,
}

impl Matching {
    /// For a rule with families, `drawing` is that of the rule unrolled.
    pub fn new(drawing: &Drawing, proved: &[matching::Step]) -> Self {
        let rule = drawing.rule;
        let (mut steps, mut tests) = (Vec::new(), Vec::new());
        let mut is_first_walk = true;
        for step in proved {
            steps.push(match step {
                matching::Step::Parameter { name, .. } => Step::Given(*name),
                matching::Step::Attempt { element, halfedge, tries } => {
                    Step::Begin(begin(drawing, *element, *halfedge, *tries))
                }
                matching::Step::Walk { orbit, halfedges } => {
                    let is_first = std::mem::take(&mut is_first_walk);
                    Step::Walk(walk(drawing, *orbit, halfedges, is_first))
                }
                matching::Step::Bind { name, source } => {
                    let at_each_index = rule.is_member(name.name());
                    Step::Bind { bound: *name, source: *source, at_each_index }
                }
                matching::Step::Test(claim) => {
                    tests.push(Test {
                        at_each_index: claim.is_repeated(rule),
                        claim: words::claim(drawing, claim),
                        refusal: words::refusal(drawing, claim, proved),
                        condition: claim.clone(),
                    });
                    continue;
                }
            });
        }
        let paths = rule.names_of(Kind::Path).filter(|&path| rule.is_first(path));
        let paths = paths.filter(|&path| drawing.before.mention(path).is_some());
        let empty_paths =
            paths.filter(|&path| drawing.is_empty_somewhere(path)).filter_map(|path| {
                let next = drawing.before.item_after(path)?;
                Some(EmptyPath { path, next, at_each_index: rule.is_member(path) })
            });
        Self { steps, empty_paths: empty_paths.collect(), tests }
    }

    /// The halfedge at which it begins, if that is one of an edge, which is the only choice.
    pub(super) fn begins_at_edge(&self, drawing: &Drawing) -> Option<NameId> {
        let mut begins = self.steps.iter().filter_map(|step| match step {
            Step::Begin(begin) => Some(begin),
            _ => None,
        });
        let begin = begins.next().filter(|_| begins.next().is_none())?;
        (drawing.rule.kind(begin.element) == Kind::Edge).then_some(begin.halfedge)
    }

    /// Sets the number of halfedges that are tried.
    pub(super) fn set_tries(&mut self, tries: Tries) {
        for step in &mut self.steps {
            if let Step::Begin(begin) = step {
                begin.tries = tries;
            }
        }
    }
}

fn begin(drawing: &Drawing, element: NameId, halfedge: NameId, tries: Option<u16>) -> Begin {
    let rule = drawing.rule;
    let text = &rule.name(element).text;
    let kind = rule.kind(element);
    let (first, step, other): (_, &[Pointer], _) = match kind {
        Kind::Edge => (Pointer::EdgeHalfedge, &[Pointer::Twin], "its twin".to_string()),
        Kind::Vertex => (
            Pointer::VertexHalfedge,
            &[Pointer::Prev, Pointer::Twin],
            format!("another spoke of {text}"),
        ),
        _ => (Pointer::FaceHalfedge, &[Pointer::Next], format!("another halfedge of {text}")),
    };
    let claim = match tries {
        Some(1) => format!("{text}.halfedge"),
        _ => format!("{text}.halfedge, or {other}"),
    };
    Begin {
        element,
        halfedge,
        first,
        step,
        tries: tries.map_or(Tries::All, Tries::Some),
        isolated: (kind == Kind::Vertex)
            .then(|| format!("{} is isolated: no halfedge starts there", rule.quoted(element))),
        claim,
    }
}

fn walk(drawing: &Drawing, orbit: NameId, halfedges: &[NameId], is_first: bool) -> Walk {
    let rule = drawing.rule;
    let around_vertex = rule.kind(orbit) == Kind::Vertex;
    let (what, quoted) = (if around_vertex { "spokes" } else { "sides" }, rule.quoted(orbit));
    let period = halfedges.len();
    Walk {
        orbit,
        around_vertex,
        families: halfedges.iter().map(|&half| (half, rule.offset(half))).collect(),
        is_whole: (period > 1).then(|| WalkTest {
            claim: format!("its {what} come in groups of {period}"),
            refusal: format!("the number of {what} of {quoted} is not a multiple of {period}"),
        }),
        fits: (!is_first).then(|| WalkTest {
            claim: "as many as before".into(),
            refusal: format!("{quoted} is longer, or shorter, than the families before"),
        }),
    }
}
