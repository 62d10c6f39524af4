//! Names of types in other languages and mesh libraries.

/// The names of types in this language, except `text`.
const OURS: [&str; 12] = [
    "vertex", "halfedge", "edge", "face", "real", "int", "bool", "vec2", "vec3", "vec4", "mat3",
    "mat4",
];

/// True if a word is the name of a type, in this language or in another.
pub(super) fn is_type(word: &str) -> bool {
    word == "text" || OURS.contains(&word) || type_meant(word).is_some()
}

/// True if a word is the name of a type of elements, in this language or in another.
pub(super) fn is_element(word: &str) -> bool {
    OURS[..4].contains(&type_meant(word).unwrap_or(word))
}

/// The type that a foreign word means, also if it differs from our name only in case; `None` if the
/// word is our name.
pub(super) fn type_meant(word: &str) -> Option<&'static str> {
    let same = |ours: &&str| ours.eq_ignore_ascii_case(word);
    type_word(word).or_else(|| OURS.into_iter().find(same)).filter(|ours| *ours != word)
}

/// The type of this language that a foreign type name means.
pub fn type_word(word: &str) -> Option<&'static str> {
    Some(match word.to_lowercase().as_str() {
        "float" | "double" | "number" | "scalar" | "f32" | "f64" => "real",
        "integer" | "i32" | "i64" | "u32" | "usize" | "long" | "short" | "unsigned" | "size_t" => {
            "int"
        }
        "boolean" => "bool",
        "string" | "str" | "char" => "text",
        "vector" | "vec" | "vector3" | "float3" | "double3" | "point" | "point3" | "position" => {
            "vec3"
        }
        "vector2" | "float2" | "point2" => "vec2",
        "matrix4" => "mat4",
        "matrix3" => "mat3",
        "he" | "half_edge" | "dart" | "halfedgeref" | "halfedgecref" | "halfedgeiter"
        | "halfedge_handle" | "halfedgehandle" | "bmloop" | "halfedges" => "halfedge",
        "halfedge_descriptor" => "halfedge",
        "vert" | "node" | "vertexref" | "vertexcref" | "vertexiter" | "vertex_handle"
        | "vertex_descriptor" | "vertexhandle" | "bmvert" | "mvert" | "vertices" => "vertex",
        "edgeref" | "edgecref" | "edgeiter" | "edge_handle" | "edge_descriptor" | "edgehandle"
        | "bmedge" | "medge" => "edge",
        "polygon" | "triangle" | "quad" | "facet" | "cell" | "faceref" | "facecref"
        | "faceiter" | "face_handle" | "face_descriptor" | "facehandle" | "bmface" | "mface"
        | "faces" | "hole" => "face",
        _ => return None,
    })
}
