//! Rules as text, and meshes as tables, for reports.

use std::fmt::Write;

use hedgerow::diagram::{Kind, LoopKind, NameId, Op, Ref, Rule, Side, Spoke};
use hedgerow::mesh::Mesh;

/// An op of one rule as text. Requirements are left out, and what is placed is placed where
/// the first vertex of `before` is.
pub fn op_text(op: &Op, rule: &Rule) -> String {
    let mut text = format!("op {}(", op.name);
    for (at, param) in op.params.iter().enumerate() {
        let comma = if at > 0 { ", " } else { "" };
        write!(text, "{comma}{}: {}", param.name, param.ty.word()).expect("a string");
    }
    text.push_str(") {\n  before {\n");
    side(rule, &rule.before, &mut text);
    text.push_str("  }\n  after {\n");
    list(rule, "new", &rule.created, &mut text);
    side(rule, &rule.after, &mut text);
    list(rule, "erase", &rule.erased, &mut text);
    let drawn = rule.before.loops.first().map(|orbit| orbit.items[0].from);
    for assignment in &rule.assignments {
        let Some(drawn) = drawn else { continue };
        let (word, drawn) = (word(rule, assignment.target.name), word(rule, drawn.name));
        writeln!(text, "    {word}.position = {drawn}.position").expect("a string");
    }
    text.push_str("  }\n}\n");
    text
}

fn word(rule: &Rule, name: NameId) -> &str {
    &rule.name(name).text
}

fn list(rule: &Rule, keyword: &str, names: &[Ref], text: &mut String) {
    if names.is_empty() {
        return;
    }
    let words: Vec<_> = names.iter().map(|name| word(rule, name.name)).collect();
    writeln!(text, "    {keyword} {}", words.join(" ")).expect("a string");
}

fn side(rule: &Rule, side: &Side, text: &mut String) {
    for orbit in &side.loops {
        let keyword = match orbit.kind {
            LoopKind::Face => "face",
            LoopKind::Hole => "hole",
            LoopKind::Any => "loop",
        };
        write!(text, "    {keyword} {}:", word(rule, orbit.face.name)).expect("a string");
        for item in &orbit.items {
            let bar = if rule.kind(item.item.name) == Kind::Path {
                '='
            } else {
                '-'
            };
            let (from, name) = (word(rule, item.from.name), word(rule, item.item.name));
            write!(text, " {from} {bar}{name}{bar}>").expect("a string");
        }
        writeln!(text, " {}", word(rule, orbit.end.name)).expect("a string");
    }
    for edge in &side.edges {
        let [left, right] = edge.halfedges.map(|half| word(rule, half.name));
        writeln!(
            text,
            "    edge {}: {left} | {right}",
            word(rule, edge.edge.name)
        )
        .expect("a string");
    }
    for star in &side.stars {
        write!(text, "    vertex {}:", word(rule, star.vertex.name)).expect("a string");
        for spoke in &star.spokes {
            match spoke {
                Spoke::Halfedge(half) => write!(text, " {}", word(rule, half.name)),
                Spoke::Fan(fan) => write!(text, " *{}", word(rule, fan.name)),
                Spoke::Rest(_) => write!(text, " *"),
            }
            .expect("a string");
        }
        text.push('\n');
    }
}

/// A mesh as a table of its halfedges.
pub fn mesh_text(mesh: &Mesh) -> String {
    let mut text = String::new();
    for h in mesh.halfedges() {
        let r = mesh.halfedge(h);
        let hole = if mesh.get_is_hole(r.face) == Some(true) {
            " (hole)"
        } else {
            ""
        };
        writeln!(
            text,
            "  h{}: next h{} twin h{} vertex v{} edge e{} face f{}{hole}",
            h.0,
            r.next.0 as i32,
            r.twin.0 as i32,
            r.vertex.0 as i32,
            r.edge.0 as i32,
            r.face.0 as i32
        )
        .expect("a string");
    }
    for v in mesh.vertices() {
        writeln!(text, "  v{} at {}", v.0, mesh.position(v)).expect("a string");
    }
    text
}
