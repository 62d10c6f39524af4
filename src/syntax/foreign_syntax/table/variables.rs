//! Variables of scripts and functions.

use super::{Line, TYPED, fixed, sure, told};
use crate::syntax::foreign_syntax::place::CODE;

const CHOSEN: &str = "a variable has a value from the beginning; an element is one of those there are: `var $n = argmin(length(e) for e in edges)`";
const BEGIN: &str = "a variable begins with `let`, or with `var` if it changes";

pub(super) const LINES: &[Line] = &[
    told(CODE, "^let/var $n : $t=vertex/halfedge/edge/face $:end", "", CHOSEN),
    told(CODE, "^$t=vertex/halfedge/edge/face $n $:end", "", CHOSEN),
    told(
        CODE,
        "^let/var $n : $t=vec2/vec3/vec4/mat3/mat4 $:end",
        "",
        "a variable has a value from the beginning: `var $n = $t(0)`",
    ),
    told(
        CODE,
        "^let/var $n : bool $:end",
        "",
        "a variable has a value from the beginning: `var $n = false`",
    ),
    told(
        CODE,
        "^let/var $n : $t:word $:end",
        "",
        "a variable has a value from the beginning: `var $n = 0`",
    ),
    told(CODE, "^let/var $n $:end", "", "a variable has a value from the beginning: `var $n = 0`"),
    told(
        CODE,
        "^let/var $a = $b = $l:line",
        "",
        "a statement sets one variable: `var $a = 0` and `var $b = 0`",
    ),
    told(
        CODE,
        "^let/var $a , $b = $l:line",
        "",
        "a statement sets one variable: `let $a = 0` and `let $b = 0`",
    ),
    sure(
        CODE,
        "^$w=let/var $a = $x:some , $b = $y:line",
        "$w $a = $x $w $b = $y",
        "a statement sets one variable",
    ),
    told(
        CODE,
        "^let/var $n = $s=vertices/edges/faces/halfedges/holes where $c:line",
        "",
        "a sequence is not a value: `count(c for x in $s)` counts, `for x in $s where c { … }` visits",
    ),
    sure(CODE, "^let mut $n", "var $n", "what changes is a `var`"),
    sure(CODE, "^$n : ~=", "let $n =", BEGIN),
    sure(CODE, "^const/auto/val/my/local/final/constexpr/static $n =", "let $n =", BEGIN),
    sure(
        CODE,
        "^$t=int/float/double/real/bool/vec2/vec3/vertex/edge/face/halfedge/size_t/unsigned/long/short/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Vec3/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $a = $x:some , $b = $y:line",
        "let $a: $t = $x let $b: $t = $y",
        "a statement sets one variable",
    ),
    sure(
        CODE,
        "^const/static/final/constexpr $t=int/float/double/real/bool/vec2/vec3/vertex/edge/face/halfedge/size_t/unsigned/long/short/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Vec3/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $n =",
        "let $n: $t =",
        BEGIN,
    ),
    sure(CODE, "^const/auto/val/static/final $t:word $n =", "let $n =", BEGIN),
    sure(CODE, "^const/auto & $n =", "let $n =", BEGIN),
    sure(
        CODE,
        "^$t=int/float/double/real/bool/vec2/vec3/vertex/edge/face/halfedge/size_t/unsigned/long/short/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Vec3/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $n =",
        "let $n: $t =",
        BEGIN,
    ),
    sure(
        CODE,
        "^$w=let/var $t=int/float/double/real/bool/vec2/vec3/vertex/edge/face/halfedge/string/text $n =",
        "$w $n: $t =",
        TYPED,
    ),
    told(
        CODE,
        "^$t=int/float/double/real/bool/vec3/string $n $:end",
        "",
        "a variable has a value from the beginning: `var $n = 0`",
    ),
    fixed(
        CODE,
        "^$x:operand + ~+",
        "$x = $x",
        "$x = $x + 1",
        "a change is written out: `$x = $x + 1`",
    ),
    fixed(
        CODE,
        "^+ ~+ $x:operand",
        "$x = $x",
        "$x = $x + 1",
        "a change is written out: `$x = $x + 1`",
    ),
    fixed(
        CODE,
        "^$x:operand - ~- $:end",
        "$x = $x",
        "$x = $x - 1",
        "a change is written out: `$x = $x - 1`",
    ),
    fixed(
        CODE,
        "^- ~- $x:operand $:end",
        "$x = $x",
        "$x = $x - 1",
        "a change is written out: `$x = $x - 1`",
    ),
    fixed(CODE, "^- ~- $l:line", "", "// $l", "a comment begins with `//`"),
    fixed(
        CODE,
        "^$a . $b:word $o=+/- ~= ( $x:inside , $y:inside , $z:inside ) $:end",
        "$a.$b = $x",
        "$a.$b = $a.$b $o vec3($x, $y, $z)",
        "a change is written out: `$a.$b = $a.$b $o …`",
    ),
    fixed(
        CODE,
        "^$x:operand $o=+/-/*// ~= $v:line",
        "$x = $v",
        "$x = $x $o ($v)",
        "a change is written out: `$x = $x $o …`",
    ),
    fixed(
        CODE,
        "^$x:operand % ~= $v:line",
        "$x = $v",
        "$x = $x mod ($v)",
        "a change is written out: `$x = $x mod …`",
    ),
    fixed(
        CODE,
        "^$x:operand &&/& ~= $v:line",
        "$x = $v",
        "$x = $x and ($v)",
        "a change is written out: `$x = $x and …`",
    ),
    fixed(
        CODE,
        "^$x:operand | ~| ~= $v:line",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    fixed(
        CODE,
        "^$x:operand | ~= $v:line",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    told(CODE, "+/-/*// ~= $v:line", "= $v", "a change is written out: `x = x + 1`"),
];
