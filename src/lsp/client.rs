//! The client: its capabilities and its settings.

use gen_lsp_types::{ClientCapabilities, InitializeParams};
use serde::Deserialize;
use serde_json::Value;

use super::position::Encoding;

/// The client.
#[derive(Debug, Default)]
pub(super) struct Client {
    /// The unit that a column counts.
    pub(super) encoding: Encoding,
    /// Its capabilities.
    pub(super) can: ClientCapabilities,
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
    pub(super) fn new(params: &InitializeParams) -> Self {
        let general = params.capabilities.general.as_ref();
        let offered = general.and_then(|general| general.position_encodings.as_deref());
        let name = params.client_info.as_ref().map(|info| info.name.to_lowercase());
        let name = name.unwrap_or_default();
        let options = params.initialization_options.as_ref();
        Self {
            encoding: Encoding::agreed(offered.unwrap_or_default()),
            can: params.capabilities.clone(),
            settings: options.map(Settings::read).unwrap_or_default(),
            draws_images: DRAWING_CLIENTS.iter().any(|known| name.contains(known)),
        }
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
        let text = self.can.text_document.as_ref();
        text.is_some_and(|text| text.publish_diagnostics.is_some())
    }

    /// True if a hover may be Markdown.
    pub(super) fn reads_markdown(&self) -> bool {
        let hover = self.can.text_document.as_ref().and_then(|can| can.hover.as_ref());
        let formats = hover.and_then(|hover| hover.content_format.as_ref());
        formats.is_some_and(|formats| formats.contains(&gen_lsp_types::MarkupKind::Markdown))
    }

    /// True if completions may have placeholders.
    pub(super) fn takes_snippets(&self) -> bool {
        let text = self.can.text_document.as_ref();
        let completion = text.and_then(|text| text.completion.as_ref());
        let item = completion.and_then(|completion| completion.completion_item.as_ref());
        item.and_then(|item| item.snippet_support).unwrap_or(false)
    }

    /// True if the server may show progress of its own.
    pub(super) fn shows_progress(&self) -> bool {
        let window = self.can.window.as_ref();
        window.and_then(|window| window.work_done_progress).unwrap_or(false)
    }

    /// True if the client opens a page when it is asked to.
    pub(super) fn shows_documents(&self) -> bool {
        let window = self.can.window.as_ref();
        window.and_then(|window| window.show_document.as_ref()).is_some_and(|show| show.support)
    }

    /// True if symbols may be nested.
    pub(super) fn nests_symbols(&self) -> bool {
        let text = self.can.text_document.as_ref();
        let symbols = text.and_then(|text| text.document_symbol.as_ref());
        symbols.and_then(|symbols| symbols.hierarchical_document_symbol_support).unwrap_or(false)
    }

    /// True if a change may say which version of a document it is about.
    pub(super) fn takes_versioned_edits(&self) -> bool {
        let workspace = self.can.workspace.as_ref();
        let edit = workspace.and_then(|workspace| workspace.workspace_edit.as_ref());
        edit.and_then(|edit| edit.document_changes).unwrap_or(false)
    }

    /// True if the client can be asked for its settings.
    pub(super) fn has_configuration(&self) -> bool {
        let workspace = self.can.workspace.as_ref();
        workspace.and_then(|workspace| workspace.configuration).unwrap_or(false)
    }

    /// True if the client can be asked to watch files.
    pub(super) fn watches_files(&self) -> bool {
        let workspace = self.can.workspace.as_ref();
        let watched = workspace.and_then(|workspace| workspace.did_change_watched_files.as_ref());
        watched.and_then(|watched| watched.dynamic_registration).unwrap_or(false)
    }
}
