//! The extension for VS Code against the server it starts: what the one says of the other.

use std::collections::BTreeSet;
use std::fs;

use hedgerow::mesh::FileFormat;
use hedgerow::source::FileId;
use hedgerow::syntax::parse;
use serde_json::{Value, json};

use crate::client::{Client, URI};

fn read(path: &str) -> String {
    let path = format!("editors/vscode/{path}");
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn manifest() -> Value {
    serde_json::from_str(&read("package.json")).unwrap()
}

fn sources() -> String {
    let names = ["extension.js", "panel.js", "files.js", "desktop.js", "browser.js"];
    names.map(|name| read(&format!("src/{name}"))).concat()
}

fn words<'v>(values: &'v Value, key: &str) -> BTreeSet<&'v str> {
    let values = values.as_array().unwrap().iter();
    values.map(|value| value[key].as_str().unwrap()).collect()
}

#[test]
fn the_package_has_the_version_and_the_licence_of_the_program() {
    let manifest = manifest();
    assert_eq!(manifest["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(manifest["license"], env!("CARGO_PKG_LICENSE"));
    let locked: Value = serde_json::from_str(&read("package-lock.json")).unwrap();
    assert_eq!(locked["version"], manifest["version"]);
    assert_eq!(locked["packages"][""]["version"], manifest["version"]);
}

#[test]
fn the_grammar_in_the_package_is_the_one_that_is_kept() {
    let contributed = &manifest()["contributes"];
    let grammar = &contributed["grammars"][0];
    let kept = fs::read_to_string("grammar/hedgerow.tmLanguage.json").unwrap();
    let kept: Value = serde_json::from_str(&kept).unwrap();
    assert_eq!(grammar["scopeName"], kept["scopeName"]);
    let built = read("build.js");
    let path = grammar["path"].as_str().unwrap().trim_start_matches("./");
    let copied = format!("copyFileSync(\"../../grammar/hedgerow.tmLanguage.json\", \"{path}\")");
    assert!(built.contains(&copied), "{built}");
    let language = &contributed["languages"][0];
    assert_eq!(language["extensions"], json!([".hedge"]));
    assert_eq!(grammar["language"], language["id"]);
}

#[test]
fn every_command_is_somebodys() {
    let contributed = manifest()["contributes"].clone();
    let commands = words(&contributed["commands"], "command");
    let sources = sources();
    for command in &commands {
        let name = command.strip_prefix("hedgerow.").unwrap();
        let is_registered = sources.contains(&format!("register(\"{name}\""))
            || sources.contains(&format!("async function {name}("));
        assert!(is_registered, "nobody does `{command}`");
    }
    for menu in ["editor/title", "commandPalette"] {
        let shown = words(&contributed["menus"][menu], "command");
        assert!(shown.is_subset(&commands), "{menu}: {shown:?}");
    }
    // The client registers what the server can run under its name: it must be free. What a
    // lens offers, the extension does itself.
    let server = Client::able("utf-16").hello;
    let run = &server["capabilities"]["executeCommandProvider"]["commands"];
    let run = run.as_array().unwrap().iter().flat_map(Value::as_str);
    let mut count = 0;
    for command in run {
        assert!(!commands.contains(command), "`{command}` is taken");
        assert!(sources.contains(&format!("\"{command}\"")), "`{command}`");
        count += 1;
    }
    assert!(count > 0);
}

/// A text with a lens, a hint and a picture.
const PROGRAM: &str = "op f(e: edge) -> e {
  before {
    loop f: v0 -a-> v1 =P=> v0
    loop g: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    loop f: v0 -a-> x -c-> v1 =P=> v0
    loop g: v1 -d-> x -b-> v0 =Q=> v1
    edge e: a | b
    edge o: c | d
    new x c b o
    x.position = v0.position
  }
}
";

/// Whether the server shows lenses, hints, and an image in a hover.
fn shown(settings: &Value) -> [bool; 3] {
    let mut client = Client::new(json!({
        "capabilities": { "textDocument": { "hover": { "contentFormat": ["markdown"] } } },
        "clientInfo": { "name": "Visual Studio Code" },
        "initializationOptions": settings,
    }));
    client.open(PROGRAM);
    let whole =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let params = json!({ "textDocument": { "uri": URI }, "range": whole, "position": { "line": 0, "character": 3 } });
    let mut ask = |method: &str| {
        let method = format!("textDocument/{method}");
        client.request(&method, params.clone()).unwrap()
    };
    let is_some = |answer: &Value| answer.as_array().is_some_and(|all| !all.is_empty());
    [
        is_some(&ask("codeLens")),
        is_some(&ask("inlayHint")),
        ask("hover").to_string().contains("data:image/svg+xml"),
    ]
}

#[test]
fn every_setting_does_what_it_says() {
    let settings = &manifest()["contributes"]["configuration"]["properties"];
    let defaults = ["codeLens.enable", "inlayHints.enable", "hover.picture"]
        .map(|name| settings[format!("hedgerow.{name}")]["default"].clone());
    let [lenses, hints, picture] = defaults;
    let all = |lenses: &Value, hints: &Value, picture: &Value| {
        shown(&json!({ "codeLens": { "enable": lenses }, "inlayHints": { "enable": hints },
            "hover": { "picture": picture } }))
    };
    let by_default = all(&lenses, &hints, &picture);
    assert_eq!(by_default, [true; 3]);
    assert_eq!(by_default, shown(&json!({})));
    assert_eq!(all(&json!(false), &hints, &picture), [false, true, true]);
    assert_eq!(all(&lenses, &json!(false), &picture), [true, false, true]);
    let pictures = &settings["hedgerow.hover.picture"]["enum"];
    let seen = pictures.as_array().unwrap().iter().map(|picture| {
        let [.., is_image] = all(&lenses, &hints, picture);
        (picture.as_str().unwrap(), is_image)
    });
    let seen: Vec<_> = seen.collect();
    assert_eq!(seen, [("auto", true), ("svg", true), ("text", false)]);
    // What the extension asks for itself.
    let asked = sources();
    for name in ["path", "bridge"] {
        assert!(settings[format!("hedgerow.{name}")].is_object(), "{name}");
        assert!(asked.contains(&format!("settings().get(\"{name}\")")), "{name}");
    }
}

/// A snippet as it stands when nobody has typed anything else.
fn expanded(snippet: &str) -> String {
    let mut values: Vec<(String, String)> = Vec::new();
    let mut text = String::new();
    let mut rest = snippet;
    while let Some((before, stop)) = rest.split_once('$') {
        text.push_str(before);
        let (number, value, after) = match stop.strip_prefix('{') {
            Some(inner) => {
                let (inside, after) = inner.split_once('}').unwrap();
                let split = inside.find([':', '|']).unwrap();
                let value = inside[split + 1..].split(['|', ',']).next().unwrap();
                (&inside[..split], Some(value.to_owned()), after)
            }
            None => (&stop[..1], None, &stop[1..]),
        };
        let known = values.iter().find(|(of, _)| of == number);
        let value = value.unwrap_or_else(|| known.map_or_else(String::new, |(_, of)| of.clone()));
        text.push_str(&value);
        values.push((number.to_owned(), value));
        rest = after;
    }
    text + rest
}

#[test]
fn every_snippet_can_be_read() {
    let snippets: Value = serde_json::from_str(&read("snippets.json")).unwrap();
    let mut count = 0;
    for (name, snippet) in snippets.as_object().unwrap() {
        let body = match &snippet["body"] {
            Value::String(line) => line.clone(),
            lines => {
                let lines = lines.as_array().unwrap().iter().flat_map(Value::as_str);
                lines.collect::<Vec<_>>().join("\n")
            }
        };
        let text = expanded(&body);
        let text = match snippet["prefix"].as_str().unwrap() {
            "op" | "script" | "test" => text,
            "rule" => format!("op o(e: edge) {{ {text} }}"),
            "require" => format!("op o(e: edge) {{ before {{ }} {text} after {{ }} }}"),
            _ => format!("op o(e: edge) {{ before {{ {text} }} after {{ }} }}"),
        };
        let told = parse(FileId::default(), &text).diagnostics;
        assert!(told.is_empty(), "{name}: {text}\n{told:?}");
        count += 1;
    }
    assert!(count > 5);
}

#[test]
fn nothing_that_a_program_says_is_trusted() {
    let sources = sources();
    assert!(sources.contains("markdown: { isTrusted: false, supportHtml: false }"));
    assert!(!sources.contains("isTrusted: true"));
    let untrusted = &manifest()["capabilities"]["untrustedWorkspaces"];
    assert_eq!(untrusted["supported"], "limited");
    // What names a program to start, or an address to speak with.
    let restricted = &untrusted["restrictedConfigurations"];
    assert_eq!(*restricted, json!(["hedgerow.path", "hedgerow.bridge"]));
    let mut client = Client::able("utf-16");
    let said = "[run](command:workbench.action.terminal.new) <img src=x> `[code]`";
    client.open(&PROGRAM.replace("op f", &format!("/// {said}\nop f")));
    let params =
        json!({ "textDocument": { "uri": URI }, "position": { "line": 1, "character": 3 } });
    let hover = client.request("textDocument/hover", params).unwrap();
    let value = hover["contents"]["value"].as_str().unwrap();
    assert!(
        value.contains("\\[run](command:workbench.action.terminal.new) \\<img src=x> `[code]`"),
        "{value}"
    );
}

#[test]
fn a_test_is_named_as_a_filter() {
    assert!(sources().contains("[\"test\", path, `--filter=${name}`, \"--exact\"]"));
}

#[test]
fn a_script_runs_on_every_mesh_that_can_be_read() {
    let endings = FileFormat::ALL.map(|format| format!("\"{}\"", format.ending()));
    let filters = format!("{{ Meshes: [{}] }}", endings.join(", "));
    assert!(sources().contains(&filters), "{filters}");
}
