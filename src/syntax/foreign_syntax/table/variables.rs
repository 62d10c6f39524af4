//! Variables of scripts and functions.

use super::{Line, TYPED, fixed, sure, told};
use crate::syntax::foreign_syntax::place::CODE;

const CHOSEN: &str = "a variable has a value from the beginning; an element is one of those there are: `var $n = argmin(length(e) for e in edges)`";
const MORE: &str = "a change is written out: `$x = $x + 1`";
const LESS: &str = "a change is written out: `$x = $x - 1`";
const COMMENT: &str = "a comment begins with `//`";
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
        "^let/var $n : real $:end",
        "",
        "a variable has a value from the beginning: `var $n = 0.0`",
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
        "^$t=int/float/double/real/bool/vec2/vec3/size_t/unsigned/long/short/Vec3 $a = $x:some , $b = $y:line",
        "let $a: $t = $x let $b: $t = $y",
        "a statement sets one variable",
    ),
    // What kind of element a variable is, follows from its value.
    sure(
        CODE,
        "^$t=vertex/edge/face/halfedge/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $a = $x:some , $b = $y:line",
        "let $a = $x let $b = $y",
        "a statement sets one variable",
    ),
    sure(
        CODE,
        "^const/static/final/constexpr $t=int/float/double/real/bool/vec2/vec3/size_t/unsigned/long/short/Vec3 $n =",
        "let $n: $t =",
        BEGIN,
    ),
    sure(
        CODE,
        "^const/static/final/constexpr $t=vertex/edge/face/halfedge/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $n =",
        "let $n =",
        BEGIN,
    ),
    sure(CODE, "^const/auto/val/static/final $t:word $n =", "let $n =", BEGIN),
    sure(CODE, "^const/auto & $n =", "let $n =", BEGIN),
    sure(
        CODE,
        "^$t=int/float/double/real/bool/vec2/vec3/size_t/unsigned/long/short/Vec3 $n =",
        "let $n: $t =",
        BEGIN,
    ),
    sure(
        CODE,
        "^$t=vertex/edge/face/halfedge/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $n =",
        "let $n =",
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
        "^$t=int/float/double/real/bool/size_t $n:word [ $x:inside ] $l:line",
        "",
        "there are no lists: values are kept at elements, `attr mark: vertex int = 0`, or counted when they are wanted, `count(degree(v) == 6 for v in vertices)`",
    ),
    told(
        CODE,
        "^int/size_t $n $:end",
        "",
        "a variable has a value from the beginning: `var $n = 0`",
    ),
    told(
        CODE,
        "^float/double/real $n $:end",
        "",
        "a variable has a value from the beginning: `var $n = 0.0`",
    ),
    told(CODE, "^bool $n $:end", "", "a variable has a value from the beginning: `var $n = false`"),
    told(
        CODE,
        "^string $n $:end",
        "",
        "a variable has a value from the beginning: `var $n = \"\"`",
    ),
    told(
        CODE,
        "^$t=vec2/vec3/vec4/mat3/mat4 $n $:end",
        "",
        "a variable has a value from the beginning: `var $n = $t(0)`",
    ),
    fixed(CODE, "^$x:place + ~+", "$x = $x", "$x = $x + 1", MORE),
    fixed(CODE, "^+ ~+ ~$x:place", "$x = $x", "$x = $x + 1", MORE),
    fixed(CODE, "; - ~- ~$x:place $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed(CODE, "; + ~+ ~$x:place $:end", "$x = $x", "$x = $x + 1", MORE),
    fixed(CODE, "; - ~- $l:apart", "", "// $l", COMMENT),
    fixed(CODE, "^$x:place - ~- $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed(CODE, "^- ~- ~$x:place $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed(CODE, "^- ~- $l:apart", "", "// $l", COMMENT),
    fixed(CODE, "- ~- $l:prose", "", "// $l", COMMENT),
    fixed(
        CODE,
        "^$a . $b:word $o=+/- ~= ( $x:inside , $y:inside , $z:inside ) $:end",
        "$a.$b = $x",
        "$a.$b = $a.$b $o vec3($x, $y, $z)",
        "a change is written out: `$a.$b = $a.$b $o …`",
    ),
    fixed(
        CODE,
        "^$x:place $o=+/-/*// ~= $v:whole",
        "$x = $v",
        "$x = $x $o ($v)",
        "a change is written out: `$x = $x $o …`",
    ),
    fixed(
        CODE,
        "^$x:place % ~= $v:whole",
        "$x = $v",
        "$x = $x mod ($v)",
        "a change is written out: `$x = $x mod …`",
    ),
    fixed(
        CODE,
        "^$x:place &&/& ~= $v:whole",
        "$x = $v",
        "$x = $x and ($v)",
        "a change is written out: `$x = $x and …`",
    ),
    fixed(
        CODE,
        "^$x:place | ~| ~= $v:whole",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    fixed(
        CODE,
        "^$x:place | ~= $v:whole",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    told(CODE, "+/-/*// ~= $v:line", "= $v", "a change is written out: `x = x + 1`"),
];
