//! The four phases of a rule.

use super::symmetric::refuses_alike;
use super::{Guard, Matching, Tries};
use crate::check::Proof;
use crate::diagram::{Access, Drawing, Expr, Kind, NameId, Ref};

/// A rule, phase by phase. Phase 3 begins with
/// [`Drawing::reassignments`](crate::diagram::Drawing::reassignments); the values come last.
///
/// For a family, the member at index 0 stands for all.
#[derive(Clone, Debug)]
pub struct Operation<'r> {
    pub matching: Matching,
    pub requires: Vec<Condition<'r>>,
    pub guard: Guard,
    /// The new values of positions and attributes; computed before anything is written.
    pub values: Vec<Value<'r>>,
    pub created: Vec<Element>,
    pub erased: Vec<Element>,
    pub result: Option<NameId>,
}

/// A condition that a rule requires.
#[derive(Clone, Debug)]
pub struct Condition<'r> {
    pub condition: &'r Expr,
    pub at_each_index: bool,
    pub refusal: &'r str,
}

/// A value that an attribute is set to.
#[derive(Clone, Debug)]
pub struct Value<'r> {
    pub element: NameId,
    pub attribute: Access,
    pub value: &'r Expr,
    pub at_each_index: bool,
    /// The reason to refuse a position that is not finite.
    pub infinite: Option<String>,
}

/// An element that is created or erased.
#[derive(Clone, Copy, Debug)]
pub struct Element {
    pub name: NameId,
    pub kind: Kind,
    pub at_each_index: bool,
}

impl<'r> Operation<'r> {
    pub fn new(drawing: &Drawing<'r>, proof: &Proof) -> Self {
        let rule = drawing.rule;
        let requires = rule.requires.iter();
        // The condition at index 0 is tested at every index.
        let requires = requires.filter(|require| require.index.is_none_or(|index| index == 0));
        let values = rule.assignments.iter().filter(|set| rule.is_first(set.target.name));
        let elements = |list: &[Ref]| {
            let first = list.iter().map(|mention| mention.name).filter(|&name| rule.is_first(name));
            let elements = first.map(|name| Element {
                name,
                kind: rule.kind(name),
                at_each_index: rule.is_member(name),
            });
            elements.filter(|one| !matches!(one.kind, Kind::Path | Kind::Fan)).collect()
        };
        let values: Vec<_> = values
            .map(|set| Value {
                element: set.target.name,
                attribute: set.attribute,
                value: &set.value,
                at_each_index: rule.is_member(set.target.name),
                infinite: (set.attribute == Access::Position).then(|| {
                    let text = &rule.name(set.target.name).text;
                    format!("the new position of `{text}` is not finite")
                }),
            })
            .collect();
        let mut matching = Matching::new(drawing, proof.matching());
        let guard = Guard::new(drawing, proof.guard());
        if let Some(halfedge) = matching.begins_at_edge(drawing)
            && refuses_alike(drawing, halfedge, &matching, &guard)
        {
            matching.set_tries(match values.iter().all(|value| value.infinite.is_none()) {
                true => Tries::Some(1),
                false => Tries::AllForValues,
            });
        }
        Self {
            matching,
            requires: requires
                .map(|require| Condition {
                    condition: &require.condition,
                    at_each_index: require.index.is_some(),
                    refusal: &require.reason,
                })
                .collect(),
            guard,
            values,
            created: elements(&rule.created),
            erased: elements(&rule.erased),
            result: rule.result.map(|result| result.name),
        }
    }
}
