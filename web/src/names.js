// Names of an operation on the mesh, and pointers that contradict each other.

import * as THREE from 'three'

/** The colours of the diagrams. */
const FATES = { kept: '#334155', reassigned: '#2563eb', new: '#15803d', erased: '#dc2626' }
const DARK_FATES = { kept: '#cbd5e1', reassigned: '#7cb0ff', new: '#5fd08a', erased: '#ff8a80' }

/** Names at elements, `[name, { kind, at, line }, fate]` each; `length` is that of an edge in pixels. */
export function drawNames(pen, names, { isDark, length }) {
  const fates = isDark ? DARK_FATES : FATES
  // On small faces lines and letters are smaller; names for which there is no room are left out.
  const size = Math.min(1, Math.max(0.45, length / 110))
  const drawn = []
  for (const [name, element, fate] of names) {
    const colour = fates[fate] ?? fates.kept
    if (!element.line.length) continue
    const flat = Float32Array.from(element.line.flat())
    if (element.kind === 'halfedge') {
      drawn.push(...pen.arrow(element.line, element.at, colour, 3 * size))
    } else if (element.kind === 'edge') {
      drawn.push(pen.segments(flat, colour, 3.5 * size, { onTop: true }))
    } else if (element.kind === 'vertex') {
      drawn.push(pen.points(flat, colour, 11 * size, { onTop: true }))
    }
    const room = { vertex: 0, face: 0, halfedge: 38, edge: 55 }[element.kind]
    if (length < room) continue
    drawn.push(pen.label(name, element.at, colour, `label-${element.kind}`, Math.max(11, 16 * size)))
  }
  return drawn
}

/** Broken pointers, `{ from, pointer, to }` each, with the places of both, as arcs around a box. */
export function drawPointers(pen, pointers, { isDark, box, camera }) {
  const colour = (isDark ? DARK_FATES : FATES).erased
  const middle = box.getCenter(new THREE.Vector3())
  const size = box.getSize(new THREE.Vector3()).length() || 1
  return pointers.flatMap(({ from, pointer, to }, at) => {
    const drawn = []
    const [a, b] = [from.at, to.at].map(place => new THREE.Vector3(...place))
    for (const { line, at: place, kind } of [from, to]) {
      if (kind === 'halfedge') drawn.push(...pen.arrow(line, place, colour, 3.5))
    }
    // An arc away from the mesh, so that two of them do not lie on each other.
    const out = a.clone().add(b).multiplyScalar(0.5).sub(middle)
    const way = camera.position.clone().sub(middle).normalize()
    const bend = out.normalize().addScaledVector(way, 1).multiplyScalar(size * (0.16 + 0.1 * at))
    const top = a.clone().add(b).multiplyScalar(0.5).add(bend)
    const points = new THREE.QuadraticBezierCurve3(a, top, b).getPoints(24)
    const ends = points.slice(1).flatMap((point, at) => [...points[at].toArray(), ...point.toArray()])
    drawn.push(pen.segments(Float32Array.from(ends), colour, 2, { onTop: true }))
    const [before] = points.slice(-3)
    const back = before.clone().sub(b)
    const aside = back.clone().cross(way).normalize().multiplyScalar(size * 0.018)
    const tip = b.clone().addScaledVector(back.normalize(), size * 0.05)
    drawn.push(pen.triangle([b, tip.clone().add(aside), tip.sub(aside)], colour))
    drawn.push(pen.label(pointer, points[12].toArray(), colour, 'label-pointer', 14))
    return drawn
  })
}
