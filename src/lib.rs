//! hedgerow
pub mod analysis;
pub mod check;
pub mod cli;
pub mod compile;
pub mod diagnostic;
pub mod diagram;
pub mod draw;
pub mod mesh;
pub mod resolve;
pub mod rewrite;
pub mod run;
pub mod source;
pub mod syntax;
