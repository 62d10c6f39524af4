// Which element is meant by a point of the view.

import * as THREE from 'three'

/**
 * The element of a kind at a point of a view, from -1 to 1 both ways, or null. `surface` holds the
 * triangles of the mesh; `size` is that of the view.
 */
export function pick(mesh, kind, point, { camera, surface, size: [width, height] }) {
  const caster = new THREE.Raycaster()
  caster.setFromCamera(point, camera)
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })
  const [hit] = caster.intersectObject(new THREE.Mesh(surface, material))
  if (!hit) return null
  const { arrays } = mesh
  const face = arrays.faces[hit.faceIndex]
  if (kind === 'face') return { kind, index: face }
  const sides = sidesOf(mesh, face)
  const scaled = ({ x, y }) => new THREE.Vector2(x * width, y * height).multiplyScalar(0.5)
  const here = scaled(point)
  const near = vertex => scaled(new THREE.Vector3().fromArray(arrays.positions, 3 * vertex).project(camera))
  if (kind === 'vertex') {
    const corners = new Set(sides.flatMap(at => [arrays.edges[2 * at], arrays.edges[2 * at + 1]]))
    const index = least([...corners], vertex => near(vertex).distanceTo(here))
    return index === undefined ? null : { kind, index }
  }
  const at = least(sides, at => {
    const [a, b] = [near(arrays.edges[2 * at]), near(arrays.edges[2 * at + 1])]
    const way = b.clone().sub(a)
    const along = Math.min(1, Math.max(0, here.clone().sub(a).dot(way) / (way.lengthSq() || 1)))
    return a.addScaledVector(way, along).distanceTo(here)
  })
  if (at === undefined) return null
  if (kind === 'edge') return { kind, index: arrays.edgeIds[at] }
  const side = arrays.edgeFaces[2 * at] === face ? 0 : 1
  return { kind: 'halfedge', index: arrays.halfedges[2 * at + side] }
}

/** The edges of a face, by their places among the edges. */
function sidesOf(mesh, face) {
  if (!mesh.sides) {
    mesh.sides = new Map()
    mesh.arrays.edgeFaces.forEach((face, at) => {
      if (!mesh.sides.has(face)) mesh.sides.set(face, [])
      mesh.sides.get(face).push(at >> 1)
    })
  }
  return mesh.sides.get(face) ?? []
}

function least(list, measure) {
  let [found, shortest] = [undefined, Infinity]
  for (const item of list) {
    const size = measure(item)
    if (size < shortest) [found, shortest] = [item, size]
  }
  return found
}
