"""The same jobs with hedgerow and with other Python libraries: a table of speed.

It runs with what is installed of trimesh, libigl, pymeshlab and gpytoolbox (`pip install ./python
trimesh fast-simplification libigl pymeshlab gpytoolbox`), in one process and on one core; times are
the best of several runs, in milliseconds of processor time. Jobs are alike, not equal: each library remeshes by its own
rules, which is why the number of faces and the spread of the edges stand beside the time.
"""

import argparse
import os
import time

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "HEDGEROW_THREADS"):
    os.environ.setdefault(threads, "1")

import numpy as np  # noqa: E402

import hedgerow  # noqa: E402

RUNS = 7


def found(name):
    try:
        return __import__(name)
    except ImportError:
        return None


trimesh, igl, gpytoolbox = map(found, ("trimesh", "igl", "gpytoolbox"))
pymeshlab = found("pymeshlab")


def best(job, *prepare):
    """The least processor time of several runs, in milliseconds, and what the last gave."""
    times, result = [], None
    for _ in range(RUNS):
        given = [one() for one in prepare]
        start = time.process_time()
        result = job(*given)
        times.append(1e3 * (time.process_time() - start))
    return min(times), result


def edge_lengths(vertices, faces):
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges = np.unique(edges, axis=0)
    return np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)


def told(vertices, faces):
    lengths = edge_lengths(vertices, faces)
    return f"{len(faces)} faces, edges {lengths.mean():.4g} ± {100 * lengths.std() / lengths.mean():.0f} %"


def jobs(vertices, faces):
    target = 0.7 * edge_lengths(vertices, faces).mean()
    count = len(faces) // 4
    std = hedgerow.std

    def mesh():
        return hedgerow.Mesh(vertices, faces)

    def scripted(script, **arguments):
        def run(mesh):
            script(mesh, **arguments)
            return mesh.arrays()

        return run

    def meshlab(name, **arguments):
        def run(meshes):
            getattr(meshes, name)(**arguments)
            made = meshes.current_mesh()
            return made.vertex_matrix(), made.face_matrix()

        return run

    def meshset():
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
        return meshes

    yield "build from arrays", "hedgerow", lambda: mesh().vertices, []
    if trimesh:
        # Pointers are what a halfedge mesh is for; here they are asked for.
        yield "build from arrays", "trimesh", lambda: trimesh.Trimesh(vertices, faces, process=False).face_adjacency, []
    if igl:
        yield "build from arrays", "libigl", lambda: igl.triangle_triangle_adjacency(faces), []
    if pymeshlab:
        yield "build from arrays", "pymeshlab", meshset, []

    yield "remesh", "hedgerow", scripted(std.remesh.remesh, target=target, iterations=5), [mesh]
    if pymeshlab:
        length = pymeshlab.PureValue(target)
        arguments = {"iterations": 5, "targetlen": length, "checksurfdist": False}
        yield "remesh", "pymeshlab", meshlab("meshing_isotropic_explicit_remeshing", **arguments), [meshset]
    if gpytoolbox:
        yield "remesh", "gpytoolbox", lambda: gpytoolbox.remesh_botsch(vertices, faces, i=5, h=target, project=False), []

    yield "simplify to a quarter", "hedgerow", scripted(std.simplify.simplify, faces_left=count), [mesh]
    if igl:
        yield "simplify to a quarter", "libigl", lambda: igl.qslim(vertices, faces, count)[:2], []
    if pymeshlab:
        yield "simplify to a quarter", "pymeshlab", meshlab("meshing_decimation_quadric_edge_collapse", targetfacenum=count), [meshset]
    if gpytoolbox:
        yield "simplify to a quarter", "gpytoolbox", lambda: gpytoolbox.decimate(vertices, faces, num_faces=count, method="qslim")[:2], []
    if trimesh and found("fast_simplification"):
        made = trimesh.Trimesh(vertices, faces, process=False)

        def simplify():
            small = made.simplify_quadric_decimation(face_count=count)
            return small.vertices, small.faces

        yield "simplify to a quarter", "trimesh", simplify, []

    yield "subdivide (Loop)", "hedgerow", scripted(std.subdivide.loop_subdivide), [mesh]
    if trimesh:

        def loop():
            fine = trimesh.Trimesh(vertices, faces, process=False).subdivide_loop(1)
            return fine.vertices, fine.faces

        yield "subdivide (Loop)", "trimesh", loop, []
    if igl:
        yield "subdivide (Loop)", "libigl", lambda: igl.loop(vertices, faces), []
    if pymeshlab:
        share = pymeshlab.PercentageValue(0)
        arguments = {"iterations": 1, "threshold": share}
        yield "subdivide (Loop)", "pymeshlab", meshlab("meshing_surface_subdivision_loop", **arguments), [meshset]
    if gpytoolbox:
        yield "subdivide (Loop)", "gpytoolbox", lambda: gpytoolbox.subdivide(vertices, faces, method="loop"), []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mesh", nargs="?", default=os.path.join(os.path.dirname(__file__), "../../examples/meshes/bunny.obj"))
    path = parser.parse_args().mesh
    vertices, faces = hedgerow.Mesh.load(path).arrays()
    print(f"{os.path.basename(path)}: {told(vertices, faces)}\n")
    print("| job | library | ms | result |\n| --- | --- | ---: | --- |")
    for job, library, run, prepare in jobs(vertices, np.ascontiguousarray(faces)):
        try:
            took, result = best(run, *prepare)
        except Exception as error:  # A library that fails is told, and the others go on.
            print(f"| {job} | {library} | – | {type(error).__name__}: {str(error).splitlines()[0][:60]} |")
            continue
        pair = result if isinstance(result, tuple) and len(result) >= 2 else None
        is_mesh = pair is not None and not job.startswith("build")
        shown = told(np.asarray(pair[0]), np.asarray(pair[1])) if is_mesh else ""
        print(f"| {job} | {library} | {took:.1f} | {shown} |")


if __name__ == "__main__":
    main()
