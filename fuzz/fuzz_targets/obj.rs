//! Any bytes are read as OBJ: a mesh comes of them that is valid, or an error.
#![no_main]

use hedgerow::mesh::{FileFormat, read_mesh_from, validate};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(obj) = read_mesh_from("fuzz.obj", FileFormat::Obj, bytes, None) {
        validate(&obj.mesh).unwrap_or_else(|law| panic!("{law}"));
    }
});
