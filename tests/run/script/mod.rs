//! Scripts on small meshes.

mod arguments;
mod asking;
mod attributes;
mod drain;
mod drain_keys;
mod expressions;
mod failures;
mod functions;
mod literal;
mod loops;
mod matrices;
mod random;
mod remesh;
mod spelled;

use hedgerow::analysis::Analysis;
use hedgerow::mesh::{Mesh, validate};
use hedgerow::rewrite::{Engine, Watch};
use hedgerow::run::{Failure, Report, prepare, run};
use hedgerow::source::Sources;
use support::engines::run_on_both;

/// Operations for the scripts of the tests: those of the example.
const OPS: &str = include_str!("../../../examples/remesh.hedge");

#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

/// A program and what is known of it.
fn analyse(text: &str) -> (Sources, Analysis) {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    (sources, analysis)
}

/// Runs the script `main` with these arguments.
fn try_run(
    mesh: &mut Mesh,
    script: &str,
    arguments: &[(&str, &str)],
) -> Result<(Report, Vec<String>), Box<Failure>> {
    run_alone(mesh, &format!("{OPS}\n{script}"), arguments)
}

/// Runs the script `main` of a program that has no other operations than its own.
fn run_alone(
    mesh: &mut Mesh,
    program: &str,
    arguments: &[(&str, &str)],
) -> Result<(Report, Vec<String>), Box<Failure>> {
    let (_, analysis) = analyse(program);
    let number = analysis.script("main").unwrap();
    let prepared = prepare(&analysis.program, number, &analysis.plans).unwrap();
    let own = |&(name, text): &(&str, &str)| (name.to_owned(), text.to_owned());
    let texts: Vec<_> = arguments.iter().map(own).collect();
    let arguments = prepared.arguments(&texts).unwrap();
    // Native code takes over in the midst of loops, or is there at once.
    let (taken_over, _) = run_on_both(&prepared, &mut mesh.clone(), &arguments, Engine::Native);
    let (report, lines) = run_on_both(&prepared, mesh, &arguments, Engine::NativeAtOnce);
    assert_eq!(taken_over, report);
    validate(mesh).unwrap();
    Ok((report?, lines))
}

/// Runs a script that has this body.
fn run_body(mesh: &mut Mesh, body: &str) -> (Report, Vec<String>) {
    let script = format!("script main() {{\n{body}\n}}");
    try_run(mesh, &script, &[]).unwrap()
}

/// What a script with this body prints.
fn printed(mesh: &mut Mesh, body: &str) -> Vec<String> {
    run_body(mesh, body).1
}

/// How often an operation was applied.
fn applied(report: &Report, name: &str) -> u64 {
    let op = report.ops.iter().find(|op| op.name == name);
    op.map_or(0, |op| op.applied)
}

/// How often an operation was refused.
fn refused(report: &Report, name: &str) -> u64 {
    let op = report.ops.iter().find(|op| op.name == name).unwrap();
    op.refused.iter().map(|(_, times)| times).sum()
}
