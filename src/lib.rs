//! hedgerow: a language in which operations on halfedge meshes are drawn, before and after,
//! and the drawing is the program.
//!
//! An operation lists the orbits of a mesh that it looks at, and what they become. The checker
//! proves that any valid mesh stays valid; the compiler turns the proved drawing into pointer
//! loads, tests and stores; a small machine runs these completely or not at all.
//!
//! As a library: read a program, call its operations and scripts on a mesh, and take the arrays.
//!
//! ```
//! use hedgerow::mesh::{Mesh, validate};
//! use hedgerow::{Outcome, Program, Session};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Programs come from files (`Program::load`), from the library, or from a text.
//! let program = Program::parse(
//!     "flip.hedge",
//!     "op flip(e: edge) {
//!        before {
//!          face f0: v0 -a-> v1 -b-> v2 -c-> v0
//!          face f1: v1 -d-> v0 -g-> v3 -h-> v1
//!          edge e: a | d
//!        }
//!        require not adjacent(v2, v3)
//!        after {
//!          face f0: v3 -a-> v2 -c-> v0 -g-> v3
//!          face f1: v2 -d-> v3 -h-> v1 -b-> v2
//!          edge e: a | d
//!        }
//!      }",
//! )?;
//! let flip = program.op("flip")?;
//!
//! // Two triangles with an edge between them.
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = Mesh::from_triangles(&corners, &[[0, 1, 2], [0, 2, 3]])?;
//! let mut session = Session::new(&program, mesh);
//!
//! let can = session.mask(&flip, ())?;
//! let edges: Vec<_> = session.mesh().edges().filter(|edge| can[edge.index()]).collect();
//! assert_eq!(edges.len(), 1);
//! match session.apply(&flip, edges[0])? {
//!     Outcome::Applied(_) => {}
//!     Outcome::Refused(reason) => println!("{reason}"),
//! }
//! assert!(validate(session.mesh()).is_ok());
//!
//! let (positions, triangles) = session.into_mesh().to_triangles()?;
//! assert_eq!(positions, corners);
//! assert_eq!(triangles.len(), 2);
//! # Ok(())
//! # }
//! ```
//!
//! Scripts are called the same way, with arguments by position or by name, and report what they
//! counted:
//!
//! ```
//! use hedgerow::mesh::shape;
//! use hedgerow::{Program, Session};
//!
//! # fn main() -> Result<(), hedgerow::Error> {
//! let program = Program::load("std/remesh.hedge")?;
//! let remesh = program.script("remesh")?;
//! for parameter in remesh.parameters() {
//!     println!("{}: {}", parameter.name, parameter.ty);
//! }
//! let mut session = Session::new(&program, shape::icosphere(1));
//! let report = session.run(&remesh, [("target", 0.4)])?;
//! let applied: u64 = report.ops.iter().map(|op| op.applied).sum();
//! assert!(applied > 0);
//! let (positions, polygons) = session.mesh().to_polygons();
//! assert!(polygons.iter().all(|polygon| polygon.len() == 3));
//! # Ok(())
//! # }
//! ```
//!
//! Attributes are columns of the mesh, read and written as slices by id:
//!
//! ```
//! use hedgerow::mesh::{ElementKind, Value, shape};
//! use hedgerow::{Program, Session};
//!
//! # fn main() -> Result<(), hedgerow::Error> {
//! let program = Program::parse(
//!     "heat.hedge",
//!     "attr heat: vertex real
//!      script spread() { update v in vertices { v.heat = mean(w.heat for w in v.neighbors) } }",
//! )?;
//! let mut mesh = shape::octahedron();
//! let heat = mesh.add_column(ElementKind::Vertex, "heat", Value::Real(0.0)).expect("it is new");
//! mesh.values_mut::<f64>(heat).expect("it is of reals")[0] = 1.0;
//! let mut session = Session::new(&program, mesh);
//! session.run(&program.script("spread")?, ())?;
//! let after: &[f64] = session.mesh().values(heat).expect("it is still there");
//! assert_eq!(after.iter().sum::<f64>(), 1.0);
//! # Ok(())
//! # }
//! ```
//!
//! What was done since a mark is undone, bit for bit; [`Session::attempt`] undoes what fails. The
//! element that an operation returns is an id of its kind:
//!
//! ```
//! use hedgerow::mesh::{EdgeId, VertexId, shape};
//! use hedgerow::{Program, Session};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let program = Program::load("std/triangle.hedge")?;
//! let mut session = Session::new(&program, shape::octahedron());
//! let mark = session.mark();
//! if let Some(new) = session.apply(&program.op("split")?, EdgeId(0))?.result() {
//!     let vertex = VertexId::try_from(new)?;
//!     assert_eq!(session.mesh().spokes(vertex).count(), 4);
//! }
//! session.undo(mark)?;
//! assert_eq!(session.mesh().vertex_count(), 6);
//! # Ok(())
//! # }
//! ```
//!
//! Bad input is an error that gives the places in the program, never a panic:
//!
//! ```
//! use hedgerow::Program;
//!
//! let error = Program::parse("wrong.hedge", "op flip(e: edge { }").unwrap_err();
//! assert!(error.to_string().contains("wrong.hedge:1:"));
//! ```
//!
//! # Features
//!
//! All are on by default: `cli`, the command line, which includes `play`; `lsp`, the language
//! server; `play`, the back end of a web page; `draw`, pictures; `native`, native code for
//! operations; `threads`, files, checks and loops over all elements on all cores, with results that
//! do not depend on the number of threads, which [`set_threads`] or the environment variable
//! `HEDGEROW_THREADS` sets; `huge-pages`, an allocator for large meshes on Linux, which a program
//! makes its own: `#[global_allocator] static A: HugePages = HugePages;`.
//! A program that calls hedgerow needs none of them:
//! `hedgerow = { version = "0.1", default-features = false }`.
//!
//! # Words
//!
//! A *halfedge* has a `next`, a `prev`, a `twin`, a `vertex` (its origin), an `edge` and a
//! `face`; a *hole* is a face with a flag, so none of them is ever missing. An *orbit* is a
//! cycle of `next` (a face), a pair of twins (an edge), or the *spokes* of a vertex,
//! counterclockwise `h.prev.twin`. An *op* has *rules*; a rule has a side *before* and a side
//! *after*, names that it *keeps*, makes *new* or *erases*, *paths* along loops and *fans* of
//! spokes, and *outer* halfedges, known only as twins. A *law* is what the *proof* demands. A
//! proved op becomes a *plan*; a plan *matches* at a place or *refuses*. A *script* calls ops.
//!
//! # Layers
//!
//! Each folder is a layer and uses only layers below it (a test checks this):
//!
//! ```text
//! 6  cli          lsp       play         the command line; the language server; behind a page
//! 5  session      lessons                as a library; texts with a gap, and their judge
//! 4  analysis                            a text taken all the way; plain data out
//! 3  format  emit     run                tree to text; code in other languages; a program on a mesh
//!            compile                     a plan
//!            lower                       what a program does, decided for all that spell it
//! 2  syntax  resolve  check    draw      text to tree; tree to program; the proof; a picture
//! 1  diagnostic   diagram    rewrite     what is wrong; what is drawn; plans and the machine
//! 0  source       mesh        library    texts and places; the halfedge mesh and its files; std
//! ```
//!
//! Three boundaries hold between them. The mesh knows nothing of the language. The checker knows
//! nothing of the machine that it vouches for. Only the checker makes a [`Proved`](check::Proved),
//! and only that can be compiled, so an unproved op cannot run.

#[doc(hidden)]
pub mod analysis;
#[doc(hidden)]
pub mod check;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[doc(hidden)]
pub mod compile;
pub mod diagnostic;
#[doc(hidden)]
pub mod diagram;
#[cfg(feature = "draw")]
#[doc(hidden)]
pub mod draw;
#[doc(hidden)]
pub mod emit;
#[cfg(feature = "lsp")]
#[doc(hidden)]
pub mod format;
#[cfg(all(target_os = "linux", feature = "huge-pages"))]
pub mod huge_pages;
#[doc(hidden)]
pub mod lessons;
#[doc(hidden)]
pub mod library;
#[doc(hidden)]
pub mod lower;
#[cfg(feature = "lsp")]
#[doc(hidden)]
pub mod lsp;
pub mod mesh;
#[cfg(feature = "play")]
#[doc(hidden)]
pub mod play;
#[doc(hidden)]
pub mod resolve;
#[doc(hidden)]
pub mod rewrite;
#[doc(hidden)]
pub mod run;
mod session;
pub mod source;
#[doc(hidden)]
pub mod syntax;

pub use analysis::{Disk, Reader};
pub use diagram::Type;
#[cfg(feature = "threads")]
pub use mesh::set_threads;
pub use rewrite::{Engine, Unwatched, Watch};
pub use run::{Argument, OpReport, Report};
pub use session::{
    Arguments, Error, Function, Given, KeptMask, Mark, Match, Op, Outcome, Parameter, Program,
    Reason, Script, Session, Values, Verdict,
};
