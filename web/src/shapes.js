// What is computed of a mesh to show it: lengths, a coarser surface.

import * as THREE from 'three'

/** A round point. */
export function disc() {
  const canvas = Object.assign(document.createElement('canvas'), { width: 64, height: 64 })
  const context = canvas.getContext('2d')
  context.fillStyle = 'white'
  context.arc(32, 32, 31, 0, 7)
  context.fill()
  return new THREE.CanvasTexture(canvas)
}

/** The mean length of some of the edges. */
export function typicalLength({ positions, edges }) {
  const step = 2 * Math.max(1, Math.floor(edges.length / 2000))
  let [sum, number] = [0, 0]
  for (let at = 0; at + 1 < edges.length; at += step) {
    const [a, b] = [3 * edges[at], 3 * edges[at + 1]]
    sum += Math.hypot(
      positions[a] - positions[b], positions[a + 1] - positions[b + 1], positions[a + 2] - positions[b + 2])
    number += 1
  }
  return sum / (number || 1)
}

/**
 * A coarser surface of about so many triangles: vertices in one cell of a grid become one
 * (J. Rossignac and P. Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993).
 */
export function clustered(positions, triangles, most) {
  const box = new THREE.Box3()
  const point = new THREE.Vector3()
  for (let at = 0; at < positions.length; at += 3) box.expandByPoint(point.fromArray(positions, at))
  const size = box.getSize(new THREE.Vector3())
  // A closed surface meets about three cells for each square of a cell's side.
  const area = size.x * size.y + size.y * size.z + size.z * size.x
  const side = Math.sqrt(2 * area / (most / 2)) || 1
  const [wide, high] = [size.x, size.y].map(length => Math.ceil(length / side) + 1)
  const cells = new Map()
  const cell = new Uint32Array(positions.length / 3)
  const places = []
  for (let at = 0; at < cell.length; at++) {
    const [x, y, z] = [0, 1, 2].map(axis =>
      Math.floor((positions[3 * at + axis] - box.min.getComponent(axis)) / side))
    const key = x + wide * (y + high * z)
    let found = cells.get(key)
    if (found === undefined) {
      cells.set(key, found = places.length / 3)
      places.push(positions[3 * at], positions[3 * at + 1], positions[3 * at + 2])
    }
    cell[at] = found
  }
  const index = []
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [cell[triangles[at]], cell[triangles[at + 1]], cell[triangles[at + 2]]]
    if (a !== b && b !== c && c !== a) index.push(a, b, c)
  }
  const geometry = new THREE.BufferGeometry()
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3))
  geometry.setIndex(index)
  return geometry
}
