//! The check whether a text solves a lesson.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::{Lesson, Mistake};
use crate::analysis::Nowhere;
use crate::mesh::{Element, ElementKind, Mesh, difference, same_up_to_renumbering, shape};
use crate::rewrite::StopAfter;
use crate::session::{Argument, Error, Op, Outcome, Parameter, Program, Script, Session};

/// The largest distance between coordinates that count as the same.
const NEAR: f64 = 1e-9;

/// The most looks at a script: on small meshes a correct one needs few.
const MOST_LOOKS: u32 = 20_000;

/// The reason why a text does not solve a lesson.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejection {
    /// The common mistake that was made, if it is one.
    pub mistake: Option<Mistake>,
    /// The reason, in words.
    pub why: String,
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Mistake { title, text, .. }) = &self.mistake {
            write!(f, "a common mistake: {title}\n\n{text}\n\n")?;
        }
        f.write_str(&self.why)
    }
}

impl std::error::Error for Rejection {}

/// Compares a text with the program of a lesson.
///
/// # Errors
/// The first difference, and the mistake of the lesson that was made, if any: one whose program
/// fails in the same way, or does the same.
pub fn judge(lesson: &Lesson, text: &str) -> Result<(), Rejection> {
    judge_file(lesson, &format!("{}.hedge", lesson.name), text)
}

/// As [`judge`], for the text of a file, whose name appears in the messages.
pub fn judge_file(lesson: &Lesson, file: &str, text: &str) -> Result<(), Rejection> {
    let read = |text: &str| Program::parse_with(file, text, &mut Nowhere);
    let given = read(text);
    same(&read(&lesson.solution), &given).map_err(|why| {
        // A program with a gap may happen to do what a mistake does.
        let is_as_given = given.is_ok() && words(text) == words(&lesson.program);
        let does_the_same = |program: &str| match (&read(program), &given) {
            (Err(mistake), Err(given)) => {
                mistake.code() == given.code() && mistake.message() == given.message()
            }
            (mistake, given) => same(mistake, given).is_ok(),
        };
        let mistakes = lesson.mistakes.iter();
        let known = mistakes.clone().find(|it| it.programs().any(|it| words(it) == words(text)));
        // What several mistakes do tells of none.
        let mut alike = mistakes.filter(|it| it.programs().any(|it| does_the_same(it)));
        let only = match is_as_given || known.is_some() {
            true => None,
            false => alike.next().filter(|_| alike.next().is_none()),
        };
        let mistake = known.or(only);
        let why = match mistake {
            None if is_as_given => format!("the missing part is not written yet: {why}"),
            _ => why,
        };
        Rejection { mistake: mistake.cloned(), why }
    })
}

/// The words of a text, without its comments.
fn words(text: &str) -> Vec<&str> {
    let lines = text.lines().filter_map(|line| line.split("//").next());
    lines.flat_map(str::split_whitespace).collect()
}

/// Checks that the operations and scripts of one program do the same in another.
fn same(wanted: &Result<Program, Error>, given: &Result<Program, Error>) -> Result<(), String> {
    let wanted = wanted.as_ref().map_err(Error::to_string)?;
    let given = given.as_ref().map_err(Error::to_string)?;
    for op in wanted.ops().filter(|op| wanted.is_own(op.name())) {
        let yours = given.op(op.name()).map_err(|error| error.message().to_owned())?;
        for (values, with) in values(op.parameters().get(1..).unwrap_or_default()) {
            for (name, mesh) in meshes() {
                let name = format!("{name}{with}");
                same_op([(wanted, &op), (given, &yours)], &name, &mesh, &values)?;
            }
        }
    }
    for script in wanted.scripts().filter(|script| wanted.is_own(script.name())) {
        let yours = given.script(script.name()).map_err(|error| error.message().to_owned())?;
        for (values, with) in values(&script.parameters()) {
            for (name, mesh) in meshes() {
                let name = format!("{name}{with}");
                same_script([(wanted, &script), (given, &yours)], &name, &mesh, &values)?;
            }
        }
    }
    Ok(())
}

/// The values to try for parameters, each with words about them: their defaults, and others, if all
/// are numbers, so that a program that ignores its parameters is found.
fn values(parameters: &[Parameter<'_>]) -> Vec<(Vec<Argument>, String)> {
    let other = |parameter: &Parameter<'_>| {
        let (default, name) = (parameter.default?, parameter.name);
        match parameter.ty {
            "int" => {
                let value = default.parse::<i64>().ok()?.checked_add(3)?;
                Some((Argument::Int(value), format!("`{name}` {value}")))
            }
            "real" => {
                let value = default.parse::<f64>().ok()? * 3.0;
                Some((Argument::Real(value), format!("`{name}` {value}")))
            }
            _ => None,
        }
    };
    let others: Option<(Vec<_>, Vec<_>)> = parameters.iter().map(other).collect();
    let others = others.filter(|(values, _)| !values.is_empty());
    let others = others.map(|(values, words)| (values, format!(" with {}", words.join(", "))));
    std::iter::once((Vec::new(), String::new())).chain(others).collect()
}

/// Small meshes, closed and with a boundary, of triangles and of other polygons.
fn meshes() -> [(&'static str, Mesh); 8] {
    [
        ("a tetrahedron", shape::tetrahedron()),
        ("an octahedron", shape::octahedron()),
        ("an icosphere", shape::icosphere(1)),
        ("a torus of triangles", shape::triangle_torus(5, 3)),
        ("a grid of triangles", shape::triangle_grid(3, 2)),
        ("a cube", shape::cube()),
        ("a grid of quads", shape::grid(2, 2)),
        ("a tube", shape::tube(3, 2)),
    ]
}

/// Checks that both operations do the same at every element.
fn same_op(
    [(wanted, op), (given, yours)]: [(&Program, &Op); 2],
    name: &str,
    mesh: &Mesh,
    values: &[Argument],
) -> Result<(), String> {
    let types = |op: &Op| op.parameters().iter().map(|it| it.ty).collect::<Vec<_>>();
    if types(op) != types(yours) {
        let types = types(op).join(", ");
        return Err(format!("`{}` should take: {types}", op.name()));
    }
    let Some(kind) = types(op).first().and_then(|ty| ElementKind::named(ty)) else { return Ok(()) };
    for index in mesh.elements(kind) {
        let element = Element { kind, index };
        let mut sessions = [wanted, given].map(|program| Session::new(program, mesh.clone()));
        let [ours, theirs] = &mut sessions;
        let arguments: Vec<_> =
            std::iter::once(Argument::from(element)).chain(values.iter().cloned()).collect();
        let outcomes = (ours.apply(op, arguments.clone()), theirs.apply(yours, arguments));
        let place = || format!("on {name}, at {} {index}", kind.name());
        match outcomes {
            (Ok(Outcome::Applied(_)), Ok(Outcome::Applied(_))) => {
                let [ours, theirs] = [ours.mesh(), theirs.mesh()];
                if !same_up_to_renumbering(ours, theirs, NEAR) {
                    return Err(format!("{}: {}", place(), another(ours, theirs)));
                }
            }
            (Ok(Outcome::Applied(_)), Ok(Outcome::Refused(reason))) => {
                let reason = reason.text;
                return Err(format!("{}: it should apply, but refuses: {reason}", place()));
            }
            (Ok(Outcome::Refused(reason)), Ok(Outcome::Applied(_))) => {
                let reason = reason.text;
                return Err(format!("{}: it applies, but should refuse: {reason}", place()));
            }
            (Ok(Outcome::Applied(_) | Outcome::Refused(_)), Err(error)) => {
                return Err(format!("{}: {}", place(), error.message()));
            }
            // The wanted operation fails on this mesh.
            (Err(error), Ok(_)) => {
                return Err(format!("{}: it should not: {}", place(), error.message()));
            }
            (Ok(Outcome::Refused(_)), Ok(Outcome::Refused(_))) | (Err(_), Err(_)) => {}
        }
    }
    Ok(())
}

/// Checks that both scripts do the same to a mesh.
fn same_script(
    [(wanted, script), (given, yours)]: [(&Program, &Script); 2],
    name: &str,
    mesh: &Mesh,
    values: &[Argument],
) -> Result<(), String> {
    let run = |program: &Program, script: &Script| -> Result<(Mesh, Applied), Error> {
        let mut session = Session::new(program, mesh.clone());
        let report =
            session.run_watched(script, values.to_vec(), &mut StopAfter(MOST_LOOKS + 1))?;
        let applied = report.ops.into_iter().map(|op| (op.name, op.applied)).collect();
        Ok((session.into_mesh(), applied))
    };
    match (run(wanted, script), run(given, yours)) {
        (Ok((ours, wanted)), Ok((theirs, given)))
            if !same_up_to_renumbering(&ours, &theirs, NEAR) =>
        {
            Err(format!("on {name}: {}{}", another(&ours, &theirs), calls(&wanted, &given)))
        }
        (Ok(_), Err(error)) => Err(format!("on {name}: {}", error.message())),
        _ => Ok(()),
    }
}

/// The operations of a script, each with how often it has been applied.
type Applied = BTreeMap<String, u64>;

/// A sentence about the operations that are not applied as often as wanted; empty if there are none.
fn calls(wanted: &Applied, given: &Applied) -> String {
    let names: BTreeSet<_> = wanted.keys().chain(given.keys()).collect();
    let differing = names.into_iter().filter_map(|name| {
        let [wanted, given] = [wanted, given].map(|applied| applied.get(name).unwrap_or(&0));
        (wanted != given).then(|| format!("`{name}` {wanted} (here {given})"))
    });
    match differing.collect::<Vec<_>>().join(", ") {
        differing if differing.is_empty() => differing,
        differing => format!(". Applied on the way to that one: {differing}"),
    }
}

/// The message about a mesh that differs from the wanted one.
fn another(wanted: &Mesh, given: &Mesh) -> String {
    let difference = difference(given, wanted, NEAR);
    format!("the mesh should be another one afterwards. Compared with that one: {difference}")
}
