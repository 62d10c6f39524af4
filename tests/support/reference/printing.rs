//! Rules as text, and meshes as tables, for reports.

use std::fmt::Write;

use hedgerow::diagram::{Kind, LoopKind, NameId, Op, Ref, Role, Rule, Side, Spoke};
use hedgerow::mesh::Mesh;

/// An op of one rule as text, one statement per line. Requirements are left out, and assigned
/// positions are replaced by that of the first vertex of `before`, or, with families, by the
/// origin.
pub fn op_text(op: &Op, rule: &Rule) -> String {
    let mut text = format!("op {}(", op.name);
    for (at, param) in op.params.iter().enumerate() {
        let comma = if at > 0 { ", " } else { "" };
        let bound = rule.params.get(at).copied().flatten();
        let family = bound.is_some_and(|name| rule.name(name).role == Role::Family);
        let first = if family { "[0]" } else { "" };
        write!(text, "{comma}{}{first}: {}", param.name, param.ty.word()).expect("a string");
    }
    text.push_str(") {\n  before {\n");
    side(rule, &rule.before, &mut text);
    text.push_str("  }\n");
    for alias in &rule.aliases {
        let words: Vec<_> = alias.names.iter().map(|&name| mention(rule, name)).collect();
        writeln!(text, "  alias {}", words.join(" ")).expect("a string");
    }
    text.push_str("  after {\n");
    list(rule, "new", &rule.created, &mut text);
    side(rule, &rule.after, &mut text);
    list(rule, "erase", &rule.erased, &mut text);
    let drawn = rule.before.loops.first().map(|orbit| orbit.items[0].from);
    for assignment in &rule.assignments {
        let Some(drawn) = drawn else { continue };
        let value = match &rule.cycle {
            Some(_) => "vec3(0, 0, 0)".into(),
            None => format!("{}.position", word(rule, drawn.name)),
        };
        let target = mention(rule, assignment.target);
        writeln!(text, "    {target}.position = {value}").expect("a string");
    }
    text.push_str("  }\n}\n");
    text
}

fn word(rule: &Rule, name: NameId) -> &str {
    &rule.name(name).text
}

/// A mention, with its subscript if it is a family.
fn mention(rule: &Rule, mention: Ref) -> String {
    let word = word(rule, mention.name);
    match &rule.cycle {
        Some(cycle) if rule.name(mention.name).role == Role::Family => match mention.shift {
            0 => format!("{word}[{}]", cycle.letter),
            shift => format!("{word}[{}{shift:+}]", cycle.letter),
        },
        _ => word.into(),
    }
}

fn list(rule: &Rule, keyword: &str, names: &[Ref], text: &mut String) {
    if names.is_empty() {
        return;
    }
    let words: Vec<_> = names.iter().map(|&name| mention(rule, name)).collect();
    writeln!(text, "    {keyword} {}", words.join(" ")).expect("a string");
}

fn side(rule: &Rule, side: &Side, text: &mut String) {
    let mention = |name: Ref| mention(rule, name);
    let letter = rule.cycle.as_ref().map_or("i", |cycle| &cycle.letter);
    for orbit in &side.loops {
        let keyword = match orbit.kind {
            LoopKind::Face => "face",
            LoopKind::Hole => "hole",
            LoopKind::Any => "loop",
        };
        let items = orbit.items.iter().map(|item| {
            let bar = match rule.kind(item.item.name) {
                Kind::Path => '=',
                _ => '-',
            };
            format!("{} {bar}{}{bar}> ", mention(item.from), mention(item.item))
        });
        let (items, face) = (items.collect::<String>(), mention(orbit.face));
        match orbit.each {
            true => writeln!(text, "    {keyword} {face}: each {letter} {{ {items}}}"),
            false => writeln!(text, "    {keyword} {face}: {items}{}", mention(orbit.end)),
        }
        .expect("a string");
    }
    for edge in &side.edges {
        let [left, right] = edge.halfedges.map(mention);
        writeln!(text, "    edge {}: {left} | {right}", mention(edge.edge)).expect("a string");
    }
    for star in &side.stars {
        let spokes = star.spokes.iter().map(|spoke| match spoke {
            Spoke::Halfedge(half) => mention(*half),
            Spoke::Fan(fan) => format!("*{}", mention(*fan)),
            Spoke::Rest(_) => "*".into(),
        });
        let (spokes, vertex) = (spokes.collect::<Vec<_>>().join(" "), mention(star.vertex));
        match star.each {
            true => writeln!(text, "    vertex {vertex}: each {letter} {{ {spokes} }}"),
            false => writeln!(text, "    vertex {vertex}: {spokes}"),
        }
        .expect("a string");
    }
}

/// A mesh as a table of its halfedges.
pub fn mesh_text(mesh: &Mesh) -> String {
    let mut text = String::new();
    for h in mesh.halfedges() {
        let r = mesh.halfedge(h);
        let hole = if mesh.get_is_hole(r.face) == Some(true) { " (hole)" } else { "" };
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
