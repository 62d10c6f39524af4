use hedgerow::mesh::{Attribute, ColumnId, EdgeId, ElementKind, Level, Mesh, VertexId, validate_level_near};

/// Bisects an edge several times, always beside the last new vertex.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn divide(mesh: &mut Mesh, e: EdgeId, n: i64) -> Option<VertexId> {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    if 12 <= n {
        return None; // that is too often
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let mut m = bisect(mesh, e)?;
        for _ in 0..twos(mesh, n) + 1 {
            let weight = attribute::<f64>(mesh, weight_column, m.0) + 1.0;
            set_attribute(mesh, weight_column, m.0, weight);
            let e_2 = mesh.edge(mesh.vertex_halfedge(m));
            m = bisect(mesh, e_2)?;
        }
        let mut i: i64 = 0;
        for _ in 0..n - 1 {
            i = i + 1;
            if i != 2 {
                let weight = attribute::<f64>(mesh, weight_column, m.0) + (i as f64);
                set_attribute(mesh, weight_column, m.0, weight);
            }
        }
        Some(m)
    })
}

/// How often 2 divides a number.
fn twos(_mesh: &Mesh, n: i64) -> i64 {
    let mut rest = n;
    let mut count: i64 = 0;
    while floor_mod(rest, 2) == 0 {
        if rest == 0 {
            break;
        }
        rest = floor_div(rest, 2);
        count = count + 1;
    }
    count
}

/// Cuts an edge in two at its midpoint; returns the new vertex.
///
/// ```text
///      .---P---.               .---P---.
///      |  f0   |               |  f0   |
///      |       |               |       |
///      v0--e--v1     ->        v0--m--v1
///      |       |               |       |
///      |  f1   |               |  f1   |
///      '---Q---'               '---Q---'
/// ```
///
/// The loops at the edge, faces or holes, gain a side. Each of the two halfedges is followed by a
/// new one, and its twin is now the new one on the other side. Never refused.
#[allow(non_snake_case)]
fn bisect(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let a = mesh.edge_halfedge(e);
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let P_first = mesh.next(a);
    let Q_first = mesh.next(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let e1 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, q);
    mesh.set_prev(P_first, p);
    mesh.set_next(d, q);
    mesh.set_twin(d, p);
    mesh.set_edge(d, e1);
    mesh.set_prev(Q_first, q);
    mesh.set_next(p, P_first);
    mesh.set_prev(p, a);
    mesh.set_twin(p, d);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e1);
    mesh.set_face(p, f0);
    mesh.set_next(q, Q_first);
    mesh.set_prev(q, d);
    mesh.set_twin(q, a);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e);
    mesh.set_face(q, f1);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, p);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect("a column of this type")[element as usize]
}

/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.note_value(column, element);
    mesh.values_mut(column).expect("a column of this type")[element as usize] = value;
}

/// `a / b`, rounded down.
fn floor_div(a: i64, b: i64) -> i64 {
    a / b - i64::from(a % b != 0 && (a < 0) != (b < 0))
}

/// The remainder of `a / b`, with the sign of `b`.
fn floor_mod(a: i64, b: i64) -> i64 {
    let rest = a.wrapping_rem(b);
    if rest != 0 && (rest < 0) != (b < 0) { rest + b } else { rest }
}

/// Runs the steps; undoes them if one refuses, or the mesh does not have the level in the end.
fn all_or_nothing<T>(
    mesh: &mut Mesh,
    level: Level,
    steps: impl FnOnce(&mut Mesh) -> Option<T>,
) -> Option<T> {
    let mark = mesh.open_journal();
    let done = steps(mesh)
        .filter(|_| validate_level_near(mesh, level, &mesh.written_since(&mark)).is_ok());
    match done {
        Some(_) => mesh.keep(mark),
        None => mesh.roll_back(mark),
    }
    done
}
