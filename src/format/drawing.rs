//! Drawings: one statement per line, in columns; edges may share a line.

use super::grid::aligned;
use super::printer::{
    Block, Doc, HANG, INDENT, Lines, Printer, joined, laid_out, nil, text, width_of,
};
use crate::source::Span;
use crate::syntax::tree::{Name, Side, Spoke, Statement};

/// The text between two edges that share a line, in addition to the space between all cells.
const BETWEEN_EDGES: &str = "   ";

/// The class of a statement; statements of one class are aligned.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    Loop,
    Edge,
    Star,
    List,
    Family,
    Assignment,
}

/// A statement without a value: its keyword, its subject, and its cells.
struct Outline {
    class: Class,
    /// The name before the colon.
    name: Option<Span>,
    /// The ends of the cells after it.
    ends: Vec<u32>,
    span: Span,
}

/// A written statement: cells for a grid, or complete lines.
enum Written {
    Cells(Class, Vec<String>),
    Lines(Lines),
}

/// Consecutive statements of one class.
struct Run {
    class: Class,
    rows: Vec<Row>,
}

/// Statements that share a line.
struct Row {
    /// The index of its placeholder line, which holds the comment after it.
    place: usize,
    /// The cells of each statement.
    statements: Vec<Vec<String>>,
    /// True if each statement gets a line of its own after all.
    parted: bool,
}

impl Printer<'_> {
    /// `before { … }`
    pub(super) fn side(&mut self, side: &Side, width: usize) -> Doc {
        let keyword = self.spaced_token();
        let at_most_one = side.statements.len() < 2;
        let start = self.next_start();
        let span = Span::new(side.span.file, start, side.span.end as usize);
        let inner = width.saturating_sub(INDENT);
        let block: Block = self.braces(span, at_most_one, |printer, lines| {
            printer.statements(&side.statements, lines, inner);
        });
        keyword.append(block.doc())
    }

    fn statements(&mut self, statements: &[Statement], lines: &mut Lines, width: usize) {
        let mut run: Option<Run> = None;
        for statement in statements {
            let shares_line = self.line_ends(self.taken_end(), self.next_start()) == 0;
            let known = lines.len();
            self.gap(lines);
            // A blank line ends a run; a comment does not.
            if lines[known..].iter().any(String::is_empty) {
                finish(run.take(), lines, width);
            }
            let (class, cells) = match self.written(statement, width) {
                Written::Cells(class, cells) => (class, cells),
                Written::Lines(own) => {
                    finish(run.take(), lines, width);
                    lines.extend(own);
                    continue;
                }
            };
            if run.as_ref().is_some_and(|run| run.class != class) {
                finish(run.take(), lines, width);
            }
            let run = run.get_or_insert_with(|| Run { class, rows: Vec::new() });
            match run.rows.last_mut() {
                Some(row) if class == Class::Edge && shares_line => row.statements.push(cells),
                _ => {
                    run.rows.push(Row {
                        place: lines.len(),
                        statements: vec![cells],
                        parted: false,
                    });
                    lines.push(String::new());
                }
            }
        }
        finish(run, lines, width);
    }

    fn written(&mut self, statement: &Statement, width: usize) -> Written {
        let Some(outline) = outline(statement) else {
            let doc = self.assignment(statement, width);
            let lines = laid_out(doc, width);
            return match lines.as_slice() {
                [line] if let Some((target, value)) = line.split_once(" = ") => {
                    Written::Cells(Class::Assignment, vec![target.to_owned(), format!("= {value}")])
                }
                _ => Written::Lines(lines),
            };
        };
        if self.has_comment(outline.span) {
            return Written::Lines(laid_out(self.flowing(&outline), width));
        }
        let mut head = self.word().to_owned();
        if let Some(name) = outline.name {
            head = format!("{head} {}", self.words(name));
            head.push_str(self.word());
        }
        let place = |end: u32| Span { end, ..outline.span };
        let cells: Vec<_> = outline.ends.iter().map(|&end| self.words(place(end))).collect();
        let mut row = vec![head];
        match outline.class {
            Class::Star | Class::Family => row.push(cells.join(" ")),
            _ => row.extend(cells),
        }
        Written::Cells(outline.class, row)
    }

    /// `v.position = …`
    fn assignment(&mut self, statement: &Statement, width: usize) -> Doc {
        let Statement::Assign { target, attribute, value, .. } = statement else { return nil() };
        let target = self.tokens(target.span).append(self.tokens(attribute.span));
        target.append(self.equals(value, width))
    }

    /// A statement with comments in it, each followed by a line break.
    fn flowing(&mut self, outline: &Outline) -> Doc {
        let mut docs = vec![self.token()];
        if let Some(name) = outline.name {
            docs.extend([text(" "), self.tokens(name), self.token()]);
        }
        for &end in &outline.ends {
            docs.extend([text(" "), self.tokens(Span { end, ..outline.span })]);
        }
        joined(docs).nest(HANG)
    }
}

/// Replaces the placeholders of a run with its lines, aligned over all of them. Edges on a shared
/// line that would be too long get a line each.
fn finish(run: Option<Run>, lines: &mut Lines, width: usize) {
    let Some(mut run) = run else { return };
    let grids = loop {
        let grids = run.grids();
        let mut is_new = false;
        for (row, grid) in run.rows.iter_mut().zip(&grids) {
            let long = grid.iter().any(|line| width_of(line) > width);
            if long && row.statements.len() > 1 && !row.parted {
                row.parted = true;
                is_new = true;
            }
        }
        if !is_new {
            break grids;
        }
    };
    // From last to first, so that the earlier places stay valid.
    for (row, grid) in run.rows.iter().zip(grids).rev() {
        let comments = std::mem::take(&mut lines[row.place]);
        let mut new = Lines::new();
        for (at, line) in grid.into_iter().enumerate() {
            match row.statements.get(at) {
                Some(cells) if width_of(&line) > width => new.extend(filled(cells, width)),
                _ => new.push(line),
            }
        }
        if let Some(last) = new.last_mut() {
            last.push_str(&comments);
        }
        lines.splice(row.place..=row.place, new);
    }
}

impl Run {
    /// The aligned lines of each row.
    fn grids(&self) -> Vec<Lines> {
        let rows = self.rows.iter().flat_map(Row::lines).collect::<Vec<_>>();
        let mut lines = match self.class {
            Class::List | Class::Family => rows.iter().map(|row| row.join(" ")).collect(),
            _ => aligned(&rows),
        }
        .into_iter();
        let counts = self.rows.iter().map(|row| row.lines().len());
        counts.map(|count| lines.by_ref().take(count).collect()).collect()
    }
}

impl Row {
    /// The cells of each of its lines.
    fn lines(&self) -> Vec<Vec<String>> {
        if self.parted {
            return self.statements.clone();
        }
        let mut cells = Vec::new();
        for statement in &self.statements {
            let gap = if cells.is_empty() { "" } else { BETWEEN_EDGES };
            let mut own = statement.iter();
            cells.extend(own.next().map(|head| format!("{gap}{head}")));
            cells.extend(own.cloned());
        }
        vec![cells]
    }
}

/// A statement that is too long for a line, broken before arrows and names.
fn filled(cells: &[String], width: usize) -> Lines {
    let (head, rest) = cells.split_first().map_or(("", cells), |(head, rest)| (head, rest));
    let hang = width_of(head) + 1;
    let mut lines = vec![head.to_owned()];
    let mut used = hang - 1;
    for (at, cell) in rest.iter().enumerate() {
        // An arrow and the vertex it leads to stay together.
        let is_arrow = cell.ends_with("=>") || cell.ends_with("->");
        let next = rest.get(at + 1).filter(|_| is_arrow);
        let wanted = width_of(cell) + next.map_or(0, |next| width_of(next) + 1);
        let after_arrow = at > 0 && (rest[at - 1].ends_with("=>") || rest[at - 1].ends_with("->"));
        if at > 0 && !after_arrow && used + 1 + wanted > width {
            lines.push(" ".repeat(hang - 1));
            used = hang - 1;
        }
        if let Some(line) = lines.last_mut() {
            line.push(' ');
            line.push_str(cell);
        }
        used += 1 + width_of(cell);
    }
    lines
}

/// The outline of a statement without a value.
fn outline(statement: &Statement) -> Option<Outline> {
    let ends_of = |names: &[Name]| names.iter().map(|name| name.span.end).collect();
    let spoke_end = |spoke: &Spoke| match spoke {
        Spoke::Halfedge(name) => name.span.end,
        Spoke::Fan(_, span) => span.end,
    };
    let outline = match statement {
        Statement::Loop(ring) => {
            let items = ring.items.iter();
            let mut ends: Vec<_> =
                items.flat_map(|item| [item.from.span.end, item.span.end]).collect();
            ends.extend(ring.end.as_ref().map(|name| name.span.end));
            let first = ring.items.first().map(|item| item.from.span.start);
            let each = ring.each.as_ref().map(|each| each.span).zip(first);
            Outline::of(Class::Loop, Some(ring.name.span), ends, ring.span).over(each)
        }
        Statement::Edge { name, halfedges: [one, other], span } => {
            let ends = vec![one.span.end, other.span.start, other.span.end];
            Outline::of(Class::Edge, Some(name.span), ends, *span)
        }
        Statement::Vertex(star) => {
            let ends = star.spokes.iter().map(spoke_end).collect();
            let first = star.spokes.first().map(|spoke| match spoke {
                Spoke::Halfedge(name) => name.span.start,
                Spoke::Fan(_, span) => span.start,
            });
            let each = star.each.as_ref().map(|each| each.span).zip(first);
            Outline::of(Class::Star, Some(star.name.span), ends, star.span).over(each)
        }
        Statement::New(names, span)
        | Statement::Erase(names, span)
        | Statement::Keep(names, span) => Outline::of(Class::List, None, ends_of(names), *span),
        Statement::Assign { .. } | Statement::Broken(_) => return None,
    };
    Some(outline)
}

impl Outline {
    fn of(class: Class, name: Option<Span>, ends: Vec<u32>, span: Span) -> Self {
        Self { class, name, ends, span }
    }

    /// The same after `each i {`, given the span of the index and the start of the period.
    fn over(self, each: Option<(Span, u32)>) -> Self {
        let Some((index, first)) = each else { return self };
        let mut ends = vec![index.start, index.end, first];
        ends.extend(self.ends);
        ends.push(self.span.end);
        Self { class: Class::Family, ends, ..self }
    }
}
