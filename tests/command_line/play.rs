//! The page that is served on this machine: to nobody but who has its address.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};

use crate::bench::{Bench, example};

/// A server that ends with the test.
struct Served {
    child: Child,
    port: String,
    token: String,
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Served {
    /// Starts one; nothing if the page had not been built, which is said then.
    fn start(bench: &Bench, files: &[&str]) -> Option<Self> {
        let arguments = [&["play", "--no-browser"][..], files].concat();
        let mut command = bench.command(&arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        if address.is_empty() {
            let output = child.wait_with_output().unwrap();
            let err = String::from_utf8_lossy(&output.stderr);
            assert!(err.contains("was built without its page"), "{err}");
            assert_eq!(output.status.code(), Some(2));
            return None;
        }
        let rest = address.trim().strip_prefix("http://127.0.0.1:").expect("it is on loopback");
        let (port, token) = rest.split_once('/').expect("a token follows");
        let token = token.trim_end_matches('/');
        assert_eq!(token.len(), 32);
        Some(Self { child, port: port.to_owned(), token: token.to_owned() })
    }

    /// Asks; the status and the body.
    fn ask(&self, request: &str, headers: &[(&str, &str)], body: &[u8]) -> (u16, Vec<u8>) {
        let mut stream = TcpStream::connect(format!("127.0.0.1:{}", self.port)).unwrap();
        let own = format!("127.0.0.1:{}", self.port);
        let mut text = format!("{request} HTTP/1.1\r\nConnection: close\r\n");
        if !headers.iter().any(|(name, _)| *name == "Host") {
            text += &format!("Host: {own}\r\n");
        }
        for (name, value) in headers {
            text += &format!("{name}: {value}\r\n");
        }
        text += &format!("Content-Length: {}\r\n\r\n", body.len());
        stream.write_all(text.as_bytes()).unwrap();
        stream.write_all(body).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let status = String::from_utf8_lossy(&answer[9..12]).parse().unwrap();
        let gap = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        (status, answer[gap + 4..].to_vec())
    }

    /// Opens the page; where it asks.
    fn open(&self) -> String {
        let (status, page) = self.ask(&format!("GET /{}/", self.token), &[], b"");
        assert_eq!(status, 200);
        let page = String::from_utf8(page).unwrap();
        let (_, rest) = page.split_once("name=\"hedgerow-local\" content=\"").unwrap();
        rest.split_once('"').unwrap().0.to_owned()
    }

    /// Asks as the page does; the answer.
    fn post(&self, path: &str, body: &[u8]) -> String {
        let (status, body) = self.ask(&format!("POST {path}"), &[], body);
        assert_eq!(status, 200, "{path}");
        String::from_utf8_lossy(&body).into_owned()
    }
}

#[test]
fn the_page_is_served_to_its_owner_only() {
    let bench = Bench::with_square();
    bench.write("mine.hedge", std::fs::read_to_string(example("flip.hedge")).unwrap());
    let Some(served) = Served::start(&bench, &["mine.hedge", "square.obj"]) else {
        return;
    };
    let token = &served.token;
    let page = format!("GET /{token}/");
    let (status, body) = served.ask(&page, &[], b"");
    assert_eq!(status, 200);
    assert!(String::from_utf8_lossy(&body).contains("hedgerow-local"));
    assert_eq!(served.ask(&format!("GET /{token}/main.js"), &[], b"").0, 200);
    for page in ["", "index.html", "main.js"] {
        assert_eq!(served.ask(&format!("HEAD /{token}/{page}"), &[], b""), (200, Vec::new()));
    }
    assert_eq!(served.ask(&format!("GET /{token}/../Cargo.toml"), &[], b"").0, 404);
    for (request, headers) in [
        ("GET /".to_owned(), vec![]),
        ("GET /00000000000000000000000000000000/".to_owned(), vec![]),
        (page.clone(), vec![("Host", "evil.example")]),
        (page.clone(), vec![("Origin", "http://evil.example")]),
        (format!("POST /{token}/save"), vec![("Origin", "null")]),
    ] {
        assert_eq!(served.ask(&request, &headers, b"").0, 403, "{request} {headers:?}");
    }
    let own = served.open();
    let post = |path: &str, body: &[u8]| served.post(&format!("{own}{path}"), body);
    let started = post("start", b"");
    assert!(started.contains("\"program\":\"mine.hedge\""), "{started}");
    assert!(
        started.contains("\"mesh\":\"square.obj\"") && started.contains("file:///"),
        "{started}"
    );
    assert!(post("open", br#"{"name":"mine.hedge"}"#).contains("op flip"));
    let question = br#"{"ask":"shape","name":"cube"}"#;
    let mut message = (question.len() as u32).to_le_bytes().to_vec();
    message.extend(question);
    assert!(post("ask", &message).contains("\"faces\":6"));
    for broken in [&b""[..], b"\x05\0\0\0{", b"\xff\xff\xff\xff"] {
        assert_eq!(served.ask(&format!("POST {own}ask"), &[], broken).0, 400);
        assert_eq!(served.ask(&format!("POST {own}lsp"), &[], broken).0, 400);
    }
    for nowhere in ["lsp", "0/lsp/", "x/lsp", "-1/lsp", "1/nothing"] {
        assert_eq!(served.ask(&format!("POST /{token}/{nowhere}"), &[], b"[]").0, 404, "{nowhere}");
    }
}

#[test]
fn a_page_that_is_opened_again_is_as_new_and_others_stay() {
    const INITIALIZE: &[u8] = br#"[{"jsonrpc":"2.0","id":1,"method":"initialize",
        "params":{"capabilities":{}}}]"#;
    let bench = Bench::with_square();
    let Some(served) = Served::start(&bench, &[]) else {
        return;
    };
    let ask = |page: &str, question: &str| {
        let mut message = (question.len() as u32).to_le_bytes().to_vec();
        message.extend(question.as_bytes());
        served.post(&format!("{page}ask"), &message)
    };
    let first = served.open();
    ask(&first, r#"{"ask":"shape","name":"cube"}"#);
    let pages = [first.clone(), served.open(), served.open()];
    for page in &pages {
        let said = served.post(&format!("{page}lsp"), INITIALIZE);
        assert!(said.contains("\"capabilities\"") && !said.contains("\"error\""), "{said}");
    }
    assert!(ask(&pages[2], r#"{"ask":"shape","name":"tetrahedron"}"#).contains("\"faces\":4"));
    assert!(ask(&first, r#"{"ask":"undo"}"#).contains("\"faces\":6"));
    // A page that is closed, or that nobody has used for long, has no engine left.
    served.post(&format!("{}close", pages[1]), b"");
    (0..7).for_each(|_| _ = served.open());
    assert_eq!(served.ask(&format!("POST {}lsp", pages[1]), &[], b"[]").0, 410);
    let (status, why) = served.ask(&format!("POST {}lsp", pages[2]), &[], b"[]");
    assert_eq!((status, String::from_utf8_lossy(&why).contains("reload")), (410, true));
    assert_eq!(served.post(&format!("{first}lsp"), b"[]"), "[]");
}

#[test]
fn a_folder_begins_with_a_program_of_its_own() {
    let bench = Bench::with_square();
    std::fs::create_dir(bench.path("inside")).unwrap();
    bench.write("inside/flip.hedge", "// mine\n");
    let Some(served) = Served::start(&bench, &["inside"]) else {
        return;
    };
    let started = served.post(&format!("{}start", served.open()), b"");
    assert!(started.contains("\"program\":\"flip.hedge\""), "{started}");
}

#[test]
fn programs_of_the_folder_are_listed_opened_and_saved_and_no_others() {
    let bench = Bench::with_square();
    let folder = bench.path("inside");
    std::fs::create_dir(&folder).unwrap();
    bench.write("outside.hedge", "// not yours\n");
    bench.write("inside/main.hedge", "use \"part.hedge\"\nscript none() { lift() }\n");
    bench.write("inside/part.hedge", "script lift() { }\n");
    bench.write("inside/notes.txt", "no mesh\n");
    bench.write("inside/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let Some(served) = Served::start(&bench, &["inside", "square.obj"]) else {
        return;
    };
    let own = served.open();
    let post = |path: &str, body: &str| served.post(&format!("{own}{path}"), body.as_bytes());
    let files = post("files", "");
    assert!(files.contains("\"programs\":[\"main.hedge\",\"part.hedge\"]"), "{files}");
    assert!(files.contains("tri.obj") && files.contains("square.obj"), "{files}");
    assert!(!files.contains("notes.txt") && !files.contains("outside"), "{files}");
    for name in ["../outside.hedge", "notes.txt", "nowhere.hedge"] {
        let said = post("open", &format!("{{\"name\":\"{name}\"}}"));
        assert!(said.contains("\"error\"") && !said.contains("not yours"), "{name}: {said}");
    }
    let outside = bench.path("outside.hedge").display().to_string();
    assert!(post("open", &format!("{{\"name\":{outside:?}}}")).contains("\"error\""));
    let ask = |json: &str| {
        let mut message = (json.len() as u32).to_le_bytes().to_vec();
        message.extend(json.as_bytes());
        post("ask", &String::from_utf8(message).unwrap())
    };
    // What a program uses is found beside it, and a mesh without its bytes in the folder.
    let name = bench.path("inside/main.hedge").display().to_string();
    let text = bench.read("inside/main.hedge");
    let program = ask(&format!("{{\"ask\":\"program\",\"name\":{name:?},\"text\":{text:?}}}"));
    assert!(program.contains("\"sound\":true") && program.contains("\"lift\""), "{program}");
    let mesh = ask(r#"{"ask":"mesh","name":"tri.obj","of_host":true}"#);
    assert!(mesh.contains("\"faces\":1"), "{mesh}");
    assert!(ask(r#"{"ask":"mesh","name":"notes.txt","of_host":true}"#).contains("error"));
    // Nothing that somebody else has written is overwritten.
    let save = |name: &str, was: &str, text: &str| {
        post("save", &format!("{{\"name\":\"{name}\",\"was\":{was},\"text\":\"{text}\"}}"))
    };
    assert!(save("part.hedge", "\"script lift() { }\\n\"", "// mine").contains("saved"));
    assert_eq!(bench.read("inside/part.hedge"), "// mine");
    assert!(
        save("part.hedge", "\"script lift() { }\\n\"", "// again").contains("changed elsewhere")
    );
    assert!(save("part.hedge", "null", "// again").contains("is there already"));
    assert!(save("new.hedge", "null", "// new").contains("saved"));
    assert_eq!(bench.read("inside/new.hedge"), "// new");
    // What cannot be read as a program has been changed as well; what is gone is written again.
    bench.write("inside/part.hedge", b"// na\xefve");
    assert!(save("part.hedge", "\"// mine\"", "// no").contains("changed elsewhere"));
    assert_eq!(std::fs::read(bench.path("inside/part.hedge")).unwrap(), b"// na\xefve");
    std::fs::remove_file(bench.path("inside/part.hedge")).unwrap();
    assert!(save("part.hedge", "\"// old\"", "// mine").contains("saved"));
    // Editors show all line ends as one.
    bench.write("inside/new.hedge", "// a\r\n// b\r\n");
    assert!(save("new.hedge", "\"// a\\n// b\\n\"", "// c\\n").contains("saved"));
    assert_eq!(bench.read("inside/new.hedge"), "// c\r\n");
    for name in ["../new.hedge", "new.txt", ".hedge", "", "sub/new.hedge"] {
        assert!(save(name, "null", "// no").contains("\"error\""), "{name}");
    }
    assert_eq!(bench.read("inside/part.hedge"), "// mine");
}

#[test]
fn who_is_refused_keeps_nobody_waiting() {
    let bench = Bench::with_square();
    let Some(served) = Served::start(&bench, &[]) else {
        return;
    };
    let sizes = ["100000", "100000000000000000", "9999999999999999999", "nonsense"];
    let open = |(at, expects): (usize, &str)| {
        let mut stream = TcpStream::connect(format!("127.0.0.1:{}", served.port)).unwrap();
        let size = sizes[at % sizes.len()];
        let text =
            format!("POST / HTTP/1.1\r\nHost: evil\r\n{expects}Content-Length: {size}\r\n\r\nx");
        stream.write_all(text.as_bytes()).unwrap();
        let mut status = [0; 12];
        stream.read_exact(&mut status).unwrap();
        assert_eq!(&status, b"HTTP/1.1 403");
        stream
    };
    let expects = ["", "Expect: 100-continue\r\n"].into_iter().cycle();
    let open: Vec<_> = (0..40).zip(expects).map(open).collect();
    assert!(served.post(&format!("{}start", served.open()), b"").contains("folder"));
    drop(open);
    assert!(served.post(&format!("{}files", served.open()), b"").contains("square.obj"));
}

#[test]
fn what_cannot_be_opened_is_told() {
    let bench = Bench::with_square();
    for arguments in [&["play", "nowhere.hedge"][..], &["play", "square.obj", "square.obj"]] {
        let output = bench.command(arguments).arg("--no-browser").output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
}
