// What lines, points, arrows and labels are made of.

import * as THREE from 'three'
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js'
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js'
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js'
import { CSS2DObject } from 'three/examples/jsm/renderers/CSS2DRenderer.js'
import { disc } from './shapes.js'

/** More lines than this are drawn thin. */
export const FAT = 30_000

export class Pen {
  /** A pen for a view: an element and what draws into it. */
  constructor(view, renderer) {
    this.view = view
    this.renderer = renderer
    this.disc = disc()
  }

  /** Lines of so many pixels between pairs of points. */
  segments(ends, colour, width, { onTop = false, colours = null } = {}) {
    if (ends.length / 6 > FAT) {
      const geometry = new THREE.BufferGeometry()
      geometry.setAttribute('position', new THREE.BufferAttribute(ends, 3))
      return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }))
    }
    const geometry = new LineSegmentsGeometry().setPositions(ends)
    if (colours) geometry.setColors(colours)
    const lines = new LineSegments2(geometry, new LineMaterial({
      color: colour, linewidth: width, depthTest: !onTop, transparent: onTop, vertexColors: !!colours,
    }))
    lines.material.resolution.set(this.view.clientWidth, this.view.clientHeight)
    lines.renderOrder = onTop ? 2 : 1
    return lines
  }

  /** Round points of so many pixels. */
  points(places, colour, size, { onTop = false } = {}) {
    const geometry = new THREE.BufferGeometry()
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3))
    const points = new THREE.Points(geometry, new THREE.PointsMaterial({
      color: colour, size: size * this.renderer.getPixelRatio(), sizeAttenuation: false,
      map: this.disc, ...onTop ? { depthTest: false, transparent: true } : { alphaTest: 0.5 },
    }))
    points.renderOrder = onTop ? 3 : 0
    return points
  }

  /** A triangle in front of the mesh. */
  triangle(corners, colour) {
    const geometry = new THREE.BufferGeometry().setFromPoints(corners)
    const triangle = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      color: colour, side: THREE.DoubleSide, depthTest: false, transparent: true,
    }))
    triangle.renderOrder = 2
    return triangle
  }

  /** A halfedge as an arrow with half a head, on the side where its face lies. */
  arrow([from, to], inside, colour, width) {
    const [a, b] = [new THREE.Vector3(...from), new THREE.Vector3(...to)]
    const way = b.clone().sub(a)
    const aside = new THREE.Vector3(...inside).sub(a).sub(way.clone().multiplyScalar(0.5))
    aside.addScaledVector(way, -aside.dot(way) / (way.lengthSq() || 1))
    aside.normalize().multiplyScalar(way.length() * 0.06)
    const back = b.clone().addScaledVector(way, -0.15)
    const line = Float32Array.from([...from, ...to])
    return [
      this.segments(line, colour, width, { onTop: true }),
      this.triangle([b, back.clone().add(aside), back], colour),
    ]
  }

  /** A text at a place. */
  label(text, place, colour, kind, size) {
    const label = document.createElement('span')
    label.className = `label ${kind}`
    label.textContent = text
    Object.assign(label.style, { color: colour, fontSize: `${size}px` })
    const object = new CSS2DObject(label)
    object.position.fromArray(place)
    return object
  }
}
