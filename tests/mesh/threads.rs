//! Any number of threads has the same results: meshes, files, and what is wrong with them.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::sync::{Mutex, PoisonError};

use hedgerow::mesh::{
    BuildError, FileFormat, Mesh, MeshFile, Polygons, Repair, identical, read_mesh, read_mesh_from,
    set_threads, shape, validate, write_mesh_to,
};

/// What comes of work by one thread and by several, which is the same.
fn alike<T>(work: impl Fn() -> T, same: impl Fn(&T, &T) -> bool) -> T {
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    set_threads(NonZeroUsize::new(1));
    let alone = work();
    for threads in [2, 3, 8] {
        set_threads(NonZeroUsize::new(threads));
        assert!(same(&alone, &work()), "with {threads} threads");
    }
    set_threads(None);
    alone
}

/// Numbers from a seed (splitmix64; S. Vigna, 2015).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) % bound as u64) as usize
    }
}

fn written(file: &MeshFile, format: FileFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, format, file).unwrap();
    bytes
}

/// All that can be seen of a file that was read.
fn read(text: &[u8], format: FileFormat, repair: Option<Repair>) -> Result<Read, String> {
    let file = read_mesh_from("t", format, text, repair).map_err(|error| error.to_string())?;
    let said = format!("{:?} {:?} {:?}", file.losses(), file.repaired, file.damage);
    let numbers = file.mesh.vertices().map(|v| file.vertex_number(v)).collect();
    Ok(Read { again: written(&file, FileFormat::Obj), mesh: file.mesh, said, numbers })
}

struct Read {
    mesh: Mesh,
    again: Vec<u8>,
    said: String,
    numbers: Vec<Option<u32>>,
}

fn same(a: &Result<Read, String>, b: &Result<Read, String>) -> bool {
    match (a, b) {
        (Ok(a), Ok(b)) => {
            identical(&a.mesh, &b.mesh)
                && (&a.again, &a.said, &a.numbers) == (&b.again, &b.said, &b.numbers)
        }
        (Err(a), Err(b)) => a == b,
        _ => false,
    }
}

#[test]
fn a_large_mesh_is_written_and_read() {
    let file = MeshFile::from_mesh(shape::icosphere(6));
    for format in [FileFormat::Obj, FileFormat::Ply, FileFormat::Stl, FileFormat::Off] {
        let bytes = alike(|| written(&file, format), |a, b| a == b);
        let again = alike(|| read(&bytes, format, None), same).unwrap();
        validate(&again.mesh).unwrap();
        assert_eq!(again.mesh.face_count(), file.mesh.face_count());
    }
}

#[test]
fn a_large_mesh_with_a_boundary_is_read() {
    let mut text = String::new();
    let side = 150;
    for i in 0..side * side {
        writeln!(text, "v {} {} {}", i % side, i / side, (i * i) % 17).unwrap();
    }
    for i in (0..side * (side - 1)).filter(|i| i % side != side - 1) {
        let (a, b) = (i + 1, i + side + 1);
        match i % 3 {
            0 => writeln!(text, "f {a} {} {} {b}", a + 1, b + 1).unwrap(),
            _ if i % 7 == 1 => {} // a hole
            _ => writeln!(text, "g {}\nf {a} {} {b}\nf {b} {} {}", i % 11, a + 1, a + 1, b + 1)
                .unwrap(),
        }
    }
    let file = alike(|| read(text.as_bytes(), FileFormat::Obj, None), same).unwrap();
    validate(&file.mesh).unwrap();
    assert!(file.mesh.hole_count() > 100);
}

#[test]
fn faults_amid_a_large_file_are_told_by_their_lines() {
    let file = MeshFile::from_mesh(shape::icosphere(5));
    let text = String::from_utf8(written(&file, FileFormat::Obj)).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let vertices = lines.iter().filter(|line| line.starts_with("v ")).count();
    let broken = [
        (vertices / 2, "v 1 2", "`v` needs three numbers; in a plane the third is 0"),
        (vertices + 9000, "f 1 2 3x", "`3x` is not a corner of a face"),
        (vertices + 9001, "f 1 2 0", "0 is not an index"),
        (vertices + 9002, "f 1 2 99999999", "there is no vertex 99999999"),
        (vertices + 15000, "f -99999 2 3", "there is no vertex -99999"),
        (vertices + 15001, "f 1 2 2", "vertex 2 as a corner twice"),
        (vertices / 3, "v 1 inf 3", "is not a finite number"),
    ];
    for (line, replaced, words) in broken {
        let mut lines = lines.clone();
        lines[line] = replaced;
        let text = lines.join("\n");
        let error = alike(|| read(text.as_bytes(), FileFormat::Obj, None), same).err().unwrap();
        assert!(error.contains(words), "{error}");
        let place = format!("t:{}:", line + 1);
        assert!(error.contains(&place) || error.contains(&format!("line {}", line + 1)), "{error}");
    }
}

#[test]
fn any_lines_in_any_order_are_read_alike() {
    let mut numbers = Numbers(7);
    let mut sound = 0;
    for round in 0..12 {
        // Some files count back, some have faults, some have neither.
        let (counts_back, has_faults) = (round % 4 == 1, round % 3 == 2);
        let mut text = String::new();
        let mut vertices = 0;
        while text.len() < 300_000 {
            match numbers.below(if has_faults { 22 } else { 20 }) {
                0..8 => {
                    for i in 0..3 {
                        let x = numbers.below(1 << 40) as f64 / 4096.0;
                        write!(text, "v {x} {i} {}", numbers.below(100)).unwrap();
                        match numbers.below(12) {
                            0 => text += " 0.25 0.5 1",
                            1 => text += " 0.5",
                            2 => text += " \\\n",
                            _ => {}
                        }
                        text += "\n";
                    }
                    vertices += 3;
                    text += "vt 0.5 0.25\nvn 0 0 1\n";
                    let face = match counts_back {
                        true => "f -3/-1 -2/-1 -1/-1\n".to_owned(),
                        false => {
                            format!("f {} {} \\  \n{}\r\n", vertices - 2, vertices - 1, vertices)
                        }
                    };
                    text += &face;
                }
                8 => writeln!(text, "g part {}", numbers.below(5)).unwrap(),
                9 => writeln!(text, "usemtl m{}", numbers.below(3)).unwrap(),
                10 => writeln!(text, "word{} 1 2", numbers.below(30)).unwrap(),
                11 => text += "# a comment that ends with a backslash \\\n",
                12 => writeln!(text, "mtllib lib{}.mtl", numbers.below(4)).unwrap(),
                13 => text += "vn 1 0 0\n",
                14 => text += "\n\r\n",
                15 => text += "s 1\n",
                20 => text += ["v 1 2\n", "f 1 2\n", "f 0 1 2\n"][numbers.below(3)],
                21 => writeln!(text, "f {} 1 2//7", numbers.below(1_000_000)).unwrap(),
                _ => text += "l 1 2\n",
            }
        }
        for repair in [None, Some(Repair::default())] {
            let file = alike(|| read(text.as_bytes(), FileFormat::Obj, repair), same);
            sound += usize::from(file.is_ok());
            if !has_faults {
                assert_eq!(file.as_ref().map_or(0, |file| file.mesh.vertex_count()), vertices);
            }
            assert_eq!(file.is_ok(), !has_faults || repair.is_some(), "{:?}", file.err());
        }
    }
    assert!(sound > 15);
}

#[test]
fn lines_longer_than_a_block_are_read() {
    let count = 200_000;
    let mut text = format!("# {}\n", "long ".repeat(count));
    (0..count).for_each(|i| writeln!(text, "v {i} {} 0", i % 2).unwrap());
    text += "f";
    (0..count).for_each(|i| write!(text, " {}", i + 1).unwrap());
    let whole = text.clone() + "\n";
    let file = alike(|| read(whole.as_bytes(), FileFormat::Obj, None), same).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.face_count()), (count, 1));
    // A file on the disk is the same, also if its last line has no end.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.obj");
    std::fs::write(&path, &text).unwrap();
    let from_disk = alike(|| read_mesh(&path, None).unwrap(), |a, b| identical(&a.mesh, &b.mesh));
    assert!(identical(&from_disk.mesh, &file.mesh));
    // Nor where each line goes on in the next.
    let continued = whole.replace(" 0\n", " \\\n0\n").replace(" 1 ", " \\\r\n 1 ");
    std::fs::write(&path, &continued).unwrap();
    let from_disk = alike(|| read_mesh(&path, None).unwrap(), |a, b| identical(&a.mesh, &b.mesh));
    assert!(identical(&from_disk.mesh, &file.mesh));
}

#[test]
fn polygons_are_refused_for_the_same_fault() {
    let (positions, polygons) = shape::icosphere(5).to_polygons();
    let mut numbers = Numbers(3);
    let mut kinds = Vec::new();
    for _ in 0..40 {
        let mut all: Vec<Vec<u32>> = polygons.iter().map(<[u32]>::to_vec).collect();
        for _ in 0..=numbers.below(2) {
            let polygon = numbers.below(all.len());
            match numbers.below(5) {
                0 => all[polygon].reverse(),
                1 => all[polygon][0] = numbers.below(positions.len()) as u32,
                2 => all.push(all[polygon].clone()),
                3 => {
                    // What faces of two places share is pinched.
                    let [a, b] = [polygon, numbers.below(all.len())];
                    let (from, to) = (all[a][0], all[b][0]);
                    for corner in all.iter_mut().flatten().filter(|corner| **corner == from) {
                        *corner = to;
                    }
                }
                _ => drop(all.swap_remove(polygon)),
            }
        }
        let all = Polygons::from_iter(all);
        let build = || Mesh::from_polygons(&positions, &all);
        let built = alike(build, |a, b| match (a, b) {
            (Ok(a), Ok(b)) => identical(a, b),
            (a, b) => a.as_ref().err() == b.as_ref().err(),
        });
        match built {
            Ok(mesh) => validate(&mesh).unwrap(),
            Err(error) => kinds.push(std::mem::discriminant::<BuildError>(&error)),
        }
    }
    kinds.sort_by_key(|kind| format!("{kind:?}"));
    kinds.dedup();
    assert!(kinds.len() >= 3, "{} kinds of faults", kinds.len());
}

#[test]
fn the_threads_of_a_caller_each_read_files_in_parts() {
    use rayon::prelude::*;
    let bytes = written(&MeshFile::from_mesh(shape::icosphere(5)), FileFormat::Obj);
    let alone = read(&bytes, FileFormat::Obj, None);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let all: Vec<_> = pool
        .install(|| (0..16).into_par_iter().map(|_| read(&bytes, FileFormat::Obj, None)).collect());
    assert!(all.iter().all(|one| same(&alone, one)));
}
