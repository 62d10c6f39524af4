//! Names over the files of a workspace, open or not.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use hedgerow::analysis::Reader;
use serde_json::{Value, json};

use crate::client::{Client, URI, document};

/// A disk with these files.
struct Shelf(BTreeMap<String, String>);

impl Reader for Shelf {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let file = self.0.get(name).cloned();
        file.ok_or_else(|| "there is no such file".to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }

    fn under(&mut self, folder: &str) -> Vec<String> {
        let names = self.0.keys();
        let inside = names.filter(|name| name.starts_with(&format!("{folder}/")));
        inside.cloned().collect()
    }
}

const OPS: &str = "file:///work/lib/ops.hedge";
const APP: &str = "file:///work/app/app.hedge";

/// An editor in the folder `/work`, in which three files lie and none is open.
fn editor(folders: Value) -> Client {
    let files = [
        ("/work/lib/ops.hedge", "op flip(e: edge) { }\nop turn(e: edge) { }\n"),
        (
            "/work/app/app.hedge",
            "use \"../lib/ops.hedge\"\nscript s() { for e in edges { flip(e) } }\n",
        ),
        ("/work/app/other.hedge", "op flip(e: edge) { }\n"),
        ("/else/far.hedge", "op far(e: edge) { }\n"),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
    Client::over(
        Box::new(Shelf(files.into())),
        json!({ "workspaceFolders": folders, "capabilities": {
            "general": { "positionEncodings": ["utf-8"] },
            "workspace": { "workspaceEdit": { "documentChanges": true } },
        } }),
    )
}

fn work() -> Value {
    json!([{ "uri": "file:///work", "name": "work" }])
}

/// The places of an answer, as file and line.
fn places(answer: &Value) -> Vec<String> {
    let place = |found: &Value| {
        let place = if found["location"].is_object() { &found["location"] } else { found };
        let file = place["uri"].as_str().unwrap().rsplit('/').next().unwrap();
        format!("{file}:{}", place["range"]["start"]["line"])
    };
    answer.as_array().unwrap().iter().map(place).collect()
}

#[test]
fn names_reach_over_files() {
    let mut client = Client::able("utf-8");
    let library = "file:///work/ops.hedge";
    client.open_as(library, "op flip(e: edge) { }\nscript s() { for e in edges { flip(e) } }\n");
    client.open("use \"ops.hedge\"\nuse \"std/triangle.hedge\"\nscript t() { for e in edges { flip(e) } }\n");
    let at = |line: u32, character: u32| json!({ "line": line, "character": character });
    let here = json!({ "textDocument": document(), "position": at(2, 32) });
    let found = client.request("textDocument/definition", here.clone()).unwrap();
    assert_eq!(found["uri"], library);
    assert_eq!(found["range"]["start"], at(0, 3));
    let mut params = here.clone();
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", params.clone()).unwrap();
    assert_eq!(found.as_array().unwrap().len(), 3);
    params["context"] = json!({ "includeDeclaration": false });
    let found = client.request("textDocument/references", params).unwrap();
    assert_eq!(found.as_array().unwrap().len(), 2);
    let mut params = here;
    params["newName"] = "turn".into();
    let edit = client.request("textDocument/rename", params).unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    let count = |uri: &str| {
        let of = changes.iter().find(|change| change["textDocument"]["uri"] == uri);
        of.map(|change| change["edits"].as_array().unwrap().len())
    };
    assert_eq!((count(library), count(URI)), (Some(2), Some(1)));
    // What a file says is heard by those who use it.
    let before = client.published().unwrap()["diagnostics"].clone();
    let change = json!({ "textDocument": { "uri": library, "version": 2 },
        "contentChanges": [{ "text": "op turn(e: edge) { }\n" }] });
    client.notify("textDocument/didChange", change);
    let after = &client.published().unwrap()["diagnostics"];
    assert_ne!(&before, after);
    let links = json!({ "textDocument": document() });
    let links = client.request("textDocument/documentLink", links).unwrap();
    assert_eq!(links[0]["target"], library);
    let std = links[1]["target"].as_str().unwrap();
    assert!(std.ends_with("/std/triangle.hedge"), "{std}");
}

#[test]
fn references_are_found_in_files_that_are_not_open() {
    let mut client = editor(work());
    client.open_as(OPS, "op flip(e: edge) { }\nop turn(e: edge) { }\n");
    let params = json!({ "textDocument": { "uri": OPS }, "position": { "line": 0, "character": 4 },
        "context": { "includeDeclaration": true } });
    let found = client.request("textDocument/references", params).unwrap();
    // `other.hedge` has a flip of its own.
    assert_eq!(places(&found), ["ops.hedge:0", "app.hedge:1"]);
}

#[test]
fn a_rename_reaches_files_that_are_not_open() {
    // From the file that calls; the one that declares is not open, nor in a folder.
    for folders in [work(), json!(null)] {
        let mut client = editor(folders);
        client
            .open_as(APP, "use \"../lib/ops.hedge\"\nscript s() { for e in edges { flip(e) } }\n");
        let rename = |to: &str| {
            json!({ "textDocument": { "uri": APP }, "position": { "line": 1, "character": 31 },
                "newName": to })
        };
        let edit = client.request("textDocument/rename", rename("spin")).unwrap();
        let changes = edit["documentChanges"].as_array().unwrap();
        let told: Vec<_> = changes
            .iter()
            .map(|change| {
                let document = &change["textDocument"];
                let count = change["edits"].as_array().unwrap().len();
                (document["uri"].clone(), document["version"].clone(), count)
            })
            .collect();
        // One that is not open has no version.
        let expected = [(json!(APP), json!(1), 1), (json!(OPS), json!(null), 1)];
        assert_eq!(told, expected);
        let (_, why) = client.request("textDocument/rename", rename("turn")).unwrap_err();
        assert_eq!(why, "there is already an op `turn` in `/work/lib/ops.hedge`");
    }
}

#[test]
fn a_rename_reaches_attributes_and_heeds_what_other_files_declare() {
    let mut client = Client::able("utf-8");
    let library = "file:///work/ops.hedge";
    client.open_as(library, "attr mass: vertex real = 0\nfn half(x: real) -> real { x / 2 }\n");
    client.open(
        "use \"ops.hedge\"\nfn third(x: real) -> real { half(x) * 2 / 3 }\n\
         script s() { for h in halfedges { h.vertex.mass = h.target.mass } }\n",
    );
    let mut rename = |uri: &str, line: u32, character: u32, to: &str| {
        let at = json!({ "line": line, "character": character });
        let params = json!({ "textDocument": { "uri": uri }, "position": at, "newName": to });
        client.request("textDocument/rename", params)
    };
    for (uri, line, character) in [(library, 0, 5), (URI, 2, 43)] {
        let edit = rename(uri, line, character, "weight").unwrap();
        let changes = edit["documentChanges"].as_array().unwrap();
        let count = |change: &Value| change["edits"].as_array().unwrap().len();
        let mut counts: Vec<_> = changes.iter().map(count).collect();
        counts.sort_unstable();
        assert_eq!(counts, [1, 2]);
    }
    let (_, why) = rename(library, 1, 3, "third").unwrap_err();
    assert_eq!(why, "there is already a function `third` in `/work/test.hedge`");
}

/// `ops::half` and `half` are one function.
#[test]
fn a_rename_reaches_names_with_their_files() {
    let mut client = Client::able("utf-8");
    let library = "file:///work/ops.hedge";
    client.open_as(library, "fn half(x: real) -> real { x / 2 }\n");
    client.open("use \"ops.hedge\"\nfn third(x: real) -> real { ops::half(x) + half(x) }\n");
    for character in [34, 47] {
        let at = json!({ "line": 1, "character": character });
        let params = json!({ "textDocument": { "uri": URI }, "position": at, "newName": "part" });
        let edit = client.request("textDocument/rename", params).unwrap();
        let changes = edit["documentChanges"].as_array().unwrap();
        let count = |change: &Value| change["edits"].as_array().unwrap().len();
        let counts: BTreeSet<_> = changes.iter().map(count).collect();
        assert_eq!(counts, BTreeSet::from([1, 2]), "{edit}");
        let place = json!({ "textDocument": { "uri": URI }, "position": at });
        let marked = client.request("textDocument/documentHighlight", place).unwrap();
        assert_eq!(marked.as_array().unwrap().len(), 2, "{marked}");
    }
}

#[test]
fn symbols_are_those_of_the_workspace() {
    let mut client = editor(work());
    let symbols = |client: &mut Client, query: &str| {
        let found = client.request("workspace/symbol", json!({ "query": query }));
        places(&found.unwrap())
    };
    assert_eq!(symbols(&mut client, "flip"), ["other.hedge:0", "ops.hedge:0"]);
    assert_eq!(symbols(&mut client, "far"), [""; 0]);
    let far = json!([{ "uri": "file:///else", "name": "else" }]);
    let change = json!({ "event": { "added": far, "removed": work() } });
    client.notify("workspace/didChangeWorkspaceFolders", change);
    assert_eq!(symbols(&mut client, "flip"), [""; 0]);
    assert_eq!(symbols(&mut client, "far"), ["far.hedge:0"]);
    // What is open counts as the editor has it.
    client.open_as("file:///else/far.hedge", "\nop nearer(e: edge) { }\n");
    assert_eq!(symbols(&mut client, "far"), [""; 0]);
    assert_eq!(symbols(&mut client, "near"), ["far.hedge:1"]);
}

#[test]
fn a_file_appears_that_only_a_used_file_looks_for() {
    let mut client = Client::able("utf-8");
    let give = |client: &mut Client, name: &str, text: &str| {
        let file = json!({ "uri": format!("file:///work/parts/{name}"), "text": text });
        client.notify("hedgerow/files", json!({ "files": [file] }));
    };
    give(&mut client, "b.hedge", "use \"c.hedge\"\nscript b() { c() }\n");
    client.open("use \"parts/b.hedge\"\nscript main() { b() }\n");
    let errors =
        |client: &Client| client.published().unwrap()["diagnostics"].as_array().unwrap().len();
    assert_eq!(errors(&client), 1);
    give(&mut client, "c.hedge", "script c() { }\n");
    assert_eq!(errors(&client), 0);
}

/// The text that the server has read of a file when it was closed counts no longer.
#[test]
fn a_file_that_is_opened_later_is_not_there_twice() {
    let mut client = editor(work());
    client.open_as(OPS, "op flip(e: edge) { }\nop turn(e: edge) { }\n");
    let params = json!({ "textDocument": { "uri": OPS }, "position": { "line": 0, "character": 4 },
        "context": { "includeDeclaration": true } });
    client.request("textDocument/references", params.clone()).unwrap();
    let text = "use \"../lib/ops.hedge\"\n\nfn twice(x: real) { 2 * x }\n";
    client.open_as(APP, text);
    let found = client.request("textDocument/references", params).unwrap();
    assert_eq!(places(&found), ["ops.hedge:0"]);
    let rename = json!({ "textDocument": { "uri": APP }, "newName": "y",
        "position": { "line": 2, "character": 9 } });
    let edit = client.request("textDocument/rename", rename).unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes[0]["edits"].as_array().unwrap().len(), 2, "{edit}");
}

/// A disk that counts what is read.
struct Counted(Shelf, Rc<Cell<usize>>);

impl Reader for Counted {
    fn read(&mut self, name: &str) -> Result<String, String> {
        self.1.set(self.1.get() + 1);
        self.0.read(name)
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        self.0.beside(name)
    }

    fn under(&mut self, folder: &str) -> Vec<String> {
        self.0.under(folder)
    }
}

/// Of a chain of files, only those are analyzed that have the name.
#[test]
fn files_without_the_name_are_not_analyzed() {
    const COUNT: usize = 40;
    let text = |at: usize| {
        let used = format!("use \"f{}.hedge\"\n", at + 1);
        let used = if at + 1 < COUNT { used } else { "\n".to_owned() };
        format!("{used}fn g{at}(x: real) {{ x }}\n")
    };
    let files = (0..COUNT).map(|at| (format!("/work/f{at}.hedge"), text(at)));
    let reads = Rc::new(Cell::new(0));
    let disk = Counted(Shelf(files.collect()), Rc::clone(&reads));
    let mut client = Client::over(Box::new(disk), json!({ "workspaceFolders": work() }));
    let uri = "file:///work/f0.hedge";
    client.open_as(uri, &text(0));
    let at = json!({ "line": 1, "character": 4 });
    let params = json!({ "textDocument": { "uri": uri }, "position": at,
        "context": { "includeDeclaration": true } });
    let found = client.request("textDocument/references", params).unwrap();
    assert_eq!(places(&found), ["f0.hedge:1"]);
    let rename = json!({ "textDocument": { "uri": uri }, "position": at, "newName": "first" });
    client.request("textDocument/rename", rename).unwrap();
    let reads = reads.get();
    assert!(reads < 6 * COUNT, "{reads} files are read");
}

/// The words that complete a path are those of the files around, open or not, and of the library.
#[test]
fn a_path_leads_to_the_files_around() {
    let mut client = Client::able("utf-8");
    client.open_as("file:///work/lib/ops.hedge", "op turn(e: edge) { }\n");
    client.open_as("file:///work/app/other.hedge", "op flip(e: edge) { }\n");
    let given = json!({ "uri": "file:///work/far.hedge", "text": "op far(e: edge) { }\n" });
    client.notify("hedgerow/files", json!({ "files": [given] }));
    let mut paths = |path: &str| -> Vec<String> {
        client.open_as(APP, &format!("use \"{path}\"\n"));
        let here = json!({ "line": 0, "character": 5 + path.len() });
        let params = json!({ "textDocument": { "uri": APP }, "position": here });
        let found = client.request("textDocument/completion", params).unwrap();
        let labels = found["items"].as_array().unwrap().iter().map(|item| &item["label"]);
        let labels = labels.map(|label| label.as_str().unwrap().to_owned());
        labels.filter(|label| !label.starts_with("std/")).collect()
    };
    assert_eq!(paths(""), ["../far.hedge", "other.hedge"]);
    assert_eq!(paths("../"), ["../far.hedge"]);
    assert_eq!(paths("../lib/"), ["../lib/ops.hedge"]);
}

/// What the client shows of a document changes with the files that it uses, and with the settings.
#[test]
fn what_is_outdated_is_requested_again() {
    let mut client = Client::new(json!({ "capabilities": { "workspace": {
        "codeLens": { "refreshSupport": true },
        "semanticTokens": { "refreshSupport": true },
        "inlayHint": { "refreshSupport": false },
    } } }));
    let expected = ["workspace/codeLens/refresh", "workspace/semanticTokens/refresh"];
    let asked = |client: &mut Client| -> Vec<String> {
        client.asked.drain(..).map(|asked| asked.method).collect()
    };
    let part = "file:///work/part.hedge";
    client.open_as(part, "script part() { }\n");
    client.open("use \"part.hedge\"\nscript main() { part() }\n");
    assert!(asked(&mut client).is_empty());
    let change = |client: &mut Client, uri: &str, text: &str| {
        let change = json!({ "textDocument": { "uri": uri, "version": 2 },
            "contentChanges": [{ "text": text }] });
        client.notify("textDocument/didChange", change);
    };
    change(&mut client, part, "script other() { }\n");
    assert_eq!(asked(&mut client), expected);
    // What changes by its own text is requested anyway.
    change(&mut client, URI, "use \"part.hedge\"\nscript main() { other() }\n");
    assert!(asked(&mut client).is_empty());
    let settings = json!({ "settings": { "codeLens": { "enable": false } } });
    client.notify("workspace/didChangeConfiguration", settings.clone());
    assert_eq!(asked(&mut client), expected);
    client.notify("workspace/didChangeConfiguration", settings);
    assert!(asked(&mut client).is_empty());
}

/// A disk on which `/work/link.hedge` leads to `/work/part.hedge`.
struct Linked;

impl Reader for Linked {
    fn read(&mut self, _name: &str) -> Result<String, String> {
        Ok("script saved() { }\n".to_owned())
    }

    fn identity(&mut self, name: &str) -> String {
        name.replace("link", "part")
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

#[test]
fn a_link_leads_to_the_text_that_is_open() {
    let mut client = Client::over(Box::new(Linked), json!({ "capabilities": {} }));
    let part = "file:///work/part.hedge";
    client.open_as(part, "script open() { }\n");
    client.open("use \"link.hedge\"\nscript main() { later() }\n");
    let errors =
        |client: &Client| client.published().unwrap()["diagnostics"].as_array().unwrap().len();
    assert_eq!(errors(&client), 1);
    let change = json!({ "textDocument": { "uri": part, "version": 2 },
        "contentChanges": [{ "text": "script later() { }\n" }] });
    client.notify("textDocument/didChange", change);
    assert_eq!(errors(&client), 0);
}

/// The text of a program after the edits of an answer.
fn after(edit: &Value, uri: &str, text: &str) -> String {
    let changes = edit["documentChanges"].as_array().unwrap();
    let Some(change) = changes.iter().find(|change| change["textDocument"]["uri"] == uri) else {
        return text.to_owned();
    };
    let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
    let mut edits: Vec<_> = change["edits"].as_array().unwrap().iter().collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit["range"]["start"]["character"].as_u64()));
    for edit in edits {
        let (start, end) = (&edit["range"]["start"], &edit["range"]["end"]);
        assert_eq!(start["line"], end["line"]);
        let at = |place: &Value| place["character"].as_u64().unwrap() as usize;
        let line = &mut lines[start["line"].as_u64().unwrap() as usize];
        line.replace_range(at(start)..at(end), edit["newText"].as_str().unwrap());
    }
    lines.join("\n") + "\n"
}

#[test]
fn moved_files_are_used_by_their_new_paths() {
    let ops = "use \"near.hedge\"\nuse \"std/triangle.hedge\"\nop turn(e: edge) { }\n";
    let app = "use \"../lib/ops.hedge\"\nuse \"./other.hedge\"\n\
               script s() { for e in edges { ops::turn(e) turn(e) } }\n";
    let [near, other] = ["op near(e: edge) { }\n", "op other(e: edge) { }\n"];
    let texts = [
        ("/work/lib/ops.hedge", ops),
        ("/work/lib/near.hedge", near),
        ("/work/app/app.hedge", app),
        ("/work/app/other.hedge", other),
    ];
    let files = texts.map(|(name, text)| (name.to_owned(), text.to_owned()));
    let mut client = Client::over(
        Box::new(Shelf(files.into())),
        json!({ "workspaceFolders": work(), "capabilities": {
            "general": { "positionEncodings": ["utf-8"] },
            "workspace": { "workspaceEdit": { "documentChanges": true } },
        } }),
    );
    client.open_as(APP, app);
    let mut told = |moves: &[(&str, &str)]| {
        let files = moves.iter().map(|(old, new)| {
            json!({ "oldUri": format!("file:///work/{old}"), "newUri": format!("file:///work/{new}") })
        });
        let params = json!({ "files": files.collect::<Vec<_>>() });
        client.request("workspace/willRenameFiles", params).unwrap()
    };
    let renamed = told(&[("lib/ops.hedge", "lib/more/turns.hedge")]);
    let expected = app.replace("lib/ops.hedge", "lib/more/turns.hedge").replace("ops::", "turns::");
    assert_eq!(after(&renamed, APP, app), expected);
    let expected = ops.replace("near.hedge", "../near.hedge");
    assert_eq!(after(&renamed, OPS, ops), expected);
    // A name that no program can write.
    let renamed = told(&[("lib/ops.hedge", "lib/my-ops.hedge")]);
    let expected = app.replace("lib/ops.hedge", "lib/my-ops.hedge").replace("ops::", "");
    assert_eq!(after(&renamed, APP, app), expected);
    // A folder, in which paths stay as they are.
    let renamed = told(&[("lib/", "app/std/")]);
    let expected = app.replace("../lib/ops.hedge", "./std/ops.hedge");
    assert_eq!(after(&renamed, APP, app), expected);
    assert_eq!(after(&renamed, OPS, ops), ops);
    // All files together.
    assert!(told(&[("lib", "a/lib"), ("app", "a/app")]).is_null());
    let renamed = told(&[("app/app.hedge", "app.hedge"), ("app/other.hedge", "other.hedge")]);
    assert_eq!(after(&renamed, APP, app), app.replace("../lib", "lib"));
    // A path that only begins alike.
    assert!(told(&[("lib/ops", "lib/moved")]).is_null());
}

/// A disk whose files come and go.
struct Changing(Rc<RefCell<BTreeMap<String, String>>>);

impl Reader for Changing {
    fn read(&mut self, name: &str) -> Result<String, String> {
        self.0.borrow().get(name).cloned().ok_or_else(|| "there is no such file".to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }

    fn under(&mut self, _folder: &str) -> Vec<String> {
        Vec::new()
    }
}

fn errors_of(client: &mut Client, uri: &str) -> usize {
    let params = json!({ "textDocument": { "uri": uri } });
    let told = client.request("textDocument/diagnostic", params).unwrap();
    told["items"].as_array().unwrap().len()
}

/// A client that is told of the folder alone has deleted what lies in it, too.
#[test]
fn a_folder_that_is_deleted_takes_its_files_along() {
    let files = [("/work/lib/ops.hedge".to_owned(), "fn one() -> int { 1 }\n".to_owned())];
    let disk = Rc::new(RefCell::new(BTreeMap::from(files)));
    let changing = Box::new(Changing(Rc::clone(&disk)));
    let mut client = Client::over(changing, json!({ "workspaceFolders": work() }));
    client.open_as(APP, "use \"../lib/ops.hedge\"\nscript s() { print one() }\n");
    assert_eq!(errors_of(&mut client, APP), 0);
    disk.borrow_mut().clear();
    let deleted = |uri: &str| json!({ "changes": [{ "uri": uri, "type": 3 }] });
    client.notify("workspace/didChangeWatchedFiles", deleted("file:///work/li"));
    assert_eq!(errors_of(&mut client, APP), 0, "this is another folder");
    client.notify("workspace/didChangeWatchedFiles", deleted("file:///work/lib"));
    assert!(errors_of(&mut client, APP) > 0);
}

/// Editors write one path as several URIs.
#[test]
fn a_file_that_is_closed_under_one_uri_stays_open_under_another() {
    let mut client = editor(work());
    client.open_as(OPS, "fn two() -> int { 2 }\n");
    client.open_as(APP, "use \"../lib/ops.hedge\"\nscript s() { print two() }\n");
    assert_eq!(errors_of(&mut client, APP), 0);
    let other = "file:///work/lib/%6Fps.hedge";
    client.open_as(other, "fn two() -> int { 2 }\n");
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": other } }));
    assert_eq!(errors_of(&mut client, APP), 0);
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": OPS } }));
    assert!(errors_of(&mut client, APP) > 0);
}

/// What stands behind an op does not belong to it, however the text has come about.
#[test]
fn what_stands_behind_an_op_leaves_its_verdict() {
    let text = include_str!("../../examples/flip.hedge").trim_end();
    let more = format!("{text}x");
    let lenses = |client: &mut Client| {
        let found = client.request("textDocument/codeLens", json!({ "textDocument": document() }));
        let found = found.unwrap();
        let titles = found.as_array().unwrap().iter().map(|lens| lens["command"]["title"].clone());
        titles.collect::<Vec<_>>()
    };
    let mut typed = Client::able("utf-8");
    typed.open(text);
    let before = lenses(&mut typed);
    typed.notify(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": more }] }),
    );
    let mut fresh = Client::able("utf-8");
    fresh.open(&more);
    assert!(before.iter().any(|title| title.as_str().is_some_and(|it| it.contains("proved"))));
    assert_eq!(lenses(&mut typed), before);
    assert_eq!(lenses(&mut fresh), before);
}
