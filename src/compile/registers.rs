//! Registers of the names of a rule: in the window or, with one slot for each index, in a buffer.

use std::collections::HashMap;

use super::Scope;
use crate::check::matching::Bound;
use crate::diagram::{Drawing, Expr, ExprKind, Kind, NameId};
use crate::rewrite::{Assembler, Reg};
use crate::source::Span;

/// The place where the value of a name is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Home {
    /// In a register.
    Reg(Reg),
    /// In a buffer, with a slot for each index of the cycle; this is the member `shift` after the
    /// index.
    Member {
        buffer: u16,
        /// The shift of the index.
        shift: i16,
    },
}

/// A home for every element, and two or three for every path.
#[derive(Clone, Debug)]
pub(super) struct Registers {
    elements: Vec<Home>,
    lasts: Vec<Home>,
    /// For each path that may be empty, whether it is.
    empty: Vec<Option<Home>>,
    /// The registers of members at index 0 that are known before their families are bound.
    begun: HashMap<NameId, Reg>,
    /// A buffer as long as the cycle, once a family is bound.
    pub cycle: Option<u16>,
    /// The index, inside a loop over the indices.
    index: Option<Reg>,
    /// Members that an expression reads.
    loaded: HashMap<NameId, Reg>,
    params: Vec<Reg>,
    folds: Vec<(u32, Reg)>,
    places: Vec<Span>,
    first_place: u32,
}

impl Registers {
    /// Assigns each name a home; a parameter that is drawn keeps its own register.
    pub fn new(asm: &mut Assembler, drawing: &Drawing, params: &[Reg]) -> Self {
        let rule = drawing.rule;
        let count = rule.names.len();
        let unused = Home::Reg(Reg(0));
        let mut registers = Self {
            elements: vec![unused; count],
            lasts: vec![unused; count],
            empty: vec![None; count],
            begun: HashMap::new(),
            cycle: None,
            index: None,
            loaded: HashMap::new(),
            params: params.to_vec(),
            folds: Vec::new(),
            places: Vec::new(),
            first_place: 0,
        };
        for name in (0..count as u32).map(NameId) {
            let kind = rule.kind(name);
            if kind == Kind::Fan {
                continue;
            }
            let parameter = rule.params.iter().position(|param| *param == Some(name));
            let parameter = parameter.map(|parameter| params[parameter]);
            if rule.is_member(name) {
                registers.give_member(asm, drawing, name);
                if let Some(reg) = parameter {
                    registers.begun.insert(name, reg);
                }
                continue;
            }
            let reg = parameter.unwrap_or_else(|| asm.reg());
            registers.elements[name.index()] = Home::Reg(reg);
            if kind == Kind::Path {
                registers.lasts[name.index()] = Home::Reg(asm.reg());
                if drawing.is_empty_somewhere(name) && drawing.before.mention(name).is_some() {
                    registers.empty[name.index()] = Some(Home::Reg(asm.reg()));
                }
            }
        }
        registers
    }

    /// The members of a family share its buffers.
    fn give_member(&mut self, asm: &mut Assembler, drawing: &Drawing, name: NameId) {
        let rule = drawing.rule;
        let first = rule.first_member(name);
        let shift = i16::try_from(rule.offset(name)).unwrap_or(0);
        let (at, of) = (name.index(), first.index());
        if name == first {
            let mut home = || Home::Member { buffer: asm.buffer(), shift: 0 };
            self.elements[at] = home();
            if rule.kind(name) == Kind::Path {
                self.lasts[at] = home();
                let drawn = drawing.before.mention(name).is_some();
                self.empty[at] = (drawn && drawing.is_empty_somewhere(name)).then(home);
            }
            return;
        }
        let turned = |home: Home| match home {
            Home::Member { buffer, .. } => Home::Member { buffer, shift },
            home => home,
        };
        self.elements[at] = turned(self.elements[of]);
        self.lasts[at] = turned(self.lasts[of]);
        self.empty[at] = self.empty[of].map(turned);
    }

    /// The home of an element, or of the first halfedge of a path.
    pub fn home(&self, name: NameId) -> Home {
        self.elements[name.index()]
    }

    /// The home of what matching binds.
    pub fn home_of(&self, bound: Bound) -> Home {
        match bound {
            Bound::Element(name) | Bound::First(name) => self.elements[name.index()],
            Bound::Last(path) => self.lasts[path.index()],
        }
    }

    /// The slot that tells whether a path is empty, if it may be.
    pub fn home_of_empty(&self, path: NameId) -> Option<Home> {
        self.empty[path.index()]
    }

    /// The register of a home; a member is loaded, at index 0 outside a loop over the indices.
    pub fn read(&self, asm: &mut Assembler, home: Home) -> Reg {
        match home {
            Home::Reg(reg) => reg,
            Home::Member { buffer, shift } => {
                let index = self.index.unwrap_or_else(|| asm.constant_int(0));
                asm.member(buffer, index, shift)
            }
        }
    }

    pub fn element(&self, asm: &mut Assembler, name: NameId) -> Reg {
        self.read(asm, self.home(name))
    }

    /// The register of what matching binds.
    pub fn bound(&self, asm: &mut Assembler, bound: Bound) -> Reg {
        self.read(asm, self.home_of(bound))
    }

    /// The register of whether a path is empty, if it may be.
    pub fn is_empty(&self, asm: &mut Assembler, path: NameId) -> Option<Reg> {
        Some(self.read(asm, self.home_of_empty(path)?))
    }

    /// The register of a member at index 0 whose family is not bound yet.
    pub fn begin(&mut self, asm: &mut Assembler, name: NameId) -> Reg {
        *self.begun.entry(name).or_insert_with(|| asm.reg())
    }

    /// Enters or leaves a loop over the indices.
    pub fn set_index(&mut self, index: Option<Reg>) {
        self.index = index;
    }

    /// The index, inside a loop over the indices.
    pub fn index(&self) -> Option<Reg> {
        self.index
    }

    /// Loads the members that an expression reads.
    pub fn load_members(&mut self, asm: &mut Assembler, expr: &Expr) {
        self.loaded.clear();
        let mut names = Vec::new();
        expr.each(&mut |expr| {
            if let ExprKind::Element(name) = expr.kind {
                names.push(name);
            }
        });
        for name in names {
            if let Home::Member { .. } = self.home(name)
                && !self.loaded.contains_key(&name)
            {
                self.loaded.insert(name, self.element(asm, name));
            }
        }
    }

    /// Numbers the places that [`Scope::place`] gives out from here on.
    pub fn number_places_from(&mut self, first: u32) {
        self.first_place = first;
    }

    /// The places given out since the last call.
    pub fn take_places(&mut self) -> Vec<Span> {
        std::mem::take(&mut self.places)
    }
}

impl Scope for Registers {
    fn element(&self, name: NameId) -> Reg {
        match self.home(name) {
            Home::Reg(reg) => reg,
            // `load_members` has loaded it.
            Home::Member { .. } => self.loaded.get(&name).copied().unwrap_or(Reg(0)),
        }
    }

    fn local(&self, variable: u32) -> Reg {
        let fold = self.folds.iter().rev().find(|(number, _)| *number == variable);
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
