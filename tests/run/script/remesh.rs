//! The example that remeshes, on closed and open meshes.

use super::*;
use hedgerow::mesh::shape;

fn remesh(mut mesh: Mesh, target: f64) -> (Mesh, Report) {
    let (_, analysis) = analyse(OPS);
    let number = analysis.script("remesh").unwrap();
    let prepared = prepare(&analysis.program, number, &analysis.plans).unwrap();
    let texts = [("target".to_owned(), target.to_string())];
    let arguments = prepared.arguments(&texts).unwrap();
    let report = run(&prepared, &mut mesh, &arguments, &mut Lines::default()).unwrap();
    validate(&mesh).unwrap();
    (mesh, report)
}

#[test]
fn a_sphere_gets_edges_of_the_wanted_length() {
    for (target, least, most) in [(0.15, 400, 1200), (0.8, 12, 60)] {
        let (mesh, report) = remesh(shape::icosphere(2), target);
        let vertices = mesh.vertex_count();
        assert!((least..most).contains(&vertices), "{vertices} {report:?}");
        assert_eq!(mesh.vertex_count() + mesh.face_count(), mesh.edge_count() + 2);
        let busy = if target < 0.5 { "split" } else { "collapse" };
        assert!(applied(&report, busy) > 20, "{report:?}");
        let mean: f64 =
            mesh.edges().map(|e| mesh.length(e)).sum::<f64>() / mesh.edge_count() as f64;
        assert!((0.7..1.3).contains(&(mean / target)), "{mean} {target}");
    }
}

#[test]
fn a_grid_keeps_its_border() {
    let (mesh, report) = remesh(shape::triangle_grid(6, 6), 0.2);
    assert_eq!(mesh.hole_count(), 1);
    assert!(applied(&report, "split") > 0, "{report:?}");
    assert!(applied(&report, "flip") > 0, "{report:?}");
}

/// No test but a measure:
/// `cargo test --release --test run script -- --ignored --nocapture`.
#[test]
#[ignore = "measures"]
fn time_of_a_remeshing() {
    let mesh = shape::icosphere(6);
    let edges = mesh.edge_count();
    let start = std::time::Instant::now();
    let (mesh, report) = remesh(mesh, 0.015);
    println!("{edges} to {} edges in {:?}: {report:#?}", mesh.edge_count(), start.elapsed());
}
