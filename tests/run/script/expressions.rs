//! What expressions are worth.

use super::*;
use glam::DVec3;
use hedgerow::mesh::{Polygons, shape};

/// Each line of a script that prints an expression, and what it should print.
fn check(mesh: &mut Mesh, cases: &[(&str, &str)]) {
    let body: String = cases.iter().map(|(expr, _)| format!("print {expr}\n")).collect();
    let expected: Vec<_> = cases.iter().map(|&(_, text)| text).collect();
    assert_eq!(printed(mesh, &body), expected);
}

#[test]
fn numbers() {
    check(
        &mut shape::cube(),
        &[
            ("1 + 2 * 3 - 4", "3"),
            ("-7 div 2", "-4"),
            ("-7 mod 2", "1"),
            ("7 / 2", "3.5"),
            ("1 / 3", "0.333333"),
            ("abs(-3), abs(-2.5)", "3 2.5"),
            ("min(1, 2), max(1, 2), min(1.5, 2.0), max(1.5, 2.0)", "1 2 1.5 2"),
            ("clamp(7, 0, 5), clamp(-7, 0, 5), clamp(3, 0, 5)", "5 0 3"),
            ("clamp(2.5, 0, 1), clamp(-0.5, 0, 1), clamp(0.5, 0, 1)", "1 0 0.5"),
            ("min(vec3(1, 5, 3), vec3(4, 2, 3)), max(vec2(1, 5), vec2(4, 2))", "(1, 2, 3) (4, 5)"),
            (
                "max(vec4(0, 1, 2, 3), vec4(1.5)) - min(vec4(2), vec4(0, 9, 0, 9))",
                "(1.5, -0.5, 2, 1)",
            ),
            (
                "min(v.position for v in vertices), max(v.position for v in vertices)",
                "(-1, -1, -1) (1, 1, 1)",
            ),
            (
                "max(vec2(v.position) + vec2(1, 2) for v in vertices where v.position.y < 0)",
                "(2, 1)",
            ),
            ("min(vec4(v.position, 3) for v in vertices where v.position.x > 0)", "(1, -1, -1, 3)"),
            ("min(vec3(sqrt(-1), 1, 2), vec3(3, sqrt(-1), 1))", "(3, 1, 1)"),
            ("sqrt(16.0), pow(2.0, 10.0), floor(1.5), ceil(1.5)", "4 1024 1 2"),
            ("round(2.5), round(3.5)", "2 4"),
            ("sin(0.0), cos(0.0), tan(0.0), asin(0.0), acos(1.0)", "0 1 0 0 0"),
            ("exp(0.0), log(1.0), atan2(0.0, 1.0)", "1 0 0"),
            ("mix(1.0, 3.0, 0.25)", "1.5"),
            ("-(1.5)", "-1.5"),
            ("1 < 2, 2 <= 1, 1 == 1, 1 != 1", "true false true false"),
            ("1.5 < 2.0, 2.0 >= 1.0, 1.5 == 1.5", "true true true"),
            ("if 1 < 2 { 10 } else { 20 }", "10"),
            (
                "\"{9007199254740993:full} {9007199254740993:.0}\"",
                "9007199254740993 9007199254740993",
            ),
            ("\"{-3:.2} {3.0:.2}\"", "-3.00 3.00"),
            // Equal as reals.
            (
                "argmin(9007199254740993 - (if v.position.x > 0 { 1 } else { 0 }) for v in vertices).position.x",
                "1",
            ),
            (
                "argmax(9007199254740992 + (if v.position.x > 0 { 1 } else { 0 }) for v in vertices).position.x",
                "1",
            ),
        ],
    );
}

/// The root of `x` is a number at four corners of the eight.
#[test]
fn what_is_not_a_number_is_neither_least_nor_greatest() {
    let root = "sqrt(v.position.x) for v in vertices";
    let all = "sqrt(-1) for v in vertices";
    let cases = [
        ("min(sqrt(-1), 1.0), max(1.0, sqrt(-1))", "1 1"),
        (&*format!("is_nan(min({root})), is_nan(max({root}))"), "false false"),
        (&*format!("is_nan(sqrt(argmin({root}).position.x))"), "false"),
        (&*format!("is_nan(sqrt(argmax({root}).position.x))"), "false"),
        (&*format!("is_nan(min({all})), argmin({all})"), "true vertex 0"),
        ("count(is_nan(sqrt(v.position.x)) for v in vertices)", "4"),
    ];
    check(&mut shape::cube(), &cases);
}

#[test]
fn truth() {
    check(
        &mut shape::cube(),
        &[
            ("true and false, true or false, not true", "false true false"),
            // The right side would trap.
            ("false and 1 div 0 == 1, true or 1 div 0 == 1", "false true"),
            ("true == false", "false"),
            ("\"a\", \"b c\"", "a b c"),
        ],
    );
}

#[test]
fn vectors() {
    check(
        &mut shape::cube(),
        &[
            ("vec3(1, 2, 3) + vec3(1, 1, 1)", "(2, 3, 4)"),
            ("vec3(1, 2, 3) - vec3(1, 1, 1)", "(0, 1, 2)"),
            ("2 * vec3(1, 2, 3), vec3(1, 2, 3) / 2", "(2, 4, 6) (0.5, 1, 1.5)"),
            ("-vec3(1, 2, 3)", "(-1, -2, -3)"),
            ("dot(vec3(1, 2, 3), vec3(1, 1, 1))", "6"),
            ("cross(vec3(1, 0, 0), vec3(0, 1, 0))", "(0, 0, 1)"),
            ("length(vec3(3, 4, 0)), normalize(vec3(0, 0, 9))", "5 (0, 0, 1)"),
            ("distance(vec3(0, 0, 0), vec3(0, 3, 4))", "5"),
            ("angle(vec3(1, 0, 0), vec3(2, 0, 0))", "0"),
            ("angle(vec3(0, 0, 0), vec3(-1, -1, -1))", "0"),
            ("normalize(vec3(1e-320, 0, 0)), normalize(vec3(0))", "(1, 0, 0) (0, 0, 0)"),
            (
                "normalize(vec3(0 / 0, 1, 0)), normalize(vec2(1, infinity))",
                "(NaN, NaN, NaN) (NaN, NaN)",
            ),
            ("mix(vec3(0, 0, 0), vec3(2, 4, 6), 0.5)", "(1, 2, 3)"),
            ("vec3(1, 2, 3).y", "2"),
            ("vec3(1, 2, 3) == vec3(1, 2, 3)", "true"),
        ],
    );
}

#[test]
fn questions_and_navigation() {
    let body = "for e in edges where boundary(e) {
           let h = if boundary(e.halfedge) { e.halfedge.twin } else { e.halfedge }
           print boundary(h), boundary(h.twin), boundary(h.vertex), boundary(h.face)
           print h.next.prev == h, h.twin.twin == h, h.target == h.twin.vertex
           print h.edge == e, h.edge.halfedge.edge == e, h.face.halfedge.face == h.face
           print h.vertex.halfedge.vertex == h.vertex, adjacent(h.vertex, h.target)
           print degree(h.face), degree(h.twin.face), link_condition(e)
           print length(e) == length(h), distance(h.vertex, h.target) == length(e)
           print midpoint(e) == (h.vertex.position + h.target.position) / 2
           print abs(area(h.face) - 2) < 0.001, normal(h.face), length(centroid(h.face)) < 0.001
           print length(normal(h.vertex))
           return
         }";
    let lines = printed(&mut shape::single_polygon(4), body);
    assert_eq!(
        lines,
        [
            "false true true false",
            "true true true",
            "true true true",
            "true true",
            "4 4 true",
            "true true",
            "true",
            "true (0, 0, 1) true",
            "1",
        ]
    );
}

#[test]
fn aggregates_over_the_mesh() {
    check(
        &mut shape::cube(),
        &[
            ("count(vertices), count(halfedges), count(edges)", "8 24 12"),
            ("count(faces), count(holes)", "6 0"),
            ("sum(1 for e in edges), sum(0.5 for e in edges)", "12 6"),
            ("sum(v.position for v in vertices)", "(0, 0, 0)"),
            ("mean(length(e) for e in edges)", "2"),
            ("mean(degree(v) for v in vertices)", "3"),
            ("mean(v.position for v in vertices)", "(0, 0, 0)"),
            ("min(v.position.x for v in vertices)", "-1"),
            ("max(v.position.x for v in vertices)", "1"),
            ("max(degree(v) for v in vertices)", "3"),
            ("min(degree(f) for f in faces)", "4"),
            ("any(v.position.x > 0 for v in vertices)", "true"),
            ("all(v.position.x > 0 for v in vertices)", "false"),
            ("all(v.position.x > 0 for v in vertices where v.position.x > 0)", "true"),
            ("count(true for v in vertices where v.position.x > 0)", "4"),
            ("sum(count(v.neighbors) for v in vertices)", "24"),
            ("sum(1 for h in holes), any(true for h in holes)", "0 false"),
        ],
    );
    check(
        &mut shape::grid(2, 2),
        &[("count(faces), count(holes)", "4 1"), ("sum(degree(h) for h in holes)", "8")],
    );
}

#[test]
fn aggregates_around_an_element() {
    check(
        &mut shape::grid(2, 2),
        &[
            ("sum(count(v.halfedges) for v in vertices)", "24"),
            ("sum(count(v.edges) for v in vertices)", "24"),
            ("sum(count(v.faces) for v in vertices)", "16"),
            ("sum(count(v.neighbors) for v in vertices)", "24"),
            ("sum(count(f.halfedges) for f in faces)", "16"),
            ("sum(count(f.vertices) for f in faces)", "16"),
            ("sum(count(f.edges) for f in faces)", "16"),
            ("sum(count(e.vertices) for e in edges)", "24"),
            ("sum(count(e.faces) for e in edges)", "16"),
            ("all(all(adjacent(v, w) for w in v.neighbors) for v in vertices)", "true"),
        ],
    );
}

#[test]
fn long_sums_and_deep_blocks_run() {
    let sum = vec!["1"; 200].join(" + ");
    let (open, close) = ("repeat 1 { if true { ".repeat(40), "} }".repeat(40));
    let body = format!("print {sum}\n{open} for e in edges {{ flip(e) }} {close}\nprint 2");
    assert_eq!(printed(&mut shape::cube(), &body), ["200", "2"]);
}

#[test]
fn angles() {
    let body = "
      let turn = atan2(0.0, -1.0)
      assert all(abs(dihedral_angle(e) - turn / 2) < 1e-12 for e in edges)
      assert all(abs(angle(h) - turn / 2) < 1e-12 for h in halfedges)
      print dihedral_angle(edges_of_cube()), count(edges)";
    let body = body.replace("edges_of_cube()", "argmin(length(e) for e in edges)");
    let printed_here = printed(&mut shape::cube(), &body);
    assert_eq!(printed_here, ["1.5708 12"]);
    // Of faces that are not flat, it is the angle between their normals.
    let body = "
      for v in vertices { v.position = v.position + vec3(0, 0, sin(3 * v.position.x + 5 * v.position.y)) }
      for e in edges where not boundary(e) {
        let between = angle(normal(e.halfedge.face), normal(e.halfedge.twin.face))
        assert abs(abs(dihedral_angle(e)) - between) < 1e-12
      }
      print count(abs(dihedral_angle(e)) > 0.1 for e in edges) > 10";
    assert_eq!(printed(&mut shape::grid(4, 4), body), ["true"]);
    // A face without an area has no normal, and the surface does not turn at it, wherever the other
    // face looks.
    let body = "
      let e = argmax(if boundary(e) { 0 } else { 1 } for e in edges)
      print dihedral_angle(e)
      for v in vertices { v.position = -v.position }
      for e in edges { assert dihedral_angle(e) == 0 }";
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, -1.0], [0.0, 1.0, -1.0], [0.5, 0.0, -0.5]];
    for turned in [[[2, 1, 0], [0, 1, 3]], [[0, 1, 2], [1, 0, 3]]] {
        let triangles = Polygons::from_triangles(&turned);
        let mut mesh = Mesh::from_polygons(&corners.map(DVec3::from), &triangles).unwrap();
        assert_eq!(printed(&mut mesh, body), ["0"]);
    }
    // Gauss and Bonnet: the angle defects add up; and triangles by their cotangents.
    let body = "
      let turn = atan2(0.0, -1.0)
      let defect = sum(2 * turn - sum(angle(h) for h in v.halfedges) for v in vertices)
      assert abs(defect - 4 * turn) < 1e-9
      let squares = sum(cotangent(h) * length(h) * length(h) for h in halfedges)
      assert abs(squares / 4 - sum(area(f) for f in faces)) < 1e-9
      print \"done\"";
    assert_eq!(printed(&mut shape::icosphere(2), body), ["done"]);
    // Whatever the size.
    for size in ["1e100", "1e-90", "1e-200", "1e300", "1e-310"] {
        let body = format!(
            "
      for v in vertices {{ v.position = v.position * {size} }}
      let third = atan2(sqrt(3.0), 1.0)
      assert all(abs(angle(h) - third) < 1e-9 for h in halfedges)
      assert all(abs(cotangent(h) - 1 / sqrt(3.0)) < 1e-9 for h in halfedges)
      print abs(angle(vec3({size}, 0, 0), vec3(0, 1, 0)) - 1.5 * third) < 1e-12"
        );
        assert_eq!(printed(&mut shape::tetrahedron(), &body), ["true"], "{size}");
    }
    // What stands out turns the surface by a positive angle, and nothing turns the boundary.
    let body = "
      let v = argmin(length(v.position - vec3(1, 1, 0)) for v in vertices)
      v.position = vec3(1, 1, 0.5)
      assert all(dihedral_angle(e) >= 0 for e in v.edges) and any(dihedral_angle(e) > 0.1 for e in v.edges)
      v.position = vec3(1, 1, -0.5)
      assert all(dihedral_angle(e) <= 0 for e in v.edges) and any(dihedral_angle(e) < -0.1 for e in v.edges)
      print count(dihedral_angle(e) == 0 for e in edges where boundary(e)) == count(boundary(e) for e in edges)";
    assert_eq!(printed(&mut shape::triangle_grid(2, 2), body), ["true"]);
    // The Laplacian of the plane: a coordinate is harmonic inside, and holes weigh nothing.
    let body = "
      assert all(cotangent(h) == 0 for h in halfedges where hole(h.face))
      let squares = sum(cotangent(h) * length(h) * length(h) for h in halfedges)
      assert abs(squares / 4 - sum(area(f) for f in faces)) < 1e-9
      assert all(abs(sum((cotangent(h) + cotangent(h.twin)) * (h.target.position.x - v.position.x)
          for h in v.halfedges)) < 1e-9 for v in vertices where not boundary(v))
      print \"done\"";
    assert_eq!(printed(&mut shape::triangle_grid(3, 4), body), ["done"]);
}

#[test]
fn elements_with_extreme_values() {
    let body = "
      print argmax(v.position.x for v in vertices where not boundary(v))
      let e = argmin(e.vertices_sum for e in edges)
      print e"
        .replace("e.vertices_sum", "e.halfedge.vertex.position.x");
    assert_eq!(printed(&mut shape::grid(3, 3), &body), ["vertex 6", "edge 0"]);
    let failed = "print argmin(area(f) for f in holes)";
    assert!(printed(&mut shape::grid(1, 1), failed).len() == 1);
}
