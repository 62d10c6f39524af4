//! Styles, one by one and together: what they make of operations compiles, or is refused with the
//! reason.

use std::fs;
use std::process::Command;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::emit::{Selection, Style, cpp};
use hedgerow::source::Sources;
use tempfile::TempDir;

use crate::cpp::has_compiler;
use crate::subjects::folder;

/// Operations that speak of all that a style spells: pointers, faces and holes, positions, walks,
/// steps, a sheet, literals of all kinds, and a parameter with a default.
const OPS: &str = r#"
use "std/map.hedge"

/// Ends with \
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 =P=> v0
    face f1: v1 -d-> v0 -g-> v3 =Q=> v1
    edge e: a | d
  }
  require length(e) < infinity else "what ends with \"
  require all(degree(v) > 2 for v in e.vertices) else "two"
  guard surface
  after {
    face f0: v3 -a-> v2 =P=> v0 -g-> v3
    face f1: v2 -d-> v3 =Q=> v1 -b-> v2
    edge e: a | d
  }
}

op inset(f: face, t: real = 0.25) -> f {
  before { face f: each i { v[i] -h[i]-> } }
  require any(boundary(e) for e in f.edges) or area(f) > -1e300 else "what"
  guard surface
  after {
    new w[i] s[i] a[i] b[i] r[i] q[i] c[i] d[i]
    face f: each i { w[i] -s[i]-> }
    face q[i]: v[i] -h[i]-> v[i+1] -a[i]-> w[i+1] -r[i]-> w[i] -b[i]-> v[i]
    edge c[i]: s[i] | r[i]
    edge d[i]: a[i] | b[i+1]
    w[i].position = mix(v[i].position, centroid(f), t) + vec3(-0.0, 1e-320, 0.5) * 3000000000
  }
}

op widen(f: face) {
  guard surface
  steps { for e in f.edges { must remove(e) } }
}

op open(f: face) {
  before { face f: v0 -a-> v1 =P=> v0 }
  after { hole f: v0 -a-> v1 =P=> v0 }
}
"#;

/// The operations in a style.
fn emitted(styles: &[&str]) -> Result<String, String> {
    let mut style = Style::default();
    for text in styles {
        style.set(text).map_err(|error| error.to_string())?;
    }
    style.check().map_err(|error| error.to_string())?;
    let mut sources = Sources::new();
    let file =
        sources.add("test.hedge", OPS.replace("what ends with \\\"", "what ends with \\\\\""));
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let ops = analysis.program.ops.iter().enumerate();
    let ops: Vec<_> = ops.filter(|(_, op)| op.span.file == file).map(|(at, _)| at).collect();
    let (program, proved) = (&analysis.program, &analysis.proved);
    let selection = Selection { program, proved, sources: &sources, ops: &ops, exhaustive: false };
    cpp(&selection, &style).map_err(|failure| failure.why.unwrap_or(failure.what))
}

/// The mesh with fields, for a style that differs in some words.
fn mesh(changes: &[(&str, &str)]) -> String {
    let text = fs::read_to_string(folder("tests/emit/fields.h")).unwrap();
    changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

#[test]
fn what_a_style_makes_compiles() {
    if !has_compiler() {
        return;
    }
    let members = "\n  std::optional<EdgeRef> turn(EdgeRef e);\n  std::optional<FaceRef> inset(FaceRef f);\n  std::optional<FaceRef> widen(FaceRef f);\n  std::optional<FaceRef> open(FaceRef f);\n  VertexRef new_vertex()";
    let plain = "\n  bool flip(EdgeRef e);\n  std::optional<FaceRef> inset(FaceRef f, double t);\n  bool widen(FaceRef f);\n  bool open(FaceRef f);\n  VertexRef new_vertex()";
    let aggregate = [
        (
            "  Vec3() : x(0), y(0), z(0) {}\n  Vec3(double x, double y, double z) : x(x), y(y), z(z) {}\n",
            "",
        ),
        ("return Vec3(", "return Vec3{"),
        (");\n}", "};\n}"),
    ];
    let aggregate: Vec<_> = aggregate[..1].to_vec();
    let braces = |text: String| {
        let lines = text.lines().map(|line| match line.contains("return Vec3(") {
            true => line.replace("return Vec3(", "return Vec3{").replace("); }", "}; }"),
            false => line.to_string(),
        });
        lines.collect::<Vec<_>>().join("\n")
    };
    let with_optional =
        |text: String| text.replace("#include <list>", "#include <list>\n#include <optional>");
    let free = "\ninline bool is_hole(Mesh::FaceRef f) { return f->boundary; }\n";
    for (styles, mesh) in [
        (vec![], mesh(&[])),
        (
            vec!["real=float"],
            mesh(&[
                ("double x", "float x"),
                ("double y", "float y"),
                ("double z", "float z"),
                ("double t", "float t"),
                ("inline double", "inline float"),
            ]),
        ),
        (vec![], braces(mesh(&aggregate))),
        (vec!["member=yes"], with_optional(mesh(&[("\n  VertexRef new_vertex()", plain)]))),
        (
            vec![
                "member=yes",
                "result=given",
                "defaults=fixed",
                "function.flip=turn",
                "include=mesh.h",
            ],
            with_optional(mesh(&[("\n  VertexRef new_vertex()", members)])),
        ),
        (vec!["boundary=is_hole({of})"], mesh(&[]) + free),
        (
            vec!["boundary=::is_hole({of})", "member=yes"],
            with_optional(mesh(&[("\n  VertexRef new_vertex()", plain)])) + free,
        ),
        (
            vec!["mesh=course::Mesh", "Vector=course::Vec3"],
            mesh(&[
                ("struct Vec3 {", "namespace course {\nstruct Vec3 {"),
                ("#define GET", "}\n#define GET"),
                ("using Vector = Vec3;", ""),
            ]),
        ),
        (
            vec!["nested=no", "Vertex=V", "Face=F", "Edge=E", "Halfedge=H"],
            mesh(&[])
                + "using V = Mesh::VertexRef;\nusing F = Mesh::FaceRef;\nusing E = Mesh::EdgeRef;\nusing H = Mesh::HalfedgeRef;\n",
        ),
        (vec!["read=(*{of}).{pointer}", "write={of}->set_{pointer}({value})", "next=next"], {
            let set =
                |ty: &str, name: &str| format!("void set_{name}({ty} it) {{ {name} = it; }}\n    ");
            let of_half = [
                ("HalfedgeRef", "next"),
                ("HalfedgeRef", "twin"),
                ("VertexRef", "vertex"),
                ("EdgeRef", "edge"),
                ("FaceRef", "face"),
            ];
            let of_half: String = of_half.map(|(ty, name)| set(ty, name)).concat();
            let half = set("HalfedgeRef", "halfedge");
            mesh(&[
                ("double mark = 0;", &format!("{of_half}double mark = 0;")),
                (
                    "    HalfedgeRef halfedge;\n",
                    &format!("    HalfedgeRef halfedge;\n    {half}\n"),
                ),
            ])
        }),
    ] {
        let code = emitted(&styles).unwrap();
        let bench = TempDir::new().unwrap();
        fs::write(bench.path().join("mesh.h"), mesh).unwrap();
        let text = format!("#include \"mesh.h\"\n{code}");
        fs::write(bench.path().join("code.cpp"), &text).unwrap();
        let done = Command::new("g++")
            .args(["-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "code.cpp"])
            .current_dir(bench.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{styles:?}: {said}");
    }
}

#[test]
fn a_style_that_cannot_compile_is_refused() {
    for (styles, why) in [
        (&["read=mesh.{pointer}({of})"][..], "does not know it: elements have to lead"),
        (&["read=mesh.{pointer}({of})", "member=yes"], "in a member of the class"),
        (&["read={pointer}({of})", "member=yes"], "write `::pointer`"),
        (&["boundary=is_hole({of})", "member=yes"], "write `::is_hole`"),
        (&["boundary=this->is_hole({of})", "member=yes"], "there is no `this`"),
        (
            &["position={of}->{pointer}"],
            "the pattern of `position` knows `{of}`, and no `{pointer}`",
        ),
        (&["write={of}->{pointer} = {value};"], "is an expression"),
        (&["read={of}->{pointer}("], "has a bracket that does not match another"),
        (&["Vertex=union"], "`Vertex` is to be a name in C++, and `union` is none"),
        (&["result=maybe"], "`result` is one of `bool` and `given`"),
        (&["function.flip=a::b"], "is to be a name in C++"),
        (&["member=yes", "Vertex=Ref", "Face=Ref"], "`Vertex` and `Face` are one type"),
    ] {
        let told = emitted(styles).expect_err(why);
        assert!(told.contains(why), "{styles:?}: {told}");
    }
}
