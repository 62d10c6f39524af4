//! Meshes as bytes: what comes back is the same to the last slot, and nothing else comes back.

use hedgerow::mesh::{
    BinaryError, EdgeId, ElementKind, Mesh, Value, identical, read_bytes, shape, validate,
    write_bytes,
};
use hedgerow::{Program, Session};
use support::dice::Dice;

/// Where what the checksum covers begins.
const START: usize = 20;

/// How far apart the bytes are that are changed one by one.
const STEP: usize = 23;

/// A mesh with erased slots, free slots and attributes.
fn worn() -> (Program, Mesh) {
    let program = Program::load("std/triangle.hedge").unwrap();
    let [split, collapse] = ["split", "collapse"].map(|name| program.op(name).unwrap());
    let mut mesh = shape::triangle_grid(4, 4);
    for kind in ElementKind::ALL {
        let m = hedgerow::mesh::glam::DMat3::from_diagonal([1.0, 2.0, 3.0].into());
        for (name, value) in [
            ("b", Value::Bool(true)),
            ("i", Value::Int(-7)),
            ("r", Value::Real(0.5)),
            ("v", Value::Vec3([1.0, 2.0, f64::NAN].into())),
            ("m", Value::Mat3(m)),
        ] {
            let column = mesh.add_column(kind, name, value).unwrap();
            if let Some(values) = mesh.values_mut::<f64>(column) {
                values.iter_mut().enumerate().for_each(|(at, value)| *value = at as f64);
            }
        }
    }
    let mut session = Session::new(&program, mesh);
    let mut applied = 0;
    for (at, op) in [(3, &split), (9, &collapse), (12, &split), (20, &collapse), (25, &collapse)] {
        applied += usize::from(session.apply(op, EdgeId(at)).unwrap().is_applied());
        if at == 20 {
            session.recycle();
            applied += usize::from(session.apply(&split, EdgeId(30)).unwrap().is_applied());
        }
    }
    assert_eq!(applied, 6);
    (program, session.into_mesh())
}

fn checksum(bytes: &[u8]) -> [u8; 8] {
    let mut padded = bytes.to_vec();
    padded.resize(bytes.len() / 4 * 4 + 4, 0);
    let (mut sum, mut sums) = (bytes.len() as u64, 0_u64);
    for word in padded.chunks_exact(4) {
        sum = sum.wrapping_add(u64::from(u32::from_le_bytes(word.try_into().unwrap())));
        sums = sums.wrapping_add(sum);
    }
    (sum ^ sums.rotate_left(32)).to_le_bytes()
}

#[test]
fn a_mesh_comes_back_with_all_its_slots() {
    let (program, worn) = worn();
    let split = program.op("split").unwrap();
    for mesh in [Mesh::default(), shape::cube(), shape::grid(3, 2), worn] {
        let bytes = write_bytes(&mesh);
        let back = read_bytes(&bytes).unwrap();
        assert!(identical(&mesh, &back));
        assert_eq!(write_bytes(&back), bytes);
        // What is done next gives the same ids.
        let mut both = [mesh, back].map(|mesh| Session::new(&program, mesh));
        let mut made = both.each_mut().map(|session| {
            session.recycle();
            let edges: Vec<_> = session.mesh().edges().collect();
            let split = |edge| session.apply(&split, edge).map(|outcome| outcome.result());
            edges.into_iter().map(split).collect::<Vec<_>>()
        });
        let [ours, theirs] = made.each_mut().map(std::mem::take);
        assert_eq!(format!("{ours:?}"), format!("{theirs:?}"));
        assert!(identical(both[0].mesh(), both[1].mesh()));
    }
}

#[test]
fn other_bytes_are_refused() {
    let bytes = write_bytes(&worn().1);
    for end in (0..100).chain((100..bytes.len()).step_by(STEP)) {
        assert!(read_bytes(&bytes[..end]).is_err(), "cut off at {end}");
    }
    assert_eq!(read_bytes(b"solid cube").unwrap_err(), BinaryError::NotAMesh);
    let mut later = bytes.clone();
    later[8] = 2;
    assert_eq!(read_bytes(&later).unwrap_err(), BinaryError::Version(2));
    let mut longer = bytes.clone();
    longer.push(0);
    assert_eq!(read_bytes(&longer).unwrap_err(), BinaryError::Damaged);
    for at in (START..bytes.len()).step_by(STEP) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 4;
        assert_eq!(read_bytes(&damaged).unwrap_err(), BinaryError::Damaged, "{at}");
    }
}

/// Bytes that were changed on purpose, with the right checksum, are a valid mesh or an error.
#[test]
fn hostile_bytes_do_no_harm() {
    let bytes = write_bytes(&worn().1);
    let mut dice = Dice(17);
    let mut refused = std::collections::BTreeSet::new();
    let mut accepted = 0;
    let first = dice.below(STEP);
    let one_each = (START + first..bytes.len()).step_by(STEP).map(|at| vec![at]);
    let several = (0..400).map(|_| Vec::new());
    for places in one_each.chain(several) {
        let mut hostile = bytes.clone();
        let some = [0, 1, 2, 5, 0x7f, 0x80, 0xfe, 0xff];
        if places.is_empty() {
            for _ in 0..=dice.below(6) {
                let at = START + dice.below(hostile.len() - START);
                match dice.below(8) {
                    0 => drop(hostile.remove(at)),
                    1 => hostile.insert(at, some[dice.below(some.len())]),
                    _ => hostile[at] = some[dice.below(some.len())],
                }
            }
        }
        places.iter().for_each(|&at| hostile[at] = some[dice.below(some.len())]);
        let sum = checksum(&hostile[START..]);
        hostile[START - 8..START].copy_from_slice(&sum);
        match read_bytes(&hostile) {
            Ok(mesh) => {
                accepted += 1;
                validate(&mesh).unwrap();
            }
            Err(error) => drop(refused.insert(error.to_string())),
        }
    }
    // Coordinates and values may be any; all the rest is looked at.
    assert!(accepted > 50 && refused.len() > 20, "{accepted} {}", refused.len());
}
