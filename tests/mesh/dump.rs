//! Tables of halfedges as text: the round trip is exact, and what is wrong is told.

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use hedgerow::mesh::{
    Dump, ElementKind, HalfedgeId, Mesh, Value, VertexId, identical, read_dump, shape, validate,
    write_dump,
};

fn round_trip(mesh: &Mesh) -> Mesh {
    let dump = Dump { meshes: vec![("m".into(), mesh.clone())], ..Dump::default() };
    let text = write_dump(&dump);
    let mut read = read_dump(&text).unwrap();
    assert_eq!(write_dump(&read), text);
    read.meshes.remove(0).1
}

#[test]
fn a_broken_mesh_makes_the_round_trip() {
    let before = shape::cube();
    let mut after = before.clone();
    after.erase_halfedge(HalfedgeId(4));
    after.set_twin(HalfedgeId(0), HalfedgeId::NONE);
    let dump = Dump {
        remarks: vec!["a cube".into()],
        meshes: vec![("before".into(), before), ("after".into(), after)],
        names: vec![
            ("v".into(), vec![VertexId(3).into()]),
            ("P".into(), vec![HalfedgeId(1).into(), HalfedgeId(2).into()]),
            ("Q".into(), Vec::new()),
        ],
    };
    let text = write_dump(&dump);
    let read = read_dump(&text).unwrap();
    assert_eq!(write_dump(&read), text);
    assert_eq!(read.names, dump.names);
    for ((name, mesh), (other, original)) in read.meshes.iter().zip(&dump.meshes) {
        assert_eq!(name, other);
        assert!(identical(mesh, original));
        assert_eq!(validate(mesh), validate(original));
    }
}

#[test]
fn malformed_lines_are_refused_in_words() {
    let cases = [
        ("vertex 0 halfedge 0 at 0 0 0", "line 1: no `mesh` line comes before it"),
        ("mesh m\nvertx 0", "line 2: `vertx` begins no line of a dump"),
        ("mesh m\n\nedge 0", "line 3: expected `edge ID halfedge ID`"),
        ("mesh m\nedge -1 halfedge 0", "line 2: `-1` is not an id below 1048576"),
        ("mesh m\nedge 4294967295 halfedge 0", "line 2: `4294967295` is not an id below 1048576"),
        ("mesh m\nvertex 0 halfedge - at 0 y 0", "line 2: `y` is not a number"),
        ("mesh m\nface 0 halfedge 0\nhole 0 halfedge 0", "line 3: face 0 has a line already"),
        ("name v", "line 1: expected `name WORD KIND ID…`"),
        ("mesh m\nvalue 0 1", "line 2: no `attribute` line comes before it"),
        (
            "mesh m\nattribute corner x real 0",
            "line 2: expected `attribute KIND WORD TYPE DEFAULT`",
        ),
        ("mesh m\nattribute edge x vec2 0", "line 2: expected a value of type vec2"),
        (
            "mesh m\nattribute edge x real 0\nattribute edge x int 0",
            "line 3: the attribute `x` has a line already",
        ),
        (
            "mesh m\nattribute edge x real 0\nvalue 3 1",
            "line 3: edge 3 has no line above this value",
        ),
    ];
    for (text, told) in cases {
        assert_eq!(read_dump(text).unwrap_err().to_string(), told);
    }
}

#[test]
fn attributes_of_all_kinds_and_types_make_the_round_trip() {
    let reals = |count: usize| -> Vec<f64> {
        let odd = [0.1, -0.0, 1e300, f64::MIN_POSITIVE, f64::INFINITY];
        (0..count).map(|i| odd[i % 5] / (1 + i / 5) as f64).collect()
    };
    let samples = [
        (Value::Bool(true), Value::Bool(false)),
        (Value::Int(i64::MIN), Value::Int(7)),
        (Value::Real(1.0 / 3.0), Value::Real(f64::NEG_INFINITY)),
        (Value::Vec2(DVec2::new(0.1, -0.0)), Value::Vec2(DVec2::ZERO)),
        (Value::Vec3(DVec3::splat(1e-320)), Value::Vec3(DVec3::ONE)),
        (Value::Vec4(DVec4::splat(2.5)), Value::Vec4(DVec4::ZERO)),
        (Value::Mat3(DMat3::from_cols_slice(&reals(9))), Value::Mat3(DMat3::IDENTITY)),
        (Value::Mat4(DMat4::from_cols_slice(&reals(16))), Value::Mat4(DMat4::ZERO)),
    ];
    let mut mesh = shape::grid(3, 2);
    let mut written = 0;
    for kind in ElementKind::ALL {
        for (value, default) in samples {
            let name = format!("{}'", value.attribute_type());
            let column = mesh.add_column(kind, &name, default).unwrap();
            for index in (0..mesh.capacity(kind) as u32).step_by(2) {
                written += usize::from(mesh.set_value(column, index, value));
            }
        }
        let scratch = Value::Real(1.0);
        mesh.add_column(kind, "private 0 x", scratch).unwrap();
    }
    assert!(written > 100);
    let read = round_trip(&mesh);
    for kind in ElementKind::ALL {
        let scratch = mesh.find_column(kind, "private 0 x").unwrap();
        assert_eq!(read.find_column(kind, "private 0 x"), None);
        mesh.remove_column(scratch);
    }
    assert!(identical(&read, &mesh));
}

#[test]
fn erased_slots_stay_free_and_keep_the_numbers_of_others() {
    let mut mesh = shape::cube();
    let column = mesh.add_column(ElementKind::Vertex, "weight", Value::Real(2.0)).unwrap();
    let extra = [(); 3].map(|()| mesh.add_vertex());
    assert!(mesh.set_value(column, extra[0].0, Value::Real(5.0)));
    assert!(mesh.set_value(column, extra[2].0, Value::Real(7.0)));
    mesh.erase_vertex(extra[0]);
    let mut read = round_trip(&mesh);
    assert!(identical(&read, &mesh));
    let weight = read.find_column(ElementKind::Vertex, "weight").unwrap();
    assert_eq!(read.value(weight, extra[2].0), Some(Value::Real(7.0)));
    // The slot that was free is given out again, with the default.
    let born = read.add_vertex();
    assert_eq!(born, extra[0]);
    assert_eq!(read.value(weight, born.0), Some(Value::Real(2.0)));
}
