//! Pictures of meshes.

use glam::DVec3;
use hedgerow::draw::{View, draw_mesh};
use hedgerow::mesh::{Mesh, VertexId, shape};

#[test]
fn a_grid_shows_its_faces_and_its_boundary() {
    let svg = draw_mesh(
        &shape::grid(2, 2),
        &View {
            from: DVec3::Z,
            size: 200.0,
        },
    )
    .svg();
    assert_eq!(svg.matches("class=\"fill-shade\"").count(), 4);
    assert_eq!(boundary_sides(&svg), 8);
    let closed = draw_mesh(&shape::cube(), &View::default()).svg();
    assert_eq!(boundary_sides(&closed), 0);
}

/// How many lines are drawn along a boundary, each of which begins with an `m`.
fn boundary_sides(svg: &str) -> usize {
    let lines = svg
        .lines()
        .filter(|line| line.contains("stroke-erased\" fill"));
    let paths = lines.filter_map(|line| line.split(" d=").nth(1));
    paths.map(|path| path.matches('m').count()).sum()
}

#[test]
fn it_is_as_large_as_wished() {
    let view = View {
        size: 123.0,
        ..View::default()
    };
    let picture = draw_mesh(&shape::icosahedron(), &view);
    assert_eq!(picture.size(), [123.0, 123.0]);
    assert!(
        picture
            .png(1.0)
            .expect("small enough")
            .starts_with(b"\x89PNG")
    );
}

#[test]
fn odd_meshes_and_directions_have_pictures() {
    let directions = [
        DVec3::ZERO,
        DVec3::Y,
        DVec3::NAN,
        DVec3::splat(1e300),
        -DVec3::Z,
    ];
    let mut broken = shape::cube();
    broken.set_position(VertexId(0), DVec3::splat(f64::NAN));
    for mesh in [Mesh::default(), shape::single_polygon(3), broken] {
        for from in directions {
            for size in [0.0, f64::NAN, 50.0] {
                let picture = draw_mesh(&mesh, &View { from, size });
                assert!(!picture.svg().contains("NaN"));
            }
        }
    }
}
