//! Any bytes are read as OBJ: a mesh comes of them that is valid, or an error.
#![no_main]

use hedgerow::mesh::{read_obj_from, validate};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(obj) = read_obj_from("fuzz.obj", bytes) {
        validate(&obj.mesh).unwrap_or_else(|law| panic!("{law}"));
    }
});
