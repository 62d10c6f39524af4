//! Colours of values, and pixels of faces.

use glam::{DVec2, DVec3};
use hedgerow::draw::raster::{Image, weigh};
use hedgerow::draw::viridis::{Range, number, viridis};

#[test]
fn ends_and_numbers() {
    assert_eq!(viridis(-1.0), [0x44, 0x01, 0x54]);
    assert_eq!(viridis(1.0), [0xfd, 0xe7, 0x25]);
    assert_eq!(number(0.123456), "0.1235");
    assert_eq!(number(-12.0), "\u{2212}12");
    assert_eq!(number(1.0e-9), "1e\u{2212}9");
    let range = Range::of([f64::NAN, 2.0, 4.0].into_iter()).expect("two numbers");
    assert_eq!(range.colour(4.0), viridis(1.0));
    assert!(Range::of([f64::INFINITY].into_iter()).is_none());
}

/// The colour in the middle of an image of two squares that cross.
#[test]
fn the_nearest_is_seen_in_any_order() {
    let square = |near: [f64; 2], red: u8| {
        let corner = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let [left, right] = near;
        let corners = [
            corner(0.0, 0.0, left),
            corner(16.0, 0.0, right),
            corner(16.0, 16.0, right),
            corner(0.0, 16.0, left),
        ];
        (corners, red)
    };
    let [rising, falling] = [square([0.0, 1.0], 10), square([1.0, 0.0], 20)];
    for order in [[rising, falling], [falling, rising]] {
        let image = Image::new(8, 8.0, |raster| {
            for (corners, red) in order {
                raster.polygon(&corners, &|_| [red, 0, 0]);
            }
        });
        let row: Vec<_> = image.pixels[32..40].iter().map(|pixel| pixel[0]).collect();
        assert_eq!(row, [20, 20, 20, 20, 10, 10, 10, 10]);
    }
}

/// A large image is drawn in parts, each of which shows its own rows.
#[test]
fn parts_of_an_image_meet() {
    const SIDE: u32 = 4500;
    let far = 2.0 * f64::from(SIDE);
    let corners = [(0.0, 0.0), (far, 0.0), (far, far), (0.0, far)];
    let corners = corners.map(|(x, y)| DVec3::new(x, y, 0.0));
    let mut parts = 0;
    let image = Image::new(SIDE, 8.0, |raster| {
        parts += 1;
        raster.polygon(&corners, |at| [(at.y / 64.0) as u8, 0, 0]);
    });
    assert_eq!(parts, 2);
    let rows: Vec<_> = image.pixels.chunks(SIDE as usize).collect();
    assert_eq!(rows.len(), SIDE as usize);
    for (row, pixels) in rows.iter().enumerate() {
        assert!(pixels.iter().all(|pixel| *pixel == [(row / 32) as u8, 0, 0, 255]), "{row}");
    }
}

#[test]
fn weights_give_back_the_place() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1.0, 1.0), (0.0, 3.0)];
    let corners = corners.map(|(x, y)| DVec2::new(x, y));
    let mut weights = [0.0; 5];
    for at in [(0.5, 0.5), (3.0, 2.0), (4.0, 1.0), (0.0, 0.0)] {
        let at = DVec2::new(at.0, at.1);
        weigh(at, &corners, &mut weights);
        let back: DVec2 = corners.iter().zip(&weights).map(|(c, w)| *c * *w).sum();
        assert!((back - at).length() < 1e-9, "{at}: {back}");
    }
}

#[test]
fn numbers_that_are_written_alike_are_one() {
    let alike = Range::of([1.0, 1.0 - 1e-16, 1.0 + 3e-16].into_iter()).unwrap();
    let [least, most] = alike.ends();
    assert_eq!(least, most);
    assert_eq!(alike.colour(1.0 - 1e-16), alike.colour(1.0 + 3e-16));
    let apart = Range::of([1.0, 1.01].into_iter()).unwrap();
    assert_ne!(apart.colour(1.0), apart.colour(1.01));
}
