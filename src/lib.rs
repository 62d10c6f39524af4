//! hedgerow
pub mod source;
pub mod mesh;
pub mod diagnostic;
pub mod diagram;
pub mod rewrite;
pub mod syntax;
pub mod check;
pub mod compile;
pub mod resolve;
pub mod run;
pub mod analysis;
pub mod cli;
