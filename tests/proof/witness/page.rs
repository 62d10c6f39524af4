//! Pages of operations: the rejected ones with what they do to a small mesh (`text`), the
//! proved ones with the argument (`argument`).

use hedgerow::analysis::{Analysis, why_proved};
use hedgerow::check::{Outcome, examine};
use hedgerow::mesh::{Level, validate, validate_level};
use hedgerow::source::Sources;

use support::pages::{Case, check};

#[test]
fn pages_hold() {
    let count = check("proof/witness", answer);
    assert!(count > 15, "only {count} cases");
}

fn answer(case: &Case) -> String {
    let mut sources = Sources::new();
    let file = sources.add("page", case.input.to_owned());
    let analysis = Analysis::of(&sources, file);
    match case.kind {
        "text" => verdicts(&analysis),
        "argument" => argument(&analysis),
        kind => panic!("{}: `{kind}` is no question", case.place),
    }
}

fn argument(analysis: &Analysis) -> String {
    let mut lines = Vec::new();
    for rule in why_proved(analysis) {
        for law in rule.laws {
            lines.push(law.law.to_owned());
            lines.extend(law.lines.iter().map(|line| format!("  {line}")));
        }
    }
    lines.join("\n")
}

fn verdicts(analysis: &Analysis) -> String {
    let mut lines = Vec::new();
    for op in &analysis.program.ops {
        let Some(diagram) = &op.diagram else {
            let told = analysis.diagnostics.iter();
            lines.extend(told.map(|told| format!("unresolved: {}", told.message)));
            continue;
        };
        match examine(diagram) {
            Ok(_) => lines.push(format!("{}: proved", op.name)),
            Err(rejection) => {
                for diagnostic in &rejection.diagnostics {
                    lines.push(format!("{}: {}", diagnostic.code, diagnostic.message));
                }
                lines.extend(rejection.outcomes.iter().map(outcome));
            }
        }
    }
    lines.join("\n")
}

/// An outcome in a line, after a look at whether it is true.
fn outcome(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Breaks(example) => {
            assert_eq!(validate(&example.before), Ok(()));
            assert_eq!(validate(&example.after), Err(example.invalid.clone()));
            let mesh = &example.before;
            let level = validate_level(mesh, Level::Surface).map_or("map", |()| "surface");
            format!(
                "  V {} E {} F {} holes {} ({level}): {}",
                mesh.vertex_count(),
                mesh.edge_count(),
                mesh.face_count(),
                mesh.hole_count(),
                example.verdict
            )
        }
        Outcome::Valid(tried) => format!("  valid on {tried} meshes"),
        Outcome::NoMesh => "  no mesh matches".into(),
        Outcome::NotTried => "  not tried".into(),
    }
}
