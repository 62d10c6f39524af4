//! The files of the page, which the build has taken along.

static FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// The files by name; none if the page had not been built.
pub(super) fn files() -> &'static [(&'static str, &'static [u8])] {
    FILES
}

/// A file of the page. The page itself knows where its server is.
pub(super) fn file(name: &str, token: &str) -> Option<(Vec<u8>, &'static str)> {
    let (_, bytes) = files().iter().find(|(known, _)| *known == name)?;
    let kind = match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        _ => "text/plain; charset=utf-8",
    };
    let bytes = match name {
        "index.html" => {
            let mark = format!("<meta name=\"hedgerow-local\" content=\"/{token}/\">");
            String::from_utf8_lossy(bytes).replace("<!--local-->", &mark).into_bytes()
        }
        _ => bytes.to_vec(),
    };
    Some((bytes, kind))
}
