//! Variables of scripts and functions.

use super::{Line, TYPED, fixed, sure, told};

const CHOSEN: &str = "a variable has a value from the beginning; an element is one of those there are: `var $n = argmin(length(e) for e in edges)`";
const MORE: &str = "a change is written out: `$x = $x + 1`";
const LESS: &str = "a change is written out: `$x = $x - 1`";
const COMMENT: &str = "a comment begins with `//`";
const BEGIN: &str = "a variable begins with `let`, or with `var` if it changes";
const ZERO: &str = "a variable has a value from the beginning: `var $n = 0`";
const ONE: &str = "a statement sets one variable";
const OF_TYPE: &str = "a variable has a value from the beginning: `var $n = $t(0)`";
const FALSE: &str = "a variable has a value from the beginning: `var $n = false`";
const REAL_ZERO: &str = "a variable has a value from the beginning: `var $n = 0.0`";

pub(super) const LINES: &[Line] = &[
    told("^let/var $n : $t=vertex/halfedge/edge/face $:end", "", CHOSEN),
    told("^$t=vertex/halfedge/edge/face $n $:end", "", CHOSEN),
    told("^let/var $n : $t=vec2/vec3/vec4/mat3/mat4 $:end", "", OF_TYPE),
    told("^let/var $n : bool $:end", "", FALSE),
    told("^let/var $n : real $:end", "", REAL_ZERO),
    told("^let/var $n : $t:word $:end", "", ZERO),
    told("^let/var $n $:end", "", ZERO),
    told(
        "^let/var $a = $b = $l:line",
        "",
        "a statement sets one variable: `var $a = 0` and `var $b = 0`",
    ),
    told(
        "^let/var $a , $b = $l:line",
        "",
        "a statement sets one variable: `let $a = 0` and `let $b = 0`",
    ),
    sure("^$w=let/var $a = $x:some , $b = $y:line", "$w $a = $x $w $b = $y", ONE),
    told(
        "^let/var $n = $s=vertices/edges/faces/halfedges/holes where $c:line",
        "",
        "a sequence is not a value: `count(c for x in $s)` counts, `for x in $s where c { … }` visits",
    ),
    sure("^let mut $n", "var $n", "what changes is a `var`"),
    sure("^$n:variable : ~=", "$n =", "a variable is set with `=`"),
    sure("^$n : ~=", "let $n =", BEGIN),
    sure("^const/auto/val/my/local/final/constexpr/static $n =", "let $n =", BEGIN),
    // What kind of element a variable is, follows from its value.
    sure("^$t:kind $a = $x:some , $b = $y:line", "let $a = $x let $b = $y", ONE),
    sure("^$t:type $a = $x:some , $b = $y:line", "let $a: $t = $x let $b: $t = $y", ONE),
    sure("^const/static/final/constexpr $t:kind $n =", "let $n =", BEGIN),
    sure("^const/static/final/constexpr $t:type $n =", "let $n: $t =", BEGIN),
    sure("^const/auto/val/static/final $t:word $n =", "let $n =", BEGIN),
    sure("^const/auto & $n =", "let $n =", BEGIN),
    sure(
        "^int/float/double/real/bool/size_t/unsigned/long/short $n = $o:owner . $p=next/prev/twin/vertex/edge/face/halfedge $:end",
        "let $n = $o.$p",
        BEGIN,
    ),
    sure("^$t:kind $n =", "let $n =", BEGIN),
    sure("^$t:type $n =", "let $n: $t =", BEGIN),
    sure("^$w=let/var $t:type $n =", "$w $n: $t =", TYPED),
    told(
        "^$t:type $n:word [ $x:inside ] $l:line",
        "",
        "there are no lists: values are kept at elements, `attr mark: vertex int = 0`, or counted when they are wanted, `count(degree(v) == 6 for v in vertices)`",
    ),
    told("^int/size_t $n $:end", "", ZERO),
    told("^float/double/real $n $:end", "", REAL_ZERO),
    told("^bool $n $:end", "", FALSE),
    told("^string $n $:end", "", "a variable has a value from the beginning: `var $n = \"\"`"),
    told("^$t=vec2/vec3/vec4/mat3/mat4 $n $:end", "", OF_TYPE),
    fixed("^$x:place + ~+", "$x = $x", "$x = $x + 1", MORE),
    fixed("^+ ~+ ~$x:place", "$x = $x", "$x = $x + 1", MORE),
    fixed("; - ~- ~$x:place $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed("; + ~+ ~$x:place $:end", "$x = $x", "$x = $x + 1", MORE),
    fixed(
        "^$x:place ~- ~- $s=print/let/var/if/for/while/repeat/update/drain/return/break/continue/assert/must",
        "$x = $x $s",
        "$x = $x - 1 $s",
        LESS,
    ),
    fixed("; - ~- $l:apart", "", "// $l", COMMENT),
    fixed("^$x:place - ~- $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed("^- ~- ~$x:place $:end", "$x = $x", "$x = $x - 1", LESS),
    fixed("^- ~- $l:apart", "", "// $l", COMMENT),
    fixed("- ~- $l:prose", "", "// $l", COMMENT),
    fixed(
        "^$a . $b:word $o=+/- ~= ( $x:inside , $y:inside , $z:inside ) $:end",
        "$a.$b = $x",
        "$a.$b = $a.$b $o vec3($x, $y, $z)",
        "a change is written out: `$a.$b = $a.$b $o …`",
    ),
    fixed(
        "^$x:place $o=+/-/*// ~= $v:whole",
        "$x = $v",
        "$x = $x $o ($v)",
        "a change is written out: `$x = $x $o …`",
    ),
    fixed(
        "^$x:place % ~= $v:whole",
        "$x = $v",
        "$x = $x mod ($v)",
        "a change is written out: `$x = $x mod …`",
    ),
    fixed(
        "^$x:place &&/& ~= $v:whole",
        "$x = $v",
        "$x = $x and ($v)",
        "a change is written out: `$x = $x and …`",
    ),
    fixed(
        "^$x:place | ~| ~= $v:whole",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    fixed(
        "^$x:place | ~= $v:whole",
        "$x = $v",
        "$x = $x or ($v)",
        "a change is written out: `$x = $x or …`",
    ),
    told("+/-/*// ~= $v:line", "= $v", "a change is written out: `x = x + 1`"),
];
