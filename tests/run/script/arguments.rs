//! Values for parameters.

use super::*;
use hedgerow::diagram::Type;
use hedgerow::mesh::{ElementKind, shape};
use hedgerow::run::Argument;

const SCRIPT: &str = "script main(
    size: int, scale: real = 2 * size, yes: bool = size > 3, at: vec3 = vec3(scale, 0, 0)
) {
    print size, scale, yes, at
}";

#[test]
fn defaults_are_evaluated_in_order() {
    let cases: [(&[(&str, &str)], &str); 4] = [
        (&[("size", "4")], "4 8 true (8, 0, 0)"),
        (&[("scale", "0.5"), ("size", "1")], "1 0.5 false (0.5, 0, 0)"),
        (&[("size", "1"), ("yes", "true")], "1 2 true (2, 0, 0)"),
        (&[("size", "1"), ("at", "1,2,3")], "1 2 false (1, 2, 3)"),
    ];
    for (arguments, line) in cases {
        let (_, lines) = try_run(&mut shape::cube(), SCRIPT, arguments).unwrap();
        assert_eq!(lines, [line]);
    }
}

#[test]
fn wrong_arguments_are_told() {
    let (_, analysis) = analyse(SCRIPT);
    let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap();
    let errors = |arguments: &[(&str, &str)]| -> Vec<String> {
        let own = |&(name, text): &(&str, &str)| (name.to_owned(), text.to_owned());
        let texts: Vec<_> = arguments.iter().map(own).collect();
        let errors = prepared.arguments(&texts).unwrap_err();
        errors.into_iter().map(|error| error.message).collect()
    };
    assert_eq!(errors(&[]), ["`size` of `main` has no value"]);
    assert_eq!(
        errors(&[("size", "x"), ("sise", "3")]),
        ["`size` cannot be `x`", "`main` has no parameter `sise`"]
    );
    assert_eq!(
        errors(&[("size", "1"), ("size", "2")]),
        ["`size` of `main` is given more than once"]
    );
    let values = |value| [("size".to_owned(), value)];
    let mut mesh = shape::cube();
    let failed = run(&prepared, &mut mesh, &values(Argument::Real(1.0)), &mut Lines::default());
    assert_eq!(
        failed.unwrap_err().diagnostic.message,
        "`size` is of type `int`, but the value given is of type `real`"
    );
    let failed = run(&prepared, &mut mesh, &[], &mut Lines::default());
    assert_eq!(failed.unwrap_err().diagnostic.code, "missing-argument");
}

#[test]
fn texts_become_values_of_their_type() {
    let good = [
        ("true", Argument::Bool(true)),
        ("-12", Argument::Int(-12)),
        ("12", Argument::Real(12.0)),
        ("1e-3", Argument::Real(0.001)),
        ("1, 2,-3", Argument::Reals(Type::Vec3, vec![1.0, 2.0, -3.0])),
        ("(1,2)", Argument::Reals(Type::Vec2, vec![1.0, 2.0])),
        ("7", Argument::Element(ElementKind::Edge, 7)),
        ("hello", Argument::Text("hello".to_owned())),
    ];
    for (text, value) in good {
        assert_eq!(Argument::parse(text, value.ty()), Some(value));
    }
    for (text, ty) in [
        ("yes", Type::Bool),
        ("1.5", Type::Int),
        ("99999999999999999999", Type::Int),
        ("inf", Type::Real),
        ("NaN", Type::Real),
        ("", Type::Real),
        ("1,2", Type::Vec3),
        ("1,2,3,4", Type::Vec3),
        ("(1,2,3", Type::Vec3),
        ("-1", Type::Face),
    ] {
        assert_eq!(Argument::parse(text, ty), None, "{text}");
    }
}
