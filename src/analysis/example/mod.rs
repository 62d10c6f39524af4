//! Examples of ops in steps: what the steps do to a small mesh.
//!
//! Such an op draws nothing itself. So it is tried on small meshes, at one place after the other,
//! until it is not refused and changes something; the faces around the place, before and after, are
//! a drawing like any other. If it applies both in the interior of a mesh and at a boundary, there
//! is an example of each. The order of the tries is fixed and their number is limited, which also
//! bounds steps that do not terminate.

mod drawn;
mod patch;
mod stage;
mod trial;

use std::fmt;
use std::ops::ControlFlow;

use patch::{Patch, Worth};
use trial::{Trial, Trials};

use crate::diagram;
use crate::resolve::Program;
use crate::rewrite::Plans;
use crate::source::Span;

/// The reason why an op in steps has no example.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoExample {
    op: String,
    /// The number of places where it was tried.
    tries: usize,
    /// The most frequent reason against an example.
    because: Option<String>,
}

impl fmt::Display for NoExample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { op, tries, because } = self;
        write!(f, "`{op}` is done in steps, and ")?;
        let shows = match tries {
            0 => return write!(f, "has no example"),
            1 => "one try on a small mesh does not show".to_owned(),
            tries => format!("none of {tries} tries on small meshes shows"),
        };
        match because {
            Some(because) => write!(f, "{shows} what it does: mostly {because}"),
            None => write!(f, "{shows} what it does: it changed nothing"),
        }
    }
}

/// The examples of an op in steps, as a drawn op with a rule for each.
///
/// # Errors
/// It is not proved, or none was found.
pub fn example(program: &Program, op: usize, plans: &Plans) -> Result<diagram::Op, NoExample> {
    let resolved = &program.ops[op];
    let none = |tries, because| NoExample { op: resolved.name.clone(), tries, because };
    let mut trials = Trials::new(program, op, plans).map_err(|_| none(0, None))?;
    let mut found = Found::default();
    for stage in stage::closed() {
        if !found.is_perfect {
            trials.on(&stage, &mut |trial| found.see(trial));
        }
    }
    for family in stage::open() {
        if found.at_boundary.is_none() {
            family.iter().for_each(|stage| trials.on(stage, &mut |trial| found.see(trial)));
        }
    }
    let rules = [found.inside, found.at_boundary].into_iter().flatten();
    let rules: Vec<_> =
        rules.map(|(_, trial, patch)| drawn::rule(resolved, &trial, &patch)).collect();
    if rules.is_empty() {
        return Err(none(trials.tries(), trials.hindrance()));
    }
    let docs = resolved.steps.as_ref().map(|steps| steps.docs.clone());
    Ok(diagram::Op {
        name: resolved.name.clone(),
        name_span: resolved.span,
        docs: docs.unwrap_or_default(),
        params: resolved.params.clone(),
        result: resolved.result,
        keeps: Vec::new(),
        rules,
        span: Span::default(),
    })
}

/// The best examples so far.
#[derive(Default)]
struct Found {
    inside: Option<(Worth, Trial, Patch)>,
    at_boundary: Option<(Worth, Trial, Patch)>,
    /// True if no interior example can be better.
    is_perfect: bool,
}

impl Found {
    /// Keeps a trial if it is better than the best so far; breaks if this mesh cannot give a better
    /// one.
    fn see(&mut self, trial: Trial) -> ControlFlow<()> {
        let Some(patch) = Patch::of(&trial) else { return ControlFlow::Continue(()) };
        let (worth, is_perfect) = (patch.worth(), patch.is_perfect());
        let best = if patch.has_hole() { &mut self.at_boundary } else { &mut self.inside };
        if best.as_ref().is_none_or(|(other, ..)| worth > *other) {
            *best = Some((worth, trial, patch));
        }
        if is_perfect && !self.is_perfect {
            self.is_perfect = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}
