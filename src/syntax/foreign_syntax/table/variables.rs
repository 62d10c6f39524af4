//! Variables of scripts and functions.

use super::{Line, TYPED, fixed, sure, told};
use crate::syntax::foreign_syntax::place::CODE;

pub(super) const LINES: &[Line] = &[
    sure(CODE, "^let mut $n", "var $n", "what changes is a `var`"),
    sure(CODE, "^$n : ~=", "let $n =", "a variable begins with `let`, or with `var` if it changes"),
    sure(
        CODE,
        "^const/auto/val/my/local/final/constexpr/static $n =",
        "let $n =",
        "a variable begins with `let`, or with `var` if it changes",
    ),
    sure(
        CODE,
        "^const/auto/val/static/final $t:word $n =",
        "let $n =",
        "a variable begins with `let`, or with `var` if it changes",
    ),
    sure(
        CODE,
        "^const/auto & $n =",
        "let $n =",
        "a variable begins with `let`, or with `var` if it changes",
    ),
    sure(
        CODE,
        "^$t=int/float/double/real/bool/vec2/vec3/vertex/edge/face/halfedge/size_t/unsigned/long/EdgeRef/FaceRef/VertexRef/HalfedgeRef/Vec3/Edge/Face/Vertex/Halfedge/EdgeCRef/FaceCRef/VertexCRef/HalfedgeCRef/HalfedgeIter/EdgeIter/FaceIter/VertexIter $n =",
        "let $n =",
        "a variable begins with `let`, or with `var` if it changes",
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
    fixed(CODE, "^$n + ~+", "$n = $n", "$n = $n + 1", "a change is written out: `$n = $n + 1`"),
    fixed(CODE, "^$n - ~-", "$n = $n", "$n = $n - 1", "a change is written out: `$n = $n - 1`"),
    fixed(CODE, "^+ ~+ $n", "$n = $n", "$n = $n + 1", "a change is written out: `$n = $n + 1`"),
    fixed(
        CODE,
        "^- ~- $n $:end",
        "$n = $n",
        "$n = $n - 1",
        "a change is written out: `$n = $n - 1`",
    ),
    sure(CODE, "^- ~- $l:line", "", "a comment begins with `//`"),
    fixed(
        CODE,
        "^$n + ~= $v:line",
        "$n = $v",
        "$n = $n + $v",
        "a change is written out: `$n = $n + …`",
    ),
    fixed(
        CODE,
        "^$n - ~= $v:line",
        "$n = $v",
        "$n = $n - ($v)",
        "a change is written out: `$n = $n - …`",
    ),
    fixed(
        CODE,
        "^$n * ~= $v:line",
        "$n = $v",
        "$n = $n * ($v)",
        "a change is written out: `$n = $n * …`",
    ),
    fixed(
        CODE,
        "^$n / ~= $v:line",
        "$n = $v",
        "$n = $n / ($v)",
        "a change is written out: `$n = $n / …`",
    ),
    fixed(
        CODE,
        "^$a . $b:word + ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b + $v",
        "a change is written out: `$a.$b = $a.$b + …`",
    ),
    fixed(
        CODE,
        "^$a . $b:word - ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b - ($v)",
        "a change is written out: `$a.$b = $a.$b - …`",
    ),
    fixed(
        CODE,
        "^$a . $b:word * ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b * ($v)",
        "a change is written out: `$a.$b = $a.$b * …`",
    ),
    fixed(
        CODE,
        "^$a . $b:word / ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b / ($v)",
        "a change is written out: `$a.$b = $a.$b / …`",
    ),
    told(CODE, "+/-/*// ~= $v:line", "= $v", "a change is written out: `x = x + 1`"),
];
