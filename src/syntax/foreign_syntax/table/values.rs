//! Values: what is read, called and computed.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, HEAD, PARTS};

const SIDES: &str = "an op is drawn: `before { … }` is what it finds, `after { … }` what it leaves";
const EXISTS: &str =
    "no element is missing: beyond a boundary is a hole, `hole(h.face)`, `boundary(v)`";
const AGGREGATE: &str =
    "what holds stands in front: `count(boundary(e) for e in edges)`, likewise `any` and `all`";
const COMPONENT: &str = "a component of a vector is `p.x`, `p.y`, `p.z`";
const CALLED: &str = "what is called stands in front: `degree(v)`, `flip(e)`";
const ALONE: &str = "functions and constants stand alone: `sqrt(x)`, `pi`";
const SIZE: &str = "the size is `abs(x)` of a number, `length(p)` of a vector";
const POINTER: &str = "what is read behind a dot has no parentheses: `.$p`";

/// A pattern of a value, with what can stand before it.
macro_rules! behind {
    ($value:literal) => {
        concat!(
            "$b=(/,/=/+/-/{/}/return/not/and/or/if/while/where/by/require/print/assert/else/</>/<=/>=/==/!= ",
            $value
        )
    };
}

pub(super) const LINES: &[Line] = &[
    told(CODE | PARTS, "is not $b=None/null/nil/nullptr/NULL", "!= true", EXISTS),
    told(CODE | PARTS, "is $b=None/null/nil/nullptr/NULL", "!= true", EXISTS),
    sure(CODE | PARTS, "is not $b:word", "!= $b", "`is not` is written `!=`"),
    sure(CODE | PARTS, "is $b:word", "== $b", "`is` is written `==`"),
    sure(CODE | PARTS, "is not $b:number", "!= $b", "`is not` is written `!=`"),
    sure(CODE | PARTS, "is $b:number", "== $b", "`is` is written `==`"),
    told(
        CODE | PARTS,
        "not in $s:word",
        "!= true",
        "whether something is in a sequence is asked by `any(x == e for x in $s)`",
    ),
    told(
        CODE,
        "^if $x in $s=edges/vertices/faces/halfedges/holes {",
        "if true {",
        "whether something is in a sequence is asked by `any(y == x for y in $s)`",
    ),
    told(
        CODE | PARTS,
        "new $f=Vertex/Edge/Face/Halfedge/HalfEdge/vertex/edge/face/halfedge ( $a:inside )",
        "true",
        "elements are made by operations: `let m = must split(e)`; a drawing lists what is new, `new m`",
    ),
    sure(CODE | PARTS, "new $f:word (", "$f(", "a value is made without `new`"),
    fixed(
        CODE | PARTS,
        "mesh . $s=vertices/edges/faces/halfedges/holes ( )",
        "$s",
        "$s",
        "a script has one mesh, which has no name: `$s` are its own",
    ),
    fixed(
        CODE | PARTS,
        "mesh -> $s=vertices/edges/faces/halfedges/holes ( )",
        "$s",
        "$s",
        "a script has one mesh, which has no name: `$s` are its own",
    ),
    sure(
        CODE | PARTS,
        "mesh ./-> $f:word ( $x:inside )",
        "$f($x)",
        "a script has one mesh, which has no name: `$f(…)`",
    ),
    fixed(
        CODE | PARTS,
        "$s=vertices/edges/faces/halfedges/holes . size/count/length/len ( )",
        "$s",
        "count($s)",
        "a sequence is counted by `count($s)`",
    ),
    sure(
        CODE | PARTS,
        "$s=vertices/edges/faces/halfedges/holes ( ) {",
        "$s {",
        "a sequence stands without parentheses",
    ),
    sure(
        CODE | PARTS,
        ". $p=next/twin/prev/vertex/edge/face/halfedge/target/position/vertices/edges/faces/halfedges/neighbors ~( )",
        ".$p",
        POINTER,
    ),
    sure(
        CODE | PARTS,
        "~-> ~$p=next/twin/prev/vertex/edge/face/halfedge/target/position/vertices/edges/faces/halfedges/neighbors ~( )",
        ".$p",
        POINTER,
    ),
    sure(
        CODE | PARTS,
        "~-> ~$p=next/twin/prev/vertex/edge/face/halfedge/target/position/vertices/edges/faces/halfedges/neighbors",
        ".$p",
        "a pointer is read behind a dot: `.$p`",
    ),
    told(
        CODE | PARTS,
        "~-> ~$p:word",
        ".$p",
        "what belongs to an element stands behind a dot, `.$p`; what is called stands in front, `$p(…)`",
    ),
    sure(
        CODE | PARTS | HEAD,
        behind!("math/Math/np/numpy/std/glm/Mathf . $f:word ~( $x:inside )"),
        "$b $f($x)",
        ALONE,
    ),
    sure(
        CODE | PARTS | HEAD,
        "math/Math/np/numpy/std/glm/Mathf . $f:word ~( $x:inside )",
        "$f($x)",
        ALONE,
    ),
    sure(
        CODE | PARTS | HEAD,
        behind!("$x:owner . $f=adjacent/distance/dot/cross/angle ~( $y:inside )"),
        "$b $f($x, $y)",
        CALLED,
    ),
    sure(
        CODE | PARTS | HEAD,
        behind!(
            "$x:owner . $f=degree/length/area/normal/centroid/midpoint/boundary/hole/dihedral_angle/angle/cotangent/normalize ~( )"
        ),
        "$b $f($x)",
        CALLED,
    ),
    fixed(
        CODE | PARTS | HEAD,
        behind!("$x:owner . is_boundary/on_boundary/is_border/is_on_boundary/isBoundary ~( )"),
        "$b $x",
        "$b boundary($x)",
        CALLED,
    ),
    fixed(
        CODE | PARTS | HEAD,
        behind!("$x:owner . valence/valency ~( )"),
        "$b $x",
        "$b degree($x)",
        CALLED,
    ),
    fixed(
        CODE | PARTS | HEAD,
        behind!("$x:owner . norm/magnitude ~( )"),
        "$b $x",
        "$b length($x)",
        CALLED,
    ),
    fixed(
        CODE | PARTS | HEAD,
        behind!("$x:owner . normalized ~( )"),
        "$b $x",
        "$b normalize($x)",
        CALLED,
    ),
    sure(CODE | PARTS, "$r=random . random/rand/uniform ~( $x:inside )", "$r($x)", CALLED),
    told(CODE | PARTS, ". $f:word ~( $x:inside )", "", CALLED),
    fixed(CODE | PARTS, ". $f=position ~[ 0 ]", ".$f", ".$f.x", COMPONENT),
    fixed(CODE | PARTS, ". $f=position ~[ 1 ]", ".$f", ".$f.y", COMPONENT),
    fixed(CODE | PARTS, ". $f=position ~[ 2 ]", ".$f", ".$f.z", COMPONENT),
    fixed(
        CODE | PARTS,
        "any/exists/some ( $x in $s:part where/,/:/| $c:inside )",
        "true",
        "any($c for $x in $s)",
        AGGREGATE,
    ),
    fixed(
        CODE | PARTS,
        "all/forall/every ( $x in $s:part where/,/:/| $c:inside )",
        "true",
        "all($c for $x in $s)",
        AGGREGATE,
    ),
    fixed(
        CODE | PARTS,
        "count ( $x in $s:part where/,/:/|/if $c:inside )",
        "true",
        "count($c for $x in $s)",
        AGGREGATE,
    ),
    told(
        CODE | PARTS,
        "count ( $s=vertices/edges/faces/halfedges/holes where $c:inside )",
        "true",
        AGGREGATE,
    ),
    told(
        CODE | PARTS,
        "$f=sum/mean/min/max/argmin/argmax ( $x in $s:inside )",
        "true",
        "an aggregate is `$f(length(e) for e in edges)`",
    ),
    told(
        CODE | PARTS,
        "$f=sum/mean/min/max/argmin/argmax/any/all/count ( $g ( $b:inside ) in $s:inside )",
        "true",
        "an aggregate is `$f(length(e) for e in edges)`",
    ),
    told(
        CODE | PARTS,
        "$f=min/max ( $s:some , key = $k:word )",
        "true",
        "the element itself is `arg$f($k(x) for x in $s)`",
    ),
    told(
        CODE,
        "$f ~( $n =/: $v:inside )",
        "true",
        "arguments have no names: they stand in their order, `$f(x, y)`",
    ),
    told(
        CODE,
        "$f ~( $a:bound , $n =/: $v:inside )",
        "true",
        "arguments have no names: they stand in their order, `$f(x, y)`",
    ),
    told(
        CODE | PARTS,
        "$f=any/all/count/sum/mean/min/max/argmin/argmax ( $s:bound , $x => $b:inside )",
        "true",
        "an aggregate is `$f($b for $x in $s)`",
    ),
    told(
        CODE | PARTS,
        "$f=any/all/count/sum/mean/min/max/argmin/argmax ( $s:bound , lambda $x : $b:inside )",
        "true",
        "an aggregate is `$f($b for $x in $s)`",
    ),
    told(
        CODE,
        "( $t=int/float/double/real ) $n",
        "true",
        "an int stands wherever a real is wanted; `round(x)` makes an int",
    ),
    told(
        CODE,
        "( $t=int/float/double/real ) $n:number",
        "true",
        "an int stands wherever a real is wanted; `round(x)` makes an int",
    ),
    sure(
        CODE | PARTS,
        "( [ $b:inside for $n in $s:inside ] )",
        "($b for $n in $s)",
        "there are no lists: `sum(x for e in edges)` has no brackets",
    ),
    told(
        CODE | PARTS,
        "= [ $a:inside ]",
        "= true",
        "there are no lists; a vector is `vec3(x, y, z)`",
    ),
    told(
        CODE | PARTS,
        "= { $a:inside }",
        "= true",
        "there are no lists and tables; values are kept at elements, `attr weight: edge real`",
    ),
    told(
        CODE | PARTS,
        "= lambda $x:line",
        "= true",
        "functions have names: `fn name(x: real) { … }`",
    ),
    told(CODE | PARTS, "= | $x:value | $:end", "= $x", SIZE),
    told(CODE | PARTS, "= | $x:value | $o=+/-/*//", "= $x $o", SIZE),
    told(
        CODE | PARTS,
        "$b==/(/, | $x:part | $l:line",
        "$b true",
        "functions have names: `fn name(x: real) { … }`",
    ),
    told(
        CODE | PARTS,
        "= $x => $l:line",
        "= true",
        "functions have names: `fn name(x: real) { … }`",
    ),
    told(
        CODE | PARTS,
        "$b=+/-/*/{/return/print/and/or/not/if/while/where/by/assert/require/</>/<=/>=/==/!= | $x:value |",
        "$b $x",
        SIZE,
    ),
    sure(CODE | PARTS, "=>", ">=", "`{}` is written `>=`"),
    told(CODE | PARTS, "null/None/nullptr/nil", "true", EXISTS),
    told(PARTS, "^face/edge/vertex/hole/loop $n : $l:line", "", SIDES),
];
