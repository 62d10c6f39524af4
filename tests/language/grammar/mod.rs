//! The grammars for editors and for people: each is read here, and agrees with the parser.

mod ebnf;
mod programs;
mod textmate;
mod tree_sitter_grammar;
