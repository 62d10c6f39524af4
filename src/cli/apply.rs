//! `hedgerow apply`

use serde::Serialize;

use super::arguments::{ApplyArguments, Format};
use super::check::{depends, reports};
use super::counts::Counts;
use super::failure::Failure;
use super::output::{eprint_json, eprint_line, is_standard, print_json, print_line};
use super::program::{self, Program, settings};
use super::{meshes, place};
use crate::mesh::{
    EdgeId, ElementKind, FaceId, HalfedgeId, Mesh, MeshFile, Places, RepairReport, VertexId,
    WrittenNumbers,
};
use crate::rewrite::{Plan, Unwatched};
use crate::run::{self, Application, Applied, Argument};

/// Applies one operation at one place of a mesh.
pub(super) fn apply(arguments: &ApplyArguments) -> Result<(), Failure> {
    let (path, name) = program::part(&arguments.op);
    let program = program::read(path)?;
    let op = program::find_op(&program, name)?;
    let Some(plan) = &program.analysis.plans[op] else {
        let told = program.complain_about(&[program.analysis.program.ops[op].span]);
        let failure = Failure::Told(reports(&told, &program.sources), 1.into());
        if let Some(lacks) = &program.analysis.lacks[op] {
            let name = &program.analysis.program.ops[op].name;
            eprint_line(&format!("`{name}` is not proved: it {}", depends(lacks)));
        }
        return Err(failure);
    };
    let output = arguments.output.as_deref();
    output.map_or(Ok(()), |output| meshes::expect_mesh(output, &arguments.encoding))?;
    program.expect_apart(&arguments.output)?;
    let mut obj = meshes::read(&arguments.mesh, &arguments.repair)?;
    let values = values(&program, op, arguments, &mut obj)?;
    let attributes = run::attributes(&program.analysis.program, op, &program.analysis.plans);
    for (kind, name, default) in &attributes {
        obj.bring((*kind, name, *default));
    }
    let is_known = |kind, name: &str| {
        attributes.iter().any(|(of, own, _)| (*of, own.as_str()) == (kind, name))
    };
    let places = Places::of(&obj.mesh, is_known);
    let before = Counts::of(&obj.mesh);
    let failed = |diagnostic, code| Failure::of(&[diagnostic], &program.sources, code);
    let application = Application::new(&program.analysis.program, op, &program.analysis.plans);
    let mut application = application.map_err(|told| failed(told, 2))?;
    application.use_engine(arguments.engine.get());
    let applied = application.apply(&mut obj.mesh, &values, &mut Unwatched);
    let applied = applied.map_err(|failure| failed(failure.diagnostic, 1))?;
    match applied {
        Applied::Done { result, created } => {
            if let Some(output) = output {
                let blame = |mesh: &Mesh| program::blame(&program, mesh, [plan.name.as_str()]);
                meshes::write(output, &mut obj, &arguments.encoding, blame)?;
                meshes::tell_displaced(output, &places, &obj.mesh);
            }
            // Without a result, elements are named as in the mesh that was given.
            let numbers = meshes::numbers(output.unwrap_or(&arguments.mesh), &obj);
            let name = |(kind, id)| element(&obj.mesh, &numbers, kind, id);
            let report = Report {
                result: result.and_then(name),
                created: created.iter().filter_map(|&new| name(new)).collect(),
                applied: true,
                after: Counts::of(&obj.mesh),
                repaired: obj.repaired,
                ..Report::nothing(plan, before)
            };
            match (arguments.format, output.is_some_and(is_standard)) {
                (Format::Json, false) => print_json(&report)?,
                (Format::Json, true) => eprint_json(&report)?,
                (Format::Human, false) => print_line(&report.show()),
                (Format::Human, true) => eprint_line(&report.show()),
            }
            if output.is_none() && arguments.format == Format::Human {
                eprint_line("the result is not kept; `-o FILE` writes it");
            }
            Ok(())
        }
        Applied::Refused(reason) => {
            if arguments.format == Format::Json {
                print_json(&Report {
                    refused: Some(reason.clone()),
                    repaired: obj.repaired,
                    ..Report::nothing(plan, before)
                })?;
            }
            Err(Failure::Refused(reason))
        }
    }
}

/// The arguments, from `--at` and `--set`.
fn values(
    program: &Program,
    op: usize,
    arguments: &ApplyArguments,
    obj: &mut MeshFile,
) -> Result<Vec<(String, Argument)>, Failure> {
    let params = &program.analysis.program.ops[op].params;
    let mut texts = settings(&arguments.set)?;
    let places = place::given(params, &arguments.at, &texts)?;
    texts.extend(place::ids(places, obj)?);
    run::arguments(&program.analysis.program, op, &texts)
        .map_err(|errors| Failure::of(&errors, &program.sources, 2))
}

/// The report of `apply`. Elements are named as `--at` would name them in the written file.
#[derive(Serialize)]
struct Report {
    op: String,
    applied: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    result: Option<String>,
    created: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    repaired: Option<RepairReport>,
    before: Counts,
    after: Counts,
}

impl Report {
    /// The report if nothing was applied: the mesh is unchanged.
    fn nothing(plan: &Plan, before: Counts) -> Self {
        Self {
            op: plan.name.clone(),
            applied: false,
            refused: None,
            result: None,
            created: Vec::new(),
            repaired: None,
            before,
            after: before,
        }
    }

    fn show(&self) -> String {
        let mut text = format!("applied {}", self.op);
        if let Some(result) = &self.result {
            text.push_str(&format!("\nresult   {result}"));
        }
        if !self.created.is_empty() {
            text.push_str(&format!("\ncreated  {}", self.created.join(" ")));
        }
        let Counts { vertices, edges, faces, .. } = self.after;
        text.push_str(&format!("\nnow      {vertices} vertices, {edges} edges, {faces} faces"));
        text
    }
}

/// An element as `--at` names it in the written file; in an OBJ file holes have no number.
fn element(mesh: &Mesh, numbers: &WrittenNumbers, kind: ElementKind, id: u32) -> Option<String> {
    // A step may have created what a later one has erased.
    if !mesh.is_alive(kind, id) {
        return None;
    }
    let ends = |half: HalfedgeId| {
        Some((numbers.vertex(mesh.vertex(half))?, numbers.vertex(mesh.target(half))?))
    };
    match kind {
        ElementKind::Vertex => {
            numbers.vertex(VertexId(id)).map(|number| format!("vertex:{number}"))
        }
        ElementKind::Face => numbers.face(FaceId(id)).map(|number| format!("face:{number}")),
        ElementKind::Halfedge => {
            ends(HalfedgeId(id)).map(|(from, to)| format!("halfedge:{from}-{to}"))
        }
        ElementKind::Edge => {
            ends(mesh.edge_halfedge(EdgeId(id))).map(|(from, to)| format!("edge:{from}-{to}"))
        }
    }
}
