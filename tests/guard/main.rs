//! Guards are weakest: refused exactly when the literal result would not be of the level.

mod meshes;
mod ops;
mod scripts;
mod weakest;
