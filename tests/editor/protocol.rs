//! The protocol below the answers: messages on a stream, paths, positions, and texts for people.

use std::path::{Path, PathBuf};

use gen_lsp_types::{Position, Uri};
use hedgerow::lsp::Encoding;
use hedgerow::lsp::markdown::{fenced, prose, quoted};
use hedgerow::lsp::message::{Incoming, Outgoing, read};
use hedgerow::lsp::position::Lines;
use hedgerow::lsp::uri::{of_path, path};
use lsp_server::Message;

fn first(text: &str) -> Result<Option<Incoming>, String> {
    read(&mut text.as_bytes()).map_err(|error| error.to_string())
}

#[test]
fn messages_are_read_and_nothing_else() {
    let exit = r#"{"jsonrpc":"2.0","method":"exit"}"#;
    let length = exit.len();
    let text = format!("content-length: {length}\r\nContent-Type: x\r\n\r\n{exit}{exit}");
    let Ok(Some(Incoming::Message(Message::Notification(told)))) = first(&text) else {
        panic!("it is a notification");
    };
    assert_eq!(told.method, "exit");
    assert!(matches!(first(""), Ok(None)));
    let told = first("Content-Length: 99\r\n\r\n{}").expect_err("the body is cut off");
    assert!(told.contains("unexpected end"), "{told}");
}

/// The answers to two messages, of which the first has an unusual header.
fn heard(header: &[u8], body: &str) -> Vec<String> {
    let last = r#"{"jsonrpc":"2.0","method":"exit"}"#;
    let end = format!("{body}Content-Length: {}\r\n\r\n{last}", last.len());
    let all = [header, end.as_bytes()].concat();
    let mut input = all.as_slice();
    let mut heard = Vec::new();
    while let Some(next) = read(&mut input).expect("the conversation goes on") {
        heard.push(match next {
            Incoming::Message(Message::Notification(told)) => told.method,
            Incoming::Refused(Outgoing::Error { why, .. }) => why,
            other => panic!("{other:?}"),
        });
    }
    heard
}

#[test]
fn headers_are_read_leniently() {
    let body = r#"{"jsonrpc":"2.0","method":"told"}"#;
    let long = format!("X: {}\r\nContent-Length: #\r\n\r\n", "a".repeat(10_000));
    let headers: [&[u8]; 14] = [
        b"content-length:#\r\n\r\n",
        b"Content-Length: #\n\n",
        b"Content-Length:   #  \r\n\r\n",
        b"Content-Length:\t#\r\n\r\n",
        b"Content-Length : #\r\n\r\n",
        b"Content-Type:x\r\nContent-Length: #\r\n\r\n",
        b"X-Content-Length: 5\r\nContent-Length: #\r\n\r\n",
        b"Content-Length: #\r\nXYZ\r\n\r\n",
        b": y\r\nContent-Length: #\r\n\r\n",
        b"\r\nContent-Length: #\r\n\r\n",
        b"\n\n\nContent-Length: #\r\n\r\n",
        b"X-\xff: \xfe\r\nContent-Length: #\r\n\r\n",
        b"hello\r\n\r\nContent-Length: #\r\n\r\n",
        long.as_bytes(),
    ];
    for header in headers {
        let (before, after) = {
            let at = header.iter().position(|&b| b == b'#').expect("a length");
            (&header[..at], &header[at + 1..])
        };
        let header = [before, body.len().to_string().as_bytes(), after].concat();
        let told = String::from_utf8_lossy(&header).into_owned();
        assert_eq!(heard(&header, body), ["told", "exit"], "{told}");
    }
}

#[test]
fn messages_without_a_length_are_passed_over() {
    let body = r#"{"jsonrpc":"2.0","method":"told"}"#;
    for length in ["-5", "5.0", "9999999999999", "99999999999999999999", "", "x"] {
        let header = format!("Content-Length: {length}\r\nContent-Type: x\r\n\r\n");
        let refused = format!("`{length}` is not a length of a message");
        for body in [body, "", &"x".repeat(10_000)] {
            assert_eq!(heard(header.as_bytes(), body), [&refused, "exit"]);
        }
    }
    let of_returns = format!("Content-Length: {}\r\r", body.len());
    for header in ["", "\r\n", "hello\r\n\r\n", "Content-Type: x\r\n\r\n", &of_returns] {
        assert_eq!(heard(header.as_bytes(), body), ["exit"], "{header:?}");
    }
}

#[test]
fn what_is_no_message_is_answered() {
    for (body, wanted) in [
        ("{]", r#""code":-32700"#),
        ("\u{0}", r#""code":-32700"#),
        (&"[".repeat(9000), r#""id":null"#),
        ("17", "a message is an object"),
        ("[]", "batches are not taken"),
        (r#"[{"id":1,"method":"shutdown"}]"#, r#""id":null"#),
        (r#"{"id":1.5,"method":"shutdown"}"#, r#""id":1.5"#),
        (r#"{"id":5000000000,"method":"shutdown"}"#, r#""id":5000000000"#),
        (r#"{"id":null,"method":"shutdown"}"#, "an id is a text"),
        (r#"{"id":[1],"method":"shutdown"}"#, r#""id":null"#),
        (r#"{"id":7,"method":8}"#, r#""id":7"#),
        (r#"{"id":"a"}"#, r#""id":"a""#),
    ] {
        let text = format!("Content-Length: {}\r\n\r\n{body}", body.len());
        let Ok(Some(Incoming::Refused(answer))) = first(&text) else {
            panic!("{body} is no message");
        };
        let mut told = Vec::new();
        answer.write(&mut told).expect("there is room");
        let told = String::from_utf8(told).expect("it is a text");
        assert!(told.contains(wanted), "{told}");
    }
}

#[test]
fn paths_survive_the_way_there_and_back() {
    let there = of_path(Path::new("/tmp/a b/é#%.hedge"));
    assert_eq!(there.0, "file:///tmp/a%20b/%C3%A9%23%25.hedge");
    assert_eq!(path(&there), Some(PathBuf::from("/tmp/a b/é#%.hedge")));
    let drive = Uri("file:///c%3A/x.hedge".into());
    assert_eq!(path(&drive), Some(PathBuf::from("c:/x.hedge")));
    assert_eq!(path(&Uri("untitled:Untitled-1".into())), None);
}

#[test]
fn positions_and_bytes_are_inverse_in_every_encoding() {
    let text = "a𝄞b\r\né\rz\n\n";
    for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
        let lines = Lines::new(text, encoding);
        for (offset, character) in text.char_indices() {
            if text[..offset].ends_with('\r') && character == '\n' {
                continue; // inside a line end
            }
            let position = lines.position(text, offset);
            assert_eq!(lines.offset(text, position), offset, "{encoding:?} {offset}");
        }
    }
    let lines = Lines::new(text, Encoding::Utf16);
    let at = |line, character| lines.offset(text, Position { line, character });
    assert_eq!(at(0, 2), 1, "inside a pair of surrogates");
    assert_eq!(at(0, 99), 6, "the end of the line, before its end mark");
    assert_eq!(at(2, 0), 11);
    assert_eq!(at(99, 0), text.len());
}

#[test]
fn only_what_arranges_text_is_left() {
    for (told, wanted) in [
        ("see [it](command:x)", "see \\[it](command:x)"),
        ("![p](https://x/y.png) <img src=x>", "!\\[p](https\\://x/y.png) \\<img src=x>"),
        ("a@b.c or WWW.x.y: no", "a\\@b.c or WWW\\.x.y: no"),
        ("*so* `v[i]` and ``a`b[0]``", "*so* `v[i]` and ``a`b[0]``"),
        ("` [x](command:x)", "\\` \\[x](command:x)"),
        ("`` [x](command:x) `", "\\`\\` \\[x](command:x) \\`"),
        ("\\`[x](command:x)`", "\\\\`[x](command:x)`"),
        ("| --- | --- |", "\\| --- | --- |"),
        ("- an item, a -> b", "- an item, a -> b"),
    ] {
        assert_eq!(prose(told), wanted);
    }
}

#[test]
fn fences_end_where_every_client_ends_them() {
    let lines = |text: &str| text.split('\n').map(str::to_owned).collect::<Vec<_>>();
    let same = "a\n\n```text\n .-[x]-.\n```\nb";
    assert_eq!(quoted(&lines(same)), lines(same));
    // In a list the fence would end with the list.
    let listed = "- a\n  ```\n[x](command:x)";
    assert_eq!(quoted(&lines(listed)), lines("- a\n```\n[x](command:x)\n```"));
    let open = "```\n````\n[x](command:x)";
    assert_eq!(quoted(&lines(open)), lines("```\n```\n\\[x](command:x)"));
    let returned = "```\na\r```\r[x](command:x)";
    assert_eq!(quoted(&lines(returned)), lines("```\na ``` [x](command:x)\n```"));
    assert_eq!(fenced("x", "a ```` b"), "`````x\na ```` b\n`````\n");
}
