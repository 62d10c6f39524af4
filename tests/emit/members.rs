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
        op mark(f: face) {
          before { face f: v -h-> w => v }
          after {
            face f: v -h-> w => v
            f.boundary = true
            f.class = 1
            f.class_ = 2
            v.class = 3
            v.pos = vec3(1)
          }
        }";
    let all = |pos| {
        [
            "face: bool boundary_2, by default false",
            "face: long long class_, by default 0",
            "face: long long class_2, by default 0",
            pos,
            "vertex: long long class_, by default 0",
        ]
    };
    assert_eq!(members(program, &Style::default()), all("vertex: Vec3 pos, by default vec3(0)"));
    let mut accessors = Style::default();
    accessors.set("accessors").unwrap();
    assert_eq!(members(program, &accessors), all("vertex: Vec3 pos_2, by default vec3(0)"));
}

/// Headers of two programs may stand in one file, and object files of both in one program.
#[test]
fn functions_of_the_same_name_with_other_texts_are_others() {
    let version = |body: &str| {
        let text = emitted(
            &format!(
                "attr n: vertex int = 0
                op one(v: vertex) {{ steps {{ v.n = weight(v) }} }}
                fn weight(v: vertex) -> int {{ {body} }}"
            ),
            &Style::default(),
        );
        let guard = text.lines().find(|line| line.starts_with("#ifndef HEDGEROW_weight_"));
        let space = text.lines().find(|line| line.starts_with("inline namespace "));
        let version = space.unwrap()["inline namespace ".len()..].trim_end_matches(" {");
        assert_eq!(guard.unwrap(), format!("#ifndef HEDGEROW_weight_{version}"));
        version.to_string()
    };
    assert_eq!(version("degree(v)"), version("degree(v)"));
    assert_ne!(version("degree(v)"), version("degree(v) + 1"));
}
