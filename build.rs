//! Takes the page of `hedgerow play` along, if it has been built: the files of `web/dist`.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let root = env::var("CARGO_MANIFEST_DIR").expect("cargo says where the crate lies");
    let out = env::var("OUT_DIR").expect("cargo says where to write");
    let web = Path::new(&root).join("web");
    let dist = web.join("dist");
    // Cargo builds anew, each time, what watches a path that is missing.
    if let Some(watched) = [&dist, &web].into_iter().find(|path| path.exists()) {
        println!("cargo:rerun-if-changed={}", watched.display());
    }
    let mut names: Vec<_> = fs::read_dir(&dist)
        .map(|files| {
            files.flatten().filter_map(|file| file.file_name().into_string().ok()).collect()
        })
        .unwrap_or_default();
    // The module is for pages without a program behind them.
    names.retain(|name: &String| !name.ends_with(".wasm"));
    names.sort();
    let mut list = String::from("&[");
    for name in names {
        let path = dist.join(&name);
        let _ = write!(list, "({name:?}, include_bytes!({path:?})), ");
    }
    list.push(']');
    fs::write(Path::new(&out).join("page.rs"), list)
        .expect("the folder of the build can be written");
}
