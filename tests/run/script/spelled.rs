//! The programs that are [read literally](super::literal), as scripts.

use super::literal::{Around, Body, Edit, MOST, Statement, Test};
use hedgerow::mesh::ElementKind;

/// The program as a script.
pub fn text(program: &Body) -> String {
    let mut text = "script main() {\nvar turns = 0\n".to_owned();
    program.iter().for_each(|statement| write(statement, &[], &mut text));
    text + "}\n"
}

fn write(statement: &Statement, seen: &[ElementKind], out: &mut String) {
    let all = |body: &Body, seen: &[ElementKind], out: &mut String| {
        body.iter().for_each(|statement| write(statement, seen, out));
        out.push_str("}\n");
    };
    let name = format!("x{}", seen.len());
    match statement {
        Statement::Repeat(times, body) => {
            *out += &format!("repeat {times} {{\n");
            all(body, seen, out);
        }
        Statement::For { kind, around, test, body } => {
            let sequence = sequence(*kind, *around, seen);
            *out += &format!("for {name} in {sequence} where {} {{\n", condition(*test));
            all(body, &[seen, &[*kind]].concat(), out);
        }
        Statement::Update { kind, around, test } => {
            let sequence = sequence(*kind, *around, seen);
            let near = self::sequence(
                ElementKind::Vertex,
                Around::Variable(seen.len()),
                &[seen, &[*kind]].concat(),
            );
            *out += &format!(
                "update {name} in {sequence} where {} {{
                 {name}.mark = sum(w.mark for w in {near}) mod 7 + 1 }}\n",
                condition(*test)
            );
        }
        Statement::Drain { kind, by_degree, turns, body } => {
            let degree = if *by_degree { format!(" + degree({name})") } else { String::new() };
            *out += &format!(
                "turns = 0
                 drain {name} in {} by {name}.mark{degree} while turns < {turns} {{
                 turns = turns + 1\n",
                sequence(*kind, Around::Mesh, seen)
            );
            all(body, &[seen, &[*kind]].concat(), out);
        }
        Statement::If(test, body) => {
            *out += &format!("if {} {{\n", condition(*test));
            all(body, seen, out);
        }
        Statement::Edit(Edit::Collapse, variable) => {
            *out += &format!("collapse(x{variable}, 100)\n")
        }
        Statement::Edit(Edit::Split, variable) => {
            *out += &format!("if count(edges) < {MOST} {{ split(x{variable}) }}\n");
        }
        Statement::Edit(edit, variable) => *out += &format!("{}(x{variable})\n", edit.name()),
        Statement::Bump(variable, by) => {
            *out += &format!("x{variable}.mark = x{variable}.mark + {by}\n");
        }
        Statement::Print(variable) => *out += &format!("print x{variable}\n"),
    }
}

fn condition(test: Test) -> String {
    match test {
        Test::Always => "true".to_owned(),
        Test::EdgesBelow(most) => format!("count(edges) < {most}"),
        Test::Mark { variable, by, rest } => format!("x{variable}.mark mod {by} == {rest}"),
    }
}

fn sequence(kind: ElementKind, around: Around, seen: &[ElementKind]) -> String {
    let plural = match kind {
        ElementKind::Vertex => "vertices",
        ElementKind::Edge => "edges",
        _ => "faces",
    };
    match around {
        Around::Mesh => plural.to_owned(),
        Around::Variable(variable) => {
            let plural = match (seen[variable], kind) {
                (ElementKind::Vertex, ElementKind::Vertex) => "neighbors",
                _ => plural,
            };
            format!("x{variable}.{plural}")
        }
    }
}
