"""A conversation with pytest-lsp, under the capabilities that real clients announce."""

import os
import pathlib
import re

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

BROKEN = """\
/// Rotates an edge between two triangles by one corner.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
  }
}
"""

PROFILES = ["visual_studio_code", "neovim", "emacs"]


@pytest_lsp.fixture(
    params=PROFILES,
    config=ClientServerConfig(server_command=[os.environ["HEDGEROW"], "lsp"]),
)
async def client(request, lsp_client: LanguageClient):
    # The profiles announce it, the client itself does not have it.
    @lsp_client.feature(lsp.CLIENT_REGISTER_CAPABILITY)
    def register(params: lsp.RegistrationParams):
        return None

    name = request.param
    capabilities = client_capabilities(name)
    names = {"visual_studio_code": "Visual Studio Code"}
    await lsp_client.initialize_session(
        lsp.InitializeParams(
            capabilities=capabilities,
            client_info=lsp.ClientInfo(name=names.get(name, name)),
            workspace_folders=None,
        )
    )
    lsp_client.profile = name
    yield
    await lsp_client.shutdown_session()


def say(client, what, answer):
    text = re.sub(r"base64,[A-Za-z0-9+/=]+", "base64,…", str(answer))
    print(f"[{client.profile}] {what}: {text}")


@pytest.mark.asyncio
async def test_a_person_mends_the_flip(client: LanguageClient, tmp_path: pathlib.Path):
    uri = (tmp_path / "flip.hedge").as_uri()
    document = lsp.TextDocumentIdentifier(uri)
    client.text_document_did_open(
        lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "hedgerow", 1, BROKEN))
    )
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    [told] = client.diagnostics[uri]
    say(client, "squiggle", f"{told.range} {told.code} {told.message.splitlines()[0]}")
    assert told.code == "missing-reassignment"
    assert told.related_information

    actions = await client.text_document_code_action_async(
        lsp.CodeActionParams(document, told.range, lsp.CodeActionContext([told]))
    )
    say(client, "actions", [action.title for action in actions])
    [fix] = [action for action in actions if action.is_preferred]
    assert fix.title == "insert `edge e: a | d`"
    changes = fix.edit.document_changes
    edits = changes[0].edits if changes else fix.edit.changes[uri]
    [edit] = edits
    assert edit.range.start == edit.range.end

    text_change = lsp.TextDocumentContentChangePartial(text=edit.new_text, range=edit.range)
    client.text_document_did_change(
        lsp.DidChangeTextDocumentParams(
            lsp.VersionedTextDocumentIdentifier(2, uri), [text_change]
        )
    )
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert not client.diagnostics[uri]
    say(client, "mended", "nothing is wrong")

    def at(line, character):
        return lsp.Position(line, character)

    hover = await client.text_document_hover_async(lsp.HoverParams(document, at(1, 4)))
    say(client, "hover", hover.contents.value)
    assert "proved" in hover.contents.value
    drawn = "data:image/svg+xml;base64," in hover.contents.value
    assert drawn == (client.profile == "visual_studio_code")

    found = await client.text_document_document_highlight_async(
        lsp.DocumentHighlightParams(document, at(3, 17))
    )
    say(client, "highlight", [(h.range.start.line, h.range.start.character) for h in found])
    assert len(found) == 4

    edit = await client.text_document_rename_async(
        lsp.RenameParams(document, at(3, 17), "spoke")
    )
    say(client, "rename", edit.document_changes or edit.changes)

    found = await client.text_document_completion_async(
        lsp.CompletionParams(document, at(9, 18))
    )
    say(client, "completion", [item.label for item in found.items][:8])

    lenses = await client.text_document_code_lens_async(lsp.CodeLensParams(document))
    say(client, "lenses", [lens.command.title for lens in lenses])
    assert lenses[0].command.title == "proved, 1 case"

    tokens = await client.text_document_semantic_tokens_full_async(
        lsp.SemanticTokensParams(document)
    )
    assert len(tokens.data) % 5 == 0 and tokens.data
    edits = await client.text_document_formatting_async(
        lsp.DocumentFormattingParams(document, lsp.FormattingOptions(2, True))
    )
    say(client, "formatting", edits)
    address = await client.workspace_execute_command_async(
        lsp.ExecuteCommandParams("hedgerow.showDiagram", [uri, "flip"])
    )
    import urllib.request

    shown = urllib.request.urlopen(address + "shown").read().decode()
    say(client, "preview", shown[:60])
    assert '"title":"flip"' in shown and "<svg" in shown


OPS = """\
/// Spins an edge.
op spin(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
"""

MAIN = """\
use "ops.hedge"
use "std/triangle.hedge"

/// Spins what it can.
script spins(times: int = 1) {
  repeat times {
    for e in edges where length(e) > 0.5 {
      spin(e)
      let l = length(e)
      print l
    }
  }
}

test "twice" {
  mesh = icosahedron()
  for e in edges { must spin(e) break }
}
"""

CLOSED = """\
use "ops.hedge"

fn once(e: edge) {
  spin(e)
}
"""


@pytest.mark.asyncio
async def test_a_person_walks_a_workspace(client: LanguageClient, tmp_path: pathlib.Path):
    """Every other feature once, over three files of which one is not open."""
    uris = {}
    for name, text in {"ops": OPS, "main": MAIN, "closed": CLOSED}.items():
        path = tmp_path / f"{name}.hedge"
        path.write_text(text)
        uris[name] = path.as_uri()
    client.workspace_did_change_workspace_folders(
        lsp.DidChangeWorkspaceFoldersParams(
            lsp.WorkspaceFoldersChangeEvent([lsp.WorkspaceFolder(tmp_path.as_uri(), "w")], [])
        )
    )
    uri = uris["main"]
    main = lsp.TextDocumentIdentifier(uri)
    client.text_document_did_open(
        lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "hedgerow", 1, MAIN))
    )
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert not client.diagnostics[uri]

    lines = MAIN.splitlines()

    def at(word, times=1, text=lines):
        for line, content in enumerate(text):
            if word in content:
                times -= 1
                if times == 0:
                    return lsp.Position(line, content.index(word) + 1)
        raise AssertionError(word)

    def places(found):
        return [f"{place.uri.rsplit('/', 1)[1]} {place.range.start}" for place in found]

    report = await client.text_document_diagnostic_async(lsp.DocumentDiagnosticParams(main))
    assert report.kind == "full" and not report.items

    found = await client.text_document_definition_async(lsp.DefinitionParams(main, at("spin(e)")))
    say(client, "definition", places([found]))
    assert found.uri == uris["ops"]
    found = await client.text_document_definition_async(lsp.DefinitionParams(main, at("std/")))
    text = pathlib.Path(found.uri.removeprefix("file://")).read_text()
    say(client, "definition of the library", text.splitlines()[0])

    found = await client.text_document_references_async(
        lsp.ReferenceParams(lsp.ReferenceContext(True), main, at("spin(e)"))
    )
    say(client, "references", places(found))
    assert len(found) == 4
    found = await client.text_document_prepare_rename_async(
        lsp.PrepareRenameParams(main, at("spin(e)"))
    )
    assert found.placeholder == "spin"
    edit = await client.text_document_rename_async(
        lsp.RenameParams(main, at("spin(e)"), "turn")
    )
    edits = edit.changes or {e.text_document.uri: e.edits for e in edit.document_changes}
    say(client, "rename", {uri.rsplit("/", 1)[1]: len(e) for uri, e in edits.items()})
    assert {u: len(e) for u, e in edits.items()} == {uris["ops"]: 1, uri: 2, uris["closed"]: 1}

    help = await client.text_document_signature_help_async(
        lsp.SignatureHelpParams(main, at("(e) > 0.5"))
    )
    say(client, "signature", [s.label for s in help.signatures])
    hover = await client.text_document_hover_async(lsp.HoverParams(main, at("spin(e)")))
    say(client, "hover over a call", hover.contents.value.splitlines()[:4])
    assert "Spins an edge" in hover.contents.value

    symbols = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(main))
    say(client, "outline", [s.name for s in symbols])
    symbols = await client.workspace_symbol_async(lsp.WorkspaceSymbolParams("spi"))
    say(client, "symbols", sorted(s.name for s in symbols))
    assert {"spin", "spins"} <= {s.name for s in symbols}
    folds = await client.text_document_folding_range_async(lsp.FoldingRangeParams(main))
    say(client, "folds", [(f.start_line, f.end_line) for f in folds])
    [inner] = await client.text_document_selection_range_async(
        lsp.SelectionRangeParams(main, [at("0.5")])
    )
    widths = []
    while inner:
        widths.append(str(inner.range))
        inner = inner.parent
    say(client, "selection", widths)
    assert len(widths) > 5
    part = lsp.Range(lsp.Position(4, 0), lsp.Position(6, 0))
    tokens = await client.text_document_semantic_tokens_range_async(
        lsp.SemanticTokensRangeParams(main, part)
    )
    assert tokens.data
    whole = lsp.Range(lsp.Position(0, 0), lsp.Position(len(lines), 0))
    hints = await client.text_document_inlay_hint_async(lsp.InlayHintParams(main, whole))
    say(client, "hints", [h.label for h in hints])
    links = await client.text_document_document_link_async(lsp.DocumentLinkParams(main))
    say(client, "links", [link.target.rsplit("/", 1)[1] for link in links])
    assert len(links) == 2
    edits = await client.text_document_range_formatting_async(
        lsp.DocumentRangeFormattingParams(main, whole, lsp.FormattingOptions(2, True))
    )
    say(client, "range formatting", edits)
    found = await client.text_document_completion_async(
        lsp.CompletionParams(main, at("spin(e)"))
    )
    say(client, "completion of a statement", [item.label for item in found.items][:8])

    lenses = await client.text_document_code_lens_async(lsp.CodeLensParams(main))
    say(client, "lenses", [lens.command.title for lens in lenses])
    commands = {lens.command.command: lens.command for lens in lenses}
    test, script = commands["hedgerow.runTest"], commands["hedgerow.runScript"]
    told = await client.workspace_execute_command_async(
        lsp.ExecuteCommandParams(test.command, test.arguments)
    )
    say(client, "test", told)
    mesh = pathlib.Path(__file__).parents[2] / "examples/meshes/bunny.obj"
    told = await client.workspace_execute_command_async(
        lsp.ExecuteCommandParams(
            script.command, [*script.arguments, str(mesh), str(tmp_path / "out.obj")]
        )
    )
    say(client, "script", told)

    # A file that is not open changes on the disk: what uses it is told of again.
    (tmp_path / "ops.hedge").write_text(OPS.replace("op spin", "op turn"))
    client.workspace_did_change_watched_files(
        lsp.DidChangeWatchedFilesParams(
            [lsp.FileEvent(uris["ops"], lsp.FileChangeType.Changed)]
        )
    )
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    say(client, "a used file changed", [d.message.splitlines()[0] for d in client.diagnostics[uri]])
    assert client.diagnostics[uri]
