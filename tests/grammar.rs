//! The grammars for editors and for people: each is read here, and agrees with the parser.

mod dice;
#[path = "grammar/ebnf.rs"]
mod ebnf;
#[path = "grammar/programs.rs"]
mod programs;
#[path = "grammar/textmate.rs"]
mod textmate;
#[path = "grammar/tree_sitter.rs"]
mod tree_sitter_grammar;
