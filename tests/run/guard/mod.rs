//! Guards are weakest: refused exactly when the literal result would not be of the level.

mod scripts;
mod weakest;
