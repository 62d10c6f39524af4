//! Attributes that a program declares: in scripts, in ops, and on reused slots.

use super::*;
use hedgerow::mesh::{Value, shape};

/// Declarations of every type, and a script over them.
fn with(declarations: &str, body: &str) -> String {
    format!("{declarations}\nscript main() {{\n{body}\n}}")
}

#[test]
fn every_type_is_stored_on_every_kind() {
    let types = [
        ("bool", "true", "not x.KIND_bool"),
        ("int", "-7", "x.KIND_int * 2"),
        ("real", "1/3", "x.KIND_real + 1"),
        ("vec2", "vec2(1, 2)", "x.KIND_vec2 * 2"),
        ("vec3", "vec3(1, 2, 3)", "-x.KIND_vec3"),
        ("vec4", "vec4(1, 2, 3, 4)", "x.KIND_vec4 / 2"),
        ("mat3", "mat3(2)", "x.KIND_mat3 * x.KIND_mat3"),
        ("mat4", "mat4(0)", "mat4(1) - x.KIND_mat4"),
    ];
    let mut declarations = String::new();
    let mut body = String::new();
    for kind in ["vertex", "halfedge", "edge", "face"] {
        let plural = if kind == "vertex" { "vertices".into() } else { format!("{kind}s") };
        for (ty, default, change) in types {
            declarations += &format!("attr {kind}_{ty}: {kind} {ty} = {default}\n");
            let change = change.replace("KIND", kind);
            body += &format!(
                "for x in {plural} {{ assert x.{kind}_{ty} == {default} }}
                 var n = 0
                 for x in {plural} where n < 3 {{ x.{kind}_{ty} = {change}  n = n + 1 }}
                 assert count(x.{kind}_{ty} != {default} for x in {plural}) == 3\n"
            );
            body = body.replace("var n = 0", &format!("var n_{kind}_{ty} = 0"));
            body = body
                .replace(" n < 3", &format!(" n_{kind}_{ty} < 3"))
                .replace(" n = n + 1", &format!(" n_{kind}_{ty} = n_{kind}_{ty} + 1"));
        }
    }
    let mut mesh = shape::cube();
    try_run(&mut mesh, &with(&declarations, &body), &[]).unwrap();
    let mut columns = 0;
    for kind in hedgerow::mesh::ElementKind::ALL {
        columns += mesh.columns(kind).count();
    }
    assert_eq!(columns, 32);
}

#[test]
fn update_keeps_writes_of_attributes_back() {
    let mut mesh = shape::cube();
    let script = with(
        "attr heat: vertex real = 0
         attr seen: vertex vec2 = vec2(0, 0)",
        "var first = true
         for v in vertices where first { v.heat = 1  first = false }
         update v in vertices {
           v.heat = sum(w.heat for w in v.neighbors)
           v.seen = vec2(v.heat, degree(v))
           v.position = v.position + vec3(v.heat, 0, 0)
         }
         print sum(v.heat for v in vertices), count(v.heat == 1 for v in vertices)
         print sum(v.seen for v in vertices)",
    );
    let before: f64 = mesh.vertices().map(|v| mesh.position(v).x).sum();
    let (_, lines) = try_run(&mut mesh, &script, &[]).unwrap();
    assert_eq!(lines, ["3 3", "(1, 24)"]);
    let after: f64 = mesh.vertices().map(|v| mesh.position(v).x).sum();
    assert_eq!(after - before, 1.0);
}

/// Bisects an edge, and cuts the vertex out again; both keep a weight on the way.
const BISECT: &str = "
attr weight: vertex real = 1
attr crease: edge int
op halve(e: edge) -> m {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  require v0.weight >= 0 and v1.weight >= 0 else \"a weight is negative\"
  after {
    new m x y e1
    loop f0: v0 -a-> m -x-> v1 =P=> v0
    loop f1: v1 -d-> m -y-> v0 =Q=> v1
    edge e: a | y
    edge e1: x | d
    m.position = midpoint(e)
    m.weight = v0.weight + v1.weight
    e1.crease = e.crease + 1
    e.crease = e.crease - 1
  }
}
op join(v: vertex) {
  before {
    loop f0: v0 -a-> v -x-> v1 =P=> v0
    loop f1: v1 -d-> v -y-> v0 =Q=> v1
    edge e: a | y
    edge e1: x | d
  }
  after {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
    erase v x y e1
    e.crease = e.crease + e1.crease
  }
}";

#[test]
fn ops_read_attributes_as_they_were_and_write_them_at_once() {
    let mut mesh = shape::tetrahedron();
    let script = with(
        BISECT,
        "for e in edges { e.crease = 10 }
         for e in edges { halve(e) }
         print sum(v.weight for v in vertices), count(v.weight == 2 for v in vertices)
         print count(e.crease == 9 for e in edges), count(e.crease == 11 for e in edges)
         for v in vertices where v.weight == 2 { v.weight = -1 }
         for e in edges { halve(e) }",
    );
    let (report, lines) = run_alone(&mut mesh, &script, &[]).unwrap();
    assert_eq!(lines, ["16 6", "6 6"]);
    assert_eq!((applied(&report, "halve"), refused(&report, "halve")), (6, 12));
}

#[test]
fn a_reused_slot_has_the_default_again() {
    let mut mesh = shape::tetrahedron();
    let script = with(
        &format!("{BISECT}\nattr mark: vertex int = 5\nattr tag: halfedge vec3 = vec3(0, 0, 1)"),
        "var again = 0
         repeat 50 {
           var done = false
           for e in edges where not done { if halve(e) { done = true } }
           for v in vertices where degree(v) == 2 {
             if v.mark == 5 { again = again + 1 }
             v.mark = 6
             for h in v.halfedges { assert h.tag.z == 1  h.tag = vec3(1, 1, 0) }
           }
           for v in vertices where degree(v) == 2 { must join(v) }
         }
         print again, count(vertices), sum(e.crease for e in edges)",
    );
    let (report, lines) = run_alone(&mut mesh, &script, &[]).unwrap();
    assert_eq!(lines, ["50 4 0"]);
    assert_eq!(applied(&report, "join"), 50);
    // Each time round the slots of the last time were used again.
    assert_eq!(mesh.capacity(hedgerow::mesh::ElementKind::Vertex), 5);
}

#[test]
fn scratch_attributes_are_gone_after_the_run_and_the_others_stay() {
    let mut mesh = shape::cube();
    let script = with(
        "attr kept: face real = 0
         attr unused: face real = 0
         private attr scratch: face real = 0.5",
        "for f in faces { f.scratch = f.scratch + 1  f.kept = f.scratch }",
    );
    for _ in 0..2 {
        try_run(&mut mesh, &script, &[]).unwrap();
        let kind = hedgerow::mesh::ElementKind::Face;
        let names: Vec<_> = mesh.columns(kind).map(|(_, c)| c.name().to_owned()).collect();
        assert_eq!(names, ["kept"]);
        let kept = mesh.find_column(kind, "kept").unwrap();
        assert!(mesh.faces().all(|f| mesh.value(kept, f.0) == Some(Value::Real(1.5))));
    }
}

#[test]
fn an_attribute_of_the_mesh_is_taken_over_or_clashes() {
    let kind = hedgerow::mesh::ElementKind::Vertex;
    let mut mesh = shape::cube();
    let column = mesh.add_column(kind, "heat", Value::Real(4.0)).unwrap();
    let script = with(
        "attr heat: vertex real = 1",
        "print sum(v.heat for v in vertices)
         for v in vertices { v.heat = 2 }",
    );
    let (_, lines) = try_run(&mut mesh, &script, &[]).unwrap();
    assert_eq!(lines, ["32"]);
    assert_eq!(mesh.value(column, 3), Some(Value::Real(2.0)));
    let script = with("attr heat: vertex int = 1", "for v in vertices { v.heat = 2 }");
    let failure = try_run(&mut mesh, &script, &[]).unwrap_err();
    assert_eq!(failure.diagnostic.code, "attribute-conflict");
    assert_eq!(
        failure.diagnostic.message,
        "the vertex attribute `heat` is of type real, not int on this mesh"
    );
}

#[test]
fn a_default_without_a_value_is_told() {
    let (_, analysis) =
        analyse("attr a: vertex int = 1 div 0\nscript main() { for v in vertices { v.a = 1 } }");
    let errors = prepare(&analysis.program, 0, &analysis.plans).unwrap_err();
    assert_eq!(errors[0].code, "attribute-default");
    assert_eq!(errors[0].message, "the default of `a` has no value: division by zero");
}

#[test]
fn the_attribute_of_an_erased_element_cannot_be_read_or_written() {
    for read in ["print v.weight", "v.weight = 1", "update w in vertices { v.weight = 1 }"] {
        let script = with(
            BISECT,
            &format!("for e in edges {{ if let v = halve(e) {{ must join(v)  {read} }} }}"),
        );
        let failure = run_alone(&mut shape::cube(), &script, &[]).unwrap_err();
        assert_eq!(failure.diagnostic.code, "element-gone", "{read}");
    }
}
