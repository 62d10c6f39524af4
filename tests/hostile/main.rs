//! Malformed and malicious input: broken programs run through every stage, excessively large items,
//! paths that are not regular files, streams that are not valid messages.

mod limits;
#[cfg(unix)]
mod paths;
mod programs;
mod streams;
