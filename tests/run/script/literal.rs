//! What the language says of loops, read word by word: a small interpreter that looks at all
//! of the mesh wherever the machine keeps books.

use hedgerow::analysis::Analysis;
use hedgerow::mesh::{EdgeId, ElementKind, FaceId, Mesh, Value, VertexId};
use hedgerow::rewrite::{Machine, Outcome};

pub type Body = Vec<Statement>;

/// A statement; variables are numbered from the outermost loop inwards.
#[derive(Clone, Debug)]
pub enum Statement {
    Repeat(i64, Body),
    For {
        kind: ElementKind,
        around: Around,
        test: Test,
        body: Body,
    },
    /// Each gets the sum of the marks around it, modulo 7, and 1.
    Update {
        kind: ElementKind,
        around: Around,
        test: Test,
    },
    /// The key is the mark, perhaps with the degree.
    Drain {
        kind: ElementKind,
        by_degree: bool,
        turns: i64,
        body: Body,
    },
    If(Test, Body),
    Edit(Edit, usize),
    Bump(usize, i64),
    Print(usize),
}

#[derive(Clone, Copy, Debug)]
pub enum Around {
    Mesh,
    Variable(usize),
}

#[derive(Clone, Copy, Debug)]
pub enum Test {
    Always,
    EdgesBelow(i64),
    Mark { variable: usize, by: i64, rest: i64 },
}

#[derive(Clone, Copy, Debug)]
pub enum Edit {
    Split,
    Flip,
    Collapse,
}

impl Edit {
    pub fn name(self) -> &'static str {
        match self {
            Edit::Split => "split",
            Edit::Flip => "flip",
            Edit::Collapse => "collapse",
        }
    }
}

/// An element that is used, and is not there any more.
#[derive(Debug)]
pub struct Gone;

/// No program splits further.
pub const MOST: usize = 130;

type Known = (ElementKind, u32);

pub struct Literal<'a> {
    pub mesh: Mesh,
    pub lines: Vec<String>,
    /// How many edits were applied.
    pub applied: usize,
    /// Whether an edit used the slot of something erased.
    pub reused: bool,
    analysis: &'a Analysis,
    machine: Machine,
}

impl<'a> Literal<'a> {
    pub fn new(mesh: Mesh, analysis: &'a Analysis) -> Self {
        Self {
            mesh,
            lines: Vec::new(),
            applied: 0,
            reused: false,
            analysis,
            machine: Machine::new(&analysis.plans),
        }
    }

    pub fn run(&mut self, program: &Body) -> Result<(), Gone> {
        self.outside(program)
    }

    /// Outside of loops over elements nobody needs an old number.
    fn outside(&mut self, body: &Body) -> Result<(), Gone> {
        for statement in body {
            if edits(statement) {
                self.mesh.recycle();
            }
            match statement {
                Statement::Repeat(times, body) => {
                    for _ in 0..*times {
                        self.outside(body)?;
                    }
                }
                Statement::Drain { kind, by_degree, turns, body } => {
                    self.drain(*kind, *by_degree, *turns, body)?;
                }
                _ => self.inside(statement, &[])?,
            }
        }
        Ok(())
    }

    fn inside(&mut self, statement: &Statement, seen: &[Known]) -> Result<(), Gone> {
        match statement {
            Statement::For { kind, around, test, body } => {
                for id in self.sequence(*kind, *around, seen)? {
                    if !self.mesh.is_alive(*kind, id) {
                        continue;
                    }
                    let seen = [seen, &[(*kind, id)]].concat();
                    if self.holds(*test, &seen)? {
                        for statement in body {
                            self.inside(statement, &seen)?;
                        }
                    }
                }
            }
            Statement::Update { kind, around, test } => {
                let mut new = Vec::new();
                for id in self.sequence(*kind, *around, seen)? {
                    let seen = [seen, &[(*kind, id)]].concat();
                    if self.holds(*test, &seen)? {
                        let near = self.near(ElementKind::Vertex, (*kind, id));
                        let marks = near.iter().map(|&v| self.mark((ElementKind::Vertex, v)));
                        new.push((id, marks.sum::<i64>().rem_euclid(7) + 1));
                    }
                }
                for (id, mark) in new {
                    self.set_mark((*kind, id), mark);
                }
            }
            Statement::If(test, body) => {
                if self.holds(*test, seen)? {
                    for statement in body {
                        self.inside(statement, seen)?;
                    }
                }
            }
            Statement::Edit(Edit::Split, _) if self.mesh.edge_count() >= MOST => {}
            Statement::Edit(edit, variable) => self.edit(*edit, self.living(seen, *variable)?)?,
            Statement::Bump(variable, by) => {
                let element = self.living(seen, *variable)?;
                self.set_mark(element, self.mark(element) + by);
            }
            Statement::Print(variable) => {
                let (kind, id) = seen[*variable];
                self.lines.push(format!("{} {id}", word(kind)));
            }
            Statement::Repeat(..) | Statement::Drain { .. } => unreachable!("stands outside"),
        }
        Ok(())
    }

    /// All keys are computed anew before each turn; one that has changed comes into the queue.
    fn drain(
        &mut self,
        kind: ElementKind,
        by_degree: bool,
        turns: i64,
        body: &Body,
    ) -> Result<(), Gone> {
        let mut keys: Vec<Option<i64>> = Vec::new();
        let mut queued: Vec<bool> = Vec::new();
        let edits_any = body.iter().any(edits);
        for turn in 0.. {
            keys.resize(self.mesh.capacity(kind), None);
            queued.resize(self.mesh.capacity(kind), false);
            let all = self.sequence(kind, Around::Mesh, &[])?;
            for id in 0..keys.len() {
                if !all.contains(&(id as u32)) {
                    (keys[id], queued[id]) = (None, false);
                }
            }
            if edits_any {
                self.mesh.recycle();
            }
            for &id in &all {
                let degree = match by_degree {
                    true => self.mesh.degree(VertexId(id)) as i64,
                    false => 0,
                };
                let key = Some(self.mark((kind, id)) + degree);
                if keys[id as usize] != key {
                    (keys[id as usize], queued[id as usize]) = (key, true);
                }
            }
            let waiting = all.iter().filter(|&&id| queued[id as usize]);
            let Some(&least) = waiting.min_by_key(|&&id| (keys[id as usize], id)) else {
                break;
            };
            if turn >= turns {
                break;
            }
            queued[least as usize] = false;
            for (at, statement) in body.iter().enumerate() {
                // Where nothing needs the element any more, its number may be given out again.
                let needed = body[at..].iter().any(|statement| uses(statement, 0));
                if edits(statement) && !needed {
                    self.mesh.recycle();
                }
                let born = self.erased_or_new(kind, &keys);
                self.inside(statement, &[(kind, least)])?;
                forget(born, &self.mesh, kind, &mut keys, &mut queued);
            }
        }
        Ok(())
    }

    /// What is not alive now; who is later, under one of these numbers, is another one.
    fn erased_or_new(&self, kind: ElementKind, keys: &[Option<i64>]) -> Vec<usize> {
        let dead = |id: &usize| !self.mesh.is_alive(kind, *id as u32);
        (0..keys.len()).filter(dead).collect()
    }

    fn sequence(
        &self,
        kind: ElementKind,
        around: Around,
        seen: &[Known],
    ) -> Result<Vec<u32>, Gone> {
        Ok(match around {
            Around::Mesh => match kind {
                ElementKind::Vertex => self.mesh.vertices().map(|v| v.0).collect(),
                ElementKind::Edge => self.mesh.edges().map(|e| e.0).collect(),
                _ => {
                    let faces = self.mesh.faces().filter(|&f| !self.mesh.is_hole(f));
                    faces.map(|f| f.0).collect()
                }
            },
            Around::Variable(variable) => self.near(kind, self.living(seen, variable)?),
        })
    }

    /// The elements of a kind around an element, in the order of its orbit.
    fn near(&self, kind: ElementKind, (of, id): Known) -> Vec<u32> {
        let mesh = &self.mesh;
        let halfedges: Vec<_> = match of {
            ElementKind::Vertex => mesh.spokes(VertexId(id)).collect(),
            ElementKind::Edge => {
                let first = mesh.edge_halfedge(EdgeId(id));
                vec![first, mesh.twin(first)]
            }
            _ => mesh.face_halfedges(FaceId(id)).collect(),
        };
        let halfedges = halfedges.into_iter();
        match kind {
            ElementKind::Vertex if of == ElementKind::Vertex => {
                mesh.neighbors(VertexId(id)).map(|v| v.0).collect()
            }
            ElementKind::Vertex => halfedges.map(|h| mesh.vertex(h).0).collect(),
            ElementKind::Edge => halfedges.map(|h| mesh.edge(h).0).collect(),
            _ => {
                let faces = halfedges.map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f));
                faces.map(|f| f.0).collect()
            }
        }
    }

    fn holds(&self, test: Test, seen: &[Known]) -> Result<bool, Gone> {
        Ok(match test {
            Test::Always => true,
            Test::EdgesBelow(most) => (self.mesh.edge_count() as i64) < most,
            Test::Mark { variable, by, rest } => {
                self.mark(self.living(seen, variable)?).rem_euclid(by) == rest
            }
        })
    }

    fn living(&self, seen: &[Known], variable: usize) -> Result<Known, Gone> {
        let (kind, id) = seen[variable];
        match self.mesh.is_alive(kind, id) {
            true => Ok((kind, id)),
            false => Err(Gone),
        }
    }

    fn mark(&self, (kind, id): Known) -> i64 {
        let column = self.mesh.find_column(kind, "mark").unwrap();
        match self.mesh.value(column, id).unwrap() {
            Value::Int(mark) => mark,
            other => panic!("{other:?}"),
        }
    }

    fn set_mark(&mut self, (kind, id): Known, mark: i64) {
        let column = self.mesh.find_column(kind, "mark").unwrap();
        assert!(self.mesh.set_value(column, id, Value::Int(mark)));
    }

    fn edit(&mut self, edit: Edit, (_, edge): Known) -> Result<(), Gone> {
        let op = self.analysis.op(edit.name()).unwrap();
        let plan = self.analysis.plans[op].as_ref().unwrap();
        let room = self.mesh.capacity(ElementKind::Edge);
        let count = self.mesh.edge_count();
        let args = [u64::from(edge), 100.0_f64.to_bits()];
        let args = &args[..plan.params.len()];
        let outcome = self.machine.apply(&mut self.mesh, plan, args).unwrap();
        if matches!(outcome, Outcome::Applied { .. }) {
            self.applied += 1;
            let grown = self.mesh.capacity(ElementKind::Edge) - room;
            self.reused |= self.mesh.edge_count() > count + grown;
        }
        Ok(())
    }
}

/// Numbers that were free and are taken: what is known of them is of someone else.
fn forget(
    free: Vec<usize>,
    mesh: &Mesh,
    kind: ElementKind,
    keys: &mut [Option<i64>],
    queued: &mut [bool],
) {
    for id in free {
        if mesh.is_alive(kind, id as u32) {
            (keys[id], queued[id]) = (None, false);
        }
    }
}

/// Whether a statement may change the mesh.
fn edits(statement: &Statement) -> bool {
    match statement {
        Statement::Edit(..) => true,
        Statement::Repeat(_, body)
        | Statement::For { body, .. }
        | Statement::Drain { body, .. }
        | Statement::If(_, body) => body.iter().any(edits),
        Statement::Update { .. } | Statement::Bump(..) | Statement::Print(_) => false,
    }
}

/// Whether a statement names a variable.
fn uses(statement: &Statement, variable: usize) -> bool {
    let around_it = |around: &Around| matches!(around, Around::Variable(v) if *v == variable);
    let asks = |test: &Test| matches!(test, Test::Mark { variable: v, .. } if *v == variable);
    match statement {
        Statement::Edit(_, v) | Statement::Bump(v, _) | Statement::Print(v) => *v == variable,
        Statement::Repeat(_, body) | Statement::Drain { body, .. } => {
            body.iter().any(|statement| uses(statement, variable))
        }
        Statement::For { around, test, body, .. } => {
            let inside = body.iter().any(|statement| uses(statement, variable));
            around_it(around) || asks(test) || inside
        }
        Statement::Update { around, test, .. } => around_it(around) || asks(test),
        Statement::If(test, body) => {
            asks(test) || body.iter().any(|statement| uses(statement, variable))
        }
    }
}

fn word(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Vertex => "vertex",
        ElementKind::Edge => "edge",
        ElementKind::Face => "face",
        ElementKind::Halfedge => "halfedge",
    }
}
