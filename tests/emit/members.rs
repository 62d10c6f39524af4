//! Names in emitted code that would be those of something else.

use hedgerow::emit::Style;

use super::told::emitted_in;

/// The first operation of a program as C++.
fn emitted(text: &str, style: &Style) -> String {
    let ([cpp, _], _) = emitted_in(style, text);
    cpp.unwrap()
}

/// The members that elements must have, as the text says: `face: bool boundary_2`.
fn members(text: &str, style: &Style) -> Vec<String> {
    let text = emitted(text, style);
    let told = text.lines().filter_map(|line| line.strip_prefix("//   "));
    told.map(String::from).collect()
}

#[test]
fn an_attribute_is_no_member_that_the_mesh_class_or_another_attribute_has() {
    let program = "
        attr boundary: face bool = false
        attr class: face int = 0
        attr class_: face int = 0
        attr class: vertex int = 0
        attr pos: vertex vec3 = vec3(0)
        attr of: vertex int = 0
        op mark(f: face) {
          before { face f: v -h-> w => v }
          after {
            face f: v -h-> w => v
            f.boundary = true
            f.class = 1
            f.class_ = 2
            v.class = 3
            v.pos = vec3(1)
            v.of = 4
          }
        }";
    let all = |pos| {
        [
            "face: bool boundary_2, by default false",
            "face: long long class_, by default 0",
            "face: long long class_2, by default 0",
            pos,
            "vertex: long long class_, by default 0",
            "vertex: long long of, by default 0",
        ]
    };
    assert_eq!(members(program, &Style::default()), all("vertex: Vec3 pos, by default vec3(0)"));
    let mut accessors = Style::default();
    accessors.set("accessors").unwrap();
    assert_eq!(members(program, &accessors), all("vertex: Vec3 pos_2, by default vec3(0)"));
}

/// An operation that calls a function which calls another.
fn weighing(weight: &str, base: &str) -> String {
    format!(
        "attr n: vertex int = 0
        op weigh(v: vertex) {{ steps {{ v.n = weight(v) }} }}
        fn weight(v: vertex) -> int {{ {weight} }}
        fn base(v: vertex) -> int {{ {base} }}"
    )
}

/// Headers of two programs can be in one file, and object files of both in one program: functions
/// that differ by their texts, or by what they call, are in namespaces of their own.
#[test]
fn functions_of_the_same_name_with_other_texts_are_others() {
    let version = |weight, base| {
        let text = emitted(&weighing(weight, base), &Style::default());
        let space = text.lines().find_map(|line| line.strip_prefix("namespace p"));
        let version = format!("p{}", space.unwrap().trim_end_matches(" {"));
        assert!(text.contains(&format!("= hedgerow::{version}::weight(v)")), "{text}");
        version
    };
    assert_eq!(version("base(v)", "degree(v)"), version("base(v)", "degree(v)"));
    assert_ne!(version("base(v)", "degree(v)"), version("base(v)", "degree(v) + 1"));
    assert_ne!(version("base(v)", "degree(v)"), version("base(v) + 1", "degree(v)"));
}
