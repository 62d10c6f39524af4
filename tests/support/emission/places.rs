//! The places at which operations are tried, and the results of the machine.

use hedgerow::diagram::Type;
use hedgerow::mesh::same_up_to_renumbering;
use hedgerow::mesh::{ElementKind, Level, Mesh, equal_up_to_renumbering, highest_level, validate};
use hedgerow::rewrite::{Machine, Message, Outcome};

use super::columns;
use super::subjects::Subject;
use crate::meshes::{Dice, meshes as many, shuffle_pointers};

/// A small mesh, and its level.
pub struct Place {
    pub mesh: Mesh,
    pub level: Level,
}

/// Meshes of each level, some with other `halfedge` pointers.
pub fn places() -> Vec<Place> {
    let mut dice = Dice(11);
    let mut places = Vec::new();
    let mut kept = 0;
    let surfaces = many(Level::Surface, &mut dice);
    for (at, mut mesh) in surfaces.into_iter().enumerate() {
        if mesh.halfedge_count() > 40 && at % 4 != 0 {
            continue;
        }
        if at % 2 == 1 {
            shuffle_pointers(&mut mesh, &mut dice);
        }
        let level = highest_level(&mesh).expect("it is in order");
        kept += usize::from(level == Level::Simple);
        columns::fill(&mut mesh, &mut dice);
        places.push(Place { mesh, level });
    }
    assert!(kept > 10 && places.len() > 30, "{kept} of {}", places.len());
    places
}

/// A value of the machine as a number, as C++ and as Rust.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Argument {
    Element(u32),
    Bool(bool),
    Int(i64),
    Real(f64),
    Vec3([f64; 3]),
}

impl Argument {
    fn slots(self) -> Vec<u64> {
        match self {
            Self::Element(id) => vec![u64::from(id)],
            Self::Bool(value) => vec![u64::from(value)],
            Self::Int(value) => vec![value as u64],
            Self::Real(value) => vec![value.to_bits()],
            Self::Vec3(parts) => parts.map(f64::to_bits).to_vec(),
        }
    }
}

/// Arguments for an operation: at most `most` choices of elements, each with values.
pub fn arguments(
    subject: &Subject,
    mesh: &Mesh,
    most: usize,
    dice: &mut Dice,
) -> Vec<Vec<Argument>> {
    let mut all = vec![Vec::new()];
    for param in &subject.params {
        let kind = match param.ty {
            Type::Vertex => ElementKind::Vertex,
            Type::Halfedge => ElementKind::Halfedge,
            Type::Edge => ElementKind::Edge,
            Type::Face => ElementKind::Face,
            ty => {
                for arguments in &mut all {
                    arguments.push(value(ty, dice));
                }
                continue;
            }
        };
        let ids: Vec<_> =
            (0..mesh.capacity(kind) as u32).filter(|&id| mesh.is_alive(kind, id)).collect();
        let longer = all.iter().flat_map(|arguments: &Vec<Argument>| {
            let one = |&id: &u32| [arguments.as_slice(), &[Argument::Element(id)]].concat();
            ids.iter().map(one)
        });
        all = longer.collect();
    }
    let skip = dice.below(3);
    let step = all.len().div_ceil(most).max(1);
    all.into_iter().skip(skip.min(step - 1)).step_by(step).collect()
}

fn value(ty: Type, dice: &mut Dice) -> Argument {
    let real = |dice: &mut Dice| dice.below(80) as f64 / 8.0 - 2.0;
    match ty {
        Type::Bool => Argument::Bool(dice.below(2) == 1),
        Type::Int => Argument::Int(dice.below(20) as i64 - 6),
        Type::Real => Argument::Real(real(dice)),
        _ => Argument::Vec3([real(dice), real(dice), real(dice)]),
    }
}

/// The outcome of a call: the mesh and the result, or `None` if it was refused.
pub type Done = Result<Option<(Mesh, Option<u32>)>, Stopped>;

/// A run that has stopped, since a step has lowered the level that another one requires.
#[derive(Clone, Copy, Debug)]
pub struct Stopped;

/// The outcome on the machine.
pub fn by_machine(subject: &Subject, place: &Place, arguments: &[Argument]) -> Done {
    let mut mesh = place.mesh.clone();
    let slots: Vec<u64> = arguments.iter().flat_map(|argument| argument.slots()).collect();
    let mut machine = Machine::new(&subject.plans);
    machine.use_columns(columns::of(subject, &mesh));
    machine.trust_level(place.level);
    match machine.apply(&mut mesh, &subject.plan, &slots) {
        Ok(Outcome::Applied { result }) => Ok(Some((mesh, result))),
        Ok(Outcome::Refused { .. }) => Ok(None),
        // Steps that would set such a position are rolled back, and a script stops there.
        Err(trap) if trap.message == Message::NotFinite => Ok(None),
        Err(trap) if matches!(trap.message, Message::BelowLevel { .. }) => Err(Stopped),
        Err(trap) => panic!("{} traps: {trap:?}", subject.name),
    }
}

/// The number of times that an operation was applied, refused and stopped.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    pub applied: usize,
    pub refused: usize,
    pub stopped: usize,
}

/// Compares the outcome of emitted code with that of the machine.
pub fn compare(
    subject: &Subject,
    arguments: &[Argument],
    tally: &mut Tally,
    tolerance: f64,
    [machine, emitted]: [&Done; 2],
) {
    let place = || format!("{} at {arguments:?}", subject.name);
    match (machine, emitted) {
        (Err(Stopped), Err(Stopped)) => tally.stopped += 1,
        (Ok(None), Ok(None)) => tally.refused += 1,
        (Ok(Some((expected, result))), Ok(Some((mesh, emitted_result)))) => {
            tally.applied += 1;
            assert_eq!(validate(mesh), Ok(()), "{}", place());
            let same = match tolerance == 0.0 {
                true => equal_up_to_renumbering(expected, mesh),
                false => same_up_to_renumbering(expected, mesh, tolerance),
            };
            assert!(same, "{}: another mesh", place());
            let [ours, theirs] = [expected, mesh].map(columns::all_numbers);
            let mut pairs = ours.iter().zip(&theirs);
            let close = |(x, y): (&f64, &f64)| (x - y).abs() <= tolerance * (1.0 + x.abs());
            let same = ours.len() == theirs.len() && pairs.all(close);
            assert!(same, "{}: other attributes", place());
            assert_eq!(result.is_some(), emitted_result.is_some(), "{}", place());
        }
        (machine, emitted) => {
            let [machine, emitted] = [machine, emitted].map(|done| match done {
                Ok(Some(_)) => "applies",
                Ok(None) => "refuses",
                Err(Stopped) => "stops",
            });
            panic!("{}: emitted code {emitted} where the machine {machine}", place())
        }
    }
}

/// Prints the tallies, and asserts that every operation was applied, and refused if it can be.
pub fn report(title: &str, tallies: &[(&Subject, Tally)]) {
    println!("{title}\n  {:<36}{:>9}{:>9}", "op", "applied", "refused");
    let mut total = Tally::default();
    for (subject, tally) in tallies {
        println!("  {:<36}{:>9}{:>9}", subject.name, tally.applied, tally.refused);
        total.applied += tally.applied;
        total.refused += tally.refused;
        total.stopped += tally.stopped;
    }
    println!("  {:<36}{:>9}{:>9}", "all", total.applied, total.refused);
    for (subject, tally) in tallies {
        assert!(tally.applied > 0, "{} was never applied", subject.name);
    }
    assert!(total.refused > 500, "only {} refusals", total.refused);
    assert!(total.stopped > 50, "only {} stops", total.stopped);
}
