//! The client: its capabilities and its settings.

use serde::Deserialize;
use serde_json::Value;

use super::position::Encoding;

/// The client.
#[derive(Debug, Default)]
pub(super) struct Client {
    /// The unit that a column counts.
    pub(super) encoding: Encoding,
    /// Its capabilities, of which few are asked for.
    capabilities: Value,
    /// The settings it asks for.
    pub(super) settings: Settings,
    /// True if it is known to draw the images of a hover.
    draws_images: bool,
}

/// The way the operation under the cursor is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum HoverPicture {
    /// As an image if the client is known to draw it, else as text.
    #[default]
    Auto,
    /// As an image.
    Svg,
    /// As text.
    Text,
}

/// The settings of the section `hedgerow`; missing or invalid ones have their defaults.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Settings {
    /// `hover.picture`: `auto`, `svg` or `text`.
    pub(super) picture: HoverPicture,
    /// `inlayHints.enable`
    pub(super) hints: bool,
    /// `codeLens.enable`
    pub(super) lenses: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { picture: HoverPicture::Auto, hints: true, lenses: true }
    }
}

impl Settings {
    /// Reads settings, with or without the section's name around them.
    pub(super) fn read(value: &Value) -> Self {
        let own = value.get("hedgerow").unwrap_or(value);
        let at = |section: &str, name: &str| own.get(section).and_then(|found| found.get(name));
        let picture = at("hover", "picture").cloned().unwrap_or_default();
        let flag = |value: Option<&Value>| value.and_then(Value::as_bool).unwrap_or(true);
        Self {
            picture: serde_json::from_value(picture).unwrap_or_default(),
            hints: flag(at("inlayHints", "enable")),
            lenses: flag(at("codeLens", "enable")),
        }
    }
}

/// Clients that draw an SVG in the Markdown of a hover, by a part of their names.
const DRAWING_CLIENTS: [&str; 6] =
    ["visual studio code", "code - oss", "vscod", "code-server", "monaco", "codemirror"];

impl Client {
    /// The client that says this of itself in `initialize`. What is missing or malformed counts as
    /// absent.
    pub(super) fn new(hello: &Value) -> Self {
        let name = hello.pointer("/clientInfo/name").and_then(Value::as_str);
        let name = name.unwrap_or_default().to_lowercase();
        let options = hello.get("initializationOptions");
        let capabilities = hello.get("capabilities").cloned().unwrap_or_default();
        let encodings: Vec<&str> = words(&capabilities, "/general/positionEncodings").collect();
        Self {
            encoding: Encoding::agreed(&encodings),
            settings: options.map(Settings::read).unwrap_or_default(),
            draws_images: DRAWING_CLIENTS.iter().any(|known| name.contains(known)),
            capabilities,
        }
    }

    /// True if the client has the capability at a path.
    fn can(&self, path: &str) -> bool {
        self.capabilities.pointer(path).and_then(Value::as_bool).unwrap_or(false)
    }

    /// True if a hover shows an image.
    pub(super) fn wants_images(&self) -> bool {
        match self.settings.picture {
            HoverPicture::Auto => self.draws_images,
            HoverPicture::Svg => true,
            HoverPicture::Text => false,
        }
    }

    /// True if the client shows published diagnostics. Most clients that can also request them
    /// would show them all twice.
    pub(super) fn shows_published(&self) -> bool {
        self.capabilities.pointer("/textDocument/publishDiagnostics").is_some_and(Value::is_object)
    }

    /// True if a hover may be Markdown.
    pub(super) fn reads_markdown(&self) -> bool {
        words(&self.capabilities, "/textDocument/hover/contentFormat").any(|it| it == "markdown")
    }

    /// True if the documentation of a completion may be Markdown.
    pub(super) fn reads_markdown_of_completions(&self) -> bool {
        let formats = "/textDocument/completion/completionItem/documentationFormat";
        words(&self.capabilities, formats).any(|it| it == "markdown")
    }

    /// True if completions may have placeholders.
    pub(super) fn takes_snippets(&self) -> bool {
        self.can("/textDocument/completion/completionItem/snippetSupport")
    }

    /// True if the server may show progress of its own.
    pub(super) fn shows_progress(&self) -> bool {
        self.can("/window/workDoneProgress")
    }

    /// True if the client opens a page when it is asked to.
    pub(super) fn shows_documents(&self) -> bool {
        self.can("/window/showDocument/support")
    }

    /// True if symbols may be nested.
    pub(super) fn nests_symbols(&self) -> bool {
        self.can("/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport")
    }

    /// True if a change may say which version of a document it is about.
    pub(super) fn takes_versioned_edits(&self) -> bool {
        self.can("/workspace/workspaceEdit/documentChanges")
    }

    /// True if the client can be asked for its settings.
    pub(super) fn has_configuration(&self) -> bool {
        self.can("/workspace/configuration")
    }

    /// True if the client can be asked to request something of a feature again.
    pub(super) fn refreshes(&self, feature: &str) -> bool {
        self.can(&format!("/workspace/{feature}/refreshSupport"))
    }

    /// True if the client can be asked to watch files.
    pub(super) fn watches_files(&self) -> bool {
        self.can("/workspace/didChangeWatchedFiles/dynamicRegistration")
    }
}

/// The words of the list at a path.
fn words<'v>(value: &'v Value, path: &str) -> impl Iterator<Item = &'v str> {
    value.pointer(path).and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str)
}
