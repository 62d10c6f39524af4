//! Options that several commands have.

#[cfg(feature = "threads")]
use std::num::NonZeroUsize;

use clap::builder::PossibleValue;
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
    /// degenerate and doubled ones, turn neighbors
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
    pub encoding: Option<Encoding>,
    /// The version of .msh, if not that which was read
    #[arg(long, value_enum, value_name = "VERSION")]
    pub msh: Option<MshVersion>,
}

impl EncodingArguments {
    /// Fails if files of a format do not have the encoding or the version.
    pub fn expect(&self, format: FileFormat) -> Result<(), Failure> {
        let has_bytes = [FileFormat::Ply, FileFormat::Stl].contains(&format);
        let problem = match self.encoding {
            Some(Encoding::BigEndian) if format != FileFormat::Ply => {
                "`--encoding big-endian` is for .ply alone"
            }
            Some(Encoding::LittleEndian) if !has_bytes => {
                "`--encoding binary` is for .ply and .stl; other files are text"
            }
            _ if self.msh.is_some() && format != FileFormat::Msh => "`--msh` is for .msh alone",
            _ => return Ok(()),
        };
        Err(Failure::usage(problem))
    }
}

impl ValueEnum for Encoding {
    fn value_variants<'v>() -> &'v [Self] {
        &[Self::Ascii, Self::LittleEndian, Self::BigEndian]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Self::Ascii => ("ascii", "As text"),
            Self::LittleEndian => ("binary", "As bytes"),
            Self::BigEndian => ("big-endian", "As bytes, the highest first (.ply alone)"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

impl ValueEnum for MshVersion {
    fn value_variants<'v>() -> &'v [Self] {
        &[Self::V2, Self::V4]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Self::V2 => ("2.2", "Version 2.2"),
            Self::V4 => ("4.1", "Version 4.1"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

impl ValueEnum for Level {
    fn value_variants<'v>() -> &'v [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Self::Map => "Every orbit is in order",
            Self::Surface => "As other libraries want it: no pinches, no two-sided faces",
            Self::Simple => "Edges and faces are told by their vertices",
        };
        Some(PossibleValue::new(self.name()).help(help))
    }
}

/// Reads a number of threads.
#[cfg(feature = "threads")]
fn threads(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "a whole number from 1 is wanted".to_owned())
}
