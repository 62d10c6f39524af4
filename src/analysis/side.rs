//! One side of a rule as it is written: successors in loops, twins, spokes.
//!
//! Derived from the tree alone, families included, so that it is available while the rule is
//! unfinished. A `keep` in `after` stands for the statement of `before`.

use crate::resolve::drawn_names;
use crate::syntax::tree::{Arrow, Loop, Name, Rule, Side, Spoke, Star, Statement};

/// A name as it is drawn: the word, and for a member of a family its shift from the index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementRef {
    /// The word; empty for a path or fan without a name.
    pub word: String,
    /// The index and the offset added to it.
    pub index: Option<(String, i64)>,
}

impl ElementRef {
    fn of(name: &Name) -> Self {
        let index = name.index.as_ref().map(|index| {
            let variable = index.variable.as_ref();
            let variable = variable.map(|variable| variable.text.clone());
            (variable.unwrap_or_default(), index.offset)
        });
        Self { word: name.ident.text.clone(), index }
    }

    fn shift(&self) -> i64 {
        self.index.as_ref().map_or(0, |(_, shift)| *shift)
    }

    /// The same with an index relative to that of another.
    fn seen_from(&self, other: &Self) -> Self {
        self.clone().shifted(other.shift().saturating_neg())
    }

    fn shifted(mut self, by: i64) -> Self {
        if let Some((_, shift)) = &mut self.index {
            *shift = shift.saturating_add(by);
        }
        self
    }

    /// The name as it is written.
    pub fn text(&self) -> String {
        match &self.index {
            None => self.word.clone(),
            Some((variable, 0)) => format!("{}[{variable}]", self.word),
            Some((variable, shift)) => format!("{}[{variable}{shift:+}]", self.word),
        }
    }
}

/// A halfedge or path of a loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawn {
    pub item: ElementRef,
    /// The face or hole.
    pub face: ElementRef,
    /// The end where it starts.
    pub from: ElementRef,
    /// The end where it arrives.
    pub to: ElementRef,
    /// The successor.
    pub next: ElementRef,
    /// The predecessor.
    pub prev: ElementRef,
}

/// A pair of twins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    pub edge: ElementRef,
    pub halfedges: [ElementRef; 2],
}

/// A vertex statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spokes {
    pub vertex: ElementRef,
    /// Its spokes and fans, as they are written.
    pub spokes: Vec<ElementRef>,
    /// The statement, without its keyword and name.
    pub text: String,
}

/// One side, as it is written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sketch {
    /// The halfedges and paths in loops.
    pub drawn: Vec<Drawn>,
    /// The edge statements.
    pub pairs: Vec<Pair>,
    /// The vertex statements.
    pub stars: Vec<Spokes>,
}

impl Sketch {
    /// Both sides of a rule.
    pub fn of(rule: &Rule) -> [Self; 2] {
        let before = statements(rule.before.as_ref());
        let mut after = statements(rule.after.as_ref());
        let kept: Vec<&str> = after
            .iter()
            .filter_map(|statement| match statement {
                Statement::Keep(names, _) => Some(names),
                _ => None,
            })
            .flatten()
            .map(|name| name.ident.text.as_str())
            .collect();
        let is_kept = |statement: &&&Statement| {
            subject(statement).is_some_and(|name| kept.contains(&name.ident.text.as_str()))
        };
        after.extend(before.iter().filter(is_kept));
        [Self::read(&before), Self::read(&after)]
    }

    fn read(statements: &[&Statement]) -> Self {
        let mut sketch = Self::default();
        for statement in statements {
            match statement {
                Statement::Loop(orbit) => sketch.orbit(orbit),
                Statement::Edge { name, halfedges, .. } => sketch.pairs.push(Pair {
                    edge: ElementRef::of(name),
                    halfedges: [ElementRef::of(&halfedges[0]), ElementRef::of(&halfedges[1])],
                }),
                Statement::Vertex(star) => sketch.star(star),
                _ => {}
            }
        }
        sketch
    }

    fn orbit(&mut self, orbit: &Loop) {
        let count = orbit.items.len();
        let around = i64::from(orbit.each.is_some());
        let item = |at: usize| match &orbit.items[at].arrow {
            Arrow::Halfedge(name) | Arrow::Path(Some(name)) => ElementRef::of(name),
            Arrow::Path(None) => ElementRef { word: String::new(), index: None },
        };
        let from = |at: usize| ElementRef::of(&orbit.items[at].from);
        for at in 0..count {
            let is_last = at + 1 == count;
            let (to, next) = if is_last {
                let first = || from(0).shifted(around);
                let to = orbit.end.as_ref().map_or_else(first, ElementRef::of);
                (to, item(0).shifted(around))
            } else {
                (from(at + 1), item(at + 1))
            };
            let prev = match at.checked_sub(1) {
                Some(before) => item(before),
                None => item(count - 1).shifted(-around),
            };
            self.drawn.push(Drawn {
                item: item(at),
                face: ElementRef::of(&orbit.name),
                from: from(at),
                to,
                next,
                prev,
            });
        }
    }

    fn star(&mut self, star: &Star) {
        let spoke = |spoke: &Spoke| match spoke {
            Spoke::Halfedge(name) | Spoke::Fan(Some(name), _) => ElementRef::of(name),
            Spoke::Fan(None, _) => ElementRef { word: String::new(), index: None },
        };
        let words = star.spokes.iter().map(|written| match written {
            Spoke::Halfedge(name) => ElementRef::of(name).text(),
            Spoke::Fan(name, _) => {
                let name = name.as_ref().map(|name| ElementRef::of(name).text());
                format!("*{}", name.unwrap_or_default())
            }
        });
        let words = words.collect::<Vec<_>>().join(" ");
        let text = match &star.each {
            Some(index) => format!("each {} {{ {words} }}", index.text),
            None => words,
        };
        self.stars.push(Spokes {
            vertex: ElementRef::of(&star.name),
            spokes: star.spokes.iter().map(spoke).collect(),
            text,
        });
    }

    /// The place of a halfedge or path in a loop; for a member of a family, with indices relative
    /// to its own.
    pub fn place(&self, word: &str) -> Option<Drawn> {
        let drawn = self.drawn.iter().find(|drawn| drawn.item.word == word)?;
        let seen = |place: &ElementRef| place.seen_from(&drawn.item);
        Some(Drawn {
            item: seen(&drawn.item),
            face: seen(&drawn.face),
            from: seen(&drawn.from),
            to: seen(&drawn.to),
            next: seen(&drawn.next),
            prev: seen(&drawn.prev),
        })
    }

    /// The edge and the twin of a halfedge; for a member of a family, with indices relative to its
    /// own.
    pub fn pair(&self, word: &str) -> Option<(ElementRef, ElementRef)> {
        let (pair, at) = self.pairs.iter().find_map(|pair| {
            let at = pair.halfedges.iter().position(|half| half.word == word)?;
            Some((pair, at))
        })?;
        let seen = |place: &ElementRef| place.seen_from(&pair.halfedges[at]);
        Some((seen(&pair.edge), seen(&pair.halfedges[1 - at])))
    }

    /// The vertex whose statement lists a spoke or fan.
    pub fn star_of(&self, word: &str) -> Option<ElementRef> {
        let star =
            self.stars.iter().find(|star| star.spokes.iter().any(|spoke| spoke.word == word))?;
        Some(star.vertex.clone())
    }

    /// The start of a halfedge, if this side determines it.
    pub fn origin(&self, word: &str) -> Option<ElementRef> {
        let own = self.place(word).map(|drawn| drawn.from);
        own.or_else(|| self.star_of(word)).or_else(|| {
            let (_, twin) = self.pair(word)?;
            Some(self.place(&twin.word)?.to.shifted(twin.shift()))
        })
    }

    /// True if an edge, face or vertex is the subject of a statement of the side.
    pub fn is_subject(&self, word: &str) -> bool {
        self.drawn.iter().any(|drawn| drawn.face.word == word)
            || self.pairs.iter().any(|pair| pair.edge.word == word)
            || self.stars.iter().any(|star| star.vertex.word == word)
    }

    /// True if any statement of the side draws a name.
    pub fn draws(&self, word: &str) -> bool {
        let is = |place: &ElementRef| place.word == word;
        self.drawn
            .iter()
            .any(|drawn| is(&drawn.item) || is(&drawn.face) || is(&drawn.from) || is(&drawn.to))
            || self.pairs.iter().any(|pair| is(&pair.edge) || pair.halfedges.iter().any(is))
            || self.stars.iter().any(|star| is(&star.vertex) || star.spokes.iter().any(is))
    }
}

fn statements(side: Option<&Side>) -> Vec<&Statement> {
    side.map_or_else(Vec::new, |side| side.statements.iter().collect())
}

/// The element that a statement is about.
pub fn subject(statement: &Statement) -> Option<&Name> {
    match statement {
        Statement::Loop(orbit) => Some(&orbit.name),
        Statement::Edge { name, .. } => Some(name),
        Statement::Vertex(star) => Some(&star.name),
        _ => None,
    }
}

/// True if a statement draws something that a side erases.
pub(super) fn draws_erased(statement: &Statement, side: &Side) -> bool {
    let erased = side.statements.iter().filter_map(|statement| match statement {
        Statement::Erase(names, _) => Some(names),
        _ => None,
    });
    let draws = |word: &str| drawn_names(statement).any(|(name, _)| name.ident.text == word);
    erased.flatten().any(|name| draws(&name.ident.text))
}

/// The statements of `before` that `after` neither states nor keeps, and that draw nothing that it
/// erases.
pub(super) fn left_open(rule: &Rule) -> impl Iterator<Item = &Statement> {
    let [_, sketch] = Sketch::of(rule);
    let statements = rule.before.iter().flat_map(|side| &side.statements);
    statements.filter(move |statement| {
        let is_open = subject(statement).is_some_and(|name| !sketch.is_subject(&name.ident.text));
        is_open && !rule.after.as_ref().is_some_and(|after| draws_erased(statement, after))
    })
}
