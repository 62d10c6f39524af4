//! The verdict on a text that is to solve a lesson.

use super::Lesson;
use crate::analysis::Nowhere;
use crate::mesh::{Element, ElementKind, Mesh, same_up_to_renumbering, shape};
use crate::session::{Error, Op, Outcome, Program, Script, Session};

/// The largest distance between coordinates that count as the same.
const NEAR: f64 = 1e-9;

/// Compares a text with the program of a lesson.
///
/// # Errors
/// In words, what is still missing.
pub fn judge(lesson: &Lesson, text: &str) -> Result<(), String> {
    let name = format!("{}.hedge", lesson.name);
    let wanted = Program::parse_with(&name, &lesson.solution, &mut Nowhere)
        .map_err(|error| error.to_string())?;
    let given =
        Program::parse_with(&name, text, &mut Nowhere).map_err(|error| error.to_string())?;
    for op in wanted.ops().filter(|op| wanted.is_own(op.name())) {
        let yours = given.op(op.name()).map_err(|error| error.message().to_owned())?;
        for (name, mesh) in meshes() {
            same_op([(&wanted, &op), (&given, &yours)], name, &mesh)?;
        }
    }
    for script in wanted.scripts().filter(|script| wanted.is_own(script.name())) {
        let yours = given.script(script.name()).map_err(|error| error.message().to_owned())?;
        for (name, mesh) in meshes() {
            same_script([(&wanted, &script), (&given, &yours)], name, &mesh)?;
        }
    }
    Ok(())
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

/// Both operations do the same at every element.
fn same_op(
    [(wanted, op), (given, yours)]: [(&Program, &Op); 2],
    name: &str,
    mesh: &Mesh,
) -> Result<(), String> {
    let types = |op: &Op| op.parameters().iter().map(|it| it.ty).collect::<Vec<_>>();
    if types(op) != types(yours) {
        let types = types(op).join(", ");
        return Err(format!("`{}` should take: {types}", op.name()));
    }
    let kind =
        types(op).first().and_then(|ty| ElementKind::ALL.into_iter().find(|it| it.name() == *ty));
    let Some(kind) = kind else {
        return Ok(());
    };
    for index in (0..mesh.capacity(kind) as u32).filter(|&index| mesh.is_alive(kind, index)) {
        let element = Element { kind, index };
        let mut sessions = [wanted, given].map(|program| Session::new(program, mesh.clone()));
        let [ours, theirs] = &mut sessions;
        let outcomes = (ours.apply(op, element), theirs.apply(yours, element));
        let place = || format!("on {name}, at {} {index}", kind.name());
        match outcomes {
            (Ok(Outcome::Applied(_)), Ok(Outcome::Applied(_))) => {
                if !same_up_to_renumbering(ours.mesh(), theirs.mesh(), NEAR) {
                    return Err(format!("{}: the mesh should be another one afterwards", place()));
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
            // Not a mesh that the operation is for.
            (Err(error), Ok(_)) => {
                return Err(format!("{}: it should not: {}", place(), error.message()));
            }
            (Ok(Outcome::Refused(_)), Ok(Outcome::Refused(_))) | (Err(_), Err(_)) => {}
        }
    }
    Ok(())
}

/// Both scripts do the same to a mesh.
fn same_script(
    [(wanted, script), (given, yours)]: [(&Program, &Script); 2],
    name: &str,
    mesh: &Mesh,
) -> Result<(), String> {
    let run = |program: &Program, script: &Script| -> Result<Mesh, Error> {
        let mut session = Session::new(program, mesh.clone());
        session.run(script, ())?;
        Ok(session.into_mesh())
    };
    match (run(wanted, script), run(given, yours)) {
        (Ok(ours), Ok(theirs)) if !same_up_to_renumbering(&ours, &theirs, NEAR) => {
            Err(format!("on {name}: the mesh should be another one afterwards"))
        }
        (Ok(_), Err(error)) => Err(format!("on {name}: {}", error.message())),
        _ => Ok(()),
    }
}
