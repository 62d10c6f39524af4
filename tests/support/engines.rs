//! Programs on the machine and as native code, with identical results, bit for bit.

use hedgerow::mesh::{Mesh, identical};
use hedgerow::rewrite::{Engine, Watch};
use hedgerow::run::{Argument, Failure, Prepared, Report, run};

#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

/// Runs a script on the machine and again on another engine, and asserts that the meshes, the
/// printed lines, the counts and the failures are the same.
pub fn run_on_both(
    prepared: &Prepared,
    mesh: &mut Mesh,
    arguments: &[(String, Argument)],
    engine: Engine,
) -> (Result<Report, Box<Failure>>, Vec<String>) {
    let mut other = mesh.clone();
    let on = |engine: Engine, mesh: &mut Mesh| {
        let mut prepared = prepared.clone();
        prepared.use_engine(engine);
        let mut lines = Lines::default();
        let done = run(&prepared, mesh, arguments, &mut lines);
        (done, lines.0)
    };
    let expected = on(Engine::Machine, mesh);
    let found = on(engine, &mut other);
    assert_eq!(found, expected, "native code does something else than the machine");
    assert!(identical(&other, mesh), "native code makes another mesh than the machine");
    expected
}
