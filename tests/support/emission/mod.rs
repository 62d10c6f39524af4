//! Emitted code compared with the machine: the operations, the meshes on which they are tried, and
//! the results. A program of emitted Rust is linked with this crate and needs nothing else.

pub mod columns;
pub mod places;
pub mod subjects;

use hedgerow::mesh::{Mesh, identical};

use crate::meshes::Dice;
use places::{Argument, Tally, arguments, by_machine, compare, places, report};
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
                let (applied, result) = call(&subject.name, &mut mesh, &arguments);
                assert!(
                    applied || identical(&mesh, &place.mesh),
                    "{} is refused at {arguments:?}, and leaves a trace",
                    subject.name
                );
                let emitted = applied.then_some((mesh, result));
                compare(subject, &arguments, tally, 1e-12, [&machine, &emitted]);
                if let (Some((_, expected)), Some((_, result))) = (&machine, &emitted) {
                    assert_eq!(expected, result, "{}", subject.name);
                }
            }
        }
    }
    let tallies: Vec<_> = subjects.into_iter().zip(tallies).collect();
    report("Rust", &tallies);
}
