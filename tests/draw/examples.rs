//! The examples' pictures.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use hedgerow::draw::{COLUMNS, draw_op, draw_sheet, text_op};

use super::{check_apart, example_ops, folder, ops_of, overlap, shipped_ops, steps};

#[test]
fn pictures_are_as_committed() {
    let update = std::env::var_os("UPDATE").is_some();
    let mut names = BTreeSet::new();
    for (stem, op) in [example_ops(), steps::shipped()].concat() {
        let name = match op.name == stem {
            true => stem,
            false => format!("{stem}-{}", op.name),
        };
        for (end, drawn) in [("svg", draw_sheet(&op).svg()), ("txt", text_op(&op, COLUMNS))] {
            let name = format!("{name}.{end}");
            let path = folder("examples/pictures").join(&name);
            if update {
                fs::write(&path, &drawn).expect("a writable folder");
            }
            let committed = fs::read_to_string(&path).unwrap_or_default();
            assert!(
                committed == drawn,
                "{name} is not as committed: run with UPDATE=1 and look at it"
            );
            names.insert(name);
        }
    }
    for entry in fs::read_dir(folder("examples/pictures")).expect("the pictures") {
        let name = entry.expect("a readable entry").file_name();
        let name = name.to_string_lossy().into_owned();
        assert!(names.contains(&name), "{name} is a picture of nothing");
    }
}

#[test]
fn every_named_element_has_an_id_and_a_title() {
    let mut seen = 0;
    for (_, op) in example_ops() {
        let svg = draw_op(&op).svg();
        for rule in &op.rules {
            let rule = rule.to_draw();
            let label = rule.label.as_ref().map(|label| format!("{label}-"));
            for name in rule.names.iter().filter(|name| name.named) {
                let word = name.text.replace('-', "-minus-").replace('+', "-plus-");
                let word = word.replace('\'', "-prime");
                let word = word.replace('[', "-").replace(']', "");
                let id = |side| {
                    let label = label.as_deref().unwrap_or("");
                    format!("id=\"{}-{label}{side}-{word}\"", op.name)
                };
                let drawn = svg.contains(&id("before")) || svg.contains(&id("after"));
                assert!(drawn, "{} does not show `{}`", op.name, name.text);
                let title = format!("<title>{} {}, ", name.kind.word(), name.text);
                assert!(svg.contains(&title), "{}: no title {title}", op.name);
                seen += 1;
            }
        }
        let ids = svg.split(" id=\"").skip(1).map(|part| part.split('"').next());
        let ids: Vec<_> = ids.collect();
        let once: BTreeSet<_> = ids.iter().collect();
        assert_eq!(ids.len(), once.len(), "an id of {} stands twice", op.name);
    }
    assert!(seen > 100);
}

#[test]
fn no_two_texts_overlap() {
    let mut pairs = 0;
    for (stem, op) in [example_ops(), steps::shipped()].concat() {
        let picture = draw_op(&op);
        let texts = picture.texts();
        pairs += check_apart(texts, &format!("{stem}::{}", op.name));
        for a in texts {
            let [width, height] = picture.size();
            let inside =
                a.from[0] >= 0.0 && a.from[1] >= 0.0 && a.to[0] <= width && a.to[1] <= height;
            assert!(inside, "{stem}::{}: `{}` lies outside", op.name, a.text);
        }
    }
    assert!(pairs > 1000);
}

#[test]
fn no_two_edges_cross() {
    for (stem, op) in [example_ops(), steps::shipped()].concat() {
        assert_eq!(draw_op(&op).crossings(), 0, "{stem}::{}", op.name);
    }
}

/// The inverse of a collapse: the two new triangles open beside the vertex that is split.
#[test]
fn a_split_vertex_opens() {
    let ops = super::ops_of(
        "op split(a: halfedge, b: halfedge) -> w {
          before {
            vertex v: a *S b *T
            edge ea: a | a'
            edge eb: b | b'
            face f0: v -a-> p -c0-> r -c1-> v
            face f1: v -b-> q -d0-> s -d1-> v
          }
          after {
            new w x x' ex y y' z z' e2 e3 f g
            face f0: w -a-> p -c0-> r -c1-> w
            face f1: v -b-> q -d0-> s -d1-> v
            face f: w -x'-> v -z-> p -y-> w
            face g: v -x-> w -z'-> q -y'-> v
            edge ex: x | x'
            edge ea: a | y
            edge eb: b | y'
            edge e2: z | a'
            edge e3: z' | b'
            vertex w: a *S z' x'
            vertex v: b *T z x
            w.position = v.position + vec3(0.1, 0, 0)
          }
        }",
    );
    let picture = draw_op(&ops[0]);
    assert_eq!(picture.crossings(), 0);
    // Those of `after` come last.
    let texts = picture.texts();
    let at = |name: &str| {
        let text = texts.iter().rfind(|text| text.text == name).expect("a name of `after`");
        [0, 1].map(|axis| (text.from[axis] + text.to[axis]) / 2.0)
    };
    assert!(at("q")[0] < at("g")[0] && at("g")[0] < at("f")[0] && at("f")[0] < at("p")[0]);
    assert!(at("w")[1] < at("f")[1] && at("f")[1] < at("s")[1]);
}

#[test]
fn drawing_twice_is_drawing_once() {
    for (_, op) in example_ops() {
        assert_eq!(draw_op(&op).svg(), draw_op(&op).svg());
    }
}

#[test]
fn pictures_of_the_library_can_be_read() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for (stem, op) in shipped_ops() {
        let (picture, name) = (draw_op(&op), format!("{stem}::{}", op.name));
        assert_eq!(draw_sheet(&op).texts().len(), picture.texts().len(), "{name}");
        if let Some(folder) = std::env::var_os("PICTURES") {
            let path = Path::new(&folder).join(format!("{stem}-{}", op.name));
            for (end, svg) in [("svg", picture.svg()), ("small.svg", picture.compact_svg())] {
                fs::write(path.with_extension(end), svg).expect("a folder");
            }
        }
        seen += 1;
        let texts = picture.texts();
        for (at, a) in texts.iter().enumerate() {
            if let Some(b) = texts[..at].iter().find(|b| overlap(a, b)) {
                wrong.push(format!("{name}: `{}` covers `{}`", a.text, b.text));
            }
        }
        // An editor shows base64 in a hover, and no more than 70,000 letters of it.
        let letters = picture.compact_svg().len() * 4 / 3;
        if letters >= 70_000 {
            wrong.push(format!("{name}: {letters} letters"));
        }
    }
    assert!(seen > 30, "only {seen} operations");
    assert_eq!(wrong, Vec::<String>::new());
}

/// Words as names have room beside their own arrows.
#[test]
fn long_names_stand_at_their_arrows() {
    let flip = "op turn(e: edge) {
      before {
        face left_face: start -along-> end -upper_right-> top -upper_left-> start
        face right_face: end -back-> start -lower_left-> bottom -lower_right-> end
        edge e: along | back
      }
      after {
        face left_face: bottom -along-> top -upper_left-> start -lower_left-> bottom
        face right_face: top -back-> bottom -lower_right-> end -upper_right-> top
        edge e: along | back
      }
    }";
    let ops = ops_of(flip);
    let picture = draw_op(&ops[0]);
    let texts = picture.texts();
    for half in ["upper", "lower"] {
        let [left, right] = ["left", "right"].map(|side| {
            let name = format!("{half}_{side}");
            texts.iter().filter(move |text| text.text == name)
        });
        let pairs: Vec<_> = left.zip(right).collect();
        assert_eq!(pairs.len(), 2, "before and after");
        for (left, right) in pairs {
            assert!(left.to[0] < right.from[0], "{half}: {left:?}, {right:?}");
        }
    }
}

/// Names in other alphabets differ: Greek letters have outlines, others are texts.
#[test]
fn names_in_other_alphabets_can_be_read() {
    let ops = ops_of(
        "op größe(ε: edge) {
          before {
            face φ: α -η-> β -θ-> γ -ξ-> α
            face 面: β -辺-> α -半-> δ -π-> β
            edge ε: η | 辺
          }
          after {
            face φ: δ -η-> γ -ξ-> α -半-> δ
            face 面: γ -辺-> δ -π-> β -θ-> γ
            edge ε: η | 辺
          }
        }",
    );
    let picture = draw_op(&ops[0]);
    for svg in [picture.svg(), picture.compact_svg()] {
        let letters = svg.split("</defs>").next().expect("definitions");
        let outlines = letters.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
        let outlines: Vec<_> = outlines.collect();
        let once: BTreeSet<_> = outlines.iter().collect();
        assert_eq!(outlines.len(), once.len(), "{letters}");
        assert!(letters.contains(">面</text>"), "{letters}");
    }
}

#[test]
fn a_picture_is_an_image() {
    for (_, op) in example_ops().into_iter().take(3) {
        let image = draw_op(&op).png(1.0).expect("small enough");
        assert!(image.starts_with(b"\x89PNG"));
        assert!(draw_op(&op).png(1e9).is_err());
    }
}

#[test]
fn text_drawings_are_whole_and_fit_into_a_terminal() {
    let mut stacked = 0;
    for (stem, op) in shipped_ops() {
        let text = text_op(&op, COLUMNS);
        let is_told =
            |line: &&str| ["new ", "erase ", &op.name].iter().any(|of| line.starts_with(of));
        for line in text.lines().filter(|line| !is_told(line)) {
            let name = format!("{stem}::{}\n{text}", op.name);
            assert!(line.chars().count() <= 100, "wide: {name}");
            assert!(line.is_empty() || line.starts_with(' '), "cut off: {name}");
        }
        stacked += usize::from(text.lines().any(|line| line.trim() == "=>"));
    }
    assert!(stacked > 2, "only {stacked} have their sides one below the other");
}
