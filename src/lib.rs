//! hedgerow: a language in which operations on halfedge meshes are drawn, before and after,
//! and the drawing is the program.
//!
//! An operation lists the orbits of a mesh that it looks at, and what becomes of them. The
//! checker proves that any valid mesh stays valid; the compiler makes pointer loads, tests and
//! stores of the proved drawing; a small machine runs them, whole or not at all.
//!
//! ```
//! use hedgerow::analysis::Analysis;
//! use hedgerow::mesh::{shape, validate};
//! use hedgerow::rewrite::{Machine, Outcome};
//! use hedgerow::source::Sources;
//!
//! let mut sources = Sources::new();
//! let file = sources.add(
//!     "flip.hedge",
//!     "op flip(e: edge) {
//!        before {
//!          face f0: v0 -a-> v1 -b-> v2 -c-> v0
//!          face f1: v1 -d-> v0 -g-> v3 -h-> v1
//!          edge e: a | d
//!        }
//!        after {
//!          face f0: v3 -a-> v2 -c-> v0 -g-> v3
//!          face f1: v2 -d-> v3 -h-> v1 -b-> v2
//!          edge e: a | d
//!        }
//!      }",
//! );
//! let analysis = Analysis::of(&sources, file);
//! assert!(analysis.is_sound());
//!
//! let flip = analysis.plans[0].as_ref().expect("a sound op has a plan");
//! let mut mesh = shape::icosahedron();
//! let edge = mesh.edges().next().expect("an icosahedron has edges");
//! let outcome = Machine::default().apply(&mut mesh, flip, &[u64::from(edge.0)]);
//! assert_eq!(outcome, Ok(Outcome::Applied { result: None }));
//! assert!(validate(&mesh).is_ok());
//! ```
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
//! Each folder is a layer, and names only layers below it (a test holds this):
//!
//! ```text
//! 5  cli          lsp                    the command line; the language server
//! 4  analysis                            a text taken all the way; plain data out
//! 3  format  resolve  run                tree to text; tree to program; a program on a mesh
//!    emit                               pointer code in other languages
//! 2  syntax  check  compile  draw       text to tree; the proof; a plan; a picture
//! 1  diagnostic   diagram    rewrite     what is wrong; what is drawn; plans and the machine
//! 0  source       mesh        library    texts and places; the halfedge mesh and OBJ files; std
//! ```
//!
//! Three walls stand between them. The mesh knows nothing of the language. The checker knows
//! nothing of the machine it vouches for. Only the checker makes a
//! [`Proved`](check::Proved), and only that can be compiled, so an unproved op cannot run.

pub mod source;

pub mod mesh;

pub mod library;

pub mod diagnostic;

pub mod diagram;

pub mod rewrite;

pub mod syntax;

pub mod check;

pub mod compile;

pub mod draw;

pub mod emit;

pub mod format;

pub mod resolve;

pub mod run;

pub mod analysis;

pub mod lsp;

pub mod cli;
