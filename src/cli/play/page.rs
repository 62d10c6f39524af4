//! The files of the page, embedded by the build.

static FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// The files by name; none if the page had not been built.
pub(super) fn files() -> &'static [(&'static str, &'static [u8])] {
    FILES
}

/// A file of the page.
pub(super) fn file(name: &str) -> Option<(Vec<u8>, &'static str)> {
    let (_, bytes) = files().iter().find(|(known, _)| *known == name)?;
    let kind = match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        _ => "text/plain; charset=utf-8",
    };
    Some((bytes.to_vec(), kind))
}

/// The page itself, with the address of its server instead of an engine of its own.
pub(super) fn index(server: &str) -> Option<(Vec<u8>, &'static str)> {
    let (bytes, kind) = file("index.html")?;
    let text = String::from_utf8_lossy(&bytes);
    let mark = format!("<meta name=\"hedgerow-local\" content=\"{server}\">");
    let (before, rest) = text.split_once("<!--engine-->")?;
    let (_, after) = rest.split_once("<!--/engine-->")?;
    Some(([before, &mark, after].concat().into_bytes(), kind))
}
