//! Phase 1, collect: names are bound by following pointers, and what is drawn is tested.

use super::build::Writer;
use super::language::type_of;
use super::value::Term;
use crate::check::matching::{Bound, Claim, Source, Way};
use crate::diagram::{Binary, LoopKind, NameId, Pointer, Type};
use crate::lower::{Begin, EmptyPath, Matching, Step, Walk};

impl Writer<'_, '_> {
    /// Binds names, in order.
    pub fn steps(&mut self, steps: &[Step]) {
        for step in steps {
            match step {
                Step::Given(_) => {}
                Step::Begin(begin) => self.begin(begin),
                Step::Walk(walk) => self.walk(walk),
                &Step::Bind { bound, source, at_each_index: each } => {
                    let value = self.for_each(each, |this| this.source(source));
                    let word = match bound {
                        Bound::Element(name) | Bound::First(name) => self.names.word(name),
                        Bound::Last(path) => &self.names.named(path).last,
                    };
                    let (ty, word) = (self.ty(bound.name()), word.to_string());
                    self.bind(ty, &word, &value, each);
                }
            }
        }
    }

    /// Binds the halfedge to begin with, where no other has to be tried.
    fn begin(&mut self, begin: &Begin) {
        let (language, element) = (self.names.language, self.names.term(begin.element));
        if let (Some(reason), true) = (&begin.isolated, language.is_rust()) {
            self.refuse(language.call("IsIsolated", [&element]), false, reason);
        }
        let name = self.names.begin(begin.halfedge);
        self.bind(Type::Halfedge, &name, &language.follow(begin.first, &element), false);
    }

    /// Walks an orbit once around and distributes its halfedges among the families of a period.
    fn walk(&mut self, walk: &Walk) {
        let (language, list) = (self.names.language, (Type::Halfedge, true));
        let function = if walk.around_vertex { "SpokesFrom" } else { "LoopFrom" };
        let from = Term::name(self.names.begin(walk.families[0].0));
        let mut all = language.call(function, [&from]);
        let [zero, period] = [0, walk.families.len()].map(|number| Term::whole(number.to_string()));
        if let Some(test) = &walk.is_whole {
            let name = self.names.fresh("all");
            self.body.push(language.bind(list, &name, &all));
            all = Term::name(name);
            let rest = language.call("Remainder", [&all, &period]);
            self.refuse(Term::infix(Binary::EqualInt, [rest, zero]).not(), false, &test.refusal);
        }
        for (place, &(half, turn)) in walk.families.iter().enumerate() {
            let mut value = all.clone();
            if walk.families.len() > 1 {
                let place = Term::whole(place.to_string());
                value = language.call("Every", [&value, &place, &period]);
            }
            if turn != 0 {
                value = language.call("Rotated", [&value, &Term::whole(turn.to_string())]);
            }
            let (name, size) = (self.names.word(half), &self.names.indices.size);
            self.body.push(language.bind(list, name, &value));
            match &walk.fits {
                _ if place > 0 => {}
                Some(test) => {
                    let length = language.call("Length", [&Term::name(name)]);
                    let fits = Term::infix(Binary::EqualInt, [length, Term::name(size)]);
                    self.refuse(fits.not(), false, &test.refusal);
                }
                None => self.body.push(language.size(size, name)),
            }
        }
    }

    /// Binds whether paths are empty, and makes the tests.
    pub fn empty_paths_and_tests(&mut self, matching: &Matching) {
        for &EmptyPath { path, next, at_each_index: each } in &matching.empty_paths {
            let name = self.names.named(path).empty.clone();
            let ends = [path, next];
            let [first, next] = self.for_each(each, |this| ends.map(|end| this.names.term(end)));
            self.bind(Type::Bool, &name, &first.is(next), each);
        }
        for test in &matching.tests {
            let holds = self.for_each(test.at_each_index, |this| this.claim(&test.condition));
            self.refuse(holds.not(), test.at_each_index, &test.refusal);
        }
    }

    /// A list of elements: those that are no members, then the members index by index.
    fn listed(&mut self, members: &[NameId]) -> Term {
        let (list, rule) = (self.names.fresh("all"), self.drawing.rule);
        let (each, once): (Vec<_>, Vec<_>) =
            members.iter().partition(|name| rule.is_member(**name));
        let ty = members.first().map_or(Type::Halfedge, |&name| self.ty(name));
        let terms: Vec<_> = once.into_iter().map(|name| self.names.term(name)).collect();
        let language = self.names.language;
        self.body.push(language.list(ty, &list, &terms));
        let pushes = self.for_each(true, |this| {
            each.into_iter().map(|name| language.push(&list, &this.names.term(name))).collect()
        });
        self.body.push(language.index_loop(&self.names.indices, pushes));
        Term::name(list)
    }

    /// The type of a name; of a path, that of its ends.
    fn ty(&self, name: NameId) -> Type {
        type_of(self.drawing.rule.kind(name))
    }

    fn bound(&self, bound: Bound) -> Term {
        match bound {
            Bound::Element(name) | Bound::First(name) => self.names.term(name),
            Bound::Last(path) => self.names.last(path),
        }
    }

    fn source(&self, source: Source) -> Term {
        let language = self.names.language;
        let follow = |term: Term, pointer: &Pointer| language.follow(*pointer, &term);
        source.pointers().iter().fold(self.bound(source.from), follow)
    }

    /// The condition that a claim holds.
    fn claim(&mut self, claim: &Claim) -> Term {
        let (language, term) = (self.names.language, |name: &NameId| self.names.term(*name));
        match claim {
            // The same, without `prev`.
            Claim::Leads(Source { way: Way::Prev, from }, to) => {
                self.source(Way::Next.of(*to)).is(self.bound(*from))
            }
            Claim::Leads(Source { way: Way::Counterclockwise, from }, to) => {
                self.source(Way::Clockwise.of(*to)).is(self.bound(*from))
            }
            Claim::Leads(source, to) => self.source(*source).is(self.bound(*to)),
            Claim::Distinct(left, right) => term(left).is(term(right)).not(),
            Claim::Kind(face, LoopKind::Hole) => language.call("IsHole", [&term(face)]),
            Claim::Kind(face, _) => language.call("IsHole", [&term(face)]).not(),
            Claim::InOrder { along_loop, halfedges } => {
                let function = if *along_loop { "InOrderAlongLoop" } else { "InOrderAroundVertex" };
                language.call(function, &halfedges.each_ref().map(term))
            }
            Claim::NotAllEmpty(paths) => self.are_empty(paths).not(),
            Claim::Listed { halfedge, vertices: [origin, vertex], spokes } => {
                let apart = term(origin).is(term(vertex)).not();
                spokes.iter().map(|spoke| term(halfedge).is(term(spoke))).fold(apart, Term::or)
            }
            Claim::Begins(name) => Term::name(self.names.begin(*name)).is(self.names.term(*name)),
            Claim::NotAllEmptyAround(paths) => {
                let some = self.for_each(true, |this| this.are_empty(paths).not());
                language.for_some(&self.names.indices, &some)
            }
            Claim::AllDistinct(names) => {
                let all = match names[..] {
                    [family] if self.drawing.rule.is_member(family) => {
                        Term::name(self.names.word(family))
                    }
                    _ => self.listed(names),
                };
                language.call("AllDiffer", [&all])
            }
            Claim::AroundInOrder { along_loop, halfedges } => {
                let function =
                    if *along_loop { "AllInOrderAlongLoop" } else { "AllInOrderAroundVertex" };
                language.call(function, [&self.listed(halfedges)])
            }
        }
    }

    /// The condition that all of these paths are empty.
    fn are_empty(&self, paths: &[NameId]) -> Term {
        let empty = |&path: &NameId| match self.drawing.is_empty_somewhere(path) {
            true => self.names.empty(path),
            false => Term::bool(false),
        };
        paths.iter().map(empty).reduce(Term::and).unwrap_or(Term::bool(false))
    }
}
