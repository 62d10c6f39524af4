//! Emitted code compared with the machine: the operations, the meshes on which they are tried, and
//! the results. A program of emitted Rust is linked with this crate and needs nothing else.

pub mod columns;
pub mod places;
pub mod subjects;

use std::panic::{AssertUnwindSafe, catch_unwind};

use hedgerow::mesh::{Mesh, identical};

use crate::meshes::Dice;
use places::{Argument, Stopped, Tally, arguments, by_machine, compare, places, report};
use subjects::emissions;

/// A call of an emitted operation by its name: whether it applied, and its result.
pub type Call = fn(&str, &mut Mesh, &[Argument]) -> (bool, Option<u32>);

/// Compares emitted Rust with the machine: `call` applies an operation by its name, and returns
/// whether it applied, and its result.
pub fn hold_rust(call: Call) {
    let emissions = emissions();
    let subjects = emissions.iter().flat_map(|emission| &emission.subjects);
    let subjects: Vec<_> = subjects.collect();
    let mut tallies = vec![Tally::default(); subjects.len()];
    let mut dice = Dice(7);
    for place in places() {
        for (&subject, tally) in subjects.iter().zip(&mut tallies) {
            if place.level < subject.plan.level {
                continue;
            }
            for arguments in arguments(subject, &place.mesh, 40, &mut dice) {
                let machine = by_machine(subject, &place, &arguments);
                let mut mesh = place.mesh.clone();
                let called = || call(&subject.name, &mut mesh, &arguments);
                let emitted = match catch_unwind(AssertUnwindSafe(called)) {
                    Ok((true, result)) => Ok(Some((mesh, result))),
                    Ok((false, _)) => {
                        let name = &subject.name;
                        let is_same = identical(&mesh, &place.mesh);
                        assert!(is_same, "{name}, refused at {arguments:?}, leaves a trace");
                        Ok(None)
                    }
                    Err(_) => Err(Stopped),
                };
                compare(subject, &arguments, tally, 1e-12, [&machine, &emitted]);
                if let (Ok(Some((_, expected))), Ok(Some((_, result)))) = (&machine, &emitted) {
                    assert_eq!(expected, result, "{}", subject.name);
                }
            }
        }
    }
    let tallies: Vec<_> = subjects.into_iter().zip(tallies).collect();
    report("Rust", &tallies);
}
