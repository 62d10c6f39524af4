//! Terms as Rust.

use super::super::builtin::{spelled, with_arguments};
use super::super::language::{Language, Level, Spelled, field, number, spell};
use super::super::names::invoked;
use super::super::support::names;
use super::super::term::{Around, Attribute, Fold, Function, IndexLoop, Term};
use super::function::{Printer, ty};
use crate::diagram::{Binary, Builtin, FoldFunction, Pointer, Type};

impl Language for Printer {
    fn real(&self, value: f64) -> Spelled {
        number(value, ["f64::INFINITY", "f64::NAN"])
    }

    fn int(&self, value: i64) -> Spelled {
        match value {
            0.. => Spelled::whole(value.to_string()),
            _ => Spelled::new(value.to_string(), Level::Prefix),
        }
    }

    fn follow(&self, pointer: Pointer, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.{}({})", field(pointer), of.text))
    }

    fn position(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.position({})", of.text))
    }

    fn attribute(&self, attribute: &Attribute, of: Spelled) -> Spelled {
        let (ty, column) = (ty(attribute.ty), &attribute.column);
        let of = of.at(Level::Whole);
        Spelled::whole(format!("attribute::<{ty}>(mesh, {column}, {of}.0)"))
    }

    fn hole(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.is_hole({})", of.text))
    }

    fn vector(&self, parts: [Spelled; 3]) -> Spelled {
        let parts = parts.map(|part| part.text).join(", ");
        Spelled::whole(format!("DVec3::new({parts})"))
    }

    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let text =
            format!("if {} {{ {} }} else {{ {} }}", condition.text, then.text, otherwise.text);
        Spelled::new(text, Level::Choice)
    }

    fn to_real(&self, of: Spelled) -> Spelled {
        // `as` binds more tightly than a comparison, but `x as f64 < y` reads as a type.
        Spelled::new(format!("{} as f64", of.at(Level::Prefix)), Level::Compare)
    }

    fn call(&self, function: Function, args: Vec<Spelled>) -> Spelled {
        let builtin = match function {
            Function::Builtin(builtin) => builtin,
            Function::Of(operation, ty) => return self.of_type(operation, ty, args),
            function => return self.own(function, args),
        };
        if let (Builtin::MixReal, [a, b, t]) = (builtin, &args[..]) {
            let [a, b, t] = [a, b, t].map(|arg| arg.clone().at(Level::Product));
            return Spelled::new(format!("{a} * (1.0 - {t}) + {b} * {t}"), Level::Sum);
        }
        let args: Vec<_> = args.into_iter().map(|arg| arg.text).collect();
        let [call, _] = spelled(builtin);
        // After a call that ends with a type, `<` would begin generic arguments.
        let level = if call.ends_with("as i64") { Level::Compare } else { Level::Whole };
        Spelled::new(with_arguments(call, &args), level)
    }

    fn invoke(&self, name: &str, args: Vec<Spelled>) -> Spelled {
        let args = args.into_iter().map(|arg| format!(", {}", arg.text));
        let args = args.collect::<String>();
        Spelled::whole(format!("{}(mesh{args})", invoked(name)))
    }

    fn operator(&self, operator: Binary, args: [Spelled; 2]) -> Spelled {
        let [left, right] = args;
        match operator {
            // Rounded down: Euclidean division does so only for a positive divisor.
            Binary::Div => {
                let (left, right) = (left.at(Level::Whole), right.at(Level::Whole));
                Spelled::whole(format!(
                    "({left} / {right} - i64::from({left} % {right} != 0 && ({left} < 0) != ({right} < 0)))"
                ))
            }
            Binary::Mod => {
                let (left, right) = (left.at(Level::Whole), right.at(Level::Whole));
                Spelled::whole(format!("(({left} % {right} + {right}) % {right})"))
            }
            Binary::MultiplyVector => {
                let text = format!("{} * {}", left.at(Level::Product), right.at(Level::Prefix));
                Spelled::new(text, Level::Product)
            }
            _ => {
                let text = format!("{} == {}", left.at(Level::Sum), right.at(Level::Sum));
                Spelled::new(text, Level::Compare)
            }
        }
    }

    fn some(&self, indices: &IndexLoop, condition: &Term) -> Spelled {
        let condition = self.text(condition);
        let IndexLoop { index, size } = indices;
        Spelled::whole(format!("(0..{size}).any(|{index}| {condition})"))
    }

    fn fold(&self, fold: &Fold) -> Spelled {
        let mut all = self.all_around(fold.around, &fold.element);
        let variable = &fold.variable.name;
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = format!("{all}.filter(|&{variable}| {filter})");
        }
        let body = spell(self, &fold.body);
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => self.to_real(body),
            _ => body,
        };
        // A count of all elements does not use the variable.
        let (body, of) = (body.text, ty(fold.ty));
        let bound = match names(&body, variable) {
            true => variable.as_str(),
            false => "_",
        };
        let (nothing, values) = ("a value of nothing", format!("{all}.map(|{bound}| {body})"));
        Spelled::whole(match fold.function {
            FoldFunction::Any => format!("{all}.any(|{bound}| {body})"),
            FoldFunction::All => format!("{all}.all(|{bound}| {body})"),
            FoldFunction::Count => {
                format!("({all}.filter(|&{bound}| {body}).count() as i64)").replace("|&_|", "|_|")
            }
            FoldFunction::Sum => format!("{values}.sum::<{of}>()"),
            FoldFunction::Mean => {
                let values = format!("{values}.collect::<Vec<{of}>>()");
                format!(
                    "{{ let all = {values}; assert!(!all.is_empty(), \"{nothing}\"); all.iter().copied().sum::<{of}>() / all.len() as f64 }}"
                )
            }
            FoldFunction::Min => format!("{values}.reduce({of}::min).expect(\"{nothing}\")"),
            FoldFunction::Max => format!("{values}.reduce({of}::max).expect(\"{nothing}\")"),
            FoldFunction::ArgMin | FoldFunction::ArgMax => {
                let name = match fold.function {
                    FoldFunction::ArgMin => "least_of",
                    _ => "greatest_of",
                };
                return self.support(name, &[all, format!("|{bound}| {body}")]);
            }
        })
    }
}

impl Printer {
    /// An iterator over the elements around an element.
    pub(super) fn all_around(&self, around: Around, element: &Term) -> String {
        let element = self.text(element);
        let half = format!("mesh.edge_halfedge({element})");
        let sides = format!("[{half}, mesh.twin({half})].into_iter()");
        let real = ".filter(|&f| !mesh.is_hole(f))";
        match around {
            Around::VertexHalfedges => format!("mesh.spokes({element})"),
            Around::VertexEdges => format!("mesh.spokes({element}).map(|h| mesh.edge(h))"),
            Around::VertexFaces => format!("mesh.spokes({element}).map(|h| mesh.face(h)){real}"),
            Around::VertexNeighbors => format!("mesh.neighbors({element})"),
            Around::FaceHalfedges => format!("mesh.face_halfedges({element})"),
            Around::FaceVertices => format!("mesh.face_vertices({element})"),
            Around::FaceEdges => format!("mesh.face_halfedges({element}).map(|h| mesh.edge(h))"),
            Around::EdgeVertices => format!("{sides}.map(|h| mesh.vertex(h))"),
            Around::EdgeFaces => format!("{sides}.map(|h| mesh.face(h)){real}"),
        }
    }

    /// A support function, or a method of a list or vector.
    fn own(&self, function: Function, args: Vec<Spelled>) -> Spelled {
        let mut args: Vec<_> = args.into_iter().map(|arg| arg.text).collect();
        let name = match function {
            Function::InOrderAlongLoop => "in_order_along_loop",
            Function::InOrderAroundVertex => "in_order_around_vertex",
            Function::AllDiffer => "all_differ",
            Function::LoopFrom | Function::SpokesFrom => {
                let walk = match function {
                    Function::LoopFrom => "loop_from",
                    _ => "spokes_from",
                };
                let from = args.join(", ");
                return Spelled::whole(format!("mesh.{walk}({from}).collect::<Vec<_>>()"));
            }
            Function::IsIsolated => {
                let text = format!("mesh.vertex_halfedge({}).is_none()", args.join(", "));
                return Spelled::whole(text);
            }
            Function::Every => {
                let [list, first, step] = [0, 1, 2].map(|at| args[at].clone());
                let steps = format!("{list}.iter().skip({first}).step_by({step})");
                return Spelled::whole(format!("{steps}.copied().collect::<Vec<_>>()"));
            }
            Function::Turned => "turned",
            Function::OfPreview(question) => {
                let of = args.split_off(1).join(", ");
                return Spelled::whole(format!("{}.{question}({of})", args.join("")));
            }
            Function::Length => return Spelled::whole(format!("{}.len()", args.join(", "))),
            Function::Remainder => {
                let text = format!("{}.len() % {}", args[0], args[1]);
                return Spelled::new(text, Level::Product);
            }
            Function::AllInOrderAlongLoop => "all_in_order_along_loop",
            Function::AllInOrderAroundVertex => "all_in_order_around_vertex",
            Function::IsFinite | Function::Builtin(_) | Function::Of(..) => {
                return Spelled::whole(format!("{}.is_finite()", args.join(", ")));
            }
        };
        match function {
            Function::InOrderAlongLoop | Function::InOrderAroundVertex => {
                args.insert(0, "mesh".to_string());
            }
            Function::AllInOrderAlongLoop | Function::AllInOrderAroundVertex => {
                args = vec!["mesh".to_string(), format!("&{}", args.join(", "))];
            }
            Function::Turned => {}
            _ => args.iter_mut().for_each(|arg| arg.insert(0, '&')),
        }
        Spelled::whole(format!("{name}({})", args.join(", ")))
    }
}
