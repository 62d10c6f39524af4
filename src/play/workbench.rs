//! The workbench and its answers.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;

use serde_json::{Value, json};

use super::ask::{Ask, Given};
use super::broken::broken;
use super::code::code;
use super::element::shown;
use super::frame::Frame;
use super::layout::laid_out;
use super::message::Message;
use super::past::Past;
use super::run::{LastRun, MOST_HISTORY};
use super::view::{counts, view};
use crate::analysis::{Counterexample, Reader};
use crate::diagram::Rule;
use crate::draw::{draw_op, fates};
use crate::mesh::{
    Element, ElementKind, FileFormat, Mesh, MeshFile, Repair, read_mesh_from, shape, write_mesh_to,
};
use crate::run::Argument;
use crate::session::{Op, Outcome, Parameter, Program, Session, Verdict};
use crate::{lessons, library};

/// The environment of a workbench: it gives files, and may stop a script when notified of progress.
pub trait Host {
    /// Called after some iterations of a script's outermost loop, with their number and, if known,
    /// the total; a break stops the script.
    fn progress(&mut self, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// The reader of the files that a program uses and a page does not provide.
    fn reader(&self) -> Box<dyn Reader>;

    /// The bytes of a mesh file that a page names and does not provide.
    fn mesh(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("{name}: there are no files here"))
    }
}

/// A program and a mesh.
#[derive(Debug)]
pub struct Workbench {
    /// The name of the current program, sound or not, and the meshes that it breaks.
    name: String,
    counterexamples: Vec<Counterexample>,
    /// The last sound program of this name.
    pub(super) program: Program,
    pub(super) session: Session,
    pub(super) past: Past,
    /// The frame in which the mesh was shown last.
    frame: Frame,
    /// True if the mesh is not the default one, but was set by a question.
    is_chosen: bool,
    /// The script that was run last, if nothing was done since.
    pub(super) last_run: Option<LastRun>,
    /// The most bytes of its history.
    pub(super) most_history: usize,
    /// The limit of the memory of the mesh and of lists, in bytes.
    memory: usize,
}

impl Default for Workbench {
    fn default() -> Self {
        let program = nothing();
        Self {
            name: String::new(),
            counterexamples: Vec::new(),
            session: Session::new(&program, shape::icosphere(2)),
            program,
            past: Past::default(),
            frame: Frame::default(),
            is_chosen: false,
            last_run: None,
            most_history: MOST_HISTORY,
            memory: usize::MAX,
        }
    }
}

/// A program without anything in it.
fn nothing() -> Program {
    let program = Program::parse_with("empty.hedge", "", &mut crate::analysis::Nowhere);
    program.expect("an empty program is sound")
}

/// An answer, or the reason in words why there is none.
pub(super) type Answer = Result<Message, String>;

impl Workbench {
    /// Limits the memory, in bytes, for the states that a script goes through: those that do not
    /// fit are recomputed by running it again.
    pub fn limit_history(&mut self, bytes: usize) {
        self.most_history = bytes;
    }

    /// Limits the memory, in bytes, for the mesh and for lists: a run that needs more fails. There is
    /// no limit at first.
    pub fn limit_memory(&mut self, bytes: usize) {
        self.memory = bytes;
        self.session.limit_memory(bytes);
    }

    /// Answers a question.
    pub fn answer(&mut self, question: Message, host: &mut dyn Host) -> Message {
        let ask = match serde_json::from_value(question.json) {
            Ok(ask) => ask,
            Err(error) => return Message::error(format!("the question cannot be read: {error}")),
        };
        self.take(ask, &question.bytes, host).unwrap_or_else(Message::error)
    }

    fn take(&mut self, ask: Ask, bytes: &[u8], host: &mut dyn Host) -> Answer {
        match ask {
            Ask::Program { name, text, files } => Ok(self.read_program(name, &text, &files, host)),
            Ask::Shape { name } => {
                self.replace(named_shape(&name).ok_or_else(|| format!("there is no `{name}`"))?);
                Ok(self.state(json!({})))
            }
            Ask::Mesh { name, repair, of_host: false } => self.open(&name, bytes, repair),
            Ask::Mesh { name, repair, of_host: true } => {
                self.open(&name, &host.mesh(&name)?, repair)
            }
            Ask::View { attribute } => {
                let mesh = self.session.mesh();
                self.frame = self.frame.fitting(mesh);
                Ok(view(mesh, &self.frame, attribute.as_deref()))
            }
            Ask::Places { op, given } => self.places(&op, &given),
            Ask::Names { op, element, given } => self.names(&op, element, &given),
            Ask::Apply { op, element, given } => self.apply(&op, element, &given),
            Ask::Run { script, given } => self.run(&script, &given, host),
            Ask::Seek { to } => self.seek(to, host),
            Ask::Undo => Ok(self.travel(Past::undo)),
            Ask::Redo => Ok(self.travel(Past::redo)),
            Ask::Save { name } => self.save(&name),
            Ask::Code { op, language } => Ok(code(&self.program, op.as_deref(), language)),
            Ask::Counterexamples => Ok(self.counterexamples()),
            Ask::Lessons => Ok(lessons_as_data()),
            Ask::Judge { lesson, text } => {
                let lesson = lessons::lesson(&lesson).ok_or("there is no such lesson")?;
                let rejected = lessons::judge(&lesson, &text).err();
                let mistake = rejected.as_ref().and_then(|it| it.mistake.as_ref());
                Ok(Message::of(json!({
                    "solved": rejected.is_none(),
                    "mistake": mistake.map(|mistake| mistake.title),
                    "said": rejected.as_ref().map(|it| &it.why),
                })))
            }
            Ask::Library => {
                let file = |file: library::LibraryFile| json!([file.name, file.text]);
                let files: Vec<_> = library::files().map(file).collect();
                Ok(Message::of(json!({ "files": files })))
            }
        }
    }

    /// An answer, with the state of the mesh added.
    pub(super) fn state(&self, mut json: Value) -> Message {
        json["counts"] = counts(self.session.mesh());
        json["past"] = json!(self.past.depth());
        Message::of(json)
    }

    /// Replaces the mesh. It can be undone, except for an untouched default mesh.
    fn replace(&mut self, mesh: Mesh) {
        if std::mem::replace(&mut self.is_chosen, true) || self.past.depth() != [0, 0] {
            self.past.keep(self.session.mesh().clone());
        }
        self.set(mesh);
        self.last_run = None;
    }

    pub(super) fn set(&mut self, mesh: Mesh) {
        self.session = self.session_of(mesh);
    }

    /// A session of the program, with the limit of memory.
    pub(super) fn session_of(&self, mesh: Mesh) -> Session {
        let mut session = Session::new(&self.program, mesh);
        session.limit_memory(self.memory);
        session
    }

    fn travel(&mut self, way: fn(&mut Past, Mesh) -> Mesh) -> Message {
        let now = self.session.mesh().clone();
        let mesh = way(&mut self.past, now);
        self.set(mesh);
        self.last_run = None;
        self.state(json!({}))
    }

    fn read_program(
        &mut self,
        name: String,
        text: &str,
        files: &BTreeMap<String, String>,
        host: &dyn Host,
    ) -> Message {
        let mut reader = Files { files, rest: host.reader() };
        let (program, counterexamples) = Program::examined(&name, text, &mut reader);
        let is_other = self.name != name;
        (self.name, self.counterexamples) = (name, counterexamples);
        let why = program.as_ref().err().map(ToString::to_string);
        let program = program.ok().or_else(|| is_other.then(nothing));
        if let Some(program) = program {
            self.program = program;
            self.set(self.session.mesh().clone());
            self.last_run = None;
        }
        self.items(json!({
            "sound": why.is_none(),
            "why": why,
            "breaks": self.counterexamples.len(),
        }))
    }

    /// The operations and scripts that can be called.
    fn items(&self, mut json: Value) -> Message {
        let parameters = |parameters: Vec<Parameter<'_>>| {
            let parameter = |it: &Parameter<'_>| json!([it.name, it.ty, it.default]);
            parameters.iter().map(parameter).collect::<Vec<_>>()
        };
        let ops = self.program.ops().map(|op| {
            json!({
                "name": op.name(),
                "own": self.program.is_own(op.name()),
                "docs": op.docs().join("\n"),
                "parameters": parameters(op.parameters()),
                "level": op.level().name(),
            })
        });
        json["ops"] = ops.collect();
        let scripts = self.program.scripts().map(|script| {
            json!({
                "name": script.name(),
                "own": self.program.is_own(script.name()),
                "docs": script.docs().join("\n"),
                "parameters": parameters(script.parameters()),
            })
        });
        json["scripts"] = scripts.collect();
        Message::of(json)
    }

    fn open(&mut self, name: &str, bytes: &[u8], repair: bool) -> Answer {
        let format = FileFormat::of(Path::new(name)).map_err(|why| why.to_string())?;
        let repair = repair.then(Repair::default);
        let mut file = match read_mesh_from(name, format, bytes, repair) {
            Ok(file) => file,
            Err(error) => {
                let json = json!({ "error": error.to_string(), "mendable": error.is_mendable() });
                return Ok(Message::of(json));
            }
        };
        file.bring_all();
        let steps = file.repaired.map(|report| report.steps());
        self.replace(file.mesh);
        Ok(self.state(json!({ "repaired": steps })))
    }

    fn save(&self, name: &str) -> Answer {
        let format = FileFormat::of(Path::new(name)).map_err(|why| why.to_string())?;
        let mut file = MeshFile::from_mesh(self.session.copy().into_mesh());
        file.bring_all();
        let mut bytes = Vec::new();
        write_mesh_to(&mut bytes, format, &file).map_err(|why| why.to_string())?;
        Ok(Message { json: json!({ "name": name }), bytes })
    }

    /// The arguments of an operation: the given ones, and an element for the first parameter that
    /// takes one.
    pub(super) fn arguments(
        parameters: &[Parameter<'_>],
        given: &Given,
        mut element: Option<Element>,
    ) -> Result<Vec<(String, Argument)>, String> {
        let mut arguments = Vec::new();
        for parameter in parameters {
            let is_element = ElementKind::named(parameter.ty).is_some();
            let name = parameter.name.to_owned();
            let given = given.get(parameter.name);
            match (given, element.take_if(|_| is_element && given.is_none())) {
                (Some(value), _) => {
                    let argument = argument(value, parameter.ty).ok_or_else(|| {
                        format!("`{name}` is of type `{}`, not {value}", parameter.ty)
                    })?;
                    arguments.push((name, argument));
                }
                (None, Some(element)) => {
                    arguments.push((name, Argument::Element(element.kind, element.index)));
                }
                (None, None) => {}
            }
        }
        Ok(arguments)
    }

    fn op(&self, name: &str) -> Result<Op, String> {
        self.program.op(name).map_err(|error| error.message().to_owned())
    }

    fn places(&mut self, op: &str, given: &Given) -> Answer {
        let op = self.op(op)?;
        let arguments = Self::arguments(&op.parameters(), given, None)?;
        let verdicts = self.session.verdicts(&op, arguments).map_err(|error| error.to_string())?;
        let parameters = op.parameters();
        let kinds = ElementKind::ALL.map(ElementKind::name);
        let free = |it: &&Parameter<'_>| kinds.contains(&it.ty) && !given.contains_key(it.name);
        let kind = parameters.iter().find(free).map_or("", |it| it.ty);
        let byte = |verdict: &Verdict| match verdict {
            Verdict::Gone => 0,
            Verdict::Applies => 1,
            Verdict::Refuses(reason) => u8::try_from(reason + 2).unwrap_or(u8::MAX),
        };
        let bytes: Vec<u8> = verdicts.iter().map(byte).collect();
        let reasons: Vec<&str> = op.reasons().iter().map(|reason| &**reason).collect();
        let applies = bytes.iter().filter(|&&verdict| verdict == 1).count();
        let asked = bytes.iter().filter(|&&verdict| verdict != 0).count();
        let json = json!({ "kind": kind, "reasons": reasons, "applies": applies, "asked": asked });
        Ok(Message { json, bytes })
    }

    fn names(&mut self, op: &str, element: Element, given: &Given) -> Answer {
        let op = self.op(op)?;
        let arguments = Self::arguments(&op.parameters(), given, Some(element))?;
        let matched = self.session.matched(&op, arguments).map_err(|error| error.to_string())?;
        let mesh = self.session.mesh();
        let shown = |element| shown(mesh, &self.frame, element);
        Ok(Message::of(match matched {
            Err(reason) => json!({ "refused": &*reason.text, "at": shown(element) }),
            Ok(found) => {
                let rule = self.drawn_rule(op.name(), found.rule);
                let fates = rule.map(fates).unwrap_or_default();
                let names = found.names.iter().flat_map(|(name, elements)| {
                    let fate = fates.get(name.as_str()).copied().unwrap_or("kept");
                    elements.iter().map(move |&element| json!([name, shown(element), fate]))
                });
                let label = rule.and_then(|rule| rule.label.as_deref());
                json!({ "rule": label, "names": names.collect::<Vec<_>>() })
            }
        }))
    }

    /// A rule of an operation that is drawn.
    fn drawn_rule(&self, op: &str, rule: usize) -> Option<&Rule> {
        let analysis = self.program.analysis();
        analysis.program.ops[analysis.op(op)?].diagram.as_ref()?.rules.get(rule)
    }

    fn apply(&mut self, op: &str, element: Element, given: &Given) -> Answer {
        let op = self.op(op)?;
        let arguments = Self::arguments(&op.parameters(), given, Some(element))?;
        let before = self.session.mesh().clone();
        match self.session.apply(&op, arguments).map_err(|error| error.to_string())? {
            Outcome::Refused(reason) => Ok(Message::of(json!({ "refused": &*reason.text }))),
            Outcome::Applied(result) => {
                self.past.keep(before);
                self.last_run = None;
                let mesh = self.session.mesh();
                let shown = |element| shown(mesh, &self.frame, element);
                let result = result.map(shown);
                let created: Vec<_> =
                    self.session.created().iter().map(|&element| shown(element)).collect();
                Ok(self.state(json!({ "result": result, "created": created })))
            }
        }
    }

    fn counterexamples(&self) -> Message {
        let mut bytes = Vec::new();
        let examples = self.counterexamples.iter().map(|example| {
            let mesh = laid_out(&example.before);
            let frame = Frame::default().fitting(&mesh);
            let before = view(&mesh, &frame, None);
            let range = [bytes.len(), before.bytes.len()];
            bytes.extend(before.bytes);
            let names = example.names.iter().flat_map(|(name, elements)| {
                let shown = |&element| json!([name, shown(&mesh, &frame, element)]);
                elements.iter().map(shown).collect::<Vec<_>>()
            });
            json!({
                "op": example.op,
                "rule": example.rule,
                "code": example.code,
                "verdict": example.verdict,
                "broken": broken(&example.invalid, &mesh, &frame),
                "svg": draw_op(&example.drawn()).svg(),
                "names": names.collect::<Vec<_>>(),
                "view": before.json,
                "range": range,
            })
        });
        let examples: Vec<_> = examples.collect();
        Message { json: json!({ "examples": examples }), bytes }
    }
}

fn lessons_as_data() -> Message {
    let lesson = |lesson: lessons::Lesson| {
        let mistakes = lesson.mistakes.iter().map(|mistake| {
            json!({ "title": mistake.title, "text": mistake.text, "program": mistake.program })
        });
        json!({
            "name": lesson.name,
            "title": lesson.title,
            "text": lesson.text,
            "program": lesson.program,
            "mesh": lesson.mesh,
            "mistakes": mistakes.collect::<Vec<_>>(),
        })
    };
    Message::of(json!({ "lessons": lessons::all().map(lesson).collect::<Vec<_>>() }))
}

/// A JSON value as an argument of a type; `None` if it is none of that type.
fn argument(value: &Value, ty: &str) -> Option<Argument> {
    let reals = || -> Option<Vec<f64>> { value.as_array()?.iter().map(Value::as_f64).collect() };
    Some(match ty {
        "bool" => Argument::Bool(value.as_bool()?),
        "int" => Argument::Int(value.as_i64()?),
        "real" => Argument::Real(value.as_f64()?),
        "text" => Argument::Text(value.as_str()?.to_owned()),
        "vec2" => Argument::from(<[f64; 2]>::try_from(reals()?).ok()?),
        "vec3" => Argument::from(<[f64; 3]>::try_from(reals()?).ok()?),
        "vec4" => Argument::from(<[f64; 4]>::try_from(reals()?).ok()?),
        _ => Argument::Element(ElementKind::named(ty)?, u32::try_from(value.as_u64()?).ok()?),
    })
}

fn named_shape(name: &str) -> Option<Mesh> {
    Some(match name {
        "tetrahedron" => shape::tetrahedron(),
        "cube" => shape::cube(),
        "octahedron" => shape::octahedron(),
        "icosphere" => shape::icosphere(2),
        "grid" => shape::grid(6, 6),
        "triangle grid" => shape::triangle_grid(6, 6),
        "torus" => shape::torus(12, 8),
        "triangle torus" => shape::triangle_torus(12, 8),
        "tube" => shape::tube(8, 4),
        _ => return None,
    })
}

/// Files that are given, and those of another reader.
struct Files<'g> {
    files: &'g BTreeMap<String, String>,
    rest: Box<dyn Reader>,
}

impl Reader for Files<'_> {
    fn read(&mut self, name: &str) -> Result<String, String> {
        self.files.get(name).map_or_else(|| self.rest.read(name), |text| Ok(text.clone()))
    }

    fn identity(&mut self, name: &str) -> String {
        self.rest.identity(name)
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        let mut names = self.rest.beside(name);
        names.extend(self.files.keys().cloned());
        names
    }
}
