//! Functions, called once or at all elements.

use super::binding::Bound;
use super::questions::free_parameter;
use super::{Arguments, Error, Function, Session};
use crate::diagram::Type;
use crate::mesh::ElementKind;
use crate::rewrite::{Code, Message, Trap, Unwatched, Watch};
use crate::run::{self, Argument, Prepared};

/// The watcher is called at ids that are multiples of this.
const IDS_PER_LOOK: u32 = 1024;

/// The values of a function at all elements of a kind, by id. In dead slots they are `false`, 0,
/// NaN, empty, or `None`.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Truth values.
    Bool(Vec<bool>),
    /// Whole numbers.
    Int(Vec<i64>),
    /// Numbers.
    Real(Vec<f64>),
    /// Vectors or matrices: the count of reals of each, and the reals, matrices column by column.
    Reals(usize, Vec<f64>),
    /// Texts.
    Text(Vec<String>),
    /// Elements of a kind.
    Element(ElementKind, Vec<Option<u32>>),
}

impl Values {
    /// Values of a type, one for each slot, all of them as in dead slots.
    fn new(ty: Type, slots: usize) -> Self {
        match ty {
            Type::Bool => Self::Bool(vec![false; slots]),
            Type::Int => Self::Int(vec![0; slots]),
            Type::Real => Self::Real(vec![f64::NAN; slots]),
            Type::Text => Self::Text(vec![String::new(); slots]),
            Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 | Type::Mat4 => {
                let width = usize::from(crate::compile::width(ty));
                Self::Reals(width, vec![f64::NAN; slots * width])
            }
            Type::Vertex => Self::Element(ElementKind::Vertex, vec![None; slots]),
            Type::Halfedge => Self::Element(ElementKind::Halfedge, vec![None; slots]),
            Type::Edge => Self::Element(ElementKind::Edge, vec![None; slots]),
            Type::Face => Self::Element(ElementKind::Face, vec![None; slots]),
        }
    }

    /// Stores at `at` the value held by the slots `window`, which is `text` if it is a text.
    fn put(&mut self, at: usize, window: &[u64], text: Option<&str>) {
        let first = window.first().copied().unwrap_or(0);
        match self {
            Self::Bool(values) => values[at] = first != 0,
            Self::Int(values) => values[at] = first as i64,
            Self::Real(values) => values[at] = f64::from_bits(first),
            Self::Reals(width, values) => {
                let values = &mut values[at * *width..(at + 1) * *width];
                for (value, &bits) in values.iter_mut().zip(window) {
                    *value = f64::from_bits(bits);
                }
            }
            Self::Text(values) => text.unwrap_or_default().clone_into(&mut values[at]),
            Self::Element(_, values) => values[at] = Some(first as u32),
        }
    }

    /// The value at a place; `None` if there is none.
    fn get(&self, at: usize, ty: Type) -> Option<Argument> {
        Some(match self {
            Self::Bool(values) => Argument::Bool(*values.get(at)?),
            Self::Int(values) => Argument::Int(*values.get(at)?),
            Self::Real(values) => Argument::Real(*values.get(at)?),
            Self::Reals(width, values) => {
                Argument::Reals(ty, values.get(at * width..(at + 1) * width)?.to_vec())
            }
            Self::Text(values) => Argument::Text(values.get(at)?.clone()),
            Self::Element(kind, values) => Argument::Element(*kind, (*values.get(at)?)?),
        })
    }
}

impl Session {
    /// Calls a function. Returns its value, if it returns one.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn call(
        &mut self,
        function: &Function,
        arguments: impl Arguments,
    ) -> Result<Option<Argument>, Error> {
        self.call_watched(function, arguments, &mut Unwatched)
    }

    /// Calls a function with a watcher.
    ///
    /// # Errors
    /// As for [`run_watched`](Self::run_watched).
    pub fn call_watched(
        &mut self,
        function: &Function,
        arguments: impl Arguments,
        watch: &mut dyn Watch,
    ) -> Result<Option<Argument>, Error> {
        let prepared = self.take_function(function, arguments)?;
        let code = self.filled(prepared)?;
        self.bind_function(function, prepared)?;
        match prepared.changes() {
            true => self.go((prepared, &code), watch).map(drop)?,
            false => self.look((prepared, &code), watch)?,
        }
        Ok(function.result_type().and_then(|ty| {
            let mut value = Values::new(ty, 1);
            self.take_value((prepared, &code), &mut value, 0);
            value.get(0, ty)
        }))
    }

    /// The values of a function at all elements of the kind of its first parameter that is an
    /// element and not among the arguments, by id, holes being faces.
    ///
    /// # Errors
    /// No such parameter is left, the function returns no value, it may change the mesh
    /// (`changing-function`), or it fails at an element.
    pub fn values(
        &mut self,
        function: &Function,
        arguments: impl Arguments,
        watch: &mut dyn Watch,
    ) -> Result<Values, Error> {
        let prepared = self.take_function(function, arguments)?;
        let name = function.name();
        let Some(ty) = function.result_type() else {
            return Err(self.wrong("wrong-argument", format!("`{name}` gives no value")));
        };
        let Some((at, kind, slot)) = free_parameter(prepared, &self.values) else {
            return Err(self.no_free_parameter(name));
        };
        if prepared.changes() {
            let message = format!("`{name}` may change the mesh: call it at one element");
            return Err(self.wrong("changing-function", message));
        }
        let mut values = Values::new(ty, self.mesh.capacity(kind));
        let mut living = self.mesh.elements(kind).collect::<Vec<_>>().into_iter();
        let Some(first) = living.next() else { return Ok(values) };
        // The first call checks the arguments, and determines the level of the mesh.
        self.values[at] = Some(Argument::Element(kind, first));
        let code = self.filled(prepared)?;
        self.bind_function(function, prepared)?;
        let runs = (prepared, &*code);
        self.look(runs, watch)?;
        self.take_value(runs, &mut values, first as usize);
        let known = self.known;
        let mark = self.mesh.open_journal();
        let done = self.with_own_defaults(|session| {
            session.look_everywhere((runs, slot), living, &mut values, watch)
        });
        self.mesh.keep(mark);
        self.known = known;
        done.map(|()| values)
    }

    /// Runs a function that does not change the mesh at some elements, whose ids are written to
    /// `slot`; the other slots are filled.
    fn look_everywhere(
        &mut self,
        ((prepared, code), slot): ((&Prepared, &Code), usize),
        elements: impl Iterator<Item = u32>,
        values: &mut Values,
        watch: &mut dyn Watch,
    ) -> Result<(), Error> {
        let drains = code.drains();
        for id in elements {
            self.slots[slot] = u64::from(id);
            let machine = &mut self.engine.machine;
            let ran = match drains {
                true => machine.run(&mut self.mesh, code, &self.slots, watch),
                false => machine.run_without_drains(&mut self.mesh, code, &self.slots, watch),
            };
            if let Err(trap) = ran {
                let diagnostic = run::diagnostic(prepared, trap, Some(machine));
                return Err(self.error(diagnostic.note(format!("asked at number {id}"))));
            }
            if id % IDS_PER_LOOK == 0 && watch.tick().is_break() {
                let trap = Trap::new(Message::Interrupted);
                let diagnostic = run::diagnostic(prepared, trap, Some(machine));
                return Err(self.error(diagnostic));
            }
            self.take_value((prepared, code), values, id as usize);
        }
        Ok(())
    }

    /// Takes the arguments of a function.
    fn take_function<'f>(
        &mut self,
        function: &'f Function,
        arguments: impl Arguments,
    ) -> Result<&'f Prepared, Error> {
        self.expect_own(&function.program)?;
        let prepared = function.prepared()?;
        self.give(prepared, arguments)?;
        Ok(prepared)
    }

    /// Finds the columns of a function, whose arguments have been checked.
    fn bind_function(&mut self, function: &Function, prepared: &Prepared) -> Result<(), Error> {
        self.known.seek(prepared.wanted(), &self.mesh);
        let wanted = Bound::to_run(prepared.changes());
        let index = function.index;
        self.bind(prepared.columns(), wanted, |engine| &mut engine.bound_functions[index])
    }

    /// Runs a function that does not change the mesh. The known level stays, and the open journal
    /// keeps ids from being reused.
    fn look(&mut self, runs: (&Prepared, &Code), watch: &mut dyn Watch) -> Result<(), Error> {
        let known = self.known;
        let mark = self.mesh.open_journal();
        let done = self.go(runs, watch);
        self.mesh.keep(mark);
        self.known = known;
        done.map(drop)
    }

    /// Stores at `at` the value of the function that has just run.
    fn take_value(&self, (prepared, code): (&Prepared, &Code), values: &mut Values, at: usize) {
        let machine = &self.engine.machine;
        let window = machine.window().get(prepared.value()..).unwrap_or_default();
        let text = match values {
            Values::Text(_) => window.first().and_then(|&number| machine.text(code, number)),
            _ => None,
        };
        values.put(at, window, text);
    }
}
