//! Styles, one by one and together: what they make of operations compiles, or is refused with the
//! reason.

use std::fs;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::emit::{Selection, Style, cpp};
use hedgerow::source::Sources;
use tempfile::TempDir;

use crate::compiled::compiler::{compile, folder, has_compiler};

/// Operations that speak of all that a style spells: pointers, faces and holes, positions, walks,
/// steps, a preview, literals of all kinds, and a parameter with a default.
const OPS: &str = include_str!("styles.hedge");

/// The operations in a style.
fn emitted(styles: &[&str]) -> Result<String, String> {
    emitted_of(OPS, styles)
}

/// The operations of a program in a style.
fn emitted_of(text: &str, styles: &[&str]) -> Result<String, String> {
    let mut style = Style::default();
    for text in styles {
        style.set(text).map_err(|error| error.to_string())?;
    }
    style.check().map_err(|error| error.to_string())?;
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
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
    let members = "\n  std::optional<EdgeRef> turn(EdgeRef e);\n  std::optional<FaceRef> inset(FaceRef f);\n  bool widen(FaceRef f);\n  std::optional<FaceRef> make_hole(FaceRef f);\n  VertexRef new_vertex()";
    let plain = "\n  bool flip(EdgeRef e);\n  std::optional<FaceRef> inset(FaceRef f, double t);\n  bool widen(FaceRef f);\n  bool make_hole(FaceRef f);\n  VertexRef new_vertex()";
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
        (vec!["boundary={of}->boundary != false", "operations=course::ops"], mesh(&[])),
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
        eprintln!("{styles:?}");
        let args = ["-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "code.cpp"];
        compile(bench.path(), "g++", &args);
    }
}

/// Programs with functions of the same names, two styles of a mesh class, two mesh classes, and a
/// program in a namespace of the reader's.
#[test]
fn what_is_emitted_compiles_together() {
    if !has_compiler() {
        return;
    }
    let weighing = |name: &str, base: &str| {
        let text = format!(
            "op {name}(v: vertex) {{ steps {{ v.position = v.position * weight(v) }} }}
            fn weight(v: vertex) -> real {{ base(v) / 2 }}
            fn base(v: vertex) -> real {{ {base} }}"
        );
        emitted_of(&text, &[]).unwrap()
    };
    let [light, heavy] = [weighing("light", "degree(v)"), weighing("heavy", "degree(v) * 8")];
    let own = emitted(&[]).unwrap();
    let other = ["mesh=course::Mesh", "Vector=course::Vec3", "namespace=course::ops"];
    let other = emitted(&other).unwrap();
    let apart = emitted(&["namespace=apart_ops"]).unwrap();
    let braced = [
        "set_boundary=({of}->boundary) = {value}",
        "function.flip=turn",
        "function.widen=w",
        "function.inset=draw_in",
        "function.make_hole=open",
    ];
    let braced = emitted(&braced).unwrap();
    let bench = TempDir::new().unwrap();
    fs::write(bench.path().join("mesh.h"), mesh(&[])).unwrap();
    let course = mesh(&[("#pragma once", "")]);
    let code = format!(
        "#include \"mesh.h\"\nnamespace course {{\n{course}\n}}\n{own}{braced}{other}{light}{heavy}\nnamespace apart {{\n{apart}\n}}\n"
    );
    fs::write(bench.path().join("code.cpp"), code).unwrap();
    let args = ["-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "code.cpp"];
    compile(bench.path(), "g++", &args);
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
            "the pattern of `position` has no placeholder `{pointer}`, only `{of}`",
        ),
        (&["write={of}->{pointer} = {value};"], "is an expression"),
        (&["read={of}->{pointer}("], "has a bracket that does not match another"),
        (&["Vertex=union"], "`union` is not a C++ name, as `Vertex` must be"),
        (&["Vertex=V*"], "an alias is one, `using T = V*;`"),
        (&["namespace=Mesh"], "no namespace of its own"),
        (&["namespace=std::hedge"], "no namespace of its own"),
        (&["operations=Mesh"], "`operations=Mesh` is no namespace of its own"),
        (&["operations=app::hedgerow"], "no namespace of its own"),
        (&["operations=app::Mesh"], "no namespace of its own"),
        (&["operations=ops", "member=yes"], "members of a class"),
        (&["namespace=turn", "function.flip=turn"], "cannot be that of a namespace"),
        (&["result=maybe"], "`result` is one of `bool` and `given`"),
        (&["function.flip=a::b"], "`a::b` is not a C++ name"),
        (&["member=yes", "Vertex=Ref", "Face=Ref"], "`Vertex` and `Face` are one type"),
        (&["next=twin"], "`next` and `twin` of a halfedge are both `twin`"),
        (&["prev=prev", "vertex=prev"], "`prev` and `vertex` of a halfedge are both `prev`"),
        (&["function.flip=inset"], "`flip` and `inset` would both be called `inset`"),
        (&["function=all"], "`function=all` names one operation, and there are"),
    ] {
        let told = emitted(styles).expect_err(why);
        assert!(told.contains(why), "{styles:?}: {told}");
    }
}

#[test]
fn what_cannot_compile_is_no_pattern() {
    let set = |text: &str| Style::default().set(text).map_err(|error| error.to_string());
    for text in [
        "read={of}.at(\"{pointer}\")",
        "read={of}->{pointer}(",
        "read={of}->{pointer}; // x",
        "read={of}->{pointer} + {value}",
        "boundary={of}->{form}",
        "new_vertex=make({of})",
        "Vertex=class",
        "Vertex=3d",
        "mesh=",
        "member=maybe",
        "include=a\"b",
        "pascal",
        "nexxt=n",
        "write={of}->{pointer}",
        "next=->x",
    ] {
        assert!(set(text).is_err(), "{text}");
    }
    for text in [
        "read=(*{of}).get_{pointer}()",
        "write=set({of}->{pointer}, T{{value}})",
        "new_vertex=add<Vertex>()",
        "prev=",
        "real=float",
        "Vertex=a::b::Vertex",
        "include=halfedge.h geometry/halfedge.h",
    ] {
        assert_eq!(set(text), Ok(()), "{text}");
    }
    assert_eq!(
        set("write={of}->{pointer} = {value} + {what}"),
        Err("the pattern of `write` has no placeholder `{what}`, only `{of}`, `{pointer}` and `{value}`"
            .into())
    );
}

#[test]
fn a_style_is_changed_bit_by_bit() {
    let plain = emitted(&[]).unwrap();
    assert!(plain.contains("->next = ") && plain.contains("->halfedge;"), "{plain}");
    let changed = emitted(&["accessors", "halfedge=half_edge"]).unwrap();
    assert!(changed.contains("->next() = ") && changed.contains("->half_edge()"), "{changed}");
    assert!(!changed.contains("->halfedge"), "{changed}");
    // What belongs to a namespace is nobody's member.
    assert!(emitted(&["boundary=ns::is_hole({of})", "member=yes"]).is_ok());
}
