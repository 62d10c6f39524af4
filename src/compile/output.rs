//! The output that all alternatives of an operation are written into.

use std::collections::HashMap;

use crate::rewrite::{Assembler, Cell, Phase, Refusal, Row};
use crate::source::{Sources, Span};

/// The output that all alternatives of an operation are written into.
pub(super) struct Output<'a> {
    pub asm: Assembler,
    pub sources: &'a Sources,
    pub places: Vec<Span>,
    pub refusals: Vec<Refusal>,
    /// The number of each refusal: an operation with hundreds of names has tens of thousands.
    numbers: HashMap<Refusal, u16>,
}

impl<'a> Output<'a> {
    pub fn new(sources: &'a Sources, texts: &[String]) -> Self {
        Self {
            asm: Assembler::knowing(texts),
            sources,
            places: Vec::new(),
            refusals: Vec::new(),
            numbers: HashMap::new(),
        }
    }

    /// The number of a place in the source.
    pub fn place(&mut self, span: Span) -> u32 {
        self.places.push(span);
        self.places.len() as u32 - 1
    }

    /// The number of a refusal; equal refusals share one.
    pub fn refusal(&mut self, reason: String, phase: Phase) -> u16 {
        let refusal = Refusal { reason, phase };
        let next = u16::try_from(self.refusals.len()).unwrap_or(u16::MAX);
        let (refusals, numbers) = (&mut self.refusals, &mut self.numbers);
        *numbers.entry(refusal).or_insert_with_key(|refusal| {
            refusals.push(refusal.clone());
            next
        })
    }

    /// The words of a place in the source, on one line.
    pub fn words(&self, span: Span) -> String {
        self.sources.slice(span).split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

impl Row {
    /// `target = value`
    pub(super) fn set(target: String, value: String, executed: bool) -> Self {
        Self { cell: Cell::Set { target, value }, executed }
    }
}
