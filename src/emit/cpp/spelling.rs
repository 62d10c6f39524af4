//! Terms as C++.

use super::super::builtin::{spelled, with_arguments};
use super::super::language::{Language, Level, Spelled, number, short_number, spell};
use super::super::matrix::is_wide;
use super::super::names::invoked;
use super::super::term::{Around, Attribute, Fold, Function, IndexLoop, Term};
use super::function::Printer;
use super::support::{qualified, with_pointers};
use crate::diagram::{Binary, Builtin, FoldFunction, Pointer, Type};

/// From here on a number is written as a `long long`.
const SHORT: i64 = 1 << 15;

impl Language for Printer<'_> {
    fn real(&self, value: f64) -> Spelled {
        let real = self.style.name("real");
        let limit = |what| format!("std::numeric_limits<{real}>::{what}()");
        let [infinite, none] = ["infinity", "quiet_NaN"].map(limit);
        match real {
            // With a `double`, the whole computation would be in `double`.
            "float" => short_number(value, [&infinite, &none]),
            _ => number(value, [&infinite, &none]),
        }
    }

    fn int(&self, value: i64) -> Spelled {
        match value {
            i64::MIN => Spelled::whole("(-9223372036854775807LL - 1)"),
            // Computations with larger ones could overflow an `int`.
            0..SHORT => Spelled::whole(value.to_string()),
            SHORT.. => Spelled::whole(format!("{value}LL")),
            _ => Spelled::new(format!("-{}", self.int(-value).text), Level::Prefix),
        }
    }

    fn follow(&self, pointer: Pointer, of: Spelled) -> Spelled {
        let of = of.at(Level::Whole);
        match (pointer, self.style.read(&of, pointer)) {
            (_, Some(text)) => Spelled::whole(text),
            (Pointer::Target, None) => {
                Spelled::whole(self.style.chained(&self.style.chained(&of, "twin"), "vertex"))
            }
            (_, None) => Spelled::whole(self.support("prev", vec![of])),
        }
    }

    fn position(&self, of: Spelled) -> Spelled {
        Spelled::whole(self.style.position(&of.at(Level::Whole)))
    }

    fn attribute(&self, attribute: &Attribute, of: Spelled) -> Spelled {
        let of = of.at(Level::Whole);
        Spelled::whole(self.style.attribute(&of, &attribute.name))
    }

    fn hole(&self, of: Spelled) -> Spelled {
        Spelled::whole(self.style.boundary(&of.at(Level::Whole)))
    }

    fn vector(&self, parts: [Spelled; 3]) -> Spelled {
        let parts = parts.map(|part| part.text).join(", ");
        Spelled::whole(format!("hedgerow::vector({parts})"))
    }

    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let (condition, then) = (condition.at(Level::Or), then.at(Level::Or));
        Spelled::new(format!("{condition} ? {then} : {}", otherwise.text), Level::Choice)
    }

    fn to_real(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("static_cast<{}>({})", self.style.name("real"), of.text))
    }

    fn call(&self, function: Function, args: Vec<Spelled>) -> Spelled {
        let level = |at: usize| match function {
            // Spelled as a difference.
            Function::Builtin(Builtin::Distance) if at == 1 => Level::Product,
            _ => Level::Or,
        };
        let mut texts: Vec<String> =
            args.into_iter().enumerate().map(|(at, arg)| arg.at(level(at))).collect();
        let builtin = match function {
            Function::Builtin(builtin) => builtin,
            Function::Of(operation, ty) => return self.of_type(operation, ty, texts),
            function => {
                let name = match function {
                    Function::InOrderAlongLoop => "in_order_along_loop",
                    Function::InOrderAroundVertex => "in_order_around_vertex",
                    Function::AllDiffer => "all_differ",
                    Function::LoopFrom => "loop_from",
                    Function::SpokesFrom => "spokes_from",
                    Function::Every => "every",
                    Function::Turned => "turned",
                    Function::AllInOrderAlongLoop => "all_in_order_along_loop",
                    Function::AllInOrderAroundVertex => "all_in_order_around_vertex",
                    Function::OfPreview(question) => {
                        let of = texts.split_off(1).join(", ");
                        return Spelled::whole(format!("{}.{question}({of})", texts.join("")));
                    }
                    Function::Length => return Spelled::whole(format!("{}.size()", texts[0])),
                    Function::Remainder => {
                        let text = format!("{}.size() % {}", texts[0], texts[1]);
                        return Spelled::new(text, Level::Product);
                    }
                    // These meshes have no isolated vertices.
                    Function::IsIsolated => return Spelled::whole("false"),
                    Function::IsFinite | Function::Builtin(_) | Function::Of(..) => "is_finite",
                };
                return Spelled::whole(self.support(name, texts));
            }
        };
        if builtin == Builtin::MixReal {
            let real = self.style.name("real");
            let text = format!("hedgerow::mix<{real}>({})", texts.join(", "));
            return Spelled::whole(text);
        }
        let [_, call] = spelled(builtin);
        let call = qualified("", &with_pointers(call, self.style));
        Spelled::whole(with_arguments(&call, &texts))
    }

    fn invoke(&self, name: &str, args: Vec<Spelled>) -> Spelled {
        let args = args.into_iter().map(|arg| arg.at(Level::Or));
        let args = args.collect::<Vec<_>>().join(", ");
        Spelled::whole(format!("hedgerow::{}({args})", invoked(name)))
    }

    fn operator(&self, operator: Binary, args: [Spelled; 2]) -> Spelled {
        let args = args.map(|arg| arg.at(Level::Or)).to_vec();
        let name = match operator {
            Binary::Div => "floor_div",
            Binary::Mod => "floor_mod",
            Binary::MultiplyVector => "multiply",
            _ => "equal",
        };
        Spelled::whole(self.support(name, args))
    }

    fn some(&self, indices: &IndexLoop, condition: &Term) -> Spelled {
        let condition = self.text(condition);
        let condition = format!("[&](std::size_t {}) {{ return {condition}; }}", indices.index);
        Spelled::whole(self.support("some", vec![indices.size.clone(), condition]))
    }

    fn fold(&self, fold: &Fold) -> Spelled {
        let mut all = self.all_around(fold.around, &fold.element);
        let head = format!("[&]({} {})", self.ty(fold.variable.ty), fold.variable.name);
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = self.support("only", vec![all, format!("{head} {{ return {filter}; }}")]);
        }
        let zero = match fold.ty {
            Type::Vec3 => self.support("vector", vec!["0, 0, 0".into()]),
            Type::Int => "0LL".into(),
            ty => format!("{}(0)", self.ty(ty)),
        };
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => {
                let body = spell(self, &fold.body);
                self.to_real(body).text
            }
            _ => self.text(&fold.body),
        };
        let mut reads = false;
        let variable = &fold.variable.name;
        fold.body.names(&mut |name| reads |= name == variable);
        let head = match reads {
            true => head,
            false => format!("[&]({})", self.ty(fold.variable.ty)),
        };
        let body = format!("{head} {{ return {body}; }}");
        let (name, args) = match fold.function {
            FoldFunction::Sum if is_wide(fold.ty) => {
                return Spelled::whole(self.total("total", fold.ty, &[all, body]));
            }
            FoldFunction::Mean if is_wide(fold.ty) => {
                return Spelled::whole(self.total("average", fold.ty, &[all, body]));
            }
            FoldFunction::Count => ("count", vec![all, body]),
            FoldFunction::Any => ("any", vec![all, body]),
            FoldFunction::All => ("all", vec![all, body]),
            FoldFunction::Sum => ("sum", vec![all, zero, body]),
            FoldFunction::Mean => ("mean", vec![all, zero, body]),
            FoldFunction::Min => ("least", vec![all, zero, body]),
            FoldFunction::Max => ("greatest", vec![all, zero, body]),
            FoldFunction::ArgMin => ("least_of", vec![all, body]),
            FoldFunction::ArgMax => ("greatest_of", vec![all, body]),
        };
        Spelled::whole(self.support(name, args))
    }
}

impl Printer<'_> {
    /// The elements around an element, as a list.
    pub(super) fn all_around(&self, around: Around, element: &Term) -> String {
        let element = self.text(element);
        let name = match around {
            Around::VertexHalfedges => "spokes",
            Around::VertexEdges => "edges_of_vertex",
            Around::VertexFaces => "faces_of_vertex",
            Around::VertexNeighbors => "neighbors",
            Around::FaceHalfedges => "halfedges",
            Around::FaceVertices => "vertices",
            Around::FaceEdges => "edges_of_face",
            Around::EdgeVertices => "ends",
            Around::EdgeFaces => "faces_of_edge",
        };
        self.support(name, vec![element])
    }
}
