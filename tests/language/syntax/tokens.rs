//! Tokens, and what stands in texts.

use hedgerow::source::{FileId, Span};
use hedgerow::syntax::text::{holes, read_text};
use hedgerow::syntax::{CommentKind, TokenKind, lex};

fn kinds(text: &str) -> Vec<TokenKind> {
    let lexed = lex(FileId(0), text);
    assert_eq!(lexed.diagnostics, []);
    lexed.tokens.iter().map(|token| token.kind).collect()
}

#[test]
fn marks_of_fixed_spelling_read_as_themselves() {
    for &(word, kind) in TokenKind::KEYWORDS.iter().chain(TokenKind::MARKS) {
        assert_eq!(kinds(word), [kind], "{word}");
    }
}

#[test]
fn numbers_names_and_arrows_end_where_they_should() {
    use TokenKind::{Arrow, Dot, FatArrow, Int, Minus, Real, Slash, Star, Word};
    assert_eq!(kinds("4/3 0.5 1e-3 2E5"), [Int, Slash, Int, Real, Real, Real]);
    assert_eq!(kinds("h'' *S ñandú_1 edges"), [Word, Star, Word, Word, Word]);
    assert_eq!(kinds("-a->"), [Minus, Word, Arrow]);
    assert_eq!(kinds("=P=>"), [TokenKind::Equals, Word, FatArrow]);
    assert_eq!(kinds("1.x 1.0.x"), [Int, Dot, Word, Real, Dot, Word]);
}

#[test]
fn comments_end_before_the_line_end() {
    let text = "\u{FEFF}// a \r\n\t/// b\r\n//!c\r//\r\n";
    let lexed = lex(FileId(0), text);
    assert_eq!((lexed.tokens.len(), lexed.diagnostics.len()), (0, 0));
    let said: Vec<_> = lexed.comments.iter().map(|c| (c.kind, c.text(text))).collect();
    let plain = CommentKind::Plain;
    let kinds = [(plain, "a"), (CommentKind::Doc, "b"), (CommentKind::FileDoc, "c\r//")];
    assert_eq!(said, kinds);
}

#[test]
fn runs_of_unknown_characters_are_reported_once_and_not_for_ever() {
    let garbage = lex(FileId(0), &"§§ \0 a ".repeat(1000));
    assert_eq!(garbage.diagnostics.len(), 17);
    assert_eq!(garbage.tokens.len(), 1000);
    let run = lex(FileId(0), "a §¶§ § b");
    assert_eq!(run.diagnostics.len(), 1);
    assert_eq!(run.diagnostics[0].span(), Span::new(FileId(0), 2, 11));
}

#[test]
fn escapes_are_undone_and_unknown_ones_are_told() {
    let read = read_text(r#""a\n\"\\\q""#);
    assert_eq!(read.value, "a\n\"\\\\q");
    assert_eq!(read.unknown, [(8..10, r"\q".to_owned())]);
}

#[test]
fn values_in_texts_are_found() {
    let found = |token: &str| {
        let holes = holes(token);
        let values = holes.values.into_iter().map(|hole| token[hole].to_owned());
        (values.collect::<Vec<_>>(), holes.is_open)
    };
    let none: [&str; 0] = [];
    assert_eq!(found(r#""a \{b\} }""#), (none.map(String::from).to_vec(), false));
    let two = ["x.y", "if c { 1 } else { 2 }"].map(String::from).to_vec();
    assert_eq!(found(r#""{x.y:.3}{if c { 1 } else { 2 }}""#), (two, false));
    assert_eq!(found(r#""a {b""#), (vec!["b".to_owned()], true));
    assert_eq!(found(r#""{""#), (vec![String::new()], true));
}

#[test]
fn a_text_may_break_off_anywhere() {
    assert_eq!(read_text("\"").value, "");
    assert_eq!(read_text("\"ab\\").value, "ab\\");
    assert_eq!(read_text("").value, "");
}
