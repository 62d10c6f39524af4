//! Functions in Rust and C++, side by side.
//!
//! `{0}` stands for the first argument. In C++ `[{0}.halfedge]` is a pointer, spelled as the style
//! reads it, and a support function is called by its name alone, as in Rust.

use super::spelled::{Level, Spelled};
use super::wide;
use crate::diagram::{Binary, Builtin};
use crate::emit::term::{Around, Function};

/// The call of a function in Rust and in C++; empty for what is not emitted, or as an operator.
pub(super) fn spelled(function: Function) -> [&'static str; 2] {
    match function {
        Function::Builtin(builtin) => builtin_call(builtin),
        Function::Of(operation, ty) => wide::spelled(operation, ty),
        Function::InOrderAlongLoop => {
            ["in_order_along_loop(mesh, {0}, {1}, {2})", "in_order_along_loop({0}, {1}, {2})"]
        }
        Function::InOrderAroundVertex => {
            ["in_order_around_vertex(mesh, {0}, {1}, {2})", "in_order_around_vertex({0}, {1}, {2})"]
        }
        Function::AllDiffer => ["all_differ(&{0})", "all_differ({0})"],
        Function::IsFinite => ["{0}.is_finite()", "is_finite({0})"],
        // The meshes of C++ have no isolated vertices.
        Function::IsIsolated => ["mesh.vertex_halfedge({0}).is_none()", "false"],
        Function::LoopFrom => ["mesh.loop_from({0}).collect::<Vec<_>>()", "loop_from({0})"],
        Function::SpokesFrom => ["mesh.spokes_from({0}).collect::<Vec<_>>()", "spokes_from({0})"],
        Function::Every => [
            "{0}.iter().skip({1}).step_by({2}).copied().collect::<Vec<_>>()",
            "every({0}, {1}, {2})",
        ],
        Function::Rotated => ["turned({0}, {1})"; 2],
        Function::Length => ["{0}.len()", "{0}.size()"],
        Function::Remainder => ["{0}.len() % {1}", "{0}.size() % {1}"],
        Function::AllInOrderAlongLoop => {
            ["all_in_order_along_loop(mesh, &{0})", "all_in_order_along_loop({0})"]
        }
        Function::AllInOrderAroundVertex => {
            ["all_in_order_around_vertex(mesh, &{0})", "all_in_order_around_vertex({0})"]
        }
        Function::OfPreview(_) => [""; 2],
    }
}

/// The call for an operator in Rust and in C++; empty where it stands between its sides.
pub(super) fn operator(operator: Binary) -> [&'static str; 2] {
    match operator {
        // Rounded down: Euclidean division does so only for a positive divisor.
        Binary::Div => [
            "({0} / {1} - i64::from({0} % {1} != 0 && ({0} < 0) != ({1} < 0)))",
            "floor_div({0}, {1})",
        ],
        Binary::Mod => ["(({0} % {1} + {1}) % {1})", "floor_mod({0}, {1})"],
        Binary::MultiplyVector => ["", "multiply({0}, {1})"],
        Binary::EqualVector => ["", "equal({0}, {1})"],
        _ => [""; 2],
    }
}

/// The call for the elements around an element in Rust and in C++.
pub(super) fn around(around: Around) -> [&'static str; 2] {
    match around {
        Around::VertexHalfedges => ["mesh.spokes({0})", "spokes({0})"],
        Around::VertexEdges => ["mesh.spokes({0}).map(|h| mesh.edge(h))", "edges_of_vertex({0})"],
        Around::VertexFaces => [
            "mesh.spokes({0}).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f))",
            "faces_of_vertex({0})",
        ],
        Around::VertexNeighbors => ["mesh.neighbors({0})", "neighbors({0})"],
        Around::FaceHalfedges => ["mesh.face_halfedges({0})", "halfedges({0})"],
        Around::FaceVertices => ["mesh.face_vertices({0})", "vertices({0})"],
        Around::FaceEdges => {
            ["mesh.face_halfedges({0}).map(|h| mesh.edge(h))", "edges_of_face({0})"]
        }
        Around::EdgeVertices => [
            "[mesh.edge_halfedge({0}), mesh.twin(mesh.edge_halfedge({0}))].into_iter().map(|h| mesh.vertex(h))",
            "ends({0})",
        ],
        Around::EdgeFaces => [
            "[mesh.edge_halfedge({0}), mesh.twin(mesh.edge_halfedge({0}))].into_iter().map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f))",
            "faces_of_edge({0})",
        ],
    }
}

fn builtin_call(builtin: Builtin) -> [&'static str; 2] {
    match builtin {
        Builtin::DegreeVertex => ["mesh.degree({0}) as i64", "degree({0})"],
        Builtin::DegreeFace => ["mesh.face_size({0}) as i64", "sides({0})"],
        Builtin::BoundaryVertex => ["mesh.is_boundary_vertex({0})", "on_boundary({0})"],
        Builtin::BoundaryHalfedge => ["mesh.is_boundary_halfedge({0})", "[{0}.face.boundary]"],
        Builtin::BoundaryEdge => ["mesh.is_boundary_edge({0})", "is_boundary_edge({0})"],
        Builtin::IsHole => ["mesh.is_hole({0})", "[{0}.boundary]"],
        Builtin::Adjacent => ["mesh.adjacent({0}, {1})", "adjacent({0}, {1})"],
        Builtin::LinkCondition => ["mesh.link_condition({0})", "link_condition({0})"],
        Builtin::StarShaped => ["mesh.kernel_centroid({0}).is_some()", "star_shaped({0})"],
        Builtin::KernelCentroid => {
            ["mesh.kernel_centroid({0}).unwrap_or(DVec3::NAN)", "kernel_centroid({0})"]
        }
        Builtin::AngleCorner => ["corner_angle(mesh, {0})", "corner_angle({0})"],
        Builtin::Cotangent => ["cotangent(mesh, {0})", "cotangent({0})"],
        Builtin::DihedralAngle => ["dihedral_angle(mesh, {0})", "dihedral_angle({0})"],
        Builtin::LengthEdge => ["mesh.length({0})", "length(edge_vector([{0}.halfedge]))"],
        Builtin::LengthHalfedge => ["mesh.vector({0}).length()", "length(edge_vector({0}))"],
        Builtin::LengthVector => ["DVec3::length({0})", "length({0})"],
        Builtin::Area => ["mesh.area({0})", "length(vector_area({0}))"],
        Builtin::NormalFace => ["mesh.normal({0})", "normalize(vector_area({0}))"],
        Builtin::NormalVertex => ["mesh.vertex_normal({0})", "vertex_normal({0})"],
        Builtin::CentroidFace => ["mesh.centroid({0})", "centroid({0})"],
        Builtin::CentroidEdge => [
            "mesh.position(mesh.vertex(mesh.edge_halfedge({0}))).lerp(mesh.position(mesh.target(mesh.edge_halfedge({0}))), 0.5)",
            "midpoint({0})",
        ],
        Builtin::MixReal => {
            ["{0} * (1.0 - {2}) + {1} * {2}", "hedgerow::mix<$real>({0}, {1}, {2})"]
        }
        Builtin::MixVector => ["DVec3::lerp({0}, {1}, {2})", "mix({0}, {1}, {2})"],
        Builtin::Dot => ["DVec3::dot({0}, {1})", "dot({0}, {1})"],
        Builtin::Cross => ["DVec3::cross({0}, {1})", "cross({0}, {1})"],
        Builtin::Normalize => ["direction({0})", "normalize({0})"],
        Builtin::Distance => ["DVec3::distance({0}, {1})", "length({0} - {1})"],
        Builtin::Angle => ["angle({0}, {1})", "angle({0}, {1})"],
        Builtin::AbsInt => ["i64::abs({0})", "std::llabs({0})"],
        Builtin::AbsReal => ["f64::abs({0})", "std::fabs({0})"],
        Builtin::MinInt => ["i64::min({0}, {1})", "std::min<long long>({0}, {1})"],
        Builtin::MaxInt => ["i64::max({0}, {1})", "std::max<long long>({0}, {1})"],
        Builtin::MinReal => ["f64::min({0}, {1})", "std::fmin({0}, {1})"],
        Builtin::MaxReal => ["f64::max({0}, {1})", "std::fmax({0}, {1})"],
        Builtin::Sqrt => ["f64::sqrt({0})", "std::sqrt({0})"],
        Builtin::Sin => ["f64::sin({0})", "std::sin({0})"],
        Builtin::Cos => ["f64::cos({0})", "std::cos({0})"],
        Builtin::Tan => ["f64::tan({0})", "std::tan({0})"],
        Builtin::Asin => ["f64::asin({0})", "std::asin({0})"],
        Builtin::Acos => ["f64::acos({0})", "std::acos({0})"],
        Builtin::Atan2 => ["f64::atan2({0}, {1})", "std::atan2({0}, {1})"],
        Builtin::Exp => ["f64::exp({0})", "std::exp({0})"],
        Builtin::Log => ["f64::ln({0})", "std::log({0})"],
        Builtin::Pow => ["f64::powf({0}, {1})", "std::pow({0}, {1})"],
        Builtin::Floor => ["f64::floor({0})", "std::floor({0})"],
        Builtin::Ceil => ["f64::ceil({0})", "std::ceil({0})"],
        Builtin::Round => {
            ["f64::round_ties_even({0}) as i64", "static_cast<long long>(std::nearbyint({0}))"]
        }
        Builtin::IsNan => ["f64::is_nan({0})", "std::isnan({0})"],
        Builtin::IsFinite => ["f64::is_finite({0})", "std::isfinite({0})"],
        // They depend on the type of their arguments, or are not emitted.
        Builtin::CrossPlane
        | Builtin::Diagonal
        | Builtin::UpperLeft
        | Builtin::Outer
        | Builtin::Transpose
        | Builtin::Inverse
        | Builtin::Determinant
        | Builtin::Solve
        | Builtin::Random
        | Builtin::RandomInt => [""; 2],
    }
}

/// A call with its arguments filled in. They bind as tightly as `level`, or as their place
/// requires.
pub(super) fn with_arguments(call: &str, args: &[Spelled], level: Level) -> String {
    let mut parts = call.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let argument = part.split_once('}').and_then(|(number, rest)| {
            let argument = args.get(number.parse::<usize>().ok()?)?;
            Some((argument.clone(), rest))
        });
        match argument {
            Some((argument, rest)) => {
                let level = match () {
                    () if rest.starts_with(['.', '[']) || text.ends_with('-') => Level::Whole,
                    () if text.ends_with("- ") => Level::Product,
                    () => level,
                };
                text.push_str(&argument.at(level));
                text.push_str(rest);
            }
            None => text.extend(["{", part]),
        }
    }
    text
}
