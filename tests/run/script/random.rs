//! Random programs of loops over meshes that change under them, against the
//! [literal reading](super::literal) of what the language says.

use super::literal::{Around, Body, Edit, Gone, Literal, Statement, Test};
use super::*;
use hedgerow::mesh::{ElementKind, Mesh, identical, shape};
use support::dice::Dice;

/// Edges more often, since they are what ops are called with.
const KINDS: [ElementKind; 5] = [
    ElementKind::Vertex,
    ElementKind::Edge,
    ElementKind::Face,
    ElementKind::Edge,
    ElementKind::Edge,
];

const DECLARATIONS: &str = "
attr mark: vertex int = 0
attr mark: edge int = 0
attr mark: face int = 0
";

/// Writes a program; a variable is its number, and its kind is known.
struct Writer {
    dice: Dice,
    kinds: Vec<ElementKind>,
}

impl Writer {
    fn int(&mut self, bound: usize) -> i64 {
        self.dice.below(bound) as i64
    }

    /// Statements outside of loops over elements.
    fn outside(&mut self, depth: usize) -> Body {
        let count = 2 + self.dice.below(3);
        (0..count)
            .map(|_| match self.dice.below(8) {
                0 if depth > 0 => Statement::Repeat(1 + self.int(3), self.outside(depth - 1)),
                1 | 2 => self.drain(),
                3 => self.update(Around::Mesh),
                _ => self.visit(Around::Mesh, 2),
            })
            .collect()
    }

    fn with<T>(&mut self, kind: ElementKind, write: impl FnOnce(&mut Self) -> T) -> T {
        self.kinds.push(kind);
        let written = write(self);
        self.kinds.pop();
        written
    }

    /// A kind of which there is a sequence.
    fn kind(&mut self, around: Around) -> ElementKind {
        let kind = KINDS[self.dice.below(KINDS.len())];
        match around {
            Around::Variable(variable) if kind == self.kinds[variable] => ElementKind::Vertex,
            _ => kind,
        }
    }

    fn visit(&mut self, around: Around, depth: usize) -> Statement {
        let kind = self.kind(around);
        let (test, body) = self.with(kind, |writer| (writer.test(), writer.inside(depth)));
        Statement::For { kind, around, test, body }
    }

    fn update(&mut self, around: Around) -> Statement {
        let kind = self.kind(around);
        let test = self.with(kind, Self::test);
        Statement::Update { kind, around, test }
    }

    fn drain(&mut self) -> Statement {
        let kind = self.kind(Around::Mesh);
        let by_degree = kind == ElementKind::Vertex && self.dice.below(2) == 0;
        let turns = 5 + self.int(30);
        let body = self.with(kind, |writer| {
            let mut body = writer.inside(1);
            // Choices inside of which numbers may be given out again are not read literally.
            body.retain(|statement| !matches!(statement, Statement::If(..)));
            body
        });
        Statement::Drain { kind, by_degree, turns, body }
    }

    /// Statements inside of a loop over elements.
    fn inside(&mut self, depth: usize) -> Body {
        let count = 1 + self.dice.below(3);
        (0..count).map(|_| self.step(depth)).collect()
    }

    fn step(&mut self, depth: usize) -> Statement {
        let variable = match self.dice.below(4) {
            0 => self.dice.below(self.kinds.len()),
            _ => self.kinds.len() - 1,
        };
        let around = Around::Variable(variable);
        match self.dice.below(14) {
            0 | 1 if depth > 0 => self.visit(around, depth - 1),
            2 if depth > 0 => self.update(around),
            3 if depth > 0 => Statement::If(self.test(), self.inside(depth - 1)),
            4 => Statement::Print(variable),
            5 | 6 => Statement::Bump(variable, 1 + self.int(4)),
            _ => match self.kinds.iter().rposition(|&kind| kind == ElementKind::Edge) {
                Some(edge) => {
                    let edits = [Edit::Split, Edit::Flip, Edit::Collapse, Edit::Collapse];
                    Statement::Edit(edits[self.dice.below(4)], edge)
                }
                None => Statement::Bump(variable, 1),
            },
        }
    }

    fn test(&mut self) -> Test {
        let variable = self.kinds.len() - 1;
        match self.dice.below(4) {
            0 => Test::Always,
            1 => Test::EdgesBelow(20 + self.int(150)),
            _ => {
                let by = 2 + self.int(3);
                let rest = self.int(by as usize);
                Test::Mark { variable, by, rest }
            }
        }
    }
}

#[test]
fn loops_over_changing_meshes_mean_what_they_say() {
    let mut meshes = [
        shape::tetrahedron(),
        shape::octahedron(),
        shape::triangle_grid(3, 2),
        shape::icosphere(1),
    ];
    let begin = "script main() {
        for v in vertices { v.mark = 0 }
        for e in edges { e.mark = 0 }
        for f in faces { f.mark = 0 }
    }";
    for mesh in &mut meshes {
        try_run(mesh, &format!("{DECLARATIONS}{begin}"), &[]).unwrap();
    }
    let (mut lines, mut edits, mut reused, mut gone) = (0, 0, 0, 0);
    for seed in 1..=PROGRAMS {
        let dice = Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let mut writer = Writer { dice, kinds: Vec::new() };
        let program = writer.outside(2);
        let text = format!("{OPS}{DECLARATIONS}{}", super::spelled::text(&program));
        let (_, analysis) = analyse(&text);
        let number = analysis.script("main").unwrap();
        let prepared = prepare(&analysis.program, number, &analysis.plans).unwrap();
        for before in &meshes {
            let mut mesh: Mesh = before.clone();
            let mut seen = Lines::default();
            let outcome = run(&prepared, &mut mesh, &[], &mut seen);
            let mut literal = Literal::new(before.clone(), &analysis);
            let expected = literal.run(&program);
            let at = || format!("seed {seed} on a mesh of {} edges:\n{text}", before.edge_count());
            assert_eq!(seen.0, literal.lines, "{}", at());
            match (outcome, expected) {
                (Ok(_), Ok(())) => {}
                (Err(failure), Err(Gone)) => {
                    assert_eq!(failure.diagnostic.code, "element-gone", "{}", at());
                    gone += 1;
                    continue;
                }
                (outcome, expected) => panic!("{outcome:?}, {expected:?}: {}", at()),
            }
            validate(&mesh).unwrap();
            assert!(identical(&mesh, &literal.mesh), "{}", at());
            lines += seen.0.len();
            edits += literal.applied;
            reused += usize::from(literal.reused);
        }
    }
    println!("{lines} lines, {edits} edits, {reused} with slots used again, {gone} with failures");
    assert!(lines > 2000 && edits > 3000 && reused > 10 && gone > 20);
}

const PROGRAMS: u64 = 150;
