//! Commands and their arguments.

use std::fmt::Display;
use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use clap_complete::Shell;

use super::option_groups::{EncodingArguments, EngineArguments, RepairArguments, ThreadArguments};
use super::output::is_standard;
use crate::draw::View;
use crate::mesh::Level;

/// A language in which operations on halfedge meshes are drawn, before and after.
#[derive(Debug, Parser)]
#[command(name = "hedgerow", version, after_help = EXIT_CODES)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  all is well
  1  something is not proved or not formatted, or a script failed
  2  bad usage, or a file that cannot be read or written
  3  the operation was refused
  130  interrupted by Ctrl-C, with nothing written";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Prove the operations of files, or say why they break a mesh
    Check(CheckArguments),
    /// Run a script on a mesh
    Run(RunArguments),
    /// Apply one operation at one place of a mesh
    Apply(ApplyArguments),
    /// Show an operation as pointer assignments, in four phases
    Plan(PlanArguments),
    /// Describe a mesh
    Info(InfoArguments),
    /// Write a mesh in another format, repaired if that is asked for
    Convert(ConvertArguments),
    /// Say what a diagnostic means, and what mends it
    Explain(ExplainArguments),
    /// Draw an operation, before and after
    Draw(DrawArguments),
    /// Make a picture of a mesh
    View(ViewArguments),
    /// Speak the Language Server Protocol, for editors
    Lsp(LspArguments),
    /// Format programs, so that their drawings stand in columns
    Fmt(FmtArguments),
    /// Run the tests of programs
    Test(TestArguments),
    /// Show the page of a browser: program, diagram, mesh in 3D, lessons
    Play(PlayArguments),
    /// Learn the language in fifteen lessons
    Learn(LearnArguments),
    /// List the standard library, print a file of it, or copy it out
    Std(StdArguments),
    /// Print the completions of a shell
    Completions(CompletionsArguments),
}

impl Command {
    /// The number of threads, where it matters.
    pub fn threads(&self) -> Option<&ThreadArguments> {
        match self {
            Self::Run(RunArguments { engine, .. })
            | Self::Apply(ApplyArguments { engine, .. })
            | Self::Test(TestArguments { engine, .. }) => Some(&engine.threads),
            Self::Info(InfoArguments { threads, .. })
            | Self::Convert(ConvertArguments { threads, .. })
            | Self::View(ViewArguments { threads, .. }) => Some(threads),
            _ => None,
        }
    }

    /// True if the answer is wanted as JSON on standard output.
    pub fn answers_json(&self) -> bool {
        let format = match self {
            Self::Run(RunArguments { format, output, .. })
            | Self::Apply(ApplyArguments { format, output, .. }) => match output {
                Some(output) if is_standard(output) => return false,
                _ => format,
            },
            Self::Check(CheckArguments { format, .. })
            | Self::Test(TestArguments { format, .. })
            | Self::Info(InfoArguments { format, .. }) => format,
            _ => return false,
        };
        *format == Format::Json
    }
}

/// The format of the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// Text for people
    #[default]
    Human,
    /// JSON for programs
    Json,
}

#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// Programs (.hedge)
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Write what rules break: .halfedges for `info`, .svg, and .obj
    #[arg(long, value_name = "DIR")]
    pub witness: Option<PathBuf>,
    /// Write what surely mends the files into them
    #[arg(long)]
    pub fix: bool,
    /// Print why what is proved holds, law by law
    #[arg(long)]
    pub explain: bool,
    /// Print which names could be one, and whether the op would hold there
    #[arg(long)]
    pub aliases: bool,
    /// Also show what each operation keeps, and how degrees and sizes change
    #[arg(short, long)]
    pub verbose: bool,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
#[command(after_help = "Behind FILE::SCRIPT, --help is about the script and its parameters.")]
pub(super) struct RunArguments {
    /// A program, or one of the library (std/remesh), and the script in it if
    /// there are several
    #[arg(value_hint = ValueHint::FilePath, value_name = "FILE[::SCRIPT]", verbatim_doc_comment)]
    pub script: String,
    /// The mesh to run it on (.obj, .ply, .stl, .off, .msh or
    /// .halfedges); - is standard input
    #[arg(verbatim_doc_comment)]
    pub mesh: PathBuf,
    /// File for the result, in one of these formats; - is standard
    /// output, as .obj; without it the script may still print and be
    /// looked at
    #[arg(short, long, value_name = "FILE", verbatim_doc_comment)]
    pub output: Option<PathBuf>,
    /// File for a picture of the result (.png or .svg)
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Values to show in colour: an attribute, as in view
    #[arg(long, value_name = "NAME", requires = "picture")]
    pub attribute: Option<String>,
    /// A parameter of the script; a vector is written x,y,z
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// A parameter that is an element: edge:A-B, halfedge:A-B,
    /// vertex:A or face:N, as in apply; several in the order of
    /// the parameters, or by name: --at start=vertex:12
    #[arg(long = "at", value_name = "PLACE", verbatim_doc_comment)]
    pub at: Vec<String>,
    /// Most memory that the mesh and lists may take, as 4G; if not
    /// given, three quarters of the machine's
    #[arg(long, value_name = "SIZE", value_parser = super::memory::read, verbatim_doc_comment)]
    #[arg(allow_negative_numbers = true)]
    pub memory: Option<usize>,
    /// Seed of `random` and `shuffle`: the same seed, the same numbers
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = within(0, u64::MAX))]
    #[arg(allow_negative_numbers = true)]
    pub seed: u64,
    /// Also tell how each `drain` keeps its keys current,
    /// and how long native code took to compile
    #[arg(short, long, verbatim_doc_comment)]
    pub verbose: bool,
    /// Renumber elements so that neighbors stand near each other
    /// in memory: faster where the file of a large mesh has them
    /// far apart. Loops visit elements in the new order, so
    /// results may differ; vertices and faces are written in the
    /// order of the file
    #[arg(long, verbatim_doc_comment)]
    pub reorder: bool,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub engine: EngineArguments,
    #[command(flatten)]
    pub repair: RepairArguments,
    #[command(flatten)]
    pub encoding: EncodingArguments,
}

#[derive(Debug, Args)]
pub(super) struct ApplyArguments {
    /// A program and an operation in it
    #[arg(value_hint = ValueHint::FilePath, value_name = "FILE::OP")]
    pub op: String,
    /// The mesh (.obj, .ply, .stl, .off, .msh or .halfedges)
    pub mesh: PathBuf,
    /// An element: edge:A-B, halfedge:A-B, vertex:A or face:N,
    /// with the numbers of the file (from 1 in .obj, ids in
    /// .halfedges, where edge:N is one too); edge:A-B#2 is the
    /// second edge between A and B; 'edge N' is what scripts print
    /// so; several in the order of the parameters, or by name:
    /// --at a=halfedge:1-2
    #[arg(long = "at", value_name = "PLACE", required = true, verbatim_doc_comment)]
    pub at: Vec<String>,
    /// A value; a vector is written x,y,z
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// File for the result, in one of these formats, or - for standard
    /// output, as .obj; without it the operation is only tried
    #[arg(short, long, value_name = "FILE", verbatim_doc_comment)]
    pub output: Option<PathBuf>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub engine: EngineArguments,
    #[command(flatten)]
    pub repair: RepairArguments,
    #[command(flatten)]
    pub encoding: EncodingArguments,
}

#[derive(Debug, Args)]
pub(super) struct PlanArguments {
    /// A program, and an operation in it; without one, as data or code
    /// all of them, of a file that only uses others those that its
    /// scripts call
    #[arg(value_hint = ValueHint::FilePath, value_name = "FILE[::OP]", verbatim_doc_comment)]
    pub op: String,
    /// Form in which to show it
    #[arg(long = "as", value_enum, value_name = "KIND", default_value_t)]
    pub shown: Shown,
    /// Spelling of C++: fields (h->next), accessors (h->next()), or a
    /// pattern, such as erase_vertex=delete_vertex({of}); `hedgerow
    /// explain style` lists them
    #[arg(long = "style", value_name = "STYLE", allow_hyphen_values = true, verbatim_doc_comment)]
    pub style: Vec<String>,
    /// For which mesh class: scotty3d, or a file of styles, one a
    /// line; styles come on top of it
    #[arg(long = "for", value_name = "TARGET", verbatim_doc_comment)]
    pub target: Option<String>,
    /// Also the pointers that do not change
    #[arg(long)]
    pub exhaustive: bool,
    /// File to write, if not standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// The forms in which a plan is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Shown {
    /// Four phases, to read
    #[default]
    Table,
    /// The same as data
    Json,
    /// C++: a function over a mesh of pointers
    #[value(alias = "c++")]
    Cpp,
    /// Rust: a function over hedgerow::mesh
    Rust,
}

#[derive(Debug, Args)]
pub(super) struct InfoArguments {
    /// The mesh (.obj, .ply, .stl, .off, .msh; - is standard
    /// input), or tables of halfedges (.halfedges)
    #[arg(verbatim_doc_comment)]
    pub mesh: PathBuf,
    /// Only tell whether the mesh is of this level; exit code 1 if not
    #[arg(long, value_enum, value_name = "LEVEL")]
    pub level: Option<Level>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub threads: ThreadArguments,
    #[command(flatten)]
    pub repair: RepairArguments,
}

#[derive(Debug, Args)]
pub(super) struct ConvertArguments {
    /// The mesh (.obj, .ply, .stl, .off, .msh or .halfedges); - is
    /// standard input, in any of these formats
    #[arg(verbatim_doc_comment)]
    pub mesh: PathBuf,
    /// File to write, in the format that its name ends in; - is
    /// standard output, as .obj
    #[arg(value_name = "OUTPUT", required_unless_present = "option", verbatim_doc_comment)]
    pub output: Option<PathBuf>,
    /// The same as an option, as in `run`
    #[arg(id = "option", short, long = "output", value_name = "FILE", conflicts_with = "output")]
    pub option: Option<PathBuf>,
    #[command(flatten)]
    pub threads: ThreadArguments,
    #[command(flatten)]
    pub repair: RepairArguments,
    #[command(flatten)]
    pub encoding: EncodingArguments,
}

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// A code such as missing-reassignment, a word such as degree, or what
    /// the library has of a name, such as collapse or std/smooth
    ///
    /// `functions`, `types`, `constants`: all of these; nothing: all codes
    #[arg(value_name = "CODE|WORD", verbatim_doc_comment)]
    pub word: Option<String>,
}

#[derive(Debug, Args)]
pub(super) struct DrawArguments {
    /// A program, and the operation in it if there are several
    #[arg(value_hint = ValueHint::FilePath, value_name = "FILE[::OP]")]
    pub op: String,
    /// File for the picture (.svg or .png)
    #[arg(short, long)]
    pub output: Option<PathBuf>,
    /// Form of the picture, if not as the end of the output's name says
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub drawn: Option<Drawn>,
    /// One page for all operations of the file: pictures, proofs and plans
    #[arg(long, conflicts_with = "drawn")]
    pub html: bool,
}

/// The forms in which an operation is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Drawn {
    /// A picture
    Svg,
    /// Lines and letters, for terminals
    Text,
}

#[derive(Debug, Args)]
pub(super) struct LspArguments {
    /// Accepted for clients that say it; there is nothing else
    #[arg(long, hide = true)]
    pub stdio: bool,
}

#[derive(Debug, Args)]
pub(super) struct ViewArguments {
    /// The mesh (.obj, .ply, .stl, .off, .msh or .halfedges)
    pub mesh: PathBuf,
    /// File for the picture (.png or .svg)
    #[arg(short, long)]
    pub output: PathBuf,
    /// Width and height of the picture in pixels:
    /// one number for both [default: 800]
    #[arg(long, value_name = "PIXELS", value_parser = within(View::SIZES[0], View::SIZES[1]), verbatim_doc_comment)]
    pub size: Option<u32>,
    /// Direction to look from [default: 0.5,0.4,1]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub from: Option<String>,
    /// An attribute to show in colour: NAME, or vertex.NAME
    #[arg(long, value_name = "NAME")]
    pub attribute: Option<String>,
    #[command(flatten)]
    pub threads: ThreadArguments,
    #[command(flatten)]
    pub repair: RepairArguments,
}

#[derive(Debug, Args)]
pub(super) struct FmtArguments {
    /// Programs (.hedge), formatted where they are; - is standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Change nothing; exit code 1 if something is not formatted
    #[arg(long)]
    pub check: bool,
}

#[derive(Debug, Args)]
pub(super) struct TestArguments {
    /// Programs (.hedge)
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Only tests whose name holds this text
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// The text is the whole name
    #[arg(long, requires = "filter")]
    pub exact: bool,
    /// Seed of `random` and `shuffle`: the same seed, the same numbers
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = within(0, u64::MAX))]
    #[arg(allow_negative_numbers = true)]
    pub seed: u64,
    /// Most memory that the meshes and lists of a test may take, as 4G;
    /// if not given, three quarters of what there is
    #[arg(long, value_name = "SIZE", value_parser = super::memory::read, verbatim_doc_comment)]
    #[arg(allow_negative_numbers = true)]
    pub memory: Option<usize>,
    #[command(flatten)]
    pub engine: EngineArguments,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

impl TestArguments {
    /// True if the test of this name is to be run.
    pub fn wants(&self, name: &str) -> bool {
        let is_wanted = |filter: &String| match self.exact {
            true => name == filter,
            false => name.contains(filter),
        };
        self.filter.as_ref().is_none_or(is_wanted)
    }
}

#[derive(Debug, Args)]
pub(super) struct StdArguments {
    /// A file of the library: std/triangle.hedge, or triangle
    pub name: Option<String>,
    /// Copy to a folder; a single one also to a file (.hedge)
    #[arg(long, value_name = "DIR|FILE")]
    pub copy: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct PlayArguments {
    /// A program (.hedge), a mesh, or a folder to list
    #[arg(value_name = "FILE", num_args = 0..=3)]
    pub files: Vec<PathBuf>,
    /// The port; 0 for any that is free
    #[arg(long, default_value_t = 0, value_parser = within(0, u16::MAX))]
    pub port: u16,
    /// Open no browser: print the address only
    #[arg(long)]
    pub no_browser: bool,
}

#[derive(Debug, Args)]
pub(super) struct LearnArguments {
    /// The number of a lesson; without it, all are listed
    pub lesson: Option<String>,
    /// A program (.hedge): does it solve the lesson?
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Write the lesson's program to the file, to begin with
    #[arg(long, requires = "file")]
    pub start: bool,
}

#[derive(Debug, Args)]
pub(super) struct CompletionsArguments {
    /// bash, elvish, fish, powershell or zsh
    ///
    /// `source <(hedgerow completions bash)` makes bash complete
    #[arg(value_name = "SHELL", hide_possible_values = true)]
    pub shell: Shell,
}

/// A parser of whole numbers from `least` to `most`.
fn within<T>(least: T, most: T) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync
where
    T: FromStr + PartialOrd + Display + Copy + Send + Sync,
{
    move |text| {
        let number = text.parse().ok().filter(|number| (least..=most).contains(number));
        number.ok_or_else(|| format!("a whole number from {least} to {most} is wanted"))
    }
}
