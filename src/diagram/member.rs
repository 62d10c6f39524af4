//! Turns of an unrolled rule around its cycle, and the indices of its members.
//!
//! Turning all names of an unrolled rule by one index gives the same rule again, so what holds at
//! index 0 holds at every index. In a rule without families nothing turns.

use super::{NameId, Ref, Role, Rule};

impl Rule {
    /// True if it has families that are not unrolled.
    pub fn has_families(&self) -> bool {
        self.cycle.as_ref().is_some_and(|cycle| cycle.size.is_none())
    }

    /// The size that it was unrolled to, if it was.
    pub fn size(&self) -> Option<u32> {
        self.cycle.as_ref()?.size
    }

    /// True if a name is a member of a family.
    pub fn is_member(&self, name: NameId) -> bool {
        matches!(self.name(name).role, Role::Member { .. })
    }

    /// The index of a member; 0 for any other name.
    pub fn index(&self, name: NameId) -> u32 {
        match self.name(name).role {
            Role::Member { index, .. } => index,
            Role::Single | Role::Family => 0,
        }
    }

    /// The index of a member, counted from the nearer end of the cycle: -1 is the last before 0.
    pub fn offset(&self, name: NameId) -> i64 {
        let (index, size) = (self.index(name), self.size().unwrap_or(1));
        if index <= size / 2 { i64::from(index) } else { i64::from(index) - i64::from(size) }
    }

    /// The member of the same family that is `by` further around the cycle; any other name is
    /// unchanged.
    pub fn turned(&self, name: NameId, by: i64) -> NameId {
        let (Role::Member { index, .. }, Some(size)) = (self.name(name).role, self.size()) else {
            return name;
        };
        let around = (i64::from(index) + by).rem_euclid(i64::from(size));
        NameId(name.0 - index + around as u32)
    }

    /// The member at index 0 of the same family; any other name is unchanged.
    pub fn first_member(&self, name: NameId) -> NameId {
        self.turned(name, -i64::from(self.index(name)))
    }

    /// True if a name is single, or a member at index 0.
    pub fn is_first(&self, name: NameId) -> bool {
        self.index(name) == 0
    }

    /// The largest number that a subscript adds to the index, or subtracts from it; at least one,
    /// since `each` leads from a period to the next.
    pub fn span_of_subscripts(&self) -> u32 {
        let mut widest = 1;
        let mut see = |mention: &Ref| widest = widest.max(mention.shift.unsigned_abs());
        for side in [&self.before, &self.after] {
            side.mentions().for_each(&mut see);
        }
        widest
    }
}
