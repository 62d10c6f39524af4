//! Journals: what is rolled back was never written, and what was written is known.

use std::path::Path;

use glam::{DMat3, DVec3};
use hedgerow::analysis::Analysis;
use hedgerow::mesh::{
    ElementKind, Level, Mesh, Value, highest_level, identical, shape, validate_level,
    validate_level_near,
};
use hedgerow::rewrite::{Machine, Outcome, Plan};
use hedgerow::source::Sources;

/// A small generator of numbers (splitmix64; S. Vigna, 2015): the same in every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) % end.max(1) as u64) as usize
    }
}

/// The steps of the library, which respect no level.
fn steps() -> Vec<Plan> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/library/std/map.hedge");
    let mut sources = Sources::new();
    let file = sources.add("map.hedge", std::fs::read_to_string(path).unwrap());
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    analysis.plans.iter().cloned().map(Option::unwrap).collect()
}

fn meshes() -> Vec<Mesh> {
    vec![
        shape::tetrahedron(),
        shape::cube(),
        shape::octahedron(),
        shape::pillow(3),
        shape::fan(5),
        shape::tube(4, 2),
        shape::grid(2, 3),
        shape::triangle_grid(3, 3),
        shape::torus(3, 4),
    ]
}

fn element(mesh: &Mesh, plan: &Plan, dice: &mut Dice) -> u64 {
    let kind = match plan.name.as_str() {
        "straighten" => ElementKind::Vertex,
        "zip" | "drop_monogon" | "open" => ElementKind::Face,
        _ => ElementKind::Edge,
    };
    dice.below(mesh.capacity(kind)) as u64
}

/// Takes a few random steps; says how many were taken.
fn wander(mesh: &mut Mesh, plans: &[Plan], dice: &mut Dice) -> usize {
    let mut machine = Machine::default();
    let mut taken = 0;
    for _ in 0..1 + dice.below(6) {
        let plan = &plans[dice.below(plans.len())];
        // Some of them take two elements.
        let at =
            [element(mesh, plan, dice), dice.below(mesh.capacity(ElementKind::Halfedge)) as u64];
        let outcome = machine.apply(mesh, plan, &at);
        taken += usize::from(matches!(outcome, Ok(Outcome::Applied { .. })));
    }
    taken
}

#[test]
fn what_is_rolled_back_was_never_written() {
    let plans = steps();
    let mut dice = Dice(5);
    let mut taken = 0;
    for original in meshes() {
        for _ in 0..200 {
            let mut mesh = original.clone();
            let color = mesh.add_column(ElementKind::Vertex, "color", Value::Int(7)).unwrap();
            // Some slots are free, some are pending.
            wander(&mut mesh, &plans, &mut dice);
            if dice.below(2) == 0 {
                mesh.recycle();
            }
            wander(&mut mesh, &plans, &mut dice);
            let before = mesh.clone();
            let outer = mesh.open_journal();
            taken += wander(&mut mesh, &plans, &mut dice);
            let between = mesh.clone();
            let inner = mesh.open_journal();
            taken += wander(&mut mesh, &plans, &mut dice);
            let v = mesh.add_vertex();
            mesh.set_position(v, DVec3::ONE);
            assert!(mesh.set_value(color, v.0, Value::Int(8)));
            mesh.recycle();
            if dice.below(2) == 0 {
                mesh.roll_back(inner);
                assert!(identical(&mesh, &between));
            } else {
                mesh.keep(inner);
            }
            mesh.roll_back(outer);
            assert!(identical(&mesh, &before));
            for kind in ElementKind::ALL {
                assert_eq!(mesh.count(kind), before.count(kind));
                assert_eq!(mesh.capacity(kind), before.capacity(kind));
            }
            // Slots are given out as if nothing had been.
            let mut twin = before.clone();
            for mesh in [&mut mesh, &mut twin] {
                mesh.recycle();
            }
            let born = |mesh: &mut Mesh| (mesh.add_vertex(), mesh.add_edge(), mesh.add_face());
            assert_eq!(born(&mut mesh), born(&mut twin));
        }
    }
    assert!(taken > 3_000, "only {taken} steps");
}

#[test]
fn a_level_is_lost_where_something_was_written() {
    let plans = steps();
    let mut dice = Dice(6);
    let (mut kept, mut lost) = ([0; 3], [0; 3]);
    for original in meshes() {
        for _ in 0..400 {
            let mut mesh = original.clone();
            let level = highest_level(&mesh).unwrap();
            let mark = mesh.open_journal();
            let taken = wander(&mut mesh, &plans, &mut dice);
            for asked in Level::ALL.into_iter().filter(|&asked| asked <= level) {
                let near = validate_level_near(&mesh, asked, &mesh.written_since(&mark));
                let all = validate_level(&mesh, asked);
                assert_eq!(near.is_ok(), all.is_ok(), "{asked}: {near:?}, {all:?}");
                match near {
                    Ok(()) => kept[asked as usize] += usize::from(taken > 0),
                    Err(_) => lost[asked as usize] += 1,
                }
            }
            mesh.keep(mark);
        }
    }
    println!("kept {kept:?}, lost {lost:?}");
    assert!(kept[1] > 100 && lost[1] > 1_000 && kept[2] > 50 && lost[2] > 1_000);
}

/// Walks in so many steps, with what scripts do in between; each state.
fn walk(mesh: &mut Mesh, plans: &[Plan], dice: &mut Dice, steps: usize) -> Vec<Mesh> {
    let color = mesh.find_column(ElementKind::Vertex, "color").unwrap();
    let mut states = Vec::new();
    for step in 0..steps {
        wander(mesh, plans, dice);
        match dice.below(6) {
            0 => mesh.recycle(),
            1 => {
                let mark = mesh.open_journal();
                wander(mesh, plans, dice);
                mesh.end_step(); // What may be rolled back is no step.
                mesh.recycle();
                mesh.roll_back(mark);
            }
            2 => {
                let frame = Value::Mat3(DMat3::from_diagonal(DVec3::splat(step as f64)));
                let column = mesh.add_column(ElementKind::Edge, "frame", frame).unwrap();
                let _ = mesh.set_value(column, dice.below(4) as u32, frame);
            }
            3 => {
                if let Some(column) = mesh.find_column(ElementKind::Edge, "frame") {
                    mesh.remove_column(column);
                }
            }
            4 => assert!(mesh.set_default(color, Value::Int(step as i64))),
            _ => {}
        }
        let v = mesh.add_vertex();
        mesh.set_position(v, DVec3::splat(step as f64));
        assert!(mesh.set_value(color, v.0, Value::Int(8)));
        if dice.below(2) == 0 {
            mesh.erase_vertex(v);
        }
        mesh.end_step();
        let mut state = mesh.clone();
        state.take_history();
        states.push(state);
    }
    states
}

#[test]
fn a_history_goes_to_each_of_its_states_and_changes_nothing() {
    let plans = steps();
    let mut dice = Dice(8);
    let (mut without, mut some) = ([0; 2], 0);
    for original in meshes() {
        for round in 0..12 {
            let mut mesh = original.clone();
            mesh.add_column(ElementKind::Vertex, "color", Value::Int(7)).unwrap();
            wander(&mut mesh, &plans, &mut dice);
            mesh.recycle();
            wander(&mut mesh, &plans, &mut dice);
            let start = mesh.clone();
            let (seed, steps) = (dice.0, 1 + dice.below(30));
            let plain = walk(&mut start.clone(), &plans, &mut Dice(seed), steps);
            let most = [usize::MAX, 4_000, 0][round % 3];
            mesh.record_history(most);
            let recorded = walk(&mut mesh, &plans, &mut Dice(seed), steps);
            let mut history = mesh.take_history().unwrap();
            assert!(mesh.take_history().is_none());
            for (recorded, plain) in recorded.iter().zip(&plain) {
                assert_same(recorded, plain);
            }
            let states: Vec<&Mesh> = [&start].into_iter().chain(&plain).collect();
            let [least, end] = history.span();
            assert_eq!(end, steps as u64);
            assert!(least == [0, least, end][round % 3]);
            some += usize::from(least > 0 && least < end);
            for _ in 0..20 {
                let step = dice.below(states.len() + 2) as u64;
                match history.go(step) {
                    Some(mesh) => assert_same(mesh, states[step as usize]),
                    None => {
                        assert!(step < least || step > end);
                        without[usize::from(step < least)] += 1;
                    }
                }
            }
        }
    }
    assert!(without[0] > 50 && without[1] > 100 && some > 10, "{without:?}, {some}");
}

/// The same to whoever reads, and to whoever adds elements.
fn assert_same(one: &Mesh, other: &Mesh) {
    assert!(identical(one, other));
    let [mut one, mut other] = [one, other].map(Mesh::clone);
    for _ in 0..2 {
        for kind in ElementKind::ALL {
            assert_eq!(one.count(kind), other.count(kind));
            assert_eq!(one.erased(kind), other.erased(kind));
        }
        for _ in 0..8 {
            let born = |mesh: &mut Mesh| {
                (mesh.add_vertex(), mesh.add_halfedge(), mesh.add_edge(), mesh.add_face())
            };
            assert_eq!(born(&mut one), born(&mut other));
        }
        assert!(identical(&one, &other));
        one.recycle();
        other.recycle();
    }
}
