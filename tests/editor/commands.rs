//! Commands of code lenses: what is run beside the server, and what the client is told of it.

use std::io::BufReader;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use lsp_server::{Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};

use crate::client::{Client, URI};

#[test]
fn commands_that_run_are_handed_to_the_process() {
    let mut client = Client::able("utf-8");
    client.open("script s() { }\ntest \"t\" { }\n");
    let run = |arguments: Value| json!({ "command": "hedgerow.runScript", "arguments": arguments });
    let lacking = client.request("workspace/executeCommand", run(json!([URI, "s"])));
    assert!(lacking.unwrap_err().1.contains("MESH"));
    let all = run(json!([URI, "s", "a.obj", "b.obj"]));
    client.request("workspace/executeCommand", all).unwrap();
    let subprocesses = client.server.take_subprocesses();
    assert_eq!(subprocesses.len(), 1);
    assert_eq!(subprocesses[0].arguments, ["run", "/work/test.hedge::s", "a.obj", "-o", "b.obj"]);
    let unknown = json!({ "command": "hedgerow.dance", "arguments": [URI] });
    assert!(client.request("workspace/executeCommand", unknown).is_err());
}

/// A file of tests and scripts, one of which fails.
const PROGRAM: &str = "
op stay(e: edge) {
  before {
    loop f: v0 -a-> v1 =P=> v0
    loop g: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after { keep f g e }
}
test \"edges stay\" {
  mesh = cube()
  let start = mesh
  for e in edges { must stay(e) }
  assert mesh == start
}
test \"one is two\" { assert 1 == 2 }
test \"edges stay, and fail\" { assert 1 == 3 }
script stay_all() { for e in edges { stay(e) } }
";

/// The program itself, over its streams.
struct Process {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    asked: i32,
}

impl Process {
    fn start() -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_hedgerow"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let input = child.stdin.take().unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        Self { child, input, output, asked: 0 }
    }

    fn tell(&mut self, method: &str, params: Value) {
        let notice = Notification::new(method.into(), params);
        Message::from(notice).write(&mut self.input).unwrap();
    }

    fn hear(&mut self) -> Message {
        let message = Message::read(&mut self.output).unwrap();
        message.expect("the server is there")
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.answer(method, params).response_result.unwrap()
    }

    /// The reason for which a request is refused.
    fn refused(&mut self, method: &str, params: Value) -> String {
        self.answer(method, params).response_result.unwrap_err().message
    }

    fn answer(&mut self, method: &str, params: Value) -> Response {
        self.asked += 1;
        let request = Request::new(RequestId::from(self.asked), method.into(), params);
        Message::from(request).write(&mut self.input).unwrap();
        loop {
            if let Message::Response(response) = self.hear() {
                return response;
            }
        }
    }

    /// The next message of a kind that the client shows.
    fn shown(&mut self, method: &str) -> String {
        loop {
            match self.hear() {
                Message::Notification(notice) if notice.method == method => {
                    return notice.params["message"].as_str().unwrap().to_owned();
                }
                _ => {}
            }
        }
    }
}

#[test]
fn lenses_run_what_they_offer() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    std::fs::write(path("stay.hedge"), PROGRAM).unwrap();
    let flat = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(path("in.obj"), flat).unwrap();
    let mut editor = Process::start();
    editor.ask("initialize", json!({ "capabilities": {} }));
    editor.tell("initialized", json!({}));
    let uri = format!("file://{}", path("stay.hedge"));
    let item = json!({ "uri": uri, "languageId": "hedgerow", "version": 1, "text": PROGRAM });
    editor.tell("textDocument/didOpen", json!({ "textDocument": item }));
    let document = json!({ "textDocument": { "uri": uri } });
    let lenses = editor.ask("textDocument/codeLens", document);
    let lens = |title: &str, name: &str| {
        let lenses = lenses.as_array().unwrap().iter();
        let commands = lenses.map(|lens| lens["command"].clone());
        let mut named = commands.filter(|command| command["arguments"][1] == name);
        named.find(|command| command["title"] == title).unwrap()
    };
    for (test, ends) in [("edges stay", "is done"), ("one is two", "failed")] {
        editor.ask("workspace/executeCommand", lens("run test", test));
        let said = editor.shown("window/logMessage");
        let is_it = |line: &&str| line.trim_end().ends_with(test);
        assert_eq!(said.lines().skip(1).filter(is_it).count(), 1, "{said}");
        let others = ["edges stay", "one is two", "edges stay, and fail"];
        let others = others.into_iter().filter(|name| *name != test);
        let is_said = |name: &str| said.lines().skip(1).any(|line| line.trim_end().ends_with(name));
        assert!(others.into_iter().all(|name| !is_said(name)), "{said}");
        let shown = editor.shown("window/showMessage");
        assert!(shown.contains(ends), "{shown}");
    }
    // What the editor has and the file does not is not run.
    let change = |version: i32, text: &str| {
        json!({ "textDocument": { "uri": uri, "version": version },
            "contentChanges": [{ "text": text }] })
    };
    editor.tell("textDocument/didChange", change(2, &PROGRAM.replace("1 == 2", "1 == 1")));
    let refused = editor.refused("workspace/executeCommand", lens("run test", "one is two"));
    assert!(refused.contains("save the document first"), "{refused}");
    editor.tell("textDocument/didChange", change(3, PROGRAM));
    let mut run = lens("run script", "stay_all");
    let files = [path("in.obj"), path("out.obj")].map(Value::from);
    run["arguments"].as_array_mut().unwrap().extend(files);
    editor.ask("workspace/executeCommand", run);
    let shown = editor.shown("window/showMessage");
    assert!(shown.contains("is done"), "{shown}");
    let written = std::fs::read_to_string(path("out.obj")).unwrap();
    assert_eq!(written.matches("v ").count(), 3, "{written}");
    editor.ask("shutdown", Value::Null);
    editor.tell("exit", Value::Null);
    assert!(editor.child.wait().unwrap().success());
}
