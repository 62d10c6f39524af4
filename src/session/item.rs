//! Operations, scripts and functions of a program, to be called.

use std::fmt;
use std::sync::Arc;

use super::{Error, Program, Reason};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Param, Type};
use crate::mesh::{ElementKind, Level};
use crate::run::{Application, Prepared, UNKNOWN_REASON, prepare, prepare_function};
use crate::{analysis, resolve};

pub(super) type ApplicationOrError = Result<Application, Diagnostic>;

/// An operation of a program: it is applied completely or not at all.
#[derive(Clone)]
pub struct Op {
    pub(super) program: Program,
    pub(super) index: usize,
}

/// A script of a program.
#[derive(Clone)]
pub struct Script {
    pub(super) program: Program,
    pub(super) index: usize,
}

/// A function of a program.
#[derive(Clone)]
pub struct Function {
    pub(super) program: Program,
    pub(super) index: usize,
}

/// A parameter of an operation, a script or a function.
#[derive(Clone, Copy, Debug)]
pub struct Parameter<'p> {
    /// Its name.
    pub name: &'p str,
    /// Its type as the language writes it: `edge`, `real`, `vec3` …
    pub ty: &'static str,
    /// Its default, as the program writes it.
    pub default: Option<&'p str>,
}

fn parameters<'p>(program: &'p Program, params: &'p [Param]) -> Vec<Parameter<'p>> {
    let parameter = |param: &'p Param| Parameter {
        name: &param.name,
        ty: param.ty.word(),
        default: param.default.as_ref().map(|default| program.0.sources.slice(default.span)),
    };
    params.iter().map(parameter).collect()
}

/// The methods that operations, scripts and functions have in common.
macro_rules! item {
    ($item:ident, $resolved:ty, $list:ident) => {
        impl $item {
            pub(super) fn new(program: &Program, index: usize) -> Self {
                Self { program: program.clone(), index }
            }

            fn item(&self) -> &$resolved {
                &self.program.0.analysis.program.$list[self.index]
            }

            /// The program.
            pub fn program(&self) -> &Program {
                &self.program
            }

            /// Its name.
            pub fn name(&self) -> &str {
                &self.item().name
            }

            /// Its parameters, in order.
            pub fn parameters(&self) -> Vec<Parameter<'_>> {
                parameters(&self.program, &self.item().params)
            }
        }

        impl fmt::Debug for $item {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_tuple(stringify!($item)).field(&self.name()).finish()
            }
        }
    };
}

item!(Op, resolve::ResolvedOp, ops);
item!(Script, resolve::Script, scripts);
item!(Function, resolve::Function, functions);

impl Op {
    pub(super) fn application(&self) -> Result<&Application, Error> {
        let parts = &self.program.0;
        let made = parts.applications[self.index].get_or_init(|| {
            Application::new(&parts.analysis.program, self.index, &parts.analysis.plans)
        });
        made.as_ref().map_err(|diagnostic| Error::one(diagnostic.clone(), &parts.sources))
    }

    /// Its doc comment, line by line.
    pub fn docs(&self) -> &[String] {
        match (&self.item().diagram, &self.item().steps) {
            (Some(diagram), _) => &diagram.docs,
            (None, Some(steps)) => &steps.docs,
            (None, None) => &[],
        }
    }

    /// True if both are the same operation of the same program.
    pub fn is(&self, other: &Self) -> bool {
        self.index == other.index && self.program.is(&other.program)
    }

    /// The levels above a map that the operation preserves.
    pub fn keeps(&self) -> &[Level] {
        self.application().map_or(&[], |application| &application.plan().keeps)
    }

    /// The verdict of its proof.
    #[doc(hidden)]
    pub fn proved(&self) -> analysis::Verdict {
        analysis::verdict(&self.program.0.analysis, self.index)
    }

    /// The kind of its result, if it has one.
    pub fn result(&self) -> Option<ElementKind> {
        self.application().ok()?.plan().result
    }

    /// The level that a mesh must have.
    pub fn level(&self) -> Level {
        self.application().map_or(Level::Map, |application| application.plan().level)
    }

    /// The reasons why it may refuse, by number. Different numbers may have the same text, where
    /// different tests fail.
    pub fn reasons(&self) -> &[Arc<str>] {
        self.program.0.reasons[self.index].get_or_init(|| {
            let plan = self.application().map(Application::plan);
            let refusals = plan.map_or(&[][..], |plan| &plan.refusals);
            let reasons = refusals.iter().map(|refusal| refusal.reason.as_str());
            reasons.chain([UNKNOWN_REASON]).map(Arc::from).collect()
        })
    }

    /// The reason of a refusal by its number; the last one if that is unknown.
    pub(super) fn reason(&self, number: Option<u16>) -> Reason {
        let reasons = self.reasons();
        let unknown = reasons.len() - 1;
        let number = number.map_or(unknown, usize::from).min(unknown);
        Reason { number, text: Arc::clone(&reasons[number]) }
    }
}

impl Script {
    pub(super) fn prepared(&self) -> Result<&Prepared, Error> {
        let parts = &self.program.0;
        let made = parts.scripts[self.index]
            .get_or_init(|| prepare(&parts.analysis.program, self.index, &parts.analysis.plans));
        made.as_ref().map_err(|errors| Error::new(errors.clone(), &parts.sources))
    }

    /// Resets its scratch attributes on a mesh to their defaults.
    #[cfg(feature = "play")]
    pub(crate) fn clear_scratch(&self, mesh: &mut crate::mesh::Mesh) {
        if let Ok(prepared) = self.prepared() {
            prepared.columns().clear(mesh);
        }
    }

    /// Its doc comment, line by line.
    pub fn docs(&self) -> &[String] {
        &self.item().docs
    }
}

impl Function {
    pub(super) fn prepared(&self) -> Result<&Prepared, Error> {
        let parts = &self.program.0;
        let made = parts.functions[self.index].get_or_init(|| {
            prepare_function(&parts.analysis.program, self.index, &parts.analysis.plans)
        });
        made.as_ref().map_err(|errors| Error::new(errors.clone(), &parts.sources))
    }

    /// Its doc comment, line by line.
    pub fn docs(&self) -> &[String] {
        &self.item().docs
    }

    /// The type of its value as the language writes it, if it returns one.
    pub fn result(&self) -> Option<&'static str> {
        self.result_type().map(Type::word)
    }

    pub(super) fn result_type(&self) -> Option<Type> {
        self.item().result
    }

    /// True if it may change the mesh.
    ///
    /// # Errors
    /// It calls an operation that is not proved.
    pub fn changes(&self) -> Result<bool, Error> {
        Ok(self.prepared()?.changes())
    }
}
