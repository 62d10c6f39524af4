// The mesh in 3D: faces, edges, what is marked on them, and which element somebody points at.

import * as THREE from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import { CSS2DRenderer } from 'three/examples/jsm/renderers/CSS2DRenderer.js'
import { drawNames, drawPointers } from './names.js'
import { FAT, Pen } from './pen.js'
import { pick } from './pick.js'
import { clustered, typicalLength } from './shapes.js'

/** Meshes with more triangles than this are not looked at under a moving pointer. */
const QUICK = 60_000
/** Edges that are shorter than this on the screen, in pixels, are not drawn: they would hide the faces. */
const SHORTEST = 3
/** A picture that takes longer than this while the mesh is turned, in milliseconds, is made coarser. */
const SLOW = 45
/** The triangles of a mesh that stands for a larger one while that is turned. */
const COARSE = 12_000
/** The types of arrays in an answer. */
const ARRAYS = { f32: Float32Array, u32: Uint32Array, u8: Uint8Array }

/** The arrays of an answer, by name. */
export function arraysOf(json, bytes) {
  const arrays = {}
  let at = bytes.byteOffset
  for (const { name, type, length } of json.arrays) {
    arrays[name] = new ARRAYS[type](bytes.buffer, at, length)
    at += arrays[name].byteLength
  }
  return arrays
}

export class Scene {
  /** Called with an element when somebody clicks one, or points at one; with null beside all. */
  onClick = () => {}
  onPoint = () => {}
  /** The kind of the elements that are pointed at. */
  kind = 'edge'
  #turning = false
  #isDrawn = false
  #last = 0
  #slow = 0
  /** How much coarser the mesh is while it is turned. */
  #level = 0
  #withEdges = true
  #mesh = null
  #box = new THREE.Box3()
  #framed = null
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
    this.name = 'the mesh'
    this.scene = new THREE.Scene()
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000)
    this.camera.position.set(1.6, 1.3, 3)
    this.light = new THREE.DirectionalLight(0xffffff, 2.2)
    this.scene.add(this.light, new THREE.HemisphereLight(0xffffff, 0x8899aa, 1.6))
    this.controls = new OrbitControls(this.camera, canvas)
    this.controls.addEventListener('change', () => this.#wake())
    this.controls.addEventListener('start', () => this.#turn(true))
    this.controls.addEventListener('end', () => this.#turn(false))
    this.pen = new Pen(parent, this.renderer)
    this.base = new THREE.Group()
    this.marks = new THREE.Group()
    this.names = new THREE.Group()
    this.scene.add(this.base, this.marks, this.names)
    new ResizeObserver(() => this.#resize()).observe(parent)
    this.#dark.addEventListener('change', () => this.#mesh && this.show(this.#mesh))
    this.#listen(canvas)
    const frame = now => {
      requestAnimationFrame(frame)
      if (this.#turning && this.#isDrawn) this.#measure(now - this.#last)
      this.#last = now
      this.#isDrawn = this.#dirty
      if (this.#dirty) this.#draw()
    }
    frame(0)
  }

  get #isDark() {
    const scheme = getComputedStyle(this.parent).colorScheme
    return scheme.includes('light') ? scheme.includes('dark') && this.#dark.matches : scheme === 'dark'
  }

  /** What the mesh is called where nobody sees it. */
  set name(name) {
    this.renderer.domElement.setAttribute('aria-label', name)
  }

  #wake() {
    this.#dirty = true
  }

  #draw() {
    this.#dirty = false
    this.light.position.copy(this.camera.position).add(new THREE.Vector3(0.4, 1, 0.2))
    if (this.lines) this.lines.visible = this.#withEdges && this.#edgeLength() > SHORTEST
    this.renderer.render(this.scene, this.camera)
    this.labels.render(this.scene, this.camera)
  }

  /** The length of a typical edge on the screen, in pixels. */
  #edgeLength() {
    const far = this.camera.position.distanceTo(this.controls.target)
    const height = 2 * far * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2))
    return (this.#mesh?.length ?? 0) * this.parent.clientHeight / height
  }

  /** Somebody begins to turn the mesh, or lets it go. */
  #turn(isTurning) {
    this.#turning = isTurning
    this.#slow = 0
    this.#coarsen()
  }

  /** Where pictures come too slowly while the mesh is turned, they are made coarser, step by step. */
  #measure(time) {
    if (time > SLOW) this.#slow += 1
    if (this.#slow < 2 || this.#level === 3) return
    this.#slow = 0
    this.#level = Math.min(3, this.#level + (time > 4 * SLOW ? 2 : 1))
    this.#coarsen()
  }

  /** First without edges, then with fewer triangles, at last with fewer pixels; whole at rest. */
  #coarsen() {
    const level = this.#turning ? this.#level : 0
    this.#withEdges = level < 1
    const isCoarse = level > 1 && this.#mesh?.arrays.faces.length > 2 * COARSE
    if (isCoarse && !this.coarse) {
      const geometry = clustered(this.#mesh.arrays.positions, this.#mesh.arrays.triangles, COARSE)
      this.coarse = new THREE.Mesh(geometry, this.faces.material.clone())
      this.coarse.material.vertexColors = false
      this.coarse.material.color.set(this.#plain())
      this.base.add(this.coarse)
    }
    if (this.coarse) this.coarse.visible = isCoarse
    if (this.faces) this.faces.visible = !isCoarse
    const ratio = Math.min(devicePixelRatio, 2) * (level > 2 ? 0.5 : 1)
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio)
    this.#wake()
  }

  #plain() {
    return this.#isDark ? 0x7fa3cf : 0xb2cdec
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
    this.coarse = null
    this.#level = 0
    const { arrays, json } = mesh
    const dark = this.#isDark
    const positions = new THREE.BufferAttribute(arrays.positions, 3)
    const surface = new THREE.BufferGeometry()
    surface.setAttribute('position', positions)
    surface.setIndex(new THREE.BufferAttribute(arrays.triangles, 1))
    const edges = new THREE.BufferGeometry()
    edges.setAttribute('position', positions)
    edges.setIndex(new THREE.BufferAttribute(arrays.edges, 1))
    mesh.length = typicalLength(arrays)
    const coloured = this.#colour(surface, edges, arrays, json.coloured)
    const isOnEdges = coloured && ['edge', 'halfedge'].includes(json.coloured)
    this.faces = new THREE.Mesh(isOnEdges ? surface : coloured ?? surface, new THREE.MeshLambertMaterial({
      color: isOnEdges ? (dark ? 0x7d8896 : 0xffffff) : coloured ? 0xffffff : this.#plain(),
      vertexColors: !!coloured && !isOnEdges, flatShading: true, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }))
    this.picked = surface
    const lines = isOnEdges
      ? new THREE.LineBasicMaterial({ vertexColors: true })
      : new THREE.LineBasicMaterial({
        color: dark ? 0x0b1220 : 0x1f2937, transparent: true,
        opacity: Math.min(0.85, Math.max(0.12, 3000 / Math.sqrt(arrays.edges.length + 1) / 10)),
      })
    this.lines = isOnEdges && arrays.edgeIds.length <= FAT
      ? this.pen.segments(coloured.attributes.position.array, 0xffffff, 3, { colours: coloured.attributes.color.array })
      : new THREE.LineSegments(isOnEdges ? coloured : edges, lines)
    this.base.add(this.faces, this.lines)
    const border = []
    for (let at = 0; at < arrays.edgeIsBoundary.length; at++) {
      if (arrays.edgeIsBoundary[at]) border.push(at)
    }
    if (border.length) this.base.add(this.pen.segments(this.#ends(border), 0xd9480f, 2.5))
    if (arrays.loose.length) this.base.add(this.pen.points(this.#placesOf(arrays.loose), 0xd9480f, 7))
    this.clearMarks()
    this.#wake()
  }

  /** The middle of the mesh, and how far it reaches. */
  #extent() {
    this.#box.makeEmpty()
    const { positions, edges } = this.#mesh.arrays
    const point = new THREE.Vector3()
    for (const vertex of edges) this.#box.expandByPoint(point.fromArray(positions, 3 * vertex))
    const center = this.#box.getCenter(new THREE.Vector3())
    let farthest = 0
    for (const vertex of edges) {
      farthest = Math.max(farthest, point.fromArray(positions, 3 * vertex).distanceToSquared(center))
    }
    return { center, radius: Math.sqrt(farthest) || 1 }
  }

  /** Puts the whole mesh into the middle of the view. */
  frame() {
    if (!this.#mesh?.arrays.edges.length) return
    const { center, radius } = this.#framed = this.#extent()
    const way = this.camera.position.clone().sub(this.controls.target).normalize()
    this.controls.target.copy(center)
    const aspect = Math.min(1, this.camera.aspect)
    const far = radius / Math.sin(THREE.MathUtils.degToRad(this.camera.fov / 2)) / aspect
    this.camera.position.copy(center).addScaledVector(way, far * 1.08)
    this.camera.near = radius / 200
    this.camera.far = radius * 60
    this.camera.updateProjectionMatrix()
    this.controls.update()
    this.#wake()
  }

  /** Does so if the mesh has become another one in size or place. */
  keepInView() {
    if (!this.#mesh?.arrays.edges.length || !this.#framed) return
    const { center, radius } = this.#extent()
    const { center: before, radius: size } = this.#framed
    const grown = (radius + center.distanceTo(before)) / size
    if (grown > 1.25 || radius < 0.6 * size) this.frame()
  }

  /** The colours of elements of a kind: a geometry with them, of faces or of edges; or nothing. */
  #colour(surface, edges, arrays, kind) {
    const { colours: given, faces, edgeIds, halfedges } = arrays
    if (!given) return null
    // The slot of each point of the geometry. The side of an edge at which a halfedge starts has the
    // colour of that halfedge.
    const [geometry, slot] = {
      vertex: () => [surface.clone(), at => at],
      face: () => [surface.toNonIndexed(), at => faces[Math.floor(at / 3)]],
      edge: () => [edges.toNonIndexed(), at => edgeIds[at >> 1]],
      halfedge: () => [edges.toNonIndexed(), at => halfedges[at]],
    }[kind]()
    const number = geometry.attributes.position.count
    const colours = new Float32Array(3 * number)
    const colour = new THREE.Color()
    for (let at = 0; at < number; at++) {
      const from = 3 * slot(at)
      const [red, green, blue] = [0, 1, 2].map(part => given[from + part] / 255)
      colour.setRGB(red, green, blue, THREE.SRGBColorSpace).toArray(colours, 3 * at)
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

  /** The places of vertices. */
  #placesOf(vertices) {
    const { positions } = this.#mesh.arrays
    const places = new Float32Array(3 * vertices.length)
    vertices.forEach((vertex, at) => {
      places.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * at)
    })
    return places
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
    const colour = this.#isDark ? 0x4ade80 : 0x16a34a
    if (kind === 'edge' || kind === 'halfedge') {
      const places = []
      arrays.edgeIds.forEach((id, at) => {
        const here = kind === 'edge'
          ? mask[id] === 1
          : mask[arrays.halfedges[2 * at]] === 1 || mask[arrays.halfedges[2 * at + 1]] === 1
        if (here) places.push(at)
      })
      if (places.length) this.marks.add(this.pen.segments(this.#ends(places), colour, 2.5))
    } else if (kind === 'vertex') {
      const vertices = []
      mask.forEach((verdict, id) => verdict === 1 && vertices.push(id))
      if (vertices.length) this.marks.add(this.pen.points(this.#placesOf(vertices), colour, 8))
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
    const drawn = drawNames(this.pen, names, { isDark: this.#isDark, length: this.#edgeLength() })
    drawn.forEach(part => this.names.add(part))
  }

  /** Shows pointers that are broken: `{ from, pointer, to }` each, with the places of both. */
  showPointers(pointers) {
    const { camera } = this
    const drawn = drawPointers(this.pen, pointers, { isDark: this.#isDark, box: this.#box, camera })
    drawn.forEach(part => this.names.add(part))
    this.#wake()
  }

  #listen(canvas) {
    // What the pointer does, by keys: arrows turn the mesh, plus and minus bring it nearer and away.
    canvas.addEventListener('keydown', event => {
      const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key]
      const near = { '+': 0.9, '=': 0.9, '-': 1 / 0.9 }[event.key]
      if (!turn && !near || event.ctrlKey || event.metaKey) return
      event.preventDefault()
      const way = this.camera.position.clone().sub(this.controls.target)
      const ball = new THREE.Spherical().setFromVector3(way)
      ball.theta += 0.12 * (turn?.[0] ?? 0)
      ball.phi += 0.12 * (turn?.[1] ?? 0)
      ball.radius *= near ?? 1
      this.camera.position.setFromSpherical(ball.makeSafe()).add(this.controls.target)
      this.controls.update()
      this.#wake()
    })
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
    const point = new THREE.Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      -((event.clientY - box.top) / box.height) * 2 + 1,
    )
    const view = { camera: this.camera, surface: this.picked, size: [box.width, box.height] }
    return pick(this.#mesh, this.kind, point, view)
  }
}

function clear(group) {
  for (const part of [...group.children]) {
    part.removeFromParent()
    part.geometry?.dispose()
    part.material?.dispose()
  }
}
