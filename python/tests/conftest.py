import numpy as np
import pytest

import hedgerow

OPS = """
use "std/triangle.hedge"
attr hits: edge int = 0
/// How far the number of neighbours of a vertex is from six.
fn excess(v: vertex) -> int { degree(v) - 6 }
fn gain(e: edge, scale: real = 1) -> real {
  scale * (excess(e.halfedge.vertex) + excess(e.halfedge.target))
}
fn along(e: edge) -> vec3 { e.halfedge.target.position - e.halfedge.vertex.position }
fn frame(v: vertex) -> mat3 { mat3(vec3(1, 2, 3), vec3(4, 5, 6), vec3(7, 8, v.position.x)) }
fn opposite(e: edge) -> vertex { e.halfedge.next.target }
fn total() -> real { sum(length(e) for e in edges) }
fn word(n: int) -> text { if n > 0 { "positive" } else { "not" } }
fn split_some(most: int) -> int {
  var done = 0
  for e in edges { if done < most { if split(e) { done = done + 1 } } }
  return done
}
/// Moves all vertices.
script move(by: vec3 = vec3(0, 0, 1), times: int = 1) {
  repeat times { for v in vertices { v.position = v.position + by } }
}
script shake(far: real) {
  for v in vertices { v.position = v.position + far * vec3(random(), random(), random()) }
}
script say(times: int) {
  repeat times { print "hello" }
  print "{count(faces)} faces"
}
script forever() { while count(faces) > 0 { for v in vertices { v.position = 1.0 * v.position } } }
script fails() {
  for v in vertices { v.position = 2 * v.position }
  assert count(faces) < 0 else "there are faces"
}
script count_hits() { for e in edges { e.hits = e.hits + 1 } }
"""


@pytest.fixture(scope="session")
def ops():
    return hedgerow.program(OPS, "ops.hedge")


@pytest.fixture
def sphere():
    return hedgerow.Mesh.icosphere(1)


@pytest.fixture
def rng():
    return np.random.default_rng(11)


def same_bytes(mesh, before):
    return mesh.to_bytes() == before
