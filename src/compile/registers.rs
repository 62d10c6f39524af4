//! Where the names of a rule live in the window.

use super::Scope;
use crate::check::matching::Bound;
use crate::diagram::{Drawing, Kind, NameId};
use crate::rewrite::{Assembler, Reg};
use crate::source::Span;

/// A register for every element, and two for every path.
#[derive(Clone, Debug)]
pub(super) struct Registers {
    elements: Vec<Reg>,
    lasts: Vec<Reg>,
    params: Vec<Reg>,
    folds: Vec<(u32, Reg)>,
    places: Vec<Span>,
    first_place: u32,
}

impl Registers {
    /// Gives each name its registers; a parameter that is drawn keeps its own.
    pub fn new(asm: &mut Assembler, drawing: &Drawing, params: &[Reg]) -> Self {
        let rule = drawing.rule;
        let unused = Reg(0);
        let mut registers = Self {
            elements: vec![unused; rule.names.len()],
            lasts: vec![unused; rule.names.len()],
            params: params.to_vec(),
            folds: Vec::new(),
            places: Vec::new(),
            first_place: 0,
        };
        for index in 0..rule.names.len() {
            let name = NameId(index as u32);
            let parameter = rule.params.iter().position(|param| *param == Some(name));
            registers.elements[index] = match (parameter, rule.kind(name)) {
                (_, Kind::Fan) => continue,
                (Some(parameter), _) => params[parameter],
                (None, _) => asm.reg(),
            };
            if rule.kind(name) == Kind::Path {
                registers.lasts[index] = asm.reg();
            }
        }
        registers
    }

    /// The register of an element.
    pub fn element(&self, name: NameId) -> Reg {
        self.elements[name.index()]
    }

    /// The register of the first halfedge of a path.
    pub fn first(&self, path: NameId) -> Reg {
        self.elements[path.index()]
    }

    /// The register of the last halfedge of a path.
    pub fn last(&self, path: NameId) -> Reg {
        self.lasts[path.index()]
    }

    /// The register of what matching binds.
    pub fn bound(&self, bound: Bound) -> Reg {
        match bound {
            Bound::Element(name) => self.element(name),
            Bound::First(path) => self.first(path),
            Bound::Last(path) => self.last(path),
        }
    }

    /// Numbers the places that [`Scope::place`] gives out from here on.
    pub fn number_places_from(&mut self, first: u32) {
        self.first_place = first;
    }

    /// The places given out since they were last taken.
    pub fn take_places(&mut self) -> Vec<Span> {
        std::mem::take(&mut self.places)
    }
}

impl Scope for Registers {
    fn element(&self, name: NameId) -> Reg {
        self.elements[name.index()]
    }

    fn local(&self, variable: u32) -> Reg {
        let fold = self
            .folds
            .iter()
            .rev()
            .find(|(number, _)| *number == variable);
        fold.map_or_else(|| self.params[variable as usize], |&(_, reg)| reg)
    }

    fn declare(&mut self, variable: u32, reg: Reg) {
        self.folds.push((variable, reg));
    }

    fn place(&mut self, span: Span) -> u32 {
        self.places.push(span);
        self.first_place + self.places.len() as u32 - 1
    }
}
