//! Families in phase 3: loops that are drawn with `each`.

use super::reassign::Reassign;
use super::routine::Statement;
use super::term::{IndexLoop, Term};
use crate::diagram::{Loop, Pointer, Type};

impl Reassign<'_, '_> {
    /// A loop with `each`: the items of a period, for each index.
    pub(super) fn orbit_around(&mut self, orbit: &Loop) {
        let size = self.drawing.rule.size().unwrap_or(1) as usize;
        let period = orbit.items.len() / size.max(1);
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        if self.is_of_runs(orbit) {
            self.orbit_of_runs(orbit, period);
            return;
        }
        self.indexed(true, |this| {
            for at in 0..period {
                this.link(&items, at);
                this.lies_in(&orbit.items[at], orbit.face.name);
            }
        });
    }

    /// True if each item is a run that may be empty.
    fn is_of_runs(&self, orbit: &Loop) -> bool {
        let mut items = orbit.items.iter().map(|item| item.item.name);
        orbit.each && items.all(|item| self.is_path(item) && self.drawing.is_empty_somewhere(item))
    }

    /// A loop of runs each of which may be empty: those that are not are linked in their
    /// order. There is one: that was tested.
    fn orbit_of_runs(&mut self, orbit: &Loop, period: usize) {
        let [firsts, lasts] = ["firsts", "lasts"].map(|wanted| self.names.fresh(wanted));
        for name in [&firsts, &lasts] {
            self.runs.push(Statement::List {
                ty: Type::Halfedge,
                name: name.clone(),
                items: Vec::new(),
            });
        }
        let paths = orbit.items[..period].iter().map(|item| item.item.name);
        let body = self.indexed(true, |this| {
            let pushed = paths.map(|path| Statement::When {
                condition: this.names.empty(path).not(),
                body: [(&firsts, this.names.term(path)), (&lasts, this.names.last(path))]
                    .map(|(list, item)| Statement::Push { list: list.clone(), item })
                    .to_vec(),
            });
            pushed.collect()
        });
        let indices = self.names.indices();
        self.runs.push(Statement::IndexLoop { indices, body });
        // From here on an index counts the runs that are there.
        let indices =
            IndexLoop { index: self.names.indices().index, size: self.names.fresh("runs") };
        let member = |list: &String, shift| Term::Member {
            list: list.clone(),
            index: Some(indices.index.clone()),
            shift,
            size: indices.size.clone(),
        };
        let (last, first) = (member(&lasts, 0), member(&firsts, 1));
        let set = |pointer, of: &Term, value: &Term| Statement::Set {
            pointer,
            of: of.clone(),
            value: value.clone(),
        };
        let mut body = vec![set(Pointer::Next, &last, &first)];
        if self.conventions.prev {
            body.push(set(Pointer::Prev, &first, &last));
        }
        self.runs.push(Statement::Size { name: indices.size.clone(), list: firsts.clone() });
        self.runs.push(Statement::IndexLoop { indices: indices.clone(), body });
        let first = Term::Member { list: firsts, index: None, shift: 0, size: indices.size };
        self.first_runs.push((orbit.face.name, first));
    }
}
