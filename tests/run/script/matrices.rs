//! Vectors and matrices against glam.

use super::*;
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use hedgerow::mesh::{ElementKind, Value, shape};
use hedgerow::rewrite::vectors::eliminate;
use support::dice::Dice;

/// The value of an expression of a type.
fn value(ty: &str, expression: &str) -> Value {
    let mut mesh = shape::cube();
    let script = format!(
        "attr a: vertex {ty}
         script main() {{ for v in vertices {{ let x = {expression}  v.a = x }} }}"
    );
    run_alone(&mut mesh, &script, &[]).unwrap();
    let column = mesh.find_column(ElementKind::Vertex, "a").unwrap();
    mesh.value(column, 7).unwrap()
}

const A: &str =
    "mat4(vec4(2, -1, 0.5, 3), vec4(1, 4, -2, 0.25), vec4(0, 1.5, 5, -1), vec4(3, 0, 1, 7))";
const B: &str = "mat3(vec3(0, 1, 2), vec3(1, 0, 3), vec3(4, -3, 8))";

fn a() -> DMat4 {
    DMat4::from_cols_array(&[
        2.0, -1.0, 0.5, 3.0, 1.0, 4.0, -2.0, 0.25, 0.0, 1.5, 5.0, -1.0, 3.0, 0.0, 1.0, 7.0,
    ])
}

fn b() -> DMat3 {
    DMat3::from_cols_array(&[0.0, 1.0, 2.0, 1.0, 0.0, 3.0, 4.0, -3.0, 8.0])
}

#[test]
fn operators_and_functions_are_those_of_glam() {
    let (a, b) = (a(), b());
    let (x, y) = (DVec4::new(1.0, 2.0, -3.0, 0.5), DVec3::new(3.0, -2.0, 1.0));
    let (x_, y_) = ("vec4(1, 2, -3, 0.5)", "vec3(3, -2, 1)");
    let outer = DMat4::from_cols(x * x.x, x * x.y, x * x.z, x * x.w);
    let cases: Vec<(&str, String, Value)> = vec![
        ("mat4", format!("{A} * {A}"), Value::Mat4(a * a)),
        ("mat4", format!("{A} + 2 * {A} - {A} / 4"), Value::Mat4(a + a * 2.0 - a * 0.25)),
        ("mat4", format!("-transpose({A})"), Value::Mat4(-a.transpose())),
        ("mat4", "mat4(1)".into(), Value::Mat4(DMat4::IDENTITY)),
        ("mat4", format!("outer({x_}, {x_})"), Value::Mat4(outer)),
        ("mat4", format!("if determinant({A}) > 0 {{ {A} }} else {{ mat4(0) }}"), Value::Mat4(a)),
        ("mat3", format!("{B} * {B}"), Value::Mat3(b * b)),
        ("mat3", format!("mat3({A})"), Value::Mat3(DMat3::from_mat4(a))),
        ("mat3", "mat3(3)".into(), Value::Mat3(DMat3::from_diagonal(DVec3::splat(3.0)))),
        ("vec4", format!("{A} * {x_}"), Value::Vec4(a * x)),
        ("vec4", format!("({A}).y"), Value::Vec4(a.y_axis)),
        ("vec4", format!("vec4({y_}, 1) * 3"), Value::Vec4(DVec4::from((y, 1.0)) * 3.0)),
        ("vec4", format!("mix({x_}, {x_} * 2, 0.5)"), Value::Vec4(x * 1.5)),
        ("vec4", format!("normalize({x_} * 0)"), Value::Vec4(DVec4::ZERO)),
        ("vec3", format!("{B} * {y_}"), Value::Vec3(b * y)),
        ("vec3", format!("vec3({x_})"), Value::Vec3(x.truncate())),
        ("vec3", "vec3(vec2(1, 2), 3)".into(), Value::Vec3(DVec3::new(1.0, 2.0, 3.0))),
        ("vec2", format!("vec2({y_}) - vec2(1, 1)"), Value::Vec2(DVec2::new(2.0, -3.0))),
        ("vec2", "vec2(1, 2) * vec2(3, 4)".into(), Value::Vec2(DVec2::new(3.0, 8.0))),
        ("real", format!("determinant({B})"), Value::Real(b.determinant())),
        ("real", format!("dot({x_}, {x_})"), Value::Real(x.dot(x))),
        ("real", "cross(vec2(1, 2), vec2(3, 4))".into(), Value::Real(-2.0)),
        ("real", "length(vec2(3, 4))".into(), Value::Real(5.0)),
        ("real", "distance(vec2(1, 1), vec2(4, 5))".into(), Value::Real(5.0)),
        ("bool", format!("{A} == {A} and {B} != mat3(1)"), Value::Bool(true)),
        ("bool", "is_finite(vec3(0, 1, 2)) and not is_finite(1 / 0)".into(), Value::Bool(true)),
        ("bool", "is_nan(vec2(0, 0 / 0)) and not is_nan(mat4(1))".into(), Value::Bool(true)),
    ];
    for (ty, expression, expected) in &cases {
        assert_eq!(value(ty, expression), *expected, "{expression}");
    }
}

#[test]
fn inverse_and_solve_undo_products() {
    let near = |ty: &str, expression: String, expected: Value| {
        let found = value(ty, &expression);
        let pairs = found.reals().iter().zip(expected.reals());
        assert!(pairs.clone().count() > 0);
        assert!(pairs.clone().all(|(x, y)| (x - y).abs() < 1e-12), "{expression}: {found:?}");
    };
    let x = DVec3::new(3.0, -2.0, 1.0);
    near("mat4", format!("inverse({A}) * {A}"), Value::Mat4(DMat4::IDENTITY));
    near("mat4", format!("inverse({A})"), Value::Mat4(a().inverse()));
    near("mat3", format!("{B} * inverse({B})"), Value::Mat3(DMat3::IDENTITY));
    near("vec3", format!("solve({B}, {B} * vec3(3, -2, 1))"), Value::Vec3(x));
    near("vec4", format!("solve({A}, ({A}).z)"), Value::Vec4(DVec4::Z));
}

#[test]
fn a_singular_matrix_gives_no_numbers() {
    let singular = "mat3(vec3(1, 2, 3), vec3(2, 4, 6), vec3(0, 0, 1))";
    for question in [
        format!("is_nan(solve({singular}, vec3(1, 1, 1)))"),
        format!("is_nan(inverse({singular}))"),
        format!("is_nan(solve(1e-250 * {singular}, vec3(1, 1, 1)))"),
        "is_nan(inverse(mat4(0)))".into(),
    ] {
        assert_eq!(value("bool", &question), Value::Bool(true), "{question}");
    }
}

#[test]
fn elimination_is_the_same_everywhere() {
    let mut mesh = shape::icosphere(3);
    let mut dice = Dice(11);
    let matrix = Value::Mat4(DMat4::ZERO);
    let matrices = mesh.add_column(ElementKind::Vertex, "a", matrix).unwrap();
    for index in 0..mesh.vertex_count() as u32 {
        // Equal pivots, lost ones, what is infinite or not a number, in some of the matrices.
        let odd = [f64::NAN, f64::INFINITY, -0.0, 1e300, 1e-300][index as usize % 5];
        let entries = std::array::from_fn(|_| match dice.below(40) {
            0 => odd,
            1..20 => dice.below(5) as f64 - 2.0,
            _ => dice.below(1_000_000) as f64 / 1e5 - 5.0,
        });
        assert!(mesh.set_value(matrices, index, Value::Mat4(DMat4::from_cols_array(&entries))));
    }
    let script = "
        attr a: vertex mat4 = mat4(0)
        attr solved: vertex vec4 = vec4(0, 0, 0, 0)
        attr inverse: vertex mat4 = mat4(0)
        attr solved3: vertex vec3 = vec3(0, 0, 0)
        attr inverse3: vertex mat3 = mat3(0)
        script main() {
          for v in vertices {
            v.solved = solve(v.a, v.a.w)
            v.inverse = inverse(v.a)
            v.solved3 = solve(mat3(v.a), vec3(v.a.w))
            v.inverse3 = inverse(mat3(v.a))
          }
        }";
    run_alone(&mut mesh, script, &[]).unwrap();
    let found = |name: &str, index: u32| {
        let column = mesh.find_column(ElementKind::Vertex, name).unwrap();
        mesh.value(column, index).unwrap().reals().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    let bits = |all: &[f64]| all.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let mut regular = 0;
    for index in 0..mesh.vertex_count() as u32 {
        let Some(Value::Mat4(a)) = mesh.value(matrices, index) else { panic!("it is a matrix") };
        let a3 = DMat3::from_mat4(a).to_cols_array_2d();
        let [solved] = eliminate(a.to_cols_array_2d(), [a.w_axis.to_array()]);
        let [solved3] = eliminate(a3, [a.w_axis.truncate().to_array()]);
        let inverse = eliminate(a.to_cols_array_2d(), DMat4::IDENTITY.to_cols_array_2d());
        let inverse3 = eliminate(a3, DMat3::IDENTITY.to_cols_array_2d());
        assert_eq!(found("solved", index), bits(&solved), "{a}");
        assert_eq!(found("inverse", index), bits(inverse.as_flattened()), "{a}");
        assert_eq!(found("solved3", index), bits(&solved3), "{a}");
        assert_eq!(found("inverse3", index), bits(inverse3.as_flattened()), "{a}");
        regular += usize::from(solved[0].is_finite());
    }
    let all = mesh.vertex_count();
    assert!(all / 3 < regular && regular < all - 50, "{regular} of {all}");
}

#[test]
fn aggregates_of_vectors_and_matrices() {
    assert_eq!(
        value("mat3", "sum(outer(w.position, w.position) for w in vertices)"),
        Value::Mat3(DMat3::from_diagonal(DVec3::splat(8.0)))
    );
    assert_eq!(
        value("vec2", "mean(vec2(w.position) + vec2(1, 2) for w in vertices)"),
        Value::Vec2(DVec2::new(1.0, 2.0))
    );
}

#[test]
fn wide_values_are_printed_by_columns() {
    let lines = printed(
        &mut shape::cube(),
        "print vec2(1, 2.5), vec4(1, 2, 3, 4)
         print mat3(2)",
    );
    assert_eq!(lines, ["(1, 2.5) (1, 2, 3, 4)", "((2, 0, 0), (0, 2, 0), (0, 0, 2))"]);
}

#[test]
fn vectors_come_from_outside() {
    let script = "script main(a: vec2, b: vec4 = vec4(a, a)) { print a, b }";
    let (_, lines) = try_run(&mut shape::cube(), script, &[("a", "1,2")]).unwrap();
    assert_eq!(lines, ["(1, 2) (1, 2, 1, 2)"]);
    let (_, lines) =
        try_run(&mut shape::cube(), script, &[("a", "1,2"), ("b", "(4,3,2,1)")]).unwrap();
    assert_eq!(lines, ["(1, 2) (4, 3, 2, 1)"]);
}

/// Of variables, in functions and in `update`, and of attributes; the others stay.
#[test]
fn components_and_columns_are_assigned() {
    let mut mesh = shape::cube();
    let script = "
        attr a: vertex mat4 = mat4(1)
        fn column(m: mat3) { var n = m  n.x.y = 5  n.z = vec3(7)  n.z.z = n.x.y + 1  return n.z }
        script main() {
          for h in halfedges { h.vertex.a.w.x = 9  h.vertex.position.y = h.vertex.position.x }
          update v in vertices { var p = v.position  p.z = 2  v.position = p + column(mat3(1)) }
        }";
    run_alone(&mut mesh, script, &[]).unwrap();
    let column = mesh.find_column(ElementKind::Vertex, "a").unwrap();
    let of_cube = shape::cube();
    for v in mesh.vertices() {
        let old = of_cube.position(v);
        assert_eq!(mesh.position(v), DVec3::new(old.x + 7.0, old.x + 7.0, 8.0));
        let mut a = DMat4::IDENTITY;
        a.w_axis.x = 9.0;
        assert_eq!(mesh.value(column, v.0), Some(Value::Mat4(a)));
    }
}
