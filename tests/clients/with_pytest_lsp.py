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
