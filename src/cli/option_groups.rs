//! Options that several commands have.

#[cfg(feature = "threads")]
use std::num::NonZeroUsize;

use clap::{Args, ValueEnum};

use super::failure::Failure;
#[cfg(feature = "threads")]
use crate::mesh::set_threads;
use crate::mesh::{Encoding, FileFormat, Level, MshVersion};
use crate::rewrite::Engine;

/// The engine that runs a program, and the number of threads.
#[derive(Debug, Args)]
pub(super) struct EngineArguments {
    /// What runs the program: native code where it pays if
    /// not given, with results that are the same bit for
    /// bit
    #[arg(long, value_enum, verbatim_doc_comment)]
    engine: Option<EngineName>,
    #[command(flatten)]
    pub threads: ThreadArguments,
}

impl EngineArguments {
    /// The engine of that name, or the usual one.
    pub fn get(&self) -> Engine {
        match self.engine {
            None => Engine::default(),
            Some(EngineName::Machine) => Engine::Machine,
            #[cfg(feature = "native")]
            Some(EngineName::Native) => Engine::NativeAtOnce,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum EngineName {
    Machine,
    #[cfg(feature = "native")]
    Native,
}

/// The number of threads.
#[derive(Debug, Default, Args)]
pub(super) struct ThreadArguments {
    /// Threads for files, checks and loops over all
    /// elements; if not given, one for each core. The
    /// results are the same
    #[cfg(feature = "threads")]
    #[arg(long, value_name = "N", env = "HEDGEROW_THREADS", hide_env_values = true)]
    #[arg(verbatim_doc_comment, value_parser = threads)]
    threads: Option<NonZeroUsize>,
}

impl ThreadArguments {
    /// Sets the number of threads, if one is given.
    pub fn set(&self) {
        #[cfg(feature = "threads")]
        if self.threads.is_some() {
            set_threads(self.threads);
        }
    }
}

/// Mending of a mesh that is none.
#[derive(Debug, Default, Args)]
pub(super) struct RepairArguments {
    /// Make a mesh of faces that are none: drop
    /// degenerate and doubled ones, turn neighbours
    /// to run alike, cut where three meet at an edge,
    /// split pinched vertices; says what it did
    #[arg(long, verbatim_doc_comment)]
    pub repair: bool,
    /// First make one vertex of those that lie no
    /// farther apart, with 0 of equal ones; repairs
    /// what comes of it
    #[arg(long, value_name = "DISTANCE", value_parser = distance, verbatim_doc_comment)]
    pub merge: Option<f64>,
}

fn distance(text: &str) -> Result<f64, String> {
    let distance =
        text.parse().ok().filter(|distance: &f64| distance.is_finite() && *distance >= 0.0);
    distance.ok_or_else(|| "a distance is a number from 0 on".to_owned())
}

/// The encoding of the numbers of a file, where its format leaves a choice.
#[derive(Debug, Default, Args)]
pub(super) struct EncodingArguments {
    /// Encoding of the numbers of .ply and .stl, if not as they were read
    #[arg(long, value_enum, value_name = "KIND", verbatim_doc_comment)]
    pub encoding: Option<EncodingName>,
    /// The version of .msh, if not that which was read
    #[arg(long, value_enum, value_name = "VERSION")]
    pub msh: Option<MshName>,
}

impl EncodingArguments {
    /// Fails if files of a format do not have the encoding or the version.
    pub fn expect(&self, format: FileFormat) -> Result<(), Failure> {
        let has_bytes = [FileFormat::Ply, FileFormat::Stl].contains(&format);
        let problem = match self.encoding {
            Some(EncodingName::BigEndian) if format != FileFormat::Ply => {
                "`--encoding big-endian` is for .ply alone"
            }
            Some(EncodingName::Binary) if !has_bytes => {
                "`--encoding binary` is for .ply and .stl; other files are text"
            }
            _ if self.msh.is_some() && format != FileFormat::Msh => "`--msh` is for .msh alone",
            _ => return Ok(()),
        };
        Err(Failure::usage(problem))
    }
}

/// An encoding, as it is said on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum EncodingName {
    /// As text
    Ascii,
    /// As bytes
    Binary,
    /// As bytes, the highest first (.ply alone)
    BigEndian,
}

impl EncodingName {
    /// The encoding.
    pub fn encoding(self) -> Encoding {
        match self {
            Self::Ascii => Encoding::Ascii,
            Self::Binary => Encoding::LittleEndian,
            Self::BigEndian => Encoding::BigEndian,
        }
    }
}

/// A version of Gmsh files, as it is said on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MshName {
    /// Version 2.2
    #[value(name = "2.2")]
    V2,
    /// Version 4.1
    #[value(name = "4.1")]
    V4,
}

impl MshName {
    /// The version.
    pub fn version(self) -> MshVersion {
        match self {
            Self::V2 => MshVersion::V2,
            Self::V4 => MshVersion::V4,
        }
    }
}

/// A level of mesh, as it is said on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum LevelName {
    /// Every orbit is in order
    Map,
    /// As other libraries want it: no pinches, no two-sided faces
    Surface,
    /// Edges and faces are told by their vertices
    Simple,
}

impl LevelName {
    /// The level.
    pub fn level(self) -> Level {
        match self {
            Self::Map => Level::Map,
            Self::Surface => Level::Surface,
            Self::Simple => Level::Simple,
        }
    }
}

/// Reads a number of threads.
#[cfg(feature = "threads")]
fn threads(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "a whole number from 1 is wanted".to_owned())
}
