//! What emitted code needs besides the mesh, written out where it is used.

/// Functions that are written out where they are used.
pub(super) const FUNCTIONS: &[(&str, &str)] = &[
    (
        "in_order_along_loop",
        "\
/// Whether `b` comes before `c` on the way along the loop from `a`.
fn in_order_along_loop(mesh: &Mesh, a: HalfedgeId, b: HalfedgeId, c: HalfedgeId) -> bool {
    let mut on_the_way = mesh.loop_from(a).enumerate();
    let found = on_the_way.find(|&(at, h)| h == b || (at > 0 && h == c));
    found.is_some_and(|(_, h)| h == b)
}
",
    ),
    (
        "in_order_around_vertex",
        "\
/// Whether `b` comes before `c` on the way around the vertex from `a`, counterclockwise.
fn in_order_around_vertex(mesh: &Mesh, a: HalfedgeId, b: HalfedgeId, c: HalfedgeId) -> bool {
    let mut on_the_way = mesh.spokes_from(a).enumerate();
    let found = on_the_way.find(|&(at, h)| h == b || (at > 0 && h == c));
    found.is_some_and(|(_, h)| h == b)
}
",
    ),
    (
        "all_in_order_along_loop",
        "\
/// Whether a walk along the loop from the first, once around, meets all others in their order.
fn all_in_order_along_loop(mesh: &Mesh, all: &[HalfedgeId]) -> bool {
    let mut open = all.iter().peekable();
    for h in all.first().into_iter().flat_map(|&first| mesh.loop_from(first)) {
        open.next_if_eq(&&h);
    }
    open.next().is_none()
}
",
    ),
    (
        "all_in_order_around_vertex",
        "\
/// Whether a walk around the vertex from the first, once and counterclockwise, meets all others
/// in their order.
fn all_in_order_around_vertex(mesh: &Mesh, all: &[HalfedgeId]) -> bool {
    let mut open = all.iter().peekable();
    for h in all.first().into_iter().flat_map(|&first| mesh.spokes_from(first)) {
        open.next_if_eq(&&h);
    }
    open.next().is_none()
}
",
    ),
    (
        "attribute",
        "\
/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect(\"a column of this type\")[element as usize]
}
",
    ),
    (
        "set_attribute",
        "\
/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.note_value(column, element);
    mesh.values_mut(column).expect(\"a column of this type\")[element as usize] = value;
}
",
    ),
    (
        "turned",
        "\
/// All, turned so that the first stands at the place, counted around.
fn turned(mut all: Vec<HalfedgeId>, place: i64) -> Vec<HalfedgeId> {
    if !all.is_empty() {
        let by = place.rem_euclid(all.len() as i64);
        all.rotate_right(by as usize);
    }
    all
}
",
    ),
    (
        "all_differ",
        "\
/// Whether nothing stands twice in `all`.
fn all_differ<T: PartialEq>(all: &[T]) -> bool {
    (1..all.len()).all(|at| !all[..at].contains(&all[at]))
}
",
    ),
    (
        "same_elements",
        "\
/// Whether `a` and `b`, neither with repetitions, hold the same.
fn same_elements<T: PartialEq>(a: &[T], b: &[T]) -> bool {
    a.len() == b.len() && a.iter().all(|x| b.contains(x))
}
",
    ),
    (
        "all_or_nothing",
        "\
/// Does the steps; if one refuses, or the mesh is not of the level in the end, undoes them.
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
",
    ),
    (
        "finite",
        "\
/// A position, if it is finite.
fn finite(position: DVec3) -> Option<DVec3> {
    position.is_finite().then_some(position)
}
",
    ),
];
