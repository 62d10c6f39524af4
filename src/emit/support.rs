//! The functions of the language in C++, written out where they are used.
//!
//! `[h.twin.next]` stands for pointers as the style reads them, `[v.position]` and
//! `[f.boundary]` for those; `$Vertex` and the like for types.

/// Each with its name. Those that a text calls stand before it.
pub(super) const FUNCTIONS: &[(&str, &str)] = &[
    (
        "prev",
        "\
/// The halfedge before h in its loop.
inline $Halfedge prev($Halfedge h) {
  $Halfedge p = h;
  while ([p.next] != h) p = [p.next];
  return p;
}",
    ),
    (
        "spokes",
        "\
/// The halfedges that start at v, counterclockwise.
inline std::vector<$Halfedge> spokes($Vertex v) {
  std::vector<$Halfedge> all;
  $Halfedge h = [v.halfedge];
  do {
    all.push_back(h);
    h = [h.twin.next];  // clockwise: no halfedge knows the one before it
  } while (h != [v.halfedge]);
  std::reverse(all.begin() + 1, all.end());
  return all;
}",
    ),
    (
        "halfedges",
        "\
/// The halfedges of f, counterclockwise.
inline std::vector<$Halfedge> halfedges($Face f) {
  std::vector<$Halfedge> all;
  $Halfedge h = [f.halfedge];
  do {
    all.push_back(h);
    h = [h.next];
  } while (h != [f.halfedge]);
  return all;
}",
    ),
    (
        "neighbors",
        "\
/// The vertices at the other ends of the edges of v.
inline std::vector<$Vertex> neighbors($Vertex v) {
  std::vector<$Vertex> all;
  for ($Halfedge h : spokes(v)) all.push_back([h.twin.vertex]);
  return all;
}",
    ),
    (
        "edges_of_vertex",
        "\
/// The edges at v.
inline std::vector<$Edge> edges_of_vertex($Vertex v) {
  std::vector<$Edge> all;
  for ($Halfedge h : spokes(v)) all.push_back([h.edge]);
  return all;
}",
    ),
    (
        "faces_of_vertex",
        "\
/// The faces around v, without holes.
inline std::vector<$Face> faces_of_vertex($Vertex v) {
  std::vector<$Face> all;
  for ($Halfedge h : spokes(v)) {
    if (![h.face.boundary]) all.push_back([h.face]);
  }
  return all;
}",
    ),
    (
        "vertices",
        "\
/// The corners of f.
inline std::vector<$Vertex> vertices($Face f) {
  std::vector<$Vertex> all;
  for ($Halfedge h : halfedges(f)) all.push_back([h.vertex]);
  return all;
}",
    ),
    (
        "edges_of_face",
        "\
/// The edges of f.
inline std::vector<$Edge> edges_of_face($Face f) {
  std::vector<$Edge> all;
  for ($Halfedge h : halfedges(f)) all.push_back([h.edge]);
  return all;
}",
    ),
    (
        "ends",
        "\
/// The two ends of e.
inline std::vector<$Vertex> ends($Edge e) {
  return {[e.halfedge.vertex], [e.halfedge.twin.vertex]};
}",
    ),
    (
        "faces_of_edge",
        "\
/// The faces at e, without holes.
inline std::vector<$Face> faces_of_edge($Edge e) {
  std::vector<$Face> all;
  for ($Face f : {[e.halfedge.face], [e.halfedge.twin.face]}) {
    if (![f.boundary]) all.push_back(f);
  }
  return all;
}",
    ),
    (
        "degree",
        "\
/// The number of edges at v.
inline int degree($Vertex v) {
  int count = 0;
  $Halfedge h = [v.halfedge];
  do {
    ++count;
    h = [h.twin.next];
  } while (h != [v.halfedge]);
  return count;
}",
    ),
    (
        "sides",
        "\
/// The number of sides of f.
inline int sides($Face f) {
  int count = 0;
  $Halfedge h = [f.halfedge];
  do {
    ++count;
    h = [h.next];
  } while (h != [f.halfedge]);
  return count;
}",
    ),
    (
        "on_boundary",
        "\
/// Whether a hole lies around v.
inline bool on_boundary($Vertex v) {
  $Halfedge h = [v.halfedge];
  do {
    if ([h.face.boundary]) return true;
    h = [h.twin.next];
  } while (h != [v.halfedge]);
  return false;
}",
    ),
    (
        "is_boundary_edge",
        "\
/// Whether a hole lies on a side of e.
inline bool is_boundary_edge($Edge e) {
  return [e.halfedge.face.boundary] || [e.halfedge.twin.face.boundary];
}",
    ),
    (
        "adjacent",
        "\
/// Whether an edge joins v and w.
inline bool adjacent($Vertex v, $Vertex w) {
  $Halfedge h = [v.halfedge];
  do {
    if ([h.twin.vertex] == w) return true;
    h = [h.twin.next];
  } while (h != [v.halfedge]);
  return false;
}",
    ),
    (
        "link_condition",
        "\
/// Whether contracting e, and the triangles at it, leaves a simple mesh simple: its ends share
/// the tips of the triangles at e and no other neighbor, both lie on the boundary only if e
/// does, and neither a tetrahedron nor a single triangle is folded up.
inline bool link_condition($Edge e) {
  $Halfedge h = [e.halfedge];
  $Vertex a = [h.vertex];
  $Vertex b = [h.twin.vertex];
  std::vector<$Vertex> tips;
  for ($Halfedge side : {h, [h.twin]}) {
    if ([side.face.boundary]) continue;
    if ([side.next.next.next] != side) return false;
    tips.push_back([side.next.next.vertex]);
  }
  if (tips.empty() || a == b) return false;
  if (tips.size() == 2 && tips[0] == tips[1]) return false;
  bool a_inside = !on_boundary(a);
  bool b_inside = !on_boundary(b);
  if (tips.size() == 2 && !a_inside && !b_inside) return false;
  std::vector<$Vertex> around = neighbors(a);
  std::size_t common = 0;
  for ($Vertex v : neighbors(b)) common += holds(around, v);
  if (common != tips.size()) return false;
  if (tips.size() == 2) return !(a_inside && b_inside && degree(a) == 3 && degree(b) == 3);
  $Halfedge hole = [h.face.boundary] ? h : [h.twin];
  return [hole.next.next.next] != hole;
}",
    ),
    (
        "dot",
        "\
inline $real dot($Vector a, $Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }",
    ),
    (
        "cross",
        "\
inline $Vector cross($Vector a, $Vector b) {
  return $Vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}",
    ),
    (
        "length",
        "\
inline $real length($Vector a) { return std::sqrt(dot(a, a)); }",
    ),
    (
        "normalize",
        "\
/// The direction of a, or zero.
inline $Vector normalize($Vector a) {
  $real size = length(a);
  return size > 0 ? a / size : $Vector(0, 0, 0);
}",
    ),
    (
        "angle",
        "\
/// The angle between a and b.
inline $real angle($Vector a, $Vector b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}",
    ),
    (
        "multiply",
        "\
inline $Vector multiply($Vector a, $Vector b) { return $Vector(a.x * b.x, a.y * b.y, a.z * b.z); }",
    ),
    (
        "equal",
        "\
inline bool equal($Vector a, $Vector b) { return a.x == b.x && a.y == b.y && a.z == b.z; }",
    ),
    (
        "is_finite",
        "\
inline bool is_finite($Vector a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}",
    ),
    (
        "mix",
        "\
/// a for t = 0, b for t = 1.
template <class T>
T mix(T a, T b, $real t) { return a * (1 - t) + b * t; }",
    ),
    (
        "midpoint",
        "\
inline $Vector midpoint($Edge e) {
  $Vertex v = [e.halfedge.vertex];
  $Vertex w = [e.halfedge.twin.vertex];
  return mix([v.position], [w.position], 0.5);
}",
    ),
    (
        "edge_vector",
        "\
/// From where h starts to where it ends.
inline $Vector edge_vector($Halfedge h) {
  $Vertex v = [h.vertex];
  $Vertex w = [h.twin.vertex];
  return [w.position] - [v.position];
}",
    ),
    (
        "vector_area",
        "\
/// Normal to f, as long as its area: half the sum of cross products around the loop.
inline $Vector vector_area($Face f) {
  $Vertex first = [f.halfedge.vertex];
  $Vector total(0, 0, 0);
  $Vector last(0, 0, 0);
  for ($Vertex v : vertices(f)) {
    $Vector at = [v.position] - [first.position];
    total = total + cross(last, at);
    last = at;
  }
  return total / 2;
}",
    ),
    (
        "vertex_normal",
        "\
/// The mean of the normals of the faces around v, weighted by area.
inline $Vector vertex_normal($Vertex v) {
  $Vector total(0, 0, 0);
  for ($Face f : faces_of_vertex(v)) total = total + vector_area(f);
  return normalize(total);
}",
    ),
    (
        "centroid",
        "\
/// The mean of the corners of f.
inline $Vector centroid($Face f) {
  $Vector total(0, 0, 0);
  std::vector<$Vertex> corners = vertices(f);
  for ($Vertex v : corners) total = total + [v.position];
  return total / static_cast<$real>(corners.size());
}",
    ),
    (
        "floor_div",
        "\
/// a / b, rounded down.
inline long long floor_div(long long a, long long b) {
  if (b == 0) throw std::domain_error(\"division by zero\");
  return a / b - (a % b != 0 && (a < 0) != (b < 0));
}",
    ),
    (
        "floor_mod",
        "\
/// The rest of a / b, with the sign of b.
inline long long floor_mod(long long a, long long b) { return a - b * floor_div(a, b); }",
    ),
    (
        "in_order_along_loop",
        "\
/// Whether b comes before c on the way along the loop from a.
inline bool in_order_along_loop($Halfedge a, $Halfedge b, $Halfedge c) {
  $Halfedge h = a;
  do {
    if (h == b) return true;
    h = [h.next];
  } while (h != c && h != a);
  return false;
}",
    ),
    (
        "in_order_around_vertex",
        "\
/// Whether b comes before c on the way around the vertex from a, counterclockwise.
inline bool in_order_around_vertex($Halfedge a, $Halfedge b, $Halfedge c) {
  $Halfedge h = a;
  do {
    if (h == b) return true;
    h = [prev(h).twin];
  } while (h != c && h != a);
  return false;
}",
    ),
    (
        "holds",
        "\
/// Whether one of all is x.
template <class T>
bool holds(const std::vector<T>& all, T x) {
  return std::find(all.begin(), all.end(), x) != all.end();
}",
    ),
    (
        "all_differ",
        "\
/// Whether nothing stands twice in all.
template <class T>
bool all_differ(const std::vector<T>& all) {
  for (auto it = all.begin(); it != all.end(); ++it) {
    if (std::find(all.begin(), it, *it) != it) return false;
  }
  return true;
}",
    ),
    (
        "same_elements",
        "\
/// Whether a and b hold the same.
template <class T>
bool same_elements(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}",
    ),
    (
        "only",
        "\
/// Those of all for which the condition holds.
template <class T, class C>
std::vector<T> only(const std::vector<T>& all, C condition) {
  std::vector<T> some;
  for (T x : all) {
    if (condition(x)) some.push_back(x);
  }
  return some;
}",
    ),
    (
        "count",
        "\
/// For how many of all the condition holds.
template <class T, class C>
long long count(const std::vector<T>& all, C condition) {
  return std::count_if(all.begin(), all.end(), condition);
}",
    ),
    (
        "any",
        "\
/// Whether the condition holds for one of all.
template <class T, class C>
bool any(const std::vector<T>& all, C condition) {
  return std::any_of(all.begin(), all.end(), condition);
}",
    ),
    (
        "all",
        "\
/// Whether the condition holds for all.
template <class T, class C>
bool all(const std::vector<T>& all, C condition) {
  return std::all_of(all.begin(), all.end(), condition);
}",
    ),
    (
        "sum",
        "\
/// The sum of the values of all.
template <class R, class T, class V>
R sum(const std::vector<T>& all, R zero, V value) {
  R total = zero;
  for (T x : all) total = total + value(x);
  return total;
}",
    ),
    (
        "mean",
        "\
/// The mean of the values of all.
template <class R, class T, class V>
R mean(const std::vector<T>& all, R zero, V value) {
  if (all.empty()) throw std::domain_error(\"the mean of nothing\");
  return sum(all, zero, value) / static_cast<$real>(all.size());
}",
    ),
    (
        "least",
        "\
/// The least of the values of all.
template <class R, class T, class V>
R least(const std::vector<T>& all, R, V value) {
  if (all.empty()) throw std::domain_error(\"the least of nothing\");
  R best = value(all.front());
  for (T x : all) best = std::min<R>(best, value(x));
  return best;
}",
    ),
    (
        "greatest",
        "\
/// The greatest of the values of all.
template <class R, class T, class V>
R greatest(const std::vector<T>& all, R, V value) {
  if (all.empty()) throw std::domain_error(\"the greatest of nothing\");
  R best = value(all.front());
  for (T x : all) best = std::max<R>(best, value(x));
  return best;
}",
    ),
];

/// The text of a function.
fn text(name: &str) -> Option<&'static str> {
    let found = FUNCTIONS.iter().find(|(known, _)| *known == name);
    found.map(|(_, text)| *text)
}

/// The names of the functions that these need, themselves included, each behind those it calls.
pub(super) fn needed(names: &[&'static str]) -> Vec<&'static str> {
    let mut order = Vec::new();
    for &name in names {
        need(name, &mut order);
    }
    order
}

fn need(name: &'static str, order: &mut Vec<&'static str>) {
    if order.contains(&name) {
        return;
    }
    let body = text(name).unwrap_or("");
    for (other, _) in FUNCTIONS {
        if *other != name && calls(body, other) {
            need(other, order);
        }
    }
    order.push(name);
}

/// Whether a text calls a function: its name as a whole word, with a bracket behind it.
fn calls(text: &str, name: &str) -> bool {
    let call = format!("{name}(");
    text.match_indices(&call).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        !before.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_' || c == ':' || c == '.')
    })
}

/// The text of a function with its pointers and types spelled.
pub(super) fn spelled(
    name: &str,
    chain: &dyn Fn(&str, &str) -> String,
    ty: &dyn Fn(&str) -> String,
) -> String {
    let mut out = String::new();
    let mut rest = text(name).unwrap_or("");
    while let Some(at) = rest.find(['[', '$']) {
        out.push_str(&rest[..at]);
        if rest[at..].starts_with('$') {
            let word = &rest[at + 1..];
            let end = word
                .find(|c: char| !c.is_ascii_alphabetic())
                .unwrap_or(word.len());
            out.push_str(&ty(&word[..end]));
            rest = &word[end..];
            continue;
        }
        let inside = &rest[at + 1..];
        let end = inside.find(']').unwrap_or(inside.len());
        match inside[..end].split_once('.') {
            // A chain of pointers; a lambda or an index is left alone.
            Some((of, pointers)) => {
                let mut term = of.to_string();
                for pointer in pointers.split('.') {
                    term = chain(&term, pointer);
                }
                out.push_str(&term);
                rest = inside.get(end + 1..).unwrap_or("");
            }
            None => {
                out.push('[');
                rest = inside;
            }
        }
    }
    qualified(name, &(out + rest))
}

/// Calls of the other functions get their namespace, or C++ would look elsewhere too.
fn qualified(name: &str, text: &str) -> String {
    let mut text = text.to_string();
    for (other, _) in FUNCTIONS.iter().filter(|(other, _)| *other != name) {
        let call = format!("{other}(");
        let mut from = 0;
        while let Some(found) = text[from..].find(&call) {
            let at = from + found;
            from = at + call.len();
            if calls(&text[at.saturating_sub(1)..from], other) {
                text.insert_str(at, "hedgerow::");
                from += "hedgerow::".len();
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_stand_behind_what_they_call() {
        let order = needed(&["link_condition", "vertex_normal"]);
        let at = |name: &str| order.iter().position(|known| *known == name);
        assert!(at("spokes") < at("neighbors") && at("neighbors") < at("link_condition"));
        assert!(at("holds") < at("link_condition") && at("holds").is_some());
        assert!(at("cross") < at("vector_area") && at("normalize") < at("vertex_normal"));
        assert_eq!(at("mean"), None);
    }
}
