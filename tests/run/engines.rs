//! The machine and native code beside each other: all operations of the library and of the
//! examples, at every place of small meshes, and the tests that library files bring.

use std::ops::ControlFlow;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::diagram::Type;
use hedgerow::library;
use hedgerow::mesh::{ElementKind, Mesh, identical, shape};
use hedgerow::rewrite::{Engine, StopAfter, Unwatched, Watch};
use hedgerow::run::{Application, Argument, Conditions, Prepared, prepare, run, test};
use hedgerow::source::Sources;
use support::dice::Dice;
use support::engines::run_on_both;
use support::reference::examples::{elements, examples};
use support::reference::printing::mesh_text;

/// The programs of the library and of the examples.
fn programs() -> Vec<(String, String)> {
    let library = library::files();
    let mut programs: Vec<_> =
        library.map(|file| (file.name.to_owned(), file.text.to_owned())).collect();
    for path in examples() {
        let text = std::fs::read_to_string(&path).expect("an example");
        programs.push((path.display().to_string(), text));
    }
    programs
}

fn analyse(name: &str, text: &str) -> Analysis {
    let mut sources = Sources::new();
    let file = sources.add(name, text);
    Analysis::with(&mut sources, file, &mut Nowhere)
}

/// The script `main` of a program that is sound.
fn script(name: &str, text: &str) -> Prepared {
    let analysis = analyse(name, text);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    let script = analysis.script("main").expect("it is there");
    prepare(&analysis.program, script, &analysis.plans).expect("it is small")
}

fn meshes() -> Vec<Mesh> {
    vec![
        shape::icosahedron(),
        shape::triangle_grid(3, 2),
        shape::triangle_torus(4, 3),
        shape::cube(),
        shape::grid(2, 2),
        shape::fan(5),
        shape::tube(4, 2),
        shape::pillow(4),
    ]
}

/// A value for a parameter, the first that is an element at a given place.
fn argument(dice: &mut Dice, mesh: &Mesh, ty: Type, place: &mut Option<u32>) -> Option<Argument> {
    let element = |kind: ElementKind, dice: &mut Dice, place: &mut Option<u32>| {
        let all = elements(mesh, ty);
        let chosen = place.take().filter(|id| all.contains(id));
        let chosen = chosen.or_else(|| all.get(dice.below(all.len().max(1))).copied())?;
        Some(Argument::Element(kind, chosen))
    };
    let mut real = || dice.below(9) as f64 / 8.0;
    Some(match ty {
        Type::Vertex => element(ElementKind::Vertex, dice, place)?,
        Type::Halfedge => element(ElementKind::Halfedge, dice, place)?,
        Type::Edge => element(ElementKind::Edge, dice, place)?,
        Type::Face => element(ElementKind::Face, dice, place)?,
        Type::Real => Argument::Real(real()),
        Type::Int => Argument::Int(dice.below(5) as i64),
        Type::Bool => Argument::Bool(dice.below(2) == 0),
        Type::Vec3 => Argument::Reals(Type::Vec3, vec![real(), real(), real()]),
        _ => return None,
    })
}

#[test]
fn operations_do_the_same_on_both() {
    let mut dice = Dice(20);
    let (mut applied, mut refused, mut ops) = (0, 0, 0);
    for (name, text) in programs() {
        let analysis = analyse(&name, &text);
        for (number, op) in analysis.program.ops.iter().enumerate() {
            let Ok(application) = Application::new(&analysis.program, number, &analysis.plans)
            else {
                continue;
            };
            ops += 1;
            let engines = [Engine::Machine, Engine::NativeAtOnce].map(|engine| {
                let mut application = application.clone();
                application.use_engine(engine);
                application
            });
            for mesh in meshes() {
                // One call after the other, so that erased slots are used again.
                let mut copies = [mesh.clone(), mesh.clone()];
                for place in (0..mesh.capacity(ElementKind::Halfedge) as u32).step_by(3) {
                    let mut place = Some(place);
                    let params = op.params.iter();
                    let values = params.map(|param| {
                        let value = argument(&mut dice, &copies[0], param.ty, &mut place)?;
                        Some((param.name.clone(), value))
                    });
                    let Some(values) = values.collect::<Option<Vec<_>>>() else {
                        break;
                    };
                    let [on_machine, native] = [0, 1]
                        .map(|at| engines[at].apply(&mut copies[at], &values, &mut Unwatched));
                    assert_eq!(native, on_machine, "{name}::{} at {values:?}", op.name);
                    assert!(
                        identical(&copies[0], &copies[1]),
                        "{name}::{} at {values:?} makes\n{}where the machine makes\n{}",
                        op.name,
                        mesh_text(&copies[1]),
                        mesh_text(&copies[0]),
                    );
                    match on_machine {
                        Ok(hedgerow::run::Applied::Done { .. }) => applied += 1,
                        _ => refused += 1,
                    }
                    copies.iter_mut().for_each(Mesh::recycle);
                }
            }
        }
    }
    assert!(ops > 60 && applied > 1000 && refused > 1000, "{ops} {applied} {refused}");
}

#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

#[test]
fn tests_of_the_library_do_the_same_on_both() {
    let mut done = 0;
    for (name, text) in programs() {
        let analysis = analyse(&name, &text);
        for number in 0..analysis.program.tests.len() {
            let [on_machine, native] = [Engine::Machine, Engine::NativeAtOnce].map(|engine| {
                let conditions = Conditions { engine, ..Conditions::default() };
                let mut lines = Lines::default();
                let report = test(
                    &analysis.program,
                    number,
                    &analysis.plans,
                    conditions,
                    &mut |_, _| Err("no test of the library loads a mesh".to_owned()),
                    &mut lines,
                );
                (report, lines.0)
            });
            assert_eq!(
                native, on_machine,
                "{name}: {}",
                analysis.program.tests[number].script.name
            );
            done += 1;
        }
    }
    assert!(done > 40, "{done} tests");
}

/// Scripts that call functions that loop and drain, on a mesh on which operations run often enough
/// to be compiled on the way.
#[test]
fn scripts_do_the_same_on_a_larger_mesh() {
    let text = "use \"std/remesh.hedge\"\nuse \"std/simplify.hedge\"\nuse \"std/subdivide.hedge\"
        use \"std/smooth.hedge\"
        script main() { loop_subdivide() laplacian(1) simplify(-1, 1, 0.5) remesh(0, 1) }";
    let prepared = script("larger.hedge", text);
    for engine in [Engine::Native, Engine::NativeAtOnce] {
        let mut mesh = shape::triangle_torus(20, 15);
        let (report, _) = run_on_both(&prepared, &mut mesh, &[], engine);
        let report = report.expect("it comes to its end");
        assert!(report.ops.iter().map(|op| op.applied).sum::<u64>() > 2000, "{report:?}");
    }
}

/// Loops in random order over elements of each kind, on a mesh that is large enough for memory to be
/// requested in advance: around elements that follow, and that may be erased by then.
#[test]
fn loops_in_random_order_do_the_same_on_a_large_mesh() {
    let text = "use \"std/triangle.hedge\"
        script main() {
          for e in shuffle(edges) { if random() < 0.5 { collapse(e) } else { flip(e) } }
          for v in shuffle(vertices) { v.position = 0.5 * v.position }
          for h in shuffle(halfedges) { if boundary(h.edge) { print h } }
          for f in shuffle(faces) { for e in f.edges { split(e) break } }
        }";
    let prepared = script("random.hedge", text);
    let mut mesh = shape::triangle_torus(100, 100);
    assert!(mesh.halfedge_count() > 50_000, "memory is requested for larger meshes only");
    let (report, _) = run_on_both(&prepared, &mut mesh, &[], Engine::Native);
    let report = report.expect("it comes to its end");
    assert!(report.ops.iter().all(|op| op.applied > 3000), "{report:?}");
}

/// Scripts that would take for ever, or nearly.
const ENDLESS: [&str; 8] = [
    "var n = 0\n while true { n = (n + 1) mod 7 }",
    "repeat 1000000000000 { }",
    "repeat 1000000000000 { for e in edges { flip(e) } }",
    "repeat 1000000000000 { update v in vertices { v.position = 0.5 * v.position } }",
    "print fibonacci(90)",
    "print sum(sum(sum(sum(length(e) for e in edges) for f in edges) for g in edges) for h in edges)",
    "drain v in vertices by v.mark while true { v.mark = v.mark + 1 }",
    "repeat 1000000000000 { for v in vertices { raise(v) } }",
];

/// Each look comes after a bounded number of turns, on the machine, in native code, and where one
/// goes over to the other.
#[test]
fn endless_scripts_are_stopped_on_all_engines() {
    for body in ENDLESS {
        let text = format!(
            "use \"std/triangle.hedge\"
            attr mark: vertex int = 0
            fn fibonacci(n: int) -> int {{
              if n < 2 {{ 1 }} else {{ fibonacci(n - 1) + fibonacci(n - 2) }}
            }}
            fn raise(v: vertex) {{ v.mark = degree(v) + v.mark }}
            script main() {{ {body} }}"
        );
        let mut prepared = script("endless.hedge", &text);
        for engine in [Engine::Machine, Engine::Native, Engine::NativeAtOnce] {
            prepared.use_engine(engine);
            for looks in [1, 2, 40] {
                let mut mesh = shape::icosphere(2);
                let stopped = run(&prepared, &mut mesh, &[], &mut StopAfter(looks));
                let failure = stopped.expect_err("it has no end");
                assert_eq!(failure.diagnostic.code, "interrupted", "{body}");
            }
        }
    }
}

/// A function that an operation in steps calls can end it: what it has written is undone.
#[test]
fn a_function_refuses_for_steps_on_both() {
    let text = "use \"std/map.hedge\"
        attr mark: vertex int = 0
        fn press(e: edge, left: int) -> int {
          let v = must contract(e)
          v.mark = v.mark + 1
          v.position = vec3(1, 2, 3)
          if left > 0 { press(v.halfedge.edge, left - 1) } else { must straighten(v) 1 }
        }
        op shrink(e: edge, left: int) -> vertex {
          guard surface
          steps {
            let n = press(e, left)
            return e.halfedge.vertex
          }
        }
        script main() {
          for e in edges {
            if let v = shrink(e, 0) { print \"applied\" }
            if let v = shrink(e, 2) { print \"applied\" }
          }
          drain e in edges by length(e) while true { shrink(e, 1) }
          print sum(v.mark for v in vertices), count(vertices)
        }";
    let prepared = script("refuses.hedge", text);
    let mut undone = 0;
    for original in meshes() {
        let mut mesh = original.clone();
        let (report, lines) = run_on_both(&prepared, &mut mesh, &[], Engine::NativeAtOnce);
        // Where the steps are done, the edge is gone that they were asked for.
        let Ok(report) = report else {
            continue;
        };
        assert!(lines.last().is_some_and(|line| line.starts_with("0 ")), "{lines:?}");
        assert!(mesh.vertices().eq(original.vertices()));
        undone += report.ops[0].refused.iter().map(|(_, times)| times).sum::<u64>();
    }
    assert!(undone > 30, "{undone}");
}

/// What native code calls and asks directly: operations that keep a level and such that lower it,
/// small functions in each other, some of which fail.
#[test]
fn calls_do_the_same_on_both() {
    let text = "use \"std/triangle.hedge\"
        op turn(e: edge) {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }
          after {
            face f0: v3 -a-> v2 -c-> v0 -g-> v3
            face f1: v2 -d-> v3 -h-> v1 -b-> v2
            edge e: a | d
          }
        }
        attr mark: vertex int = 0
        fn third(n: int) -> int { n div 3 }
        fn share(v: vertex, of: int) -> int { third(of) + of mod degree(v) }
        fn mean_share(v: vertex) -> real { mean(share(w, w.mark) for w in v.neighbors) }
        fn beyond(v: vertex, n: int) -> int { 12 div (share(v, v.mark) - n) }
        fn count_down(v: vertex, n: int) -> int {
          if n == 0 { share(v, 7) } else { 1 + count_down(v, n - 1) }
        }
        fn note(v: vertex) { v.mark = v.mark + share(v, v.mark + 5) }
        fn is_even(h: halfedge) -> bool { (h.vertex.mark + h.target.mark) mod 2 == 0 }
        script main(limit: int) {
          var asked = 0
          for e in edges {
            let h = e.halfedge
            note(h.vertex)
            if can flip(e) { asked = asked + 1 }
            if is_even(h) { flip(e) } else if let m = split(e) { note(m) }
            if can collapse(e) and not is_even(e.halfedge) { collapse(e) }
          }
          for e in edges {
            if is_even(e.halfedge) { split(e) }
            flip(e)
            collapse(e, 0.25)
          }
          print asked, sum(mean_share(v) for v in vertices), count(faces)
          for e in edges where is_even(e.halfedge) {
            turn(e)
            flip(e)
          }
          print sum(count_down(v, 70) for v in vertices), count(edges)
          print sum(beyond(v, limit) for v in vertices)
        }";
    let prepared = script("calls.hedge", text);
    let (mut ended, mut failed) = (0, 0);
    for original in meshes().into_iter().chain([shape::icosphere(2)]) {
        for engine in [Engine::Native, Engine::NativeAtOnce] {
            for limit in [-1, 1, 2, 3] {
                let limit = [("limit".to_owned(), Argument::Int(limit))];
                let mut mesh = original.clone();
                match run_on_both(&prepared, &mut mesh, &limit, engine).0 {
                    Ok(_) => ended += 1,
                    Err(_) => failed += 1,
                }
            }
        }
    }
    assert!(ended > 10 && failed > 10, "{ended} {failed}");
}

/// Whether vertices are adjacent is found by walks from halfedges at hand, also where both have many
/// neighbors.
#[test]
fn adjacency_is_the_same_on_both() {
    let text = "script main() {
          for h in halfedges {
            for k in halfedges {
              if adjacent(h.vertex, k.target) { print h, k, degree(k.target) }
            }
          }
          for v in vertices { print count(adjacent(v, w) for w in vertices) }
        }";
    let prepared = script("adjacent.hedge", text);
    let hubs = [shape::fan(40), shape::pillow(40), two_hubs(25), two_hubs(3)];
    for original in meshes().into_iter().chain(hubs) {
        let mut mesh = original.clone();
        let (report, lines) = run_on_both(&prepared, &mut mesh, &[], Engine::NativeAtOnce);
        report.expect("it comes to its end");
        let found = lines.iter().filter(|line| line.contains(' ')).count();
        let expected = |h| {
            let of = |k| mesh.adjacent(mesh.vertex(h), mesh.target(k));
            mesh.halfedges().filter(|&k| of(k)).count()
        };
        assert_eq!(found, mesh.halfedges().map(expected).sum::<usize>());
    }
}

/// Two vertices that are not adjacent, with so many neighbors, which are the same.
fn two_hubs(neighbors: u32) -> Mesh {
    let around = (0..neighbors).map(|i| [2 + i, 2 + (i + 1) % neighbors]);
    let faces = around.flat_map(|[v, w]| [[0, v, w], [1, w, v]]);
    let at = |i: u32| [f64::from(i).sin(), f64::from(i).cos(), f64::from(i % 3)];
    let positions: Vec<[f64; 3]> = (0..neighbors + 2).map(at).collect();
    Mesh::from_triangles(&positions, &faces.collect::<Vec<_>>()).expect("it is a mesh")
}

/// To ask whether an operation in steps would apply takes the steps, and undoes them: the tables may
/// have moved behind it.
#[test]
fn tables_move_where_steps_are_only_asked_for() {
    let text = "use \"std/triangle.hedge\"
        op twice(e: edge) -> vertex {
          guard simple
          steps { let m = must split(e) return must split(m.halfedge.edge) }
        }
        script main() {
          var sum = 0.0
          var many = 0
          for v in vertices {
            sum = sum + v.position.x
            if can twice(v.halfedge.edge) { many = many + 1 }
            sum = sum + v.halfedge.target.position.y + v.halfedge.prev.vertex.position.z
          }
          print sum, many
        }";
    let prepared = script("asked.hedge", text);
    // Tables that the system gives back when they move.
    let mut mesh = shape::triangle_torus(80, 80);
    let (report, lines) = run_on_both(&prepared, &mut mesh, &[], Engine::NativeAtOnce);
    report.expect("it comes to its end");
    assert!(lines[0].ends_with("6400"), "{lines:?}");
}

/// Functions that call themselves, with many variables that each of them keeps meanwhile: on a stack
/// of 2 MiB, which is that of a test.
#[test]
fn functions_nest_as_deep_on_both() {
    let kept: String = (0..150).map(|i| format!("let x{i} = sin(k + {i})\n")).collect();
    let sum: Vec<_> = (0..150).map(|i| format!("x{i}")).collect();
    let text = format!(
        "fn deep(k: int) -> real {{
           {kept}
           let rest = if k > 0 {{ deeper(k - 1) }} else {{ 0.0 }}
           rest + {}
         }}
         fn deeper(k: int) -> real {{ if count(vertices) > k mod 7 {{ deep(k) }} else {{ 0.5 }} }}
         script main(most: int) {{ print deep(most) }}",
        sum.join(" + ")
    );
    let prepared = script("deep.hedge", &text);
    for most in [10, 100, 490, 600] {
        let mut mesh = shape::cube();
        let arguments = [("most".to_owned(), Argument::Int(most))];
        let (report, lines) = run_on_both(&prepared, &mut mesh, &arguments, Engine::NativeAtOnce);
        assert_eq!(report.is_ok(), most < 500);
        assert_eq!(lines.len(), usize::from(most < 500));
    }
}

/// To ask whether an operation would apply makes room for what it would create, so the tables may
/// move behind each question.
#[test]
fn tables_move_where_operations_are_only_asked_for() {
    let mut asked = 0;
    for (name, mut text) in programs() {
        let analysis = analyse(&name, &text);
        if !analysis.is_sound() {
            continue; // it uses files that stand elsewhere
        }
        let ops = analysis.program.ops.iter().filter(|op| op.span.file.0 == 0);
        let questions = ops.filter_map(|op| {
            let types: Vec<_> = op.params.iter().map(|param| param.ty).collect();
            questions(&op.name, &types)
        });
        let ops: Vec<_> = questions.collect();
        for (number, question) in ops.iter().enumerate() {
            text += &format!("\nscript asks_{number}() {question}\n");
        }
        let analysis = analyse(&name, &text);
        assert!(analysis.is_sound(), "{name}: {:#?}", analysis.diagnostics);
        for (number, question) in ops.iter().enumerate() {
            let script = analysis.script(&format!("asks_{number}")).expect("it is there");
            let prepared = prepare(&analysis.program, script, &analysis.plans).expect("small");
            // Full tables, so large that the system takes them back when they move.
            for mut mesh in [shape::triangle_torus(60, 60), shape::grid(60, 60)] {
                let (report, lines) = run_on_both(&prepared, &mut mesh, &[], Engine::NativeAtOnce);
                report.unwrap_or_else(|error| panic!("{name}: {question}: {error:?}"));
                asked += usize::from(lines.iter().any(|line| !line.starts_with("0 ")));
            }
        }
    }
    assert!(asked > 60, "{asked}");
}

/// Statements that ask an operation about elements, and read the mesh behind each question.
fn questions(op: &str, params: &[Type]) -> Option<String> {
    let (first, others) = params.split_first()?;
    let (all, around) = match first {
        Type::Vertex => ("vertices", "x.neighbors"),
        Type::Halfedge => ("halfedges", "x.vertex.neighbors"),
        Type::Edge => ("edges", "x.halfedge.vertex.neighbors"),
        Type::Face => ("faces", "x.vertices"),
        _ => return None,
    };
    let others = others.iter().map(|ty| match ty {
        Type::Real => Some(", 0.5"),
        Type::Int => Some(", 2"),
        Type::Bool => Some(", true"),
        Type::Vec3 => Some(", vec3(0.1, 0.2, 0.3)"),
        _ => None,
    });
    let call = format!("{op}(x{})", others.collect::<Option<String>>()?);
    Some(format!(
        "{{
          var turn = 0
          for x in {all} {{
            turn = turn + 1
            if turn > 9 {{ break }}
            print count(can {call} and z.halfedge.twin.vertex.position.x > 0 for z in {around}),
              sum(z.halfedge.prev.vertex.position.y for z in {around} where can {call})
          }}
        }}"
    ))
}

/// Breaks where it is asked, and counts the lines that were printed before.
#[derive(Default)]
struct Impatient {
    lines: usize,
}

impl Watch for Impatient {
    fn tick(&mut self) -> ControlFlow<()> {
        ControlFlow::Break(())
    }

    fn print(&mut self, _line: &str) {
        self.lines += 1;
    }
}

#[test]
fn long_lists_are_interrupted() {
    let text = "script main() { repeat 200 { print 1 for h in shuffle(halfedges) { break } } }";
    let mut prepared = script("shuffled.hedge", text);
    for engine in [Engine::Machine, Engine::NativeAtOnce] {
        prepared.use_engine(engine);
        let mut watch = Impatient::default();
        let done = run(&prepared, &mut shape::triangle_torus(60, 60), &[], &mut watch);
        assert!(done.is_err() && watch.lines == 1, "{}", watch.lines);
    }
}

/// What functions write is noted, also where they were compiled when nobody wanted to know.
#[test]
fn writes_are_noted_whatever_was_compiled_before() {
    let text = "attr mark: vertex int = 0
        fn raise(v: vertex) { v.mark = v.mark + 1 v.position = 2 * v.position }
        fn raise_all() { for v in vertices { raise(v) } }
        script main() { repeat 3 { raise_all() } for v in vertices { raise(v) } }";
    let mut prepared = script("writes.hedge", text);
    for engine in [Engine::Native, Engine::NativeAtOnce] {
        prepared.use_engine(engine);
        let original = shape::icosphere(2);
        for _ in 0..2 {
            let mut mesh = original.clone();
            run(&prepared, &mut mesh, &[], &mut Unwatched).expect("it comes to its end");
            let done = mesh.clone();
            let mut mesh = original.clone();
            let mark = mesh.open_journal();
            run(&prepared, &mut mesh, &[], &mut Unwatched).expect("it comes to its end");
            assert!(identical(&mesh, &done));
            mesh.roll_back(mark);
            let positions =
                |mesh: &Mesh| mesh.vertices().map(|v| mesh.position(v)).collect::<Vec<_>>();
            assert_eq!(positions(&mesh), positions(&original));
        }
    }
}
