//! Words of other languages and mesh libraries, and their equivalents here.
//!
//! A newcomer writes `h.opposite`, `len(faces)` or `float`. Such words are too far from ours to be
//! taken for misspellings, so they are listed in tables. About half of them have an equivalent
//! here, which is offered as a fix; for the others a sentence explains how it is done.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Overload, Type, Wanted, functions, overloads};
use crate::source::Span;
use crate::syntax::foreign_syntax::type_word;
use crate::syntax::tree::{self, Ident};

use super::lookup::CONSTANTS;
use super::suggestion::suggest;

/// The replacement of a foreign word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Here {
    /// The equivalent in this language.
    Written(&'static str),
    /// A sentence that explains how it is done.
    Said(&'static str),
}

use Here::{Said, Written};

const COUNTED: Here =
    Said("`count(vertices)` counts a sequence, `degree(v)` what is around an element");
const REPEATED: Here =
    Said("there are no lists; `for i in 0..n { … }` takes the ints from 0 to n - 1");
const PRINTED: Here = Said("`print x, y` stands without parentheses: `print \"{x} of {y}\"`");
const DECLARED: Here = Said("a variable begins with `let`, or with `var` if it changes");
const BRANCHED: Here = Said("a choice is `if c { … } else if d { … } else { … }`");
const ASKED: Here = Said("`if split(e) { … } else { … }` asks whether an op applied");
const VISITED: Here = Said("a loop is `for v in vertices { … }`");
const NOTHING: Here = Said("no pointer is missing: beyond the boundary is a hole, `hole(h.face)`");
const CONVERTED: Here = Said("an int stands wherever a real is wanted; `round(x)` makes an int");
const NUMBERED: Here = Said("an element has no number to reckon with; `print v` shows it");
const POINTED: Here =
    Said("a pointer stands behind a dot: `h.next`, `h.twin`, `h.target`, `v.halfedge`");
const AROUND: Here =
    Said("around an element there are `v.halfedges`, `v.neighbors`, `f.vertices` …");
const PICKED: Here = Said(
    "an element is found by a loop that ends with `break`, `for e in edges where … { … }`, or by \
     `argmin(length(e) for e in edges)`; in random order in `shuffle(edges)`",
);
const PARALLEL: Here = Said(
    "on several threads there are `parallel for e in edges where … { … }`, whose `where` is tested \
     on all of them, and `update`",
);
const CHANGED: Here =
    Said("a script changes a mesh by calling operations: `split(e)`, `dissolve_edge(e)`");
const STOPPED: Here = Said("`assert c else \"…\"` stops a script");
const LEAST: Here = Said("`drain e in edges by length(e) { … }` takes the least first");
const SQUARED: Here = Said("of a vector it is `dot(d, d)`, of an edge `pow(length(e), 2)`");

/// The replacement of a foreign field of a type.
pub(super) fn field(ty: Type, word: &str) -> Option<Here> {
    let written = match (ty, word) {
        (Type::Halfedge, "origin" | "source" | "from" | "tail" | "start" | "v") => "vertex",
        (Type::Halfedge, "to" | "head" | "tip" | "dest" | "destination" | "end") => "target",
        (Type::Halfedge, "opposite" | "opp" | "pair" | "sym" | "flip" | "mate" | "reverse") => {
            "twin"
        }
        (Type::Halfedge, "previous" | "prev_halfedge") => "prev",
        (Type::Halfedge, "next_halfedge") => "next",
        (Type::Halfedge, "left" | "f" | "facet") => "face",
        (Type::Halfedge, "e") => "edge",
        (Type::Vertex, "pos" | "point" | "p" | "co" | "coord" | "coords" | "xyz") => "position",
        (Type::Vertex, "x" | "y" | "z") => {
            return Some(Said("a vertex has a position: `v.position.x`"));
        }
        (
            Type::Vertex,
            "neighbours" | "adjacent" | "adjacent_vertices" | "verts" | "vertices" | "ring"
            | "one_ring",
        ) => "neighbors",
        (Type::Vertex, "incident_faces" | "adjacent_faces") => "faces",
        (Type::Vertex, "incident_edges" | "adjacent_edges") => "edges",
        (Type::Face, "neighbors" | "neighbours" | "faces" | "adjacent_faces" | "adjacent") => {
            return Some(Said(
                "the faces beside a face lie across its halfedges: `for h in f.halfedges where not \
                 boundary(h.twin) { … h.twin.face … }`",
            ));
        }
        (Type::Vec3 | Type::Vec4, "r") => "x",
        (Type::Vec3 | Type::Vec4, "g") => "y",
        (Type::Vec3 | Type::Vec4, "b") => "z",
        (Type::Vec4, "a") => "w",
        (Type::Vertex, "outgoing" | "outgoing_halfedges" | "spokes") => "halfedges",
        (Type::Edge, "v0" | "origin" | "source" | "start" | "from") => "halfedge.vertex",
        (Type::Edge, "v1" | "end" | "to" | "tip") => "halfedge.target",
        (Type::Edge, "h1" | "halfedge1" | "twin") => "halfedge.twin",
        (Type::Edge, "verts") => "vertices",
        (Type::Vertex | Type::Edge | Type::Face, "he" | "h" | "h0" | "halfedge0") => "halfedge",
        (Type::Face, "verts" | "corners" | "points") => "vertices",
        (Type::Vec2 | Type::Vec3 | Type::Vec4, parts)
            if (2..=4).contains(&parts.len()) && parts.chars().all(|c| "xyzwrgba".contains(c)) =>
        {
            return Some(Said("parts of a vector are put together: `vec2(p.x, p.y)`"));
        }
        (Type::Vertex | Type::Halfedge | Type::Edge | Type::Face, "index" | "id" | "idx") => {
            return Some(NUMBERED);
        }
        _ => return None,
    };
    Some(Written(written))
}

/// True if other languages use the word for the number of sides of a face or of edges at a vertex.
pub(super) fn is_degree(ty: Type, word: &str) -> bool {
    match word {
        "n" | "degree" | "valence" | "valency" | "size" | "count" | "len" | "num_edges"
        | "n_edges" | "edge_count" | "num_halfedges" => matches!(ty, Type::Vertex | Type::Face),
        "sides" | "num_sides" | "n_sides" | "side_count" | "num_vertices" | "n_vertices"
        | "vertex_count" | "nverts" | "num_verts" | "length" | "arity" => ty == Type::Face,
        "num_neighbors" | "num_neighbours" => ty == Type::Vertex,
        _ => false,
    }
}

/// The replacement of a foreign function name.
pub(super) fn function(word: &str) -> Option<Here> {
    Some(match word {
        "valence" | "valency" => Written("degree"),
        "norm" | "magnitude" | "edge_length" => Written("length"),
        "is_boundary" | "on_boundary" | "is_border" | "is_on_boundary" => Written("boundary"),
        "is_hole" => Written("hole"),
        "barycenter" | "barycentre" | "center" | "centre" => Written("centroid"),
        "lerp" | "interpolate" => Written("mix"),
        "average" | "avg" => Written("mean"),
        "total" => Written("sum"),
        "cot" | "cotan" => Written("cotangent"),
        "det" => Written("determinant"),
        "inv" => Written("inverse"),
        "normalise" | "normalized" | "unit" => Written("normalize"),
        "arccos" => Written("acos"),
        "arcsin" => Written("asin"),
        "fabs" => Written("abs"),
        "isnan" => Written("is_nan"),
        "isfinite" => Written("is_finite"),
        "ln" => Written("log"),
        "power" => Written("pow"),
        "ceiling" => Written("ceil"),
        "dihedral" => Written("dihedral_angle"),
        "dist" => Written("distance"),
        "are_adjacent" | "is_adjacent" => Written("adjacent"),
        "minimum" => Written("min"),
        "maximum" => Written("max"),
        "vec" | "vector" | "vector3" | "point" | "Vec3" | "Vector3" => Written("vec3"),
        "len" | "size" | "num" | "nv" | "ne" | "nf" => COUNTED,
        "num_vertices" | "n_vertices" | "vertex_count" | "num_faces" | "n_faces" | "face_count"
        | "num_edges" | "n_edges" | "edge_count" => COUNTED,
        "range" | "seq" | "list" | "append" | "push" => REPEATED,
        "int" | "real" | "float" | "double" => CONVERTED,
        "printf" | "println" | "echo" | "str" | "format" => PRINTED,
        "exit" | "panic" | "error" | "throw" | "raise" => STOPPED,
        "refuses" => Said(
            "in a test, it stands directly behind `assert`: `assert refuses(flip(e))`; whether an \
             op would apply is asked by `can flip(e)`",
        ),
        "assert_eq" | "assertEqual" | "expect" => Said("it is `assert x == y`"),
        "enumerate" | "zip" | "map" | "filter" | "sorted" => {
            Said("a loop is `for v in vertices where … { … }`; `drain` takes the least first")
        }
        "getattr" | "get" | "at" => {
            Said("attributes and pointers stand behind a dot: `v.position`")
        }
        "parallel_for" | "parfor" => PARALLEL,
        "sqr" | "square" => Said("it is `x * x`"),
        "next" | "prev" | "twin" | "opposite" | "sym" | "target" | "source" | "origin"
        | "halfedge" | "vertex" | "edge" | "face" | "position" | "pos" | "to_vertex"
        | "from_vertex" | "to_vertex_handle" | "from_vertex_handle" | "edge_handle"
        | "face_handle" | "halfedge_handle" => POINTED,
        "next_halfedge_handle" | "opposite_halfedge_handle" | "prev_halfedge_handle" => POINTED,
        "one_ring" | "ring" | "neighbors" | "neighbours" | "adjacent_vertices"
        | "incident_edges" | "incident_faces" | "vv_range" | "ve_range" | "vf_range"
        | "fv_range" | "fh_range" => AROUND,
        "vertices_around_target" | "halfedges_around_target" => AROUND,
        "halfedges_around_face" | "faces_around_target" => AROUND,
        "face_normal" | "vertex_normal" | "calc_normal" | "calc_face_normal" => Written("normal"),
        "face_area" | "calc_face_area" => Written("area"),
        "edge_midpoint" => Written("midpoint"),
        "face_centroid" | "face_barycenter" | "calc_face_centroid" => Written("centroid"),
        "calc_edge_length" => Written("length"),
        "find_edge" | "get_edge" | "edge_between" | "find_halfedge" | "get_halfedge"
        | "halfedge_between" | "find_vertex" | "get_vertex" | "find_face" | "get_face" => PICKED,
        "first" | "choice" | "pick" | "any_of" | "random_choice" | "random_edge" | "sample" => {
            PICKED
        }
        "sort" | "sort_by" | "order" | "order_by" | "queue" | "priority_queue" | "heap"
        | "heapq" | "heappush" | "heappop" | "pop" => LEAST,
        "seed" | "srand" | "set_seed" => Said("the seed is given to the run: `--seed 7`"),
        "save" | "write" | "export" | "save_mesh" | "write_obj" | "write_mesh" => {
            Said("what a script leaves is written by `hedgerow run … -o FILE`")
        }
        "read" | "open" | "import" | "read_obj" | "load_mesh" | "read_mesh" => {
            Said("the mesh is given to the run: `hedgerow run FILE.hedge MESH.obj`")
        }
        "valid" | "is_valid" | "validate" | "check" | "is_manifold" | "check_mesh" => {
            Said("what is proved keeps every mesh valid, so there is nothing to ask")
        }
        "poke" | "poke_face" | "kis" | "stellate" | "face_split" | "split_face"
        | "insert_vertex" | "add_center" | "add_centre" => Said(
            "a vertex at the centroid of a face, with an edge from each corner, comes by \
             `inset_vertex(f)` of `std/polygon.hedge`",
        ),
        "add_vertex" | "add_face" | "add_edge" | "new_vertex" | "new_face" | "delete_vertex"
        | "delete_face" | "delete_edge" | "remove_vertex" | "remove_face" | "remove_edge"
        | "delete" | "remove" | "set_next" | "set_twin" | "set_face" | "set_vertex"
        | "garbage_collection" => CHANGED,
        "rand" | "randint" | "rnd" | "uniform" => Written("random"),
        "permute" | "shuffled" => Written("shuffle"),
        _ => return measured(word).or_else(|| calculated(word)).or_else(|| sequence_called(word)),
    })
}

/// True if other languages have such a function of values.
pub(super) fn is_foreign(word: &str) -> bool {
    measured(word).or_else(|| calculated(word)).is_some()
}

/// The replacement of a measure of a mesh or its elements.
fn measured(word: &str) -> Option<Here> {
    Some(match word {
        "squared_length" | "length_squared" | "squaredNorm" | "squared_norm" | "length2"
        | "lengthSquared" | "length_sq" | "lengthSq" | "norm2" | "sqr_length" | "sqrLength" => {
            SQUARED
        }
        "squared_distance" | "distance_squared" | "distance2" | "dist2" => {
            Said("with `let d = p - q` it is `dot(d, d)`")
        }
        "gaussian_curvature" | "angle_defect" | "gauss_curvature" => {
            Said("inside the boundary it is `2 * pi - sum(angle(h) for h in v.halfedges)`")
        }
        "vertex_area" | "voronoi_area" | "mixed_area" | "barycentric_area" | "dual_area" => {
            Said("a third of the faces around a vertex is `sum(area(f) for f in v.faces) / 3`")
        }
        "bounding_box" | "bbox" | "aabb" => Said(
            "its corners are `min(v.position for v in vertices)` and `max(v.position for v in vertices)`",
        ),
        "volume" => Said(
            "of a mesh without boundary it is `sum(dot(centroid(f), normal(f)) * area(f) for f in \
             faces) / 3`",
        ),
        "surface_area" | "total_area" => Said("it is `sum(area(f) for f in faces)`"),
        _ => return None,
    })
}

/// The replacement of a function of numbers, vectors or matrices.
fn calculated(word: &str) -> Option<Here> {
    Some(match word {
        "sign" | "signum" | "sgn" => Said("it is `if x > 0 { 1 } else if x < 0 { -1 } else { 0 }`"),
        "copysign" => Said("it is `if y < 0 { -abs(x) } else { abs(x) }`"),
        "sinh" => Said("it is `(exp(x) - exp(-x)) / 2`"),
        "cosh" => Said("it is `(exp(x) + exp(-x)) / 2`"),
        "tanh" => Said("it is `1 - 2 / (exp(2 * x) + 1)`"),
        "asinh" | "arcsinh" => Said("it is `log(x + sqrt(x * x + 1))`"),
        "acosh" | "arccosh" => Said("it is `log(x + sqrt(x * x - 1))`"),
        "atanh" | "arctanh" => Said("it is `log((1 + x) / (1 - x)) / 2`"),
        "atan" | "arctan" => Said("`atan2(y, x)` takes both sides: of one number, `atan2(x, 1)`"),
        "arctan2" => Written("atan2"),
        "log2" => Said("it is `log(x) / log(2)`"),
        "log10" => Said("it is `log(x) / log(10)`"),
        "log1p" => Said("it is `log(1 + x)`"),
        "exp2" => Said("it is `pow(2, x)`"),
        "exp10" => Said("it is `pow(10, x)`"),
        "expm1" => Said("it is `exp(x) - 1`"),
        "fract" | "frac" => Said("it is `x - floor(x)`"),
        "trunc" => Said("it is `if x < 0 { ceil(x) } else { floor(x) }`"),
        "modf" => Said("the whole part is `floor(x)`, the rest `x - floor(x)`"),
        "fmod" | "remainder" => {
            Said("of ints it is `i mod n`, of reals from 0 on `x - y * floor(x / y)`")
        }
        "hypot" => Said("it is `length(vec2(x, y))`"),
        "cbrt" => Said("of a number from 0 on it is `pow(x, 1 / 3)`"),
        "rsqrt" | "inversesqrt" => Said("it is `1 / sqrt(x)`"),
        "radians" | "deg2rad" | "to_radians" => Said("it is `x * pi / 180`"),
        "degrees" | "rad2deg" | "to_degrees" => Said("it is `x * 180 / pi`"),
        "saturate" | "clamp01" => Said("it is `clamp(x, 0, 1)`"),
        "clip" => Written("clamp"),
        "smoothstep" => {
            Said("with `let t = clamp((x - a) / (b - a), 0, 1)` it is `t * t * (3 - 2 * t)`")
        }
        "step" => Said("`step(a, x)` is `if x < a { 0 } else { 1 }`"),
        "reflect" => Said("it is `d - 2 * dot(d, n) * n`"),
        "trace" => Said(
            "it is the sum of `(m * vec3(1, 0, 0)).x`, `(m * vec3(0, 1, 0)).y` and \
             `(m * vec3(0, 0, 1)).z`",
        ),
        "fmin" => Written("min"),
        "fmax" => Written("max"),
        _ => return of_floats(word),
    })
}

/// The function that C calls with an `f` behind its name: `sqrtf`.
fn of_floats(word: &str) -> Option<Here> {
    let name = word.strip_suffix('f')?;
    let (ours, _) = functions().find(|(ours, _)| *ours == name)?;
    let of_reals =
        |way: &Overload| way.wanted.iter().all(|wanted| *wanted == Wanted::Is(Type::Real));
    overloads(name).iter().all(of_reals).then_some(Written(ours))
}

fn sequence_called(word: &str) -> Option<Here> {
    let is_sequence = matches!(word, "vertices" | "halfedges" | "edges" | "faces" | "holes");
    is_sequence.then_some(Said("a sequence is written without parentheses: `for v in vertices`"))
}

/// The replacement of a foreign word used as a value or statement.
pub(super) fn name(word: &str) -> Option<Here> {
    Some(match word {
        "PI" | "Pi" | "M_PI" => Written("pi"),
        "inf" | "INF" | "Infinity" | "INFINITY" => Written("infinity"),
        "True" | "TRUE" => Written("true"),
        "False" | "FALSE" => Written("false"),
        "null" | "nil" | "None" | "none" | "nullptr" | "NULL" => NOTHING,
        _ if declares(word) => DECLARED,
        "switch" | "match" | "case" | "unless" => BRANCHED,
        "try" | "catch" | "except" => ASKED,
        "throw" | "raise" | "panic" => STOPPED,
        "pass" => Said("an empty block is `{ }`"),
        "import" | "include" => {
            Said("files are used at the head of a file: `use \"std/smooth.hedge\"`")
        }
        "math" | "Math" | "np" | "numpy" | "std" => {
            Said("functions and constants stand alone: `sqrt(x)`, `pi`")
        }
        "self" | "this" => {
            Said("there are no objects: an op is given its element, `op flip(e: edge)`")
        }
        "end" | "done" | "fi" => Said("a block ends with `}`"),
        "parallel" | "parfor" | "par" => PARALLEL,
        "foreach" | "do" | "until" | "loop" => VISITED,
        "mesh" | "bm" | "bmesh" | "geometry" | "geom" => Said(
            "a script has one mesh, which has no name: `vertices` and `edges` are its own; a test \
             begins with `mesh = cube()`",
        ),
        "num_vertices" | "n_vertices" | "num_faces" | "n_faces" | "num_edges" | "n_edges" => {
            COUNTED
        }
        "boundaries" | "boundary_loops" | "borders" | "boundary_cycles" => Written("holes"),
        "boundary_edges" | "border_edges" | "boundary_vertices" | "border_vertices"
        | "boundary_halfedges" => {
            Said("those on the boundary are chosen: `for e in edges where boundary(e) { … }`")
        }
        "echo" | "puts" | "printf" | "println" => PRINTED,
        "nan" | "NaN" | "NAN" => Said("what is not a number is asked by `is_nan(x)`"),
        _ => return None,
    })
}

/// True if other languages declare a variable with this word: `int x = 3`, `const x = 3`.
pub(super) fn declares(word: &str) -> bool {
    matches!(word, "const" | "auto" | "mut") || declared_type(word).is_some()
}

/// The type that such a word gives to a variable.
pub(super) fn declared_type(word: &str) -> Option<&'static str> {
    let mut ours = Type::ALL.into_iter().map(Type::word);
    type_word(word).or_else(|| ours.find(|ours| *ours == word))
}

/// The error with the fix for a call of a constant; any other call gives the error back.
pub(super) fn constant_called(
    error: Diagnostic,
    function: &Ident,
    args: &[tree::Expr],
    span: Span,
) -> Result<Diagnostic, Diagnostic> {
    let word = function.text.as_str();
    if !args.is_empty() || !CONSTANTS.iter().any(|(known, _)| *known == word) {
        return Err(error);
    }
    let error = error.saying(format!("`{word}` is a constant"));
    Ok(error.fix(format!("write `{word}`"), span, word))
}

/// Adds the replacement of the foreign `word` at `span` to `diagnostic`; if there is none, suggests
/// the closest of the `candidates`.
pub(super) fn tell<'a>(
    diagnostic: Diagnostic,
    (word, span): (&str, Span),
    here: Option<Here>,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    match here {
        Some(Written(ours)) => diagnostic.saying(format!("here it is written `{ours}`")).fix(
            format!("write `{ours}`"),
            span,
            ours,
        ),
        Some(Said(sentence)) => diagnostic.note(sentence),
        None => suggest(diagnostic, word, span, candidates),
    }
}
