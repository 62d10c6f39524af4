//! `hedgerow info`

use std::collections::BTreeMap;

use serde::Serialize;

use super::arguments::{Format, InfoArguments};
use super::failure::Failure;
use super::meshes;
use super::output::{print_json, print_line, table};
use crate::mesh::{
    AttributeSummary, Bin, Element, Lengths, Level, Measures, Mesh, MeshFile, RepairReport,
    Summary, validate_level,
};

/// The most names of groups and the like that are shown.
const MOST_NAMES: usize = 6;

/// The most bars of a histogram that are shown.
const MOST_BARS: usize = 12;

/// The number of bars in a line of 80 columns.
const BARS_IN_A_LINE: usize = 5;

/// Describes a mesh, or the tables of a dump.
pub(super) fn info(arguments: &InfoArguments) -> Result<(), Failure> {
    let shown = arguments.mesh.display().to_string();
    if meshes::is_tables(&arguments.mesh) {
        return describe_dump(&shown, arguments);
    }
    let mut obj = meshes::read(&arguments.mesh, &arguments.repair)?;
    obj.bring_all();
    if let Some(level) = arguments.level {
        return tell_level(arguments, &obj.mesh, level);
    }
    let summary = Summary::of(&obj.mesh);
    match arguments.format {
        Format::Json => print_json(&InfoReport {
            summary: &summary,
            repaired: obj.repaired,
            parts: parts(&obj).collect(),
        }),
        Format::Human => {
            let rows: Vec<_> = parts(&obj).map(|(what, names)| row(what, listed(&names))).collect();
            print_line(&show(&shown, &summary, rows));
            Ok(())
        }
    }
}

fn describe_dump(shown: &str, arguments: &InfoArguments) -> Result<(), Failure> {
    let dump = meshes::read_tables(&arguments.mesh, &arguments.repair)?;
    if let Some(level) = arguments.level {
        return tell_level(arguments, &meshes::only_table(&arguments.mesh, dump)?, level);
    }
    let meshes = dump.meshes.iter().map(|(name, mesh)| (name.as_str(), Summary::of(mesh)));
    match arguments.format {
        Format::Json => print_json(&DumpReport {
            remarks: &dump.remarks,
            meshes: meshes.collect(),
            names: dump.names.iter().map(stands_for).collect(),
        }),
        Format::Human => {
            for remark in &dump.remarks {
                print_line(remark);
            }
            for (name, summary) in meshes {
                print_line(&show(&format!("{shown}, {name}"), &summary, Vec::new()));
            }
            let names = dump.names.iter().map(stands_for);
            let rows: Vec<_> = names.map(|(name, elements)| row(name, elements)).collect();
            if !rows.is_empty() {
                print_line(&format!("names\n{}", table(&rows, &[])));
            }
            Ok(())
        }
    }
}

/// A name and its elements in words.
fn stands_for((name, elements): &(String, Vec<Element>)) -> (&str, String) {
    let words = match elements.as_slice() {
        [] => "nothing".into(),
        [one] => one.to_string(),
        [first, ..] => {
            let ids: Vec<_> = elements.iter().map(|of| of.index.to_string()).collect();
            format!("{} {}", first.kind.plural(), ids.join(" "))
        }
    };
    (name, words)
}

#[derive(Serialize)]
struct InfoReport<'s> {
    #[serde(flatten)]
    summary: &'s Summary,
    #[serde(skip_serializing_if = "Option::is_none")]
    repaired: Option<RepairReport>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    parts: BTreeMap<&'static str, Vec<String>>,
}

#[derive(Serialize)]
struct DumpReport<'a> {
    remarks: &'a [String],
    meshes: BTreeMap<&'a str, Summary>,
    names: BTreeMap<&'a str, String>,
}

/// Prints whether a mesh is of a level, and fails if it is not.
fn tell_level(arguments: &InfoArguments, mesh: &Mesh, level: Level) -> Result<(), Failure> {
    let below = validate_level(mesh, level).err().map(|below| below.to_string());
    let file = arguments.mesh.display();
    match (arguments.format, &below) {
        (Format::Json, _) => {
            print_json(&LevelReport { level, holds: below.is_none(), reason: below.as_deref() })?
        }
        (Format::Human, None) => print_line(&format!("{file}: of level {level}")),
        (Format::Human, Some(reason)) => {
            print_line(&format!("{file}: not of level {level}: {reason}"))
        }
    }
    if below.is_none() { Ok(()) } else { Err(Failure::Silent(1.into())) }
}

#[derive(Serialize)]
struct LevelReport<'r> {
    level: Level,
    holds: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'r str>,
}

/// The objects, groups and so on that a file has, by name.
fn parts(file: &MeshFile) -> impl Iterator<Item = (&'static str, Vec<String>)> {
    let kinds = ["objects", "groups", "materials", "smoothing groups"].into_iter();
    let named = kinds.zip(file.named_parts()).map(|(kind, names)| {
        let names = names.into_iter().map(|name| String::from_utf8_lossy(name).into_owned());
        (kind, names.collect::<Vec<_>>())
    });
    named.filter(|(_, names)| !names.is_empty())
}

/// The number of names, and the first of them.
fn listed(names: &[String]) -> String {
    let shown: Vec<_> =
        names.iter().take(MOST_NAMES).map(|name| name.escape_debug().to_string()).collect();
    let rest = if names.len() > MOST_NAMES { ", …" } else { "" };
    format!("{}: {}{rest}", names.len(), shown.join(", "))
}

fn show(file: &str, summary: &Summary, parts: Vec<Vec<String>>) -> String {
    let mut rows = vec![
        row("vertices", summary.vertices),
        row("edges", summary.edges),
        row("faces", summary.faces),
        row("holes", summary.holes),
    ];
    if summary.isolated_vertices > 0 {
        rows.push(row("isolated vertices", summary.isolated_vertices));
    }
    if let Some(measures) = &summary.measures {
        rows.extend(measured(measures));
    }
    rows.extend(parts);
    let attributes = summary.attributes.iter().enumerate();
    rows.extend(attributes.map(|(at, AttributeSummary { name, of, ty })| {
        let head = if at == 0 { "attributes" } else { "" };
        row(head, format!("{name}: {of} {ty}"))
    }));
    rows.push(match (&summary.invalid, summary.level) {
        (Some(law), _) => row("validity", format!("broken: {law}")),
        (None, Some(level)) => row("validity", format!("valid, of level {}", level.name())),
        (None, None) => row("validity", "unknown"),
    });
    if let Some(reason) = &summary.below_next_level {
        rows.push(row("", format!("not higher: {reason}")));
    }
    format!("{file}\n{}", table(&rows, &[]))
}

fn measured(measures: &Measures) -> Vec<Vec<String>> {
    let mut rows = vec![
        row("components", measures.components),
        row("genus", measures.genus),
        row("Euler characteristic", measures.euler_characteristic),
    ];
    rows.extend(histogram("degrees", &measures.degrees));
    rows.extend(histogram("face sizes", &measures.face_sizes));
    if let Some(Lengths { min, mean, max, spread, .. }) = measures.edge_lengths {
        rows.push(row(
            "edge lengths",
            match spread.is_finite() {
                true => {
                    let [min, max, mean] = decimals([min, max, mean]);
                    format!("{min} to {max}, mean {mean}, spread {:.1} %", 100.0 * spread)
                }
                false => TOO_FAR.to_owned(),
            },
        ));
    }
    rows.push(size("area", measures.area));
    rows.extend(measures.volume.map(|volume| size("volume", volume)));
    if let Some([low, high]) = measures.bounds {
        let [a, b, c] = low;
        let [x, y, z] = high;
        let [a, b, c, x, y, z] = decimals([a, b, c, x, y, z]);
        rows.push(row("bounding box", format!("({a}, {b}, {c}) to ({x}, {y}, {z})")));
    }
    rows
}

fn size(name: &str, value: f64) -> Vec<String> {
    if value.is_finite() { row(name, decimals([value]).concat()) } else { row(name, TOO_FAR) }
}

/// Measures of one kind with six decimals; with an exponent if the largest is very large or small.
fn decimals<const N: usize>(measures: [f64; N]) -> [String; N] {
    let largest = measures.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let is_usual = largest == 0.0 || (1e-2..1e9).contains(&largest);
    measures.map(|x| x + 0.0).map(|x| if is_usual { format!("{x:.6}") } else { format!("{x:.6e}") })
}

/// The text for a measure that is not finite.
const TOO_FAR: &str = "not measured: the coordinates are too large";

fn row(name: &str, value: impl ToString) -> Vec<String> {
    vec![format!("  {name}"), value.to_string()]
}

/// `3: 12  4: 120  5: 9`, size by size.
fn histogram(name: &str, bins: &[Bin]) -> Vec<Vec<String>> {
    let mut bars: Vec<_> =
        bins.iter().take(MOST_BARS).map(|bin| format!("{}: {}", bin.size, bin.count)).collect();
    if bins.len() > MOST_BARS {
        let more: usize = bins[MOST_BARS..].iter().map(|bin| bin.count).sum();
        bars.push(format!("more: {more}"));
    }
    if bars.is_empty() {
        bars.push("none".into());
    }
    let lines = bars.chunks(BARS_IN_A_LINE).enumerate();
    lines.map(|(at, bars)| row(if at == 0 { name } else { "" }, bars.join("  "))).collect()
}
