//! `hedgerow run`

use std::time::Instant;

use serde::Serialize;

use super::arguments::{Format, RunArguments};
use super::counts::Counts;
use super::draw::{expect_picture, write_picture};
use super::failure::Failure;
use super::output::{
    end_when_closed, eprint_json, eprint_line, is_standard, print_json, print_line, table,
};
use super::program::{self, Program, settings};
use super::progress::Progress;
use super::view::{attribute, tell_if_blank};
use super::{files, interrupt, memory, meshes, place};
use crate::draw::{View, draw_mesh};
use crate::mesh::{Mesh, MeshFile, Places, RepairReport};
use crate::rewrite::Unbounded;
use crate::run::{self, OpReport, prepare};
use crate::source::{Sources, Span};

/// Runs a script on a mesh.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let started = Instant::now();
    let (program, script) = program::read_script(&arguments.script)?;
    let failed = |diagnostics: &[_], code| Failure::of(diagnostics, &program.sources, code);
    let mut prepared = prepare(&program.analysis.program, script, &program.analysis.plans)
        .map_err(|errors| failed(&errors, 1))?
        .with_seed(arguments.seed);
    prepared.use_engine(arguments.engine.get());
    if !meshes::is_tables(&arguments.mesh) {
        prepared.expect_polygons();
    }
    prepared.limit_memory(arguments.memory.unwrap_or_else(memory::usual));
    let mut texts = settings(&arguments.set)?;
    let places = place::given(prepared.params(), &arguments.at, &texts)?;
    // What is wrong with the other values is told before a mesh is read.
    let elements = places.iter().map(|(name, _)| (name.clone(), "0".to_owned()));
    let read = |texts: &[_]| prepared.arguments(texts).map_err(|errors| failed(&errors, 2));
    read(&texts.iter().cloned().chain(elements).collect::<Vec<_>>())?;
    let compile = started.elapsed().as_secs_f64();
    if let Some(output) = &arguments.output {
        meshes::expect_mesh(output, &arguments.encoding)?;
    }
    program.expect_apart(arguments.output.iter().chain(&arguments.picture))?;
    if let Some(picture) = &arguments.picture {
        expect_picture(picture)?;
        if is_standard(picture) && arguments.output.as_deref().is_some_and(is_standard) {
            return Err(Failure::usage("the mesh and the picture cannot both be written to `-`"));
        }
    }

    let started = Instant::now();
    let mut obj = match arguments.reorder {
        true => meshes::read_reordered(&arguments.mesh, &arguments.repair)?,
        false => meshes::read(&arguments.mesh, &arguments.repair)?,
    };
    let load = started.elapsed().as_secs_f64();
    texts.extend(place::ids(places, &mut obj)?);
    let values = read(&texts)?;
    for attribute in prepared.attributes() {
        obj.bring(attribute);
    }
    let is_known =
        |kind, name: &str| prepared.attributes().any(|(of, own, _)| (of, own) == (kind, name));
    let places = Places::of(&obj.mesh, is_known);
    let before = Counts::of(&obj.mesh);

    let started = Instant::now();
    let name = program.analysis.program.scripts[script].name.clone();
    interrupt::listen();
    let results = [arguments.output.as_deref(), arguments.picture.as_deref()];
    if results.iter().flatten().next().is_none() {
        end_when_closed();
    }
    let poured = results.into_iter().flatten().any(is_standard);
    let mut progress = Progress::new(&name, poured || arguments.format == Format::Json);
    let report = run::run(&prepared, &mut obj.mesh, &values, &mut progress);
    progress.finish();
    let report = report.map_err(|failure| {
        let is_interrupted = failure.diagnostic.code == "interrupted";
        let code = if is_interrupted { interrupt::CODE } else { 1 };
        let ops: Vec<_> = failure.report.ops.into_iter().map(Op::from).collect();
        if arguments.format == Format::Human && ops.iter().any(|op| op.applied + op.refused > 0) {
            eprint_line(&format!("until it stopped:\n{}\n", show_ops(&ops)));
        }
        failed(&[failure.diagnostic], code)
    })?;
    let run = started.elapsed().as_secs_f64();

    let drains = prepared.drains().into_iter().filter(|_| arguments.verbose);
    let mut report = Report {
        script: name,
        drains: drains.map(|(place, why)| Drain::new(place, why, &program.sources)).collect(),
        repaired: obj.repaired,
        ops: report.ops.into_iter().map(Op::from).collect(),
        before,
        after: Counts::of(&obj.mesh),
        seconds: Seconds {
            load,
            compile,
            run,
            save: 0.0,
            native: arguments.verbose.then_some(progress.compiling.as_secs_f64()),
        },
    };

    let started = Instant::now();
    let saved = save(arguments, &program, &report, &mut obj, &places);
    report.seconds.save = started.elapsed().as_secs_f64();
    if let Err(failure) = saved {
        // It shows what may have gone wrong.
        if arguments.format == Format::Human && !interrupt::is_asked() {
            eprint_line(&report.show());
        }
        return Err(failure);
    }
    match arguments.format {
        Format::Json if poured => eprint_json(&report),
        Format::Json => print_json(&report),
        Format::Human => {
            if poured {
                eprint_line(&report.show())
            } else {
                print_line(&report.show())
            }
            let output = arguments.output.as_deref();
            if output.is_some_and(|output| files::is_same(output, &arguments.mesh)) {
                eprint_line(&format!("`{}` is replaced by the result", arguments.mesh.display()));
            }
            if arguments.output.is_none() && arguments.picture.is_none() {
                eprint_line("the result is not kept; `-o FILE` writes it");
            }
            Ok(())
        }
    }
}

/// Writes the mesh and its picture, as requested.
fn save(
    arguments: &RunArguments,
    program: &Program,
    report: &Report,
    obj: &mut MeshFile,
    places: &Places,
) -> Result<(), Failure> {
    // The script may have created the attribute.
    let shown = arguments.attribute.as_ref().map(|name| attribute(&obj.mesh, name)).transpose()?;
    if let Some(output) = &arguments.output {
        let blame = |mesh: &Mesh| {
            let applied = report.ops.iter().filter(|op| op.applied > 0);
            program::blame(program, mesh, applied.map(|op| op.op.as_str()))
        };
        meshes::write(output, obj, &arguments.encoding, blame)?;
        meshes::tell_displaced(output, places, &obj.mesh);
    }
    if let Some(picture) = &arguments.picture {
        let view = View { attribute: shown, ..View::default() };
        let drawn = draw_mesh(&obj.mesh, &view.with_own_colours(&obj.mesh));
        tell_if_blank(&drawn, &obj.mesh);
        write_picture(&drawn, picture, 1.0)?;
    }
    Ok(())
}

#[derive(Serialize)]
struct Report {
    script: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    repaired: Option<RepairReport>,
    ops: Vec<Op>,
    before: Counts,
    after: Counts,
    seconds: Seconds,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    drains: Vec<Drain>,
}

/// The report on the keys of a `drain` loop.
#[derive(Serialize)]
struct Drain {
    place: String,
    keys: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    because: Option<String>,
}

impl Drain {
    fn new(place: Span, why: Option<Unbounded>, sources: &Sources) -> Self {
        let source = sources.get(place.file);
        let (line, column) = source.line_column(place.start as usize);
        Self {
            place: format!("{}:{line}:{column}", source.name()),
            keys: match why {
                None => "updated incrementally",
                Some(_) => "updated by noting what they read",
            },
            because: why.map(|why| why.to_string()),
        }
    }
}

#[derive(Serialize)]
struct Op {
    op: String,
    applied: u64,
    refused: u64,
    reasons: Vec<Reason>,
}

#[derive(Serialize)]
struct Reason {
    reason: String,
    times: u64,
}

#[derive(Serialize)]
struct Seconds {
    load: f64,
    compile: f64,
    run: f64,
    save: f64,
    /// The part of the run that compiled native code.
    #[serde(skip_serializing_if = "Option::is_none")]
    native: Option<f64>,
}

impl From<OpReport> for Op {
    fn from(report: OpReport) -> Self {
        let refused = report.refused.iter().map(|(_, times)| times).sum();
        let reasons = report.refused.into_iter().map(|(reason, times)| Reason { reason, times });
        Self { op: report.name, applied: report.applied, refused, reasons: reasons.collect() }
    }
}

impl Report {
    fn show(&self) -> String {
        let mut parts = Vec::new();
        if !self.ops.is_empty() {
            parts.push(show_ops(&self.ops));
        }
        parts.push(self.show_counts());
        if !self.drains.is_empty() {
            parts.push(self.show_drains());
        }
        let Seconds { load, compile, run, save, native } = self.seconds;
        let native = native.map_or_else(String::new, |native| {
            format!(" (with {native:.3} to compile native code)")
        });
        parts.push(format!(
            "seconds: load {load:.3}, compile {compile:.3}, run {run:.3}{native}, save {save:.3}"
        ));
        parts.join("\n\n")
    }

    fn show_drains(&self) -> String {
        let rows = self.drains.iter().map(|Drain { place, keys, because }| {
            let because = because.as_ref().map_or_else(String::new, |why| format!(": {why}"));
            format!("{place}: keys of `drain` are {keys}{because}")
        });
        rows.collect::<Vec<_>>().join("\n")
    }

    fn show_counts(&self) -> String {
        let mut rows = vec![["", "before", "after"].map(String::from).to_vec()];
        for ((name, before), (_, after)) in self.before.rows().into_iter().zip(self.after.rows()) {
            rows.push(vec![name.to_string(), before.to_string(), after.to_string()]);
        }
        table(&rows, &[false, true, true])
    }
}

/// A table of what was applied and refused.
fn show_ops(ops: &[Op]) -> String {
    let mut rows = vec![["op", "applied", "refused", ""].map(String::from).to_vec()];
    for op in ops {
        rows.push(vec![op.op.clone(), op.applied.to_string(), op.refused.to_string()]);
        for Reason { reason, times } in &op.reasons {
            rows.push(vec![String::new(), String::new(), times.to_string(), reason.clone()]);
        }
    }
    table(&rows, &[false, true, true, false])
}
