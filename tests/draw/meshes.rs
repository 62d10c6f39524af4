//! Pictures of meshes.

use glam::DVec3;
use hedgerow::draw::{View, draw_mesh};
use hedgerow::mesh::{ElementKind, Mesh, Polygons, Value, VertexId, shape};

/// How many pixels of a picture of 200 by 200 are of a colour, about.
fn pixels(mesh: &Mesh, view: View, colour: [u8; 3]) -> usize {
    let image = draw_mesh(mesh, &View { size: 200.0, ..view });
    let image = image.png(1.0).expect("small enough");
    let pixmap = tiny_skia::Pixmap::decode_png(&image).expect("an image");
    // Faces are a little darker than their colours.
    let near = |a: u8, b: u8| a.abs_diff(b) < 24;
    let pixels = pixmap.pixels().iter().map(|pixel| pixel.demultiply());
    pixels
        .map(|pixel| [pixel.red(), pixel.green(), pixel.blue()])
        .filter(|pixel| (0..3).all(|at| near(pixel[at], colour[at])))
        .count()
}

const BOUNDARY: [u8; 3] = [0xc2, 0x41, 0x0c];

#[test]
fn a_boundary_is_strong() {
    let above = View { from: DVec3::Z, ..View::default() };
    // Four sides of 180, about three wide, less where pixels are mixed.
    let open = pixels(&shape::grid(2, 2), above, BOUNDARY);
    assert!((4 * 180..4 * 180 * 3).contains(&open), "{open} pixels");
    assert_eq!(pixels(&shape::cube(), View::default(), BOUNDARY), 0);
}

#[test]
fn an_attribute_has_the_colours_of_its_values() {
    let mut mesh = shape::grid(2, 1);
    let column = mesh.add_column(ElementKind::Face, "side", Value::Real(3.0));
    let column = column.expect("the first of its name");
    assert!(mesh.set_value(column, 1, Value::Real(5.0)));
    let view = View { from: DVec3::Z, attribute: Some(column), ..View::default() };
    let picture = draw_mesh(&mesh, &view);
    assert!(picture.size()[0] > picture.size()[1], "no room for a legend");
    // Half of the picture is purple, and half yellow.
    for colour in [[0x44, 0x01, 0x54], [0xfd, 0xe7, 0x25]] {
        let count = pixels(&mesh, view, colour);
        assert!(count > 5000, "{count} pixels of {colour:?}");
    }
}

/// Up to eight whole numbers have colours that are far from each other, however near they are.
#[test]
fn a_few_whole_numbers_are_labels() {
    const LABELS: [[u8; 3]; 3] = [[0x56, 0xb4, 0xe9], [0xe6, 0x9f, 0x00], [0x00, 0x9e, 0x73]];
    let mut mesh = shape::grid(9, 1);
    let column = mesh.add_column(ElementKind::Face, "label", Value::Int(1_000_000));
    let column = column.expect("the first of its name");
    for (face, label) in [(0, -2), (1, -2), (2, -1), (3, -1)] {
        assert!(mesh.set_value(column, face, Value::Int(label)));
    }
    let view = View { from: DVec3::Z, attribute: Some(column), ..View::default() };
    for colour in LABELS {
        let count = pixels(&mesh, view, colour);
        assert!(count > 200, "{count} pixels of {colour:?}");
    }
    for face in 0..9 {
        assert!(mesh.set_value(column, face, Value::Int(i64::from(face))));
    }
    assert_eq!(LABELS.map(|colour| pixels(&mesh, view, colour)), [0; 3]);
}

#[test]
fn colours_are_shown_as_they_are() {
    let mut mesh = shape::grid(2, 1);
    let colour = |red, green| Value::Vec3(DVec3::new(red, green, 0.0));
    let column = mesh.add_column(ElementKind::Face, "color", colour(1.0, 0.0));
    let column = column.expect("the first of its name");
    assert!(mesh.set_value(column, 1, colour(0.0, 1.0)));
    let view = View { from: DVec3::Z, attribute: Some(column), ..View::default() };
    let picture = draw_mesh(&mesh, &view);
    assert_eq!(picture.size()[0], picture.size()[1], "there is no legend");
    for shown in [[255, 0, 0], [0, 255, 0]] {
        let count = pixels(&mesh, view, shown);
        assert!(count > 5000, "{count} pixels of {shown:?}");
    }
    // Out of range they are vectors like others.
    assert!(mesh.set_value(column, 1, colour(0.0, 2.0)));
    let picture = draw_mesh(&mesh, &view);
    assert!(picture.size()[0] > picture.size()[1], "no room for a legend");
}

#[test]
fn faces_hide_each_other_in_any_order() {
    // A roof over a floor, the roof first and last.
    let corner = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let square = |z: f64, half: f64| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| corner(x * half, y * half, z))
    };
    let [low, high] = [square(0.0, 2.0), square(1.0, 1.0)];
    for order in [[low, high], [high, low]] {
        let corners: Vec<_> = order.concat();
        let mut faces = Polygons::new();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[4, 5, 6, 7]);
        let mut mesh = Mesh::from_polygons(&corners, &faces).expect("two squares");
        let column = mesh.add_column(ElementKind::Face, "high", Value::Real(0.0));
        let column = column.expect("the first of its name");
        let roof = u32::from(order[1] == high);
        assert!(mesh.set_value(column, roof, Value::Real(1.0)));
        let view = View { from: DVec3::Z, attribute: Some(column), ..View::default() };
        let yellow = pixels(&mesh, view, [0xfd, 0xe7, 0x25]);
        assert!(yellow > 5000, "{yellow} pixels of the roof");
    }
}

#[test]
fn it_is_as_large_as_wished() {
    let view = View { size: 123.0, ..View::default() };
    let picture = draw_mesh(&shape::icosahedron(), &view);
    assert_eq!(picture.size(), [123.0, 123.0]);
    assert!(picture.png(1.0).expect("small enough").starts_with(b"\x89PNG"));
}

#[test]
fn odd_meshes_and_directions_have_pictures() {
    let directions = [DVec3::ZERO, DVec3::Y, DVec3::NAN, DVec3::splat(1e300), -DVec3::Z];
    let mut broken = shape::cube();
    broken.set_position(VertexId(0), DVec3::splat(f64::NAN));
    for mesh in [Mesh::default(), shape::single_polygon(3), broken] {
        for from in directions {
            for size in [0.0, 50.0, f64::NAN] {
                if size.is_nan() && from != DVec3::Y {
                    continue; // it is 800 then, which takes a while
                }
                let view = View { from, size, ..View::default() };
                let svg = draw_mesh(&mesh, &view).svg();
                let mut lines = svg.lines();
                // Letters of an image may say anything.
                let is_fine = |line: &str| line.starts_with("<image") || !line.contains("NaN");
                assert!(lines.all(is_fine));
            }
        }
    }
}

/// Of a truth value at edges, the lines where it holds are strong, and all others as usual.
#[test]
fn edges_where_it_holds_stand_out() {
    const HOLDS: [u8; 3] = [0x00, 0x65, 0xb3];
    let mut mesh = shape::grid(4, 4);
    let column = mesh.add_column(ElementKind::Edge, "sharp", Value::Bool(false));
    let column = column.expect("the first of its name");
    let view = View { from: DVec3::Z, attribute: Some(column), ..View::default() };
    let picture = draw_mesh(&mesh, &view);
    assert!(picture.size()[0] > picture.size()[1], "no room for a legend");
    // The square of the legend alone.
    let none = pixels(&mesh, view, HOLDS);
    assert!(mesh.set_value(column, 7, Value::Bool(true)));
    assert!(pixels(&mesh, view, HOLDS) > none + 30);
    assert!(pixels(&mesh, view, BOUNDARY) > 4 * 180, "the boundary is as it was");
}

#[test]
fn own_colours_are_shown_unasked() {
    let mut mesh = shape::grid(2, 1);
    let above = View { from: DVec3::Z, ..View::default() };
    assert_eq!(above.with_own_colours(&mesh), above);
    let red = Value::Vec3(DVec3::new(1.0, 0.0, 0.0));
    let column = mesh.add_column(ElementKind::Face, "color", red);
    assert_eq!(above.with_own_colours(&mesh).attribute, column.ok());
    assert!(pixels(&mesh, above.with_own_colours(&mesh), [255, 0, 0]) > 5000);
}

#[test]
fn what_shows_nothing_is_blank() {
    let edge_on = View { from: DVec3::X, ..View::default() };
    assert!(draw_mesh(&shape::grid(2, 2), &edge_on).is_blank());
    assert!(draw_mesh(&Mesh::default(), &View::default()).is_blank());
    assert!(!draw_mesh(&shape::grid(2, 2), &View::default()).is_blank());
}
