//! The words of the language, each explained in a sentence.

use crate::diagram;
use crate::resolve::{function_words, signatures};

/// A word of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The ways to write it: `degree(vertex) -> int`, a line for each way.
    pub forms: Vec<String>,
    pub meaning: &'static str,
}

/// The meaning of each keyword, kind, property, pointer and aggregate; the functions have theirs in
/// their table.
pub const MEANINGS: &[(&str, &str)] = &[
    ("use", "takes in what another file declares: `use \"std/triangle.hedge\"`"),
    ("steps", "what an operation calls in place of a drawing, all or nothing: `steps { … }`"),
    (
        "private",
        "makes an op, function, script or attribute visible in its file only: `private fn weight(e: edge) { … }`; an attribute is then never saved",
    ),
    ("attr", "a value stored with each element of a kind: `attr weight: edge real = 1`"),
    (
        "inherited",
        "a default for what comes from nothing: other new halfedges, edges and faces take over the value of what they come from, `attr label: face int = inherited(0)`",
    ),
    (
        "fn",
        "a function: computes a value from elements and values, `fn size(e: edge) -> real { length(e) }`",
    ),
    ("op", "an operation, drawn before and after: `op flip(e: edge) { before { … } after { … } }`"),
    (
        "script",
        "a program that runs operations over a mesh: `script main() { for e in edges { flip(e) } }`",
    ),
    (
        "test",
        "a test: runs on small meshes, and asserts, `test \"a cube\" { mesh = cube()  assert count(faces) == 6 }`",
    ),
    (
        "keeps",
        "what the operation must be proved to keep, besides validity: `op flip(e: edge) keeps triangles { … }`",
    ),
    (
        "rule",
        "one alternative of an operation; they are tried in order: `rule border { before { … } after { … } }`",
    ),
    ("before", "the orbits that the operation matches"),
    ("after", "the orbits that the operation leaves"),
    (
        "require",
        "a condition asked before anything is written; where it fails the operation refuses, and changes nothing: `require degree(v) > 3 else \"too few edges\"`",
    ),
    (
        "guard",
        "the weakest tests, found by the compiler, that keep a mesh of this level one: `guard simple`",
    ),
    (
        "alias",
        "names that may stand for one element, `alias v0 v1`: the operation is proved for that too",
    ),
    (
        "face",
        "a cycle of `next` around an interior face, counterclockwise: `face f0: v0 -a-> v1 -b-> v2 -c-> v0`",
    ),
    ("loop", "a cycle of `next`: a face or a hole; in `after` it stays what it was"),
    ("edge", "a pair of twins: `edge e: a | d`"),
    ("vertex", "the spokes of a vertex, counterclockwise: `vertex v: a b *S`"),
    ("halfedge", "one side of an edge: it has `next`, `prev`, `twin`, `vertex`, `edge` and `face`"),
    (
        "outer halfedge",
        "a halfedge that stands in no loop of the drawing, only in an `edge` statement as the twin of one that does; what is behind it may be a face or a hole",
    ),
    ("each", "a cyclic pattern of any size: `face f: each i { v[i] -h[i]-> }`"),
    ("new", "lists what `after` adds: `new m e1 e2`"),
    ("keep", "states again, word for word, what `before` says of these names: `keep f0 e`"),
    (
        "erase",
        "lists what the operation removes: `erase v1 e a d`; a face alone is deleted by drawing its loop as a hole, `hole f: …`",
    ),
    ("let", "a variable that does not change: `let most = max(length(e) for e in edges)`"),
    ("var", "a variable that may change: `var n = 0`, then `n = n + 1`"),
    ("if", "chooses by a condition; `if let m = split(e)` by whether an operation applies"),
    ("else", "what is done otherwise; behind `require`, the reason of the refusal"),
    ("repeat", "does something a number of times: `repeat 5 { smooth() }`"),
    (
        "for",
        "visits the elements that exist when the loop starts, and still do when their turn comes: `for e in edges where boundary(e) { split(e) }`; or takes the ints of a range, without its end: `for i in 0..5 { print i }`",
    ),
    (
        "parallel",
        "before `for`, `parallel for e in edges where … { … }`: its `where` is tested for all elements before the first turn, on all threads if it only reads, and again when the turn of an element comes",
    ),
    ("in", "what is visited: `for v in f.vertices { … }`"),
    (
        "where",
        "which elements are visited, tested when their turn comes; of a `parallel for` also before the first turn",
    ),
    ("while", "goes on as long as a condition holds: `while n > 0 { n = n - 1 }`"),
    (
        "drain",
        "takes the element with the least key first, and keeps keys current: `drain e in edges by length(e) while count(faces) > 1000 { collapse(e) }`",
    ),
    ("by", "the key of a `drain`"),
    (
        "update",
        "reads old values everywhere, and writes all at the end: `update v in vertices { v.position = mean(w.position for w in v.neighbors) }`",
    ),
    (
        "must",
        "stops the script where the operation refuses: `must flip(e)`, `let m = must split(e)`",
    ),
    ("can", "whether an operation would apply: `can flip(e)` asks and writes nothing"),
    (
        "why",
        "why an operation would refuse, as a text: `why flip(e)` asks and writes nothing; the text is empty where it would apply",
    ),
    (
        "print",
        "prints values, separated by spaces: `print count(faces), \"faces\"`, `print \"v = {v}\"`",
    ),
    (
        "assert",
        "stops the script unless a condition holds: `assert count(holes) == 0 else \"it is open\"`",
    ),
    ("return", "ends the script, or gives the value of a function: `return length(e)`"),
    ("break", "ends the innermost loop"),
    ("continue", "goes on with the next turn of the innermost loop"),
    ("and", "both hold; the right one is asked only if the left one does"),
    ("or", "one of them holds; the right one is asked only if the left one does not"),
    ("not", "it does not hold"),
    ("div", "division of ints, rounded towards minus infinity"),
    ("mod", "what `div` leaves; it has the sign of the divisor"),
    ("true", "holds"),
    ("false", "does not hold"),
    ("refuses", "in a test, whether an operation refuses: `assert refuses(flip(e), \"…\")`"),
    ("load", "the mesh of a file beside the test: `mesh = load(\"cube.obj\")`"),
    ("mesh", "the mesh of a test: `mesh = cube()` makes it, `let start = mesh` keeps it"),
    ("full", "prints all digits of a number: `{x:full}`"),
    ("tetrahedron", "a mesh for tests: four triangles, closed"),
    ("cube", "a mesh for tests: six quads, closed"),
    ("octahedron", "a mesh for tests: eight triangles, closed"),
    ("icosahedron", "a mesh for tests: twenty triangles, closed"),
    (
        "icosphere",
        "a mesh for tests: an icosahedron, each triangle split in four so many times over",
    ),
    ("grid", "a mesh for tests: so many by so many unit squares in the plane"),
    ("triangle_grid", "a mesh for tests: a `grid` with each square cut in two"),
    ("torus", "a mesh for tests: so many by so many quads around a torus"),
    ("triangle_torus", "a mesh for tests: a `torus` with each quad cut in two"),
    ("cylinder", "a mesh for tests: so many quads around and so many along, open at both ends"),
    ("disk", "a mesh for tests: so many triangles around a vertex"),
    ("polygon", "a mesh for tests: one face with so many sides"),
    ("pillow", "a mesh for tests: two faces with so many sides, back to back"),
    ("x", "the first component of a vector, or column of a matrix"),
    ("y", "the second component of a vector, or column of a matrix"),
    ("z", "the third component of a vector, or column of a matrix"),
    ("w", "the fourth component of a vector, or column of a matrix"),
    ("next", "the halfedge that follows in the loop"),
    ("prev", "the halfedge that precedes in the loop"),
    ("twin", "the halfedge on the other side of the edge"),
    ("target", "the vertex where the halfedge ends"),
    ("position", "where a vertex is, a vector"),
    ("halfedges", "all halfedges, of the mesh, around a vertex or around a face"),
    ("vertices", "all vertices, of the mesh, of a face or of an edge"),
    ("edges", "all edges, of the mesh, at a vertex or around a face"),
    ("faces", "all faces, of the mesh, around a vertex or beside an edge"),
    ("holes", "all boundary loops of the mesh"),
    ("neighbors", "the other ends of the edges at a vertex"),
    (
        "ears",
        "of a face: halfedges at its corners, in an order in which they can be cut off, the best shaped triangle first, until one is left",
    ),
    (
        "patch",
        "of a face: as `ears`, such that the triangles bend little, with each other and with the faces around",
    ),
    (
        "level",
        "what a mesh is besides a map, whose orbits are in order: a `surface`, or `simple`; `guard simple` refuses what would lose it",
    ),
    (
        "manifold",
        "a mesh where every edge has two sides and every vertex one ring of spokes, as all meshes here; with more asked of it, a `surface`",
    ),
    (
        "orbit",
        "a cycle of `next` (a face or a hole), a pair of twins (an edge), or a ring of spokes (a vertex)",
    ),
    (
        "orientation",
        "faces run counterclockwise seen from outside, and the two halfedges of an edge run in opposite directions, so every mesh here is oriented; `--repair` turns the polygons of a file that are not",
    ),
    (
        "list",
        "there is none: values are kept at elements, `attr mark: vertex int = 0`; `for i in 0..n { … }` takes ints, and `drain` elements in an order",
    ),
    (
        "histogram",
        "counts, one by one: `for n in 3..9 { print \"{n}: {count(degree(v) == n for v in vertices)}\" }`; `hedgerow info` shows those of degrees and sides",
    ),
    ("spoke", "a halfedge that starts at the vertex"),
    ("path", "a run of zero or more halfedges of a loop: `v2 =P=> v0`"),
    ("fan", "a run of zero or more spokes of a vertex: `*S`, or `*` without a name"),
    (
        "family",
        "a name with a subscript: one element for each corner of a face or each spoke of a vertex, `v[i]`",
    ),
    ("map", "every orbit is in order: what is always proved"),
    ("surface", "a level: no face or hole with two sides, no vertex where the surface is pinched"),
    ("simple", "a level: edges and faces are told apart by their vertices"),
    ("triangles", "every face stays a triangle, if all were"),
    ("quads", "every face stays a quad, if all were"),
    ("euler", "V - E + F stays what it is, with holes among the faces"),
    ("constant_time", "the time does not grow with the mesh"),
    ("bool", "true or false"),
    ("int", "a whole number of 64 bits"),
    ("real", "a number with a fraction, of 64 bits"),
    ("vec2", "two reals"),
    ("vec3", "three reals: a point or a direction"),
    ("vec4", "four reals"),
    ("mat3", "three columns of three reals"),
    ("mat4", "four columns of four reals"),
    ("text", "letters in quotes"),
    ("pi", "half the circumference of the unit circle"),
    ("infinity", "more than any number"),
    ("shuffle", "visits a sequence in a random order: `for e in shuffle(edges) { flip(e) }`"),
    ("mean", "the mean of a value over a sequence: `mean(length(e) for e in edges)`"),
    ("sum", "the sum of a value over a sequence"),
    ("argmin", "the element with the least value: `argmin(length(e) for e in edges)`"),
    ("argmax", "the element with the greatest value"),
    ("count", "how many there are: `count(faces)`"),
    ("any", "whether a condition holds somewhere: `any(boundary(v) for v in vertices)`"),
    ("all", "whether a condition holds everywhere"),
];

/// The functions of the language, in the order in which they are explained.
pub fn functions() -> Vec<&'static str> {
    function_words().collect()
}

/// The explanation of a word of the language.
pub fn word(text: &str) -> Option<Word> {
    let forms = forms(text);
    let meaning = meaning(text);
    if meaning.is_none() && forms.is_empty() {
        return None;
    }
    Some(Word { forms, meaning: meaning.unwrap_or("") })
}

/// The meaning of a word, in a sentence.
pub fn meaning(text: &str) -> Option<&'static str> {
    let mut known = MEANINGS.iter().copied().chain(diagram::functions());
    known.find(|(word, _)| *word == text).map(|(_, meaning)| meaning)
}

/// The ways to call a function of the language.
fn forms(text: &str) -> Vec<String> {
    let ways = signatures(text).into_iter().map(|way| {
        let takes = way.takes.join(", ");
        match way.gives {
            Some(ty) => format!("{text}({takes}) -> {}", ty.word()),
            None => format!("{text}({takes})"),
        }
    });
    ways.collect()
}
