// The mesh in 3D: faces, edges, what is marked on them, and which element somebody points at.

import * as THREE from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js'
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js'
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js'
import { CSS2DObject, CSS2DRenderer } from 'three/examples/jsm/renderers/CSS2DRenderer.js'

/** The colours of S. van der Walt and N. Smith, "A better default colormap for Matplotlib", 2015. */
const VIRIDIS = [
  0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725,
].map(colour => new THREE.Color(colour))

/** The colours of the diagrams. */
const FATES = { kept: '#334155', reassigned: '#2563eb', new: '#15803d', erased: '#dc2626' }
const DARK_FATES = { kept: '#cbd5e1', reassigned: '#7cb0ff', new: '#5fd08a', erased: '#ff8a80' }

/** Meshes with more triangles than this are not looked at under a moving pointer. */
const QUICK = 60_000
/** More marks than this are drawn thin. */
const FAT = 30_000

/** The arrays of an answer, by name. */
export function arraysOf(json, bytes) {
  const arrays = {}
  let at = bytes.byteOffset
  for (const { name, type, length } of json.arrays) {
    arrays[name] = new (type === 'f32' ? Float32Array : Uint32Array)(bytes.buffer, at, length)
    at += 4 * length
  }
  return arrays
}

export class Scene {
  /** Called with an element when somebody clicks one, or points at one; with null beside all. */
  onClick = () => {}
  onPoint = () => {}
  /** The kind of the elements that are pointed at. */
  kind = 'edge'
  #mesh = null
  #box = new THREE.Box3()
  #dirty = true
  #dark = matchMedia('(prefers-color-scheme: dark)')

  constructor(parent) {
    this.parent = parent
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true })
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.labels = new CSS2DRenderer()
    this.labels.domElement.className = 'labels'
    parent.append(this.renderer.domElement, this.labels.domElement)
    const canvas = this.renderer.domElement
    canvas.tabIndex = 0
    canvas.setAttribute('role', 'img')
    this.scene = new THREE.Scene()
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000)
    this.camera.position.set(1.6, 1.3, 3)
    this.light = new THREE.DirectionalLight(0xffffff, 2.2)
    this.scene.add(this.light, new THREE.HemisphereLight(0xffffff, 0x8899aa, 1.6))
    this.controls = new OrbitControls(this.camera, canvas)
    this.controls.addEventListener('change', () => this.#wake())
    this.base = new THREE.Group()
    this.marks = new THREE.Group()
    this.names = new THREE.Group()
    this.scene.add(this.base, this.marks, this.names)
    new ResizeObserver(() => this.#resize()).observe(parent)
    this.#dark.addEventListener('change', () => this.#mesh && this.show(this.#mesh))
    this.#listen(canvas)
    const frame = () => {
      requestAnimationFrame(frame)
      if (this.#dirty) this.#draw()
    }
    frame()
  }

  #wake() {
    this.#dirty = true
  }

  #draw() {
    this.#dirty = false
    this.light.position.copy(this.camera.position).add(new THREE.Vector3(0.4, 1, 0.2))
    this.renderer.render(this.scene, this.camera)
    this.labels.render(this.scene, this.camera)
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.parent
    if (!width || !height) return
    this.renderer.setSize(width, height)
    this.labels.setSize(width, height)
    this.camera.aspect = width / height
    this.camera.updateProjectionMatrix()
    for (const part of [...this.marks.children, ...this.names.children, ...this.base.children]) {
      part.material?.resolution?.set(width, height)
    }
    this.#wake()
  }

  /** Shows a mesh: the answer to `view`, and its arrays. */
  show(mesh) {
    this.#mesh = mesh
    clear(this.base)
    const { arrays, json } = mesh
    const dark = this.#dark.matches
    const positions = new THREE.BufferAttribute(arrays.positions, 3)
    const surface = new THREE.BufferGeometry()
    surface.setAttribute('position', positions)
    surface.setIndex(new THREE.BufferAttribute(arrays.triangles, 1))
    const coloured = this.#colour(surface, arrays, json.valuesOf)
    this.faces = new THREE.Mesh(coloured ?? surface, new THREE.MeshStandardMaterial({
      color: coloured || json.valuesOf === 'edge' ? 0xffffff : dark ? 0x7fa3cf : 0xb2cdec,
      vertexColors: !!coloured, flatShading: true, side: THREE.DoubleSide, roughness: 0.75,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }))
    this.picked = surface
    const edges = new THREE.BufferGeometry()
    edges.setAttribute('position', positions)
    edges.setIndex(new THREE.BufferAttribute(arrays.edges, 1))
    const lines = new THREE.LineBasicMaterial({
      color: dark ? 0x0b1220 : 0x1f2937, transparent: true,
      opacity: Math.min(0.85, Math.max(0.12, 3000 / Math.sqrt(arrays.edges.length + 1) / 10)),
    })
    this.base.add(this.faces, new THREE.LineSegments(edges, lines))
    const border = []
    for (let at = 0; at < arrays.edgeIsBoundary.length; at++) {
      if (arrays.edgeIsBoundary[at]) border.push(at)
    }
    if (border.length) this.base.add(this.#segments(this.#ends(border), 0xd9480f, 2.5))
    if (arrays.loose.length) this.base.add(this.#points(arrays.loose, 0xd9480f, 7))
    this.clearMarks()
    this.#wake()
  }

  /** Puts the whole mesh into the middle of the view. */
  frame() {
    if (!this.#mesh) return
    this.#box.makeEmpty()
    const { positions, edges } = this.#mesh.arrays
    const point = new THREE.Vector3()
    for (const vertex of edges) {
      this.#box.expandByPoint(point.fromArray(positions, 3 * vertex))
    }
    if (this.#box.isEmpty()) return
    const sphere = this.#box.getBoundingSphere(new THREE.Sphere())
    const radius = sphere.radius || 1
    const way = this.camera.position.clone().sub(this.controls.target).normalize()
    this.controls.target.copy(sphere.center)
    const aspect = Math.min(1, this.camera.aspect)
    const far = radius / Math.sin(THREE.MathUtils.degToRad(this.camera.fov / 2)) / aspect
    this.camera.position.copy(sphere.center).addScaledVector(way, far * 1.05)
    this.camera.near = radius / 200
    this.camera.far = radius * 60
    this.camera.updateProjectionMatrix()
    this.controls.update()
    this.#wake()
  }

  /** Colours for values: a geometry with them, or nothing. */
  #colour(surface, arrays, kind) {
    const { values, faces, triangles } = arrays
    if (!values || !['vertex', 'face'].includes(kind)) return null
    let [low, high] = [Infinity, -Infinity]
    for (const value of values) {
      if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)]
    }
    this.range = [low, high]
    const geometry = kind === 'face' ? surface.toNonIndexed() : surface.clone()
    const count = geometry.attributes.position.count
    const colours = new Float32Array(3 * count)
    for (let at = 0; at < count; at++) {
      const of = kind === 'face' ? faces[Math.floor(at / 3)] : at
      viridis((values[of] - low) / (high - low)).toArray(colours, 3 * at)
    }
    geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3))
    return geometry
  }

  /** The ends of edges, by their places among the edges. */
  #ends(places) {
    const { positions, edges } = this.#mesh.arrays
    const ends = new Float32Array(6 * places.length)
    places.forEach((place, at) => {
      for (const side of [0, 1]) {
        const vertex = 3 * edges[2 * place + side]
        ends.set(positions.subarray(vertex, vertex + 3), 6 * at + 3 * side)
      }
    })
    return ends
  }

  #segments(ends, colour, width, onTop = false) {
    const material = { color: colour, linewidth: width, depthTest: !onTop, transparent: onTop }
    if (ends.length / 6 > FAT) {
      const geometry = new THREE.BufferGeometry()
      geometry.setAttribute('position', new THREE.BufferAttribute(ends, 3))
      return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }))
    }
    const lines = new LineSegments2(
      new LineSegmentsGeometry().setPositions(ends), new LineMaterial(material))
    lines.material.resolution.set(this.parent.clientWidth, this.parent.clientHeight)
    lines.renderOrder = onTop ? 2 : 1
    return lines
  }

  #points(vertices, colour, size) {
    const { positions } = this.#mesh.arrays
    const places = new Float32Array(3 * vertices.length)
    vertices.forEach((vertex, at) => {
      places.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * at)
    })
    const geometry = new THREE.BufferGeometry()
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3))
    return new THREE.Points(geometry, new THREE.PointsMaterial({
      color: colour, size: size * this.renderer.getPixelRatio(), sizeAttenuation: false,
    }))
  }

  clearMarks() {
    clear(this.marks)
    this.clearNames()
  }

  clearNames() {
    clear(this.names)
    this.#wake()
  }

  /** Marks the elements of a kind for which `mask[id]` is 1. */
  markPlaces(kind, mask) {
    clear(this.marks)
    const { arrays } = this.#mesh
    const colour = this.#dark.matches ? 0x4ade80 : 0x16a34a
    if (kind === 'edge' || kind === 'halfedge') {
      const places = []
      arrays.edgeIds.forEach((id, at) => {
        const here = kind === 'edge'
          ? mask[id] === 1
          : mask[arrays.halfedges[2 * at]] === 1 || mask[arrays.halfedges[2 * at + 1]] === 1
        if (here) places.push(at)
      })
      if (places.length) this.marks.add(this.#segments(this.#ends(places), colour, 2.5))
    } else if (kind === 'vertex') {
      const vertices = []
      mask.forEach((verdict, id) => verdict === 1 && vertices.push(id))
      if (vertices.length) this.marks.add(this.#points(Uint32Array.from(vertices), colour, 8))
    } else if (kind === 'face') {
      const index = []
      arrays.faces.forEach((face, at) => {
        if (mask[face] === 1) index.push(...arrays.triangles.subarray(3 * at, 3 * at + 3))
      })
      const geometry = new THREE.BufferGeometry()
      geometry.setAttribute('position', new THREE.BufferAttribute(arrays.positions, 3))
      geometry.setIndex(index)
      this.marks.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
        color: colour, side: THREE.DoubleSide, transparent: true, opacity: 0.35,
      })))
    }
    this.#wake()
  }

  /** Shows names at elements: `[name, { kind, at, line }, fate]` each. */
  showNames(names) {
    this.clearNames()
    const fates = this.#dark.matches ? DARK_FATES : FATES
    for (const [name, element, fate] of names) {
      const colour = fates[fate] ?? fates.kept
      if (!element.line.length) continue
      const flat = element.line.flat()
      if (element.kind === 'halfedge') {
        this.names.add(this.#arrow(element.line, colour))
      } else if (element.kind === 'edge') {
        this.names.add(this.#segments(Float32Array.from(flat), colour, 4, true))
      } else if (element.kind === 'vertex') {
        const geometry = new THREE.BufferGeometry()
        geometry.setAttribute('position', new THREE.Float32BufferAttribute(flat, 3))
        const points = new THREE.Points(geometry, new THREE.PointsMaterial({
          color: colour, size: 11 * this.renderer.getPixelRatio(), sizeAttenuation: false,
          depthTest: false,
        }))
        points.renderOrder = 3
        this.names.add(points)
      }
      const label = document.createElement('span')
      label.className = `label label-${element.kind}`
      label.textContent = name
      label.style.color = colour
      const object = new CSS2DObject(label)
      object.position.fromArray(element.at)
      this.names.add(object)
    }
    this.#wake()
  }

  /** A halfedge as an arrow with half a head, on its side. */
  #arrow([from, to], colour) {
    const [a, b] = [new THREE.Vector3(...from), new THREE.Vector3(...to)]
    const way = b.clone().sub(a)
    const view = this.camera.position.clone().sub(b)
    const aside = view.cross(way).normalize().multiplyScalar(way.length() * 0.11)
    const barb = b.clone().addScaledVector(way, -0.2).add(aside)
    const ends = [...a.toArray(), ...b.toArray(), ...b.toArray(), ...barb.toArray()]
    return this.#segments(Float32Array.from(ends), colour, 3, true)
  }

  #listen(canvas) {
    let pressed = null
    canvas.addEventListener('pointerdown', event => (pressed = [event.clientX, event.clientY]))
    canvas.addEventListener('pointerup', event => {
      const [x, y] = pressed ?? [NaN, NaN]
      pressed = null
      if (Math.hypot(event.clientX - x, event.clientY - y) < 4) this.onClick(this.pick(event))
    })
    let last = ''
    canvas.addEventListener('pointermove', event => {
      if (event.buttons || !this.#mesh || this.#mesh.arrays.faces.length > QUICK) return
      const element = this.pick(event)
      const key = element ? `${element.kind} ${element.index}` : ''
      if (key !== last) this.onPoint(element)
      last = key
    })
    canvas.addEventListener('pointerleave', () => {
      last = ''
      this.onPoint(null)
    })
  }

  /** The element of the wanted kind under the pointer. */
  pick(event) {
    if (!this.#mesh) return null
    const box = this.renderer.domElement.getBoundingClientRect()
    const pointer = new THREE.Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      -((event.clientY - box.top) / box.height) * 2 + 1,
    )
    const caster = new THREE.Raycaster()
    caster.setFromCamera(pointer, this.camera)
    const target = new THREE.Mesh(this.picked, this.faces.material)
    const [hit] = caster.intersectObject(target)
    if (!hit) return null
    const { arrays } = this.#mesh
    const face = arrays.faces[hit.faceIndex]
    if (this.kind === 'face') return { kind: 'face', index: face }
    const sides = this.#sidesOf(face)
    const near = vertex => {
      const at = new THREE.Vector3().fromArray(arrays.positions, 3 * vertex).project(this.camera)
      return new THREE.Vector2(at.x * box.width, at.y * box.height).multiplyScalar(0.5)
    }
    const here = new THREE.Vector2(pointer.x * box.width, pointer.y * box.height).multiplyScalar(0.5)
    if (this.kind === 'vertex') {
      const corners = new Set(sides.flatMap(at => [arrays.edges[2 * at], arrays.edges[2 * at + 1]]))
      const index = least([...corners], vertex => near(vertex).distanceTo(here))
      return index === undefined ? null : { kind: 'vertex', index }
    }
    const distance = at => {
      const [a, b] = [near(arrays.edges[2 * at]), near(arrays.edges[2 * at + 1])]
      const way = b.clone().sub(a)
      const along = Math.min(1, Math.max(0, here.clone().sub(a).dot(way) / (way.lengthSq() || 1)))
      return a.addScaledVector(way, along).distanceTo(here)
    }
    const at = least(sides, distance)
    if (at === undefined) return null
    if (this.kind === 'edge') return { kind: 'edge', index: arrays.edgeIds[at] }
    const side = arrays.edgeFaces[2 * at] === face ? 0 : 1
    return { kind: 'halfedge', index: arrays.halfedges[2 * at + side] }
  }

  /** The edges of a face, by their places among the edges. */
  #sidesOf(face) {
    const mesh = this.#mesh
    if (!mesh.sides) {
      mesh.sides = new Map()
      mesh.arrays.edgeFaces.forEach((face, at) => {
        if (!mesh.sides.has(face)) mesh.sides.set(face, [])
        mesh.sides.get(face).push(at >> 1)
      })
    }
    return mesh.sides.get(face) ?? []
  }
}

/** The colour of a part between 0 and 1; grey for what is no number. */
export function viridis(part) {
  if (!Number.isFinite(part)) return new THREE.Color(0xcbd5e1)
  const along = Math.min(1, Math.max(0, part)) * (VIRIDIS.length - 1)
  const at = Math.min(Math.floor(along), VIRIDIS.length - 2)
  return VIRIDIS[at].clone().lerp(VIRIDIS[at + 1], along - at)
}

function least(list, measure) {
  let [found, shortest] = [undefined, Infinity]
  for (const item of list) {
    const size = measure(item)
    if (size < shortest) [found, shortest] = [item, size]
  }
  return found
}

function clear(group) {
  for (const part of [...group.children]) {
    part.removeFromParent()
    part.geometry?.dispose()
    part.material?.dispose()
  }
}
