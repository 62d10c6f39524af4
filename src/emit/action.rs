//! Actions of steps and functions besides computing: variables that change, branches, loops, and
//! calls of what changes the mesh.

use super::routine::{Statement, give_back};
use super::term::{Around, Attribute, Parameter, Term};
use crate::diagram::{Level, Type};

/// An operation that calls others, all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Whole {
    /// Its name.
    pub name: String,
    /// Its name in the program.
    pub declared: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// The type of its result; without one it tells whether it applied.
    pub result: Option<Type>,
    /// The first parameter that is an element and surely outlives it.
    pub given: Option<Parameter>,
    /// The tests before anything is done.
    pub asks: Vec<Statement>,
    /// The level that the mesh has to have in the end.
    pub level: Level,
    /// The statements that do it.
    pub body: Vec<Statement>,
}

impl Whole {
    /// The operation with the element that it was given as its result, if it has none.
    pub fn giving_back(mut self) -> Self {
        if let (None, Some(given)) = (self.result, self.given.clone()) {
            self.result = Some(given.ty);
            give_back(&mut self.body, &given.name);
        }
        self
    }
}

/// A statement of steps or of a function.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    /// A variable, with its first value.
    Variable { place: Target, value: Term },
    /// Calls what changes the mesh, and must do it.
    Must { call: Call, place: Option<Target> },
    /// Calls an operation, which may refuse.
    May { call: Call },
    /// Calls an operation, and goes on as it applied or refused.
    Apply { call: Call, place: Option<Parameter>, then: Vec<Statement>, otherwise: Vec<Statement> },
    /// Goes on as a condition holds or does not.
    Choose { condition: Term, then: Vec<Statement>, otherwise: Vec<Statement> },
    /// So many times.
    Repeat { index: String, count: Term, body: Vec<Statement> },
    /// As long as a condition holds.
    While { condition: Term, body: Vec<Statement> },
    /// For the elements around one that are there when the loop begins.
    For {
        variable: Parameter,
        around: Around,
        element: Term,
        /// True if the body may erase some of them; those have no turn.
        may_go: bool,
        filter: Option<Term>,
        body: Vec<Statement>,
    },
    /// A loop whose writes are put off to its end.
    Update { visit: Box<Action>, held: Vec<Held> },
    /// Puts a write off.
    Hold { list: String, element: Term, value: Term },
    /// `break`
    Break,
    /// `continue`
    Continue,
    /// `vertex.position = value`, which has to be finite.
    Move {
        vertex: Term,
        value: Term,
        /// True if it surely is.
        is_finite: bool,
    },
    /// Refuses a mesh without an attribute.
    Ask(Attribute),
    /// Notes the elements that will be written to.
    Keep(Vec<Term>),
    /// Notes the value of an attribute that will be written to.
    KeepAttribute { attribute: Attribute, element: Term },
    /// Leaves a function that has no value.
    Leave,
}

/// A call of an operation, or of a function that changes the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Call {
    /// The name of what is called.
    pub name: String,
    pub args: Vec<Term>,
    pub of: Called,
}

/// The kind of thing that is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Called {
    /// An operation with a result.
    Operation,
    /// One without.
    Plain,
    /// A function that may refuse.
    Refusing,
    /// A function that does not.
    Sure,
}

/// The writes to one attribute that are put off.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Held {
    /// The list of them.
    pub list: String,
    /// The type of the elements.
    pub element: Type,
    /// The type of the values.
    pub ty: Type,
    /// The attribute; none for positions.
    pub attribute: Option<Attribute>,
}

/// The target of a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Target {
    pub name: String,
    pub ty: Type,
    pub form: Form,
}

/// The form of an assignment: to a variable that exists, or to a new one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// It is new, and keeps this value.
    Fixed,
    /// It is new, and will change.
    Changing,
    /// It is there.
    Known,
}

impl Action {
    /// The statements inside of it.
    pub fn bodies(&self) -> Vec<&[Statement]> {
        match self {
            Self::Apply { then, otherwise, .. } | Self::Choose { then, otherwise, .. } => {
                vec![then, otherwise]
            }
            Self::Repeat { body, .. } | Self::While { body, .. } | Self::For { body, .. } => {
                vec![body]
            }
            Self::Update { visit, .. } => visit.bodies(),
            _ => Vec::new(),
        }
    }

    /// The statements inside of it, to be changed.
    pub fn bodies_mut(&mut self) -> Vec<&mut Vec<Statement>> {
        match self {
            Self::Apply { then, otherwise, .. } | Self::Choose { then, otherwise, .. } => {
                vec![then, otherwise]
            }
            Self::Repeat { body, .. } | Self::While { body, .. } | Self::For { body, .. } => {
                vec![body]
            }
            Self::Update { visit, .. } => visit.bodies_mut(),
            _ => Vec::new(),
        }
    }

    /// Tells the types of the variables that begin with it.
    pub fn types(&self, see: &mut dyn FnMut(Type)) {
        match self {
            Self::Variable { place, .. } | Self::Must { place: Some(place), .. } => see(place.ty),
            Self::Apply { place: Some(variable), .. } | Self::For { variable, .. } => {
                see(variable.ty)
            }
            Self::Update { visit, held } => {
                visit.types(see);
                held.iter().for_each(|held| see(held.element));
            }
            _ => {}
        }
    }

    /// Asks about every name that it reads, bodies included.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        self.terms(&mut |term| term.names(see));
        if let Self::Must { place: Some(place), .. } = self
            && place.form == Form::Known
        {
            see(&place.name);
        }
        for body in self.bodies() {
            body.iter().for_each(|statement| statement.names(see));
        }
    }

    /// Shows its own terms, without those of its bodies.
    pub fn terms(&self, see: &mut dyn FnMut(&Term)) {
        match self {
            Self::Variable { value, .. } => see(value),
            Self::Must { call, .. } | Self::May { call } | Self::Apply { call, .. } => {
                call.args.iter().for_each(see);
            }
            Self::Choose { condition, .. } | Self::While { condition, .. } => see(condition),
            Self::Repeat { count, .. } => see(count),
            Self::For { element, filter, .. } => {
                see(element);
                filter.iter().for_each(see);
            }
            Self::Move { vertex, value, .. } => {
                see(vertex);
                see(value);
            }
            Self::Update { visit, .. } => visit.terms(see),
            Self::Hold { element, value, .. } => {
                see(element);
                see(value);
            }
            Self::Keep(elements) => elements.iter().for_each(see),
            Self::KeepAttribute { element, .. } => see(element),
            Self::Break | Self::Continue | Self::Ask(_) | Self::Leave => {}
        }
    }
}
