//! The table: how something is written elsewhere, and how here. How patterns are read is said
//! in [`pattern`](super::pattern); of several that match the first counts.
//!
//! In what is said, `{}` is the first word of the pattern as it is written, and `$a` what stands
//! in the hole of that name.

use super::pattern::Pattern;
use super::place::{ANY, CODE, DRAWING, HEAD, PARTS, Places};
use crate::syntax::token::TokenKind;
use logos::Logos;
use std::ops::Range;
use std::sync::LazyLock;

/// A line of the table.
struct Line {
    place: Places,
    seen: &'static str,
    ours: &'static str,
    fix: Option<&'static str>,
    says: &'static str,
}

/// A way of writing whose meaning is sure, and how that is written.
const fn sure(place: Places, seen: &'static str, ours: &'static str, says: &'static str) -> Line {
    Line { place, seen, ours, fix: Some(ours), says }
}

/// The same, where what is written is not what the rest is read with.
const fn fixed(
    place: Places,
    seen: &'static str,
    ours: &'static str,
    fix: &'static str,
    says: &'static str,
) -> Line {
    Line { place, seen, ours, fix: Some(fix), says }
}

/// A way of writing that only a person can write anew; the rest is read as if it were `ours`.
const fn told(place: Places, seen: &'static str, ours: &'static str, says: &'static str) -> Line {
    Line { place, seen, ours, fix: None, says }
}

const HALFEDGE: &str =
    "a halfedge is drawn in its loop, `face f: v0 -a-> v1 …`, and has no statement of its own";
const POINTERS: &str = "pointers are not assigned: `next` and `face` follow from the loops that `after` draws, `twin` from its edges, `edge e: a | d`";
const DECLARED: &str = "names are not declared: what is drawn tells what they stand for";
const CALLS: &str = "a drawing calls nothing: it says what there is before and after; scripts call operations, `flip(e)`";
const PAIRED: &str = "an edge is a pair of twins with a bar between them: `edge e: a | d`";
const OWN_ENDS: &str = "an edge names its two halfedges, not its ends: `edge e: a | d` where `v0 -a-> v1` and `v1 -d-> v0`";
const BACKWARDS: &str = "arrows run forward, around the face: `v0 -$a-> v1`";
const GUARDED: &str =
    "`guard simple` names a level; what has to hold is asked by `require c else \"…\"`";
const SIDES: &str = "an op is drawn: `before { … }` is what it finds, `after { … }` what it leaves";
const STEPS: &str = "an op is drawn, `before { … } after { … }`; one that calls others has `steps { … }`, and a script or `fn` statements of any kind";
const DRAWN: &str = "a drawing has no `{}`: alternatives are `rule name { … }`, a refusal is `require c else \"…\"`, and `each i { … }` repeats a period";
const VALUES: &str =
    "a drawing has no variables: a value is written where it is used, or computed by a `fn`";
const REQUIRED: &str = "what has to hold is asked by `require c else \"…\"`";
const EXISTS: &str =
    "no element is missing: beyond a boundary is a hole, `hole(h.face)`, `boundary(v)`";
const CALLED: &str = "what is called stands in front: `degree(v)`, `flip(e)`";
const POINTER: &str = "a pointer is read without parentheses: `h.$p`";
const POWER: &str = "a power is `pow(x, y)`, a square `x * x`";
const LOOP: &str = "a loop is `for v in vertices where … { … }`";
const BRACES: &str = "a block stands in braces: `$w … { … }`";
const CONSTANT: &str = "values stand in items: a constant is a function, `fn k() { 3 }`, a setting a parameter with a default, `script go(k: real = 3)`";
const CHOICE: &str = "a choice is `if c { … } else { … }`, also as a value";
const ARROW: &str = "a halfedge is drawn `v0 -a-> v1`, a path `v0 =P=> v1`";
const TYPED: &str = "a type stands behind its name: `$n: $t`";

const LINES: &[Line] = &[
    // Signs.
    sure(ANY, ";", "", "no `;`: a statement ends where the next one begins"),
    sure(ANY, "&&/&/∧", "and", "`{}` is written `and`"),
    sure(CODE | PARTS, "| ~|", "or", "`||` is written `or`"),
    sure(ANY, "∨", "or", "`{}` is written `or`"),
    sure(ANY, "!/¬", "not", "`{}` is written `not`"),
    sure(ANY, "%", "mod", "`%` is written `mod`"),
    sure(CODE | PARTS, "== ~=", "==", "`===` is written `==`"),
    sure(CODE | PARTS, "!= ~=", "!=", "`!==` is written `!=`"),
    sure(CODE | PARTS, "< ~>", "!=", "`<>` is written `!=`"),
    sure(CODE | PARTS, "= ~<", "<=", "`=<` is written `<=`"),
    sure(ANY, "≤", "<=", "`{}` is written `<=`"),
    sure(ANY, "≥", ">=", "`{}` is written `>=`"),
    sure(ANY, "≠", "!=", "`{}` is written `!=`"),
    sure(ANY, "×/·/∗", "*", "`{}` is written `*`"),
    sure(DRAWING, "−/–/—/─ $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`"),
    sure(DRAWING, "- $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`"),
    sure(DRAWING, "= $a ⇒", "=$a=>", "a path is typed `=$a=>`"),
    sure(ANY, "−/–/—/─", "-", "`{}` is written `-`"),
    sure(ANY, "→/⟶/➔", "->", "`{}` is written `->`"),
    sure(ANY, "⇒", "=>", "`{}` is written `=>`"),
    sure(DRAWING, "…", "=>", "a path without a name is `=>`"),
    fixed(CODE, "∈", "in", "in", "`{}` is written `in`"),
    // What a power is taken of is whole behind one of these.
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $x * ~* $n:number",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $x . $y * ~* $n:number",
        "$b $x . $y * $n",
        "$b pow($x.$y, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return ( $x:inside ) * ~* $n:number",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $f ( $x:inside ) * ~* $n:number",
        "$b $f ( $x ) * $n",
        "$b pow($f($x), $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $x ^ $n:number",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $x . $y ^ $n:number",
        "$b $x . $y * $n",
        "$b pow($x.$y, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return ( $x:inside ) ^ $n:number",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/return $f ( $x:inside ) ^ $n:number",
        "$b $f ( $x ) * $n",
        "$b pow($f($x), $n)",
        POWER,
    ),
    told(CODE | PARTS, "* ~*", "*", POWER),
    told(ANY, "^", "*", POWER),
    told(ANY, "? $a:part : $b:line", "", "a choice is `if c { x } else { y }`"),
    // Heads of items.
    sure(
        HEAD,
        "^def/function/func/fun/fn/void/auto/bool/define/sub/procedure/method/int/Mesh/EdgeRef/FaceRef/VertexRef/HalfedgeRef/optional $f ( $p:inside ) $r:part { $b=before/rule/after/steps",
        "op $f($p) $r { $b",
        "what is drawn is an operation, `op $f(…) { before { … } after { … } }`",
    ),
    told(
        HEAD,
        "^def $f ( $p:inside ) $r:part : $:end",
        "fn $f($p) { }",
        "a function is `fn $f(x: real) -> real { … }`, an operation `op $f(e: edge) { before { … } after { … } }`: with braces",
    ),
    told(
        HEAD,
        "fn/op/script $f ( $p:inside ) $r:part : $:end",
        "fn $f($p) { }",
        "a block stands in braces: `{} $f(…) { … }`",
    ),
    sure(
        HEAD,
        "^def/function/func/fun/define/sub/procedure/method/void/proc/lambda $f ( $p:inside )",
        "fn $f($p)",
        "a function is `fn`, an operation `op`, a program `script`",
    ),
    sure(HEAD, "^Fn/FN $f ( ", "fn $f(", "`{}` is written `fn`"),
    told(
        HEAD,
        "^int/void/auto main ( $p:inside ) {",
        "fn main ( ) {",
        "a program is `script name() { … }`, with as many as are wanted in a file",
    ),
    fixed(
        HEAD,
        "^$t=real/float/double/int/bool/vec3/vec2/Vec3/vertex/edge/face/halfedge $f ( $p:inside ) {",
        "fn $f($p) {",
        "fn $f($p) -> $t {",
        "a function is `fn $f(…) -> $t { … }`",
    ),
    sure(HEAD, "$k=op/fn/script $f < $x:inside > (", "$k $f(", "there are no templates"),
    told(
        HEAD,
        ") returns/return/yields $t:part {",
        ") {",
        "what is returned stands behind an arrow: `op flip(e: edge) -> m`, `fn f(x: real) -> real`",
    ),
    told(
        HEAD,
        ") -> ( $a , $b:inside ) {",
        ") {",
        "an op returns one element, a function one value",
    ),
    sure(
        HEAD,
        "^operation/operator/rewrite/rule/transform/transformation/action/Op/OP/oper/operate/local_op $f (",
        "op $f(",
        "`{}` is written `op`",
    ),
    sure(
        HEAD,
        "^main/program/algorithm/Script/proc/task/routine/macro $f (",
        "script $f(",
        "`{}` is written `script`",
    ),
    sure(
        HEAD,
        "^import/include/using/open/require/load/from/with/Use $p:text",
        "use $p",
        "`{}` is written `use`",
    ),
    told(
        HEAD,
        "^from $p:part import $l:line",
        "",
        "a file is used whole: `use \"std/triangle.hedge\"`",
    ),
    told(
        HEAD,
        "^import/include/using/open/from/load $p:line",
        "",
        "a file is used by its path: `use \"std/triangle.hedge\"`",
    ),
    sure(
        HEAD,
        "^pub/public/static/export/extern/inline/virtual/async/override/protected/const/constexpr $k=op/fn/script/attr",
        "$k",
        "no `{}`: what a file declares, all files see that use it",
    ),
    sure(
        HEAD,
        "^pub/public/static/export/extern/inline/virtual/async/override/protected/const/constexpr $:end",
        "",
        "no `{}`: what a file declares, all files see that use it",
    ),
    sure(HEAD, "^private $:end", "", "only an attribute can be `private`"),
    sure(HEAD, "^private $k=op/fn/script", "$k", "only an attribute can be `private`"),
    sure(HEAD, "^template < $x:inside >", "", "there are no templates"),
    told(HEAD, "^let/var/const/constexpr/auto/val/global/define $n:part = $v:line", "", CONSTANT),
    told(HEAD, "^$n = $v:line", "", CONSTANT),
    told(
        HEAD,
        "^for/if/while/repeat/drain/update/print/assert/must $l:inside { $b:inside }",
        "",
        "statements stand in a script: `script go() { … }`",
    ),
    told(
        HEAD,
        "^print/assert/must $l:line",
        "",
        "statements stand in a script: `script go() { … }`",
    ),
    told(
        HEAD,
        "^class/struct/enum/interface/namespace/module/trait/impl/mesh/object $n:part { $b:inside }",
        "",
        "there are no types of one's own: values are kept at elements, `attr weight: edge real = 0`",
    ),
    told(
        HEAD,
        "^type/typedef/typename $l:line",
        "",
        "there are no types of one's own: values are kept at elements, `attr weight: edge real = 0`",
    ),
    sure(HEAD, "attribute/property/attrib $n :", "attr $n:", "`{}` is written `attr`"),
    sure(
        HEAD,
        "attr $t=real/int/bool/vec2/vec3/vec4/mat3/mat4 $k=vertex/halfedge/edge/face $n",
        "attr $n: $k $t",
        "an attribute is `attr $n: $k $t`",
    ),
    sure(
        HEAD,
        "attr $k=vertex/halfedge/edge/face $t=real/int/bool/vec2/vec3/vec4/mat3/mat4 $n",
        "attr $n: $k $t",
        "an attribute is `attr $n: $k $t`",
    ),
    sure(
        HEAD,
        "attr $k=vertex/halfedge/edge/face $n : $t:word",
        "attr $n: $k $t",
        "an attribute is `attr $n: $k $t`",
    ),
    sure(
        HEAD,
        "attr $k=vertex/halfedge/edge/face . $n : $t:word",
        "attr $n: $k $t",
        "an attribute is `attr $n: $k $t`",
    ),
    sure(
        HEAD,
        "attr $n : $t=real/int/bool/vec2/vec3/vec4/mat3/mat4 $k=vertex/halfedge/edge/face",
        "attr $n: $k $t",
        "the kind of element stands before the type: `attr $n: $k $t`",
    ),
    sure(
        HEAD,
        "attr $n : $k=vertex/halfedge/edge/face : $t:word",
        "attr $n: $k $t",
        "an attribute is `attr $n: $k $t`",
    ),
    told(
        HEAD,
        "attr $n : $t=real/int/bool/vec2/vec3/vec4/mat3/mat4 $:end",
        "",
        "an attribute belongs to a kind of element: `attr $n: vertex $t`",
    ),
    told(
        HEAD,
        "attr $n : $t=real/int/bool/vec2/vec3/vec4/mat3/mat4 = $v:line",
        "",
        "an attribute belongs to a kind of element: `attr $n: vertex $t = $v`",
    ),
    told(
        HEAD,
        "attr $n = $v:line",
        "",
        "an attribute has a kind of element and a type: `attr $n: vertex real = $v`",
    ),
    sure(HEAD, "$o=(/, const", "$o", "parameters have no `const`"),
    sure(
        HEAD,
        "$t:word & $n",
        "$t $n",
        "there are no references: an element is handed over as it is",
    ),
    sure(HEAD, "$t:word & ~&", "$t", "there are no references: an element is handed over as it is"),
    sure(HEAD, "$o=(/, $t:word * $n", "$o$n: $t", TYPED),
    sure(
        HEAD,
        "$c=: & $t:word",
        "$c $t",
        "there are no references: an element is handed over as it is",
    ),
    sure(HEAD, "$o=(/, $n $t=edge/face/vertex/halfedge/real/int/bool/vec2/vec3", "$o$n: $t", TYPED),
    sure(
        HEAD,
        "$o=(/, $n = $t=edge/face/vertex/halfedge/real/int/bool/vec2/vec3",
        "$o$n: $t",
        TYPED,
    ),
    sure(HEAD, "$o=(/, $t:word $n", "$o$n: $t", TYPED),
    sure(HEAD, ") : $t:word {", ") -> $t {", "what is returned stands behind an arrow: `-> $t`"),
    sure(HEAD, ") => $t:word {", ") -> $t {", "what is returned stands behind an arrow: `-> $t`"),
    sure(
        HEAD,
        ") $t=real/int/bool/vec3/float/double {",
        ") -> $t {",
        "what is returned stands behind an arrow: `-> $t`",
    ),
    sure(
        HEAD,
        "fn $f ( $p:inside ) => $t:word {",
        "fn $f($p) -> $t {",
        "what is returned stands behind an arrow: `-> $t`",
    ),
    told(
        HEAD,
        "^use $p:part { $b:inside }",
        "",
        "a file is used whole, by its path: `use \"std/triangle.hedge\"`",
    ),
    sure(
        HEAD,
        "fn $f ( $p:inside ) =/=> $v:line",
        "fn $f($p) { $v }",
        "a function has a block: `fn $f(…) { … }`",
    ),
    told(
        HEAD,
        "-> $o:word < $x:inside >",
        "",
        "an op says which element it returns, `-> m`; that it may refuse is understood",
    ),
    sure(
        HEAD,
        "$k=script/fn $n {",
        "$k $n() {",
        "parentheses stand behind the name also where nothing is given: `$k $n() { … }`",
    ),
    told(
        HEAD,
        "op $n {",
        "op $n ( ) {",
        "an op says at which element it begins: `op $n(e: edge) { … }`",
    ),
    fixed(
        HEAD,
        "test $n ( ) { $b:inside }",
        "",
        "test \"$n\" { $b }",
        "a test has a name in quotes: `test \"…\" { … }`",
    ),
    fixed(
        HEAD,
        "test $n { $b:inside }",
        "",
        "test \"$n\" { $b }",
        "a test has a name in quotes: `test \"…\" { … }`",
    ),
    told(HEAD, "test { $b:inside }", "", "a test has a name in quotes: `test \"…\" { … }`"),
    sure(
        HEAD,
        ") keep/ensures/preserves/maintains/preserving/keeping/keep:",
        ") keeps",
        "`keeps` says what is to be proved besides",
    ),
    // Parts of an op.
    sure(PARTS, "->/=>/,/;/→/⇒/⟶ $a=after", "$a", "nothing stands between the parts of an op"),
    sure(PARTS, "->/=>/→/⇒/⟶ {", "after {", "what an op leaves is `after { … }`"),
    sure(PARTS, "$s=before/after/steps :/= {", "$s {", "`$s` is followed by its brace"),
    sure(PARTS, "$s=before/after/steps :/= $:end", "$s {", "`$s { … }` has braces"),
    sure(
        PARTS,
        "$s=before/after $k=face/hole/loop/edge/vertex/new/keep/erase",
        "$s { $k",
        "`$s` is followed by a brace: `$s { … }`",
    ),
    sure(
        PARTS,
        "^pre/given/lhs/match/from/old/input/find/left/where/when/source/initial/original/start/precondition/LHS/pattern/Before/BEFORE/begin {",
        "before {",
        "`before { … }` is what an op finds; `{}` is not written",
    ),
    sure(
        PARTS,
        "^post/then/rhs/to/becomes/result/new/output/replace/right/do/target/into/final/afterwards/yields/produces/RHS/After/AFTER/become/replacement/end {",
        "after {",
        "`after { … }` is what an op leaves; `{}` is not written",
    ),
    sure(
        PARTS,
        "^alternative/case/or/variant/option/Rule $n {",
        "rule $n {",
        "an alternative is `rule $n { … }`",
    ),
    sure(PARTS, "rule : $n {", "rule $n {", "an alternative is `rule $n { … }`"),
    sure(PARTS, "rule $n : {", "rule $n {", "an alternative is `rule $n { … }`"),
    sure(PARTS, "rule $n ( ) {", "rule $n {", "an alternative is `rule $n { … }`"),
    told(PARTS, "rule {", "", "alternatives have names: `rule interior { … }`"),
    told(
        PARTS,
        "rule $n:text {",
        "",
        "the name of an alternative stands without quotes: `rule interior { … }`",
    ),
    told(
        PARTS,
        "if $c:inside { return/refuse/fail/abort/break $r:inside } $b=before",
        "$b",
        "an op refuses by `require c else \"…\"`, with what has to hold, behind its `before`",
    ),
    sure(
        PARTS,
        "if $c:inside { return $r:inside }",
        "require not ($c)",
        "an op refuses by `require c else \"…\"`, with what has to hold",
    ),
    sure(
        PARTS,
        "if $c:inside { refuse/fail/abort/reject/stop/exit/throw/raise/break $r:inside }",
        "require not ($c)",
        "an op refuses by `require c else \"…\"`, with what has to hold",
    ),
    sure(
        PARTS,
        "if ( $c:inside ) return $r:line",
        "require not ($c)",
        "an op refuses by `require c else \"…\"`, with what has to hold",
    ),
    sure(
        PARTS,
        "^unless/refuse/reject/forbid $c:line",
        "require not ($c)",
        "an op refuses by `require c else \"…\"`, with what has to hold",
    ),
    sure(
        PARTS,
        "^guard ( $l=map/surface/simple )",
        "guard $l",
        "a level stands without parentheses: `guard $l`",
    ),
    sure(PARTS, "^guard ( $c:inside )", "require $c", GUARDED),
    sure(PARTS, "^guard $b=not/! $c:part", "require not $c", GUARDED),
    sure(PARTS, "^guard $f ( $c:inside )", "require $f($c)", GUARDED),
    sure(PARTS, "$w=require/guard :", "$w", "no colon stands behind `$w`"),
    sure(
        PARTS,
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition ( $c:inside , $t:text )",
        "require $c else $t",
        REQUIRED,
    ),
    sure(
        PARTS,
        "^require ( $c:inside , $t:text )",
        "require $c else $t",
        "the reason of a refusal stands behind `else`",
    ),
    sure(
        PARTS,
        "^require $c:part ,/: $t:text",
        "require $c else $t",
        "the reason of a refusal stands behind `else`",
    ),
    sure(
        PARTS,
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition :",
        "require",
        REQUIRED,
    ),
    sure(PARTS, "^only if", "require", REQUIRED),
    sure(
        PARTS,
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition",
        "require",
        REQUIRED,
    ),
    sure(
        PARTS,
        "^guards/level/guarantee $l=map/surface/simple",
        "guard $l",
        "`{}` is written `guard`",
    ),
    sure(PARTS, "^aliases/allow/may_alias $a $b", "alias $a $b", "`{}` is written `alias`"),
    told(
        PARTS,
        "^for/while/if/repeat/drain/update $h:inside { $b:inside } else { $c:inside }",
        "",
        STEPS,
    ),
    told(PARTS, "^for/while/if/repeat/drain/update $h:inside { $b:inside }", "", STEPS),
    told(PARTS, "^let/var/print/return/must/const/auto $l:line", "", STEPS),
    told(PARTS, "^$n ( $a:inside ) $l:line", "", STEPS),
    told(PARTS, "^$n . $l:line", "", STEPS),
    told(PARTS, "^$n ->/= $l:line", "", STEPS),
    told(PARTS, "^$t:word $n = $l:line", "", STEPS),
    told(
        PARTS,
        "^each $i { $b:inside }",
        "",
        "what is drawn stands in `before { … }` or `after { … }`",
    ),
    // Lists of drawings.
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=halfedge/halfedges/vertices/edges/faces/he/vert $n",
        "$w $l $n",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=vertex/edge/face $n $:end",
        "$w $l $n",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=vertex/edge/face $n $e=new/erase/keep/edge/face/vertex/halfedge/,",
        "$w $l $n $e",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(DRAWING, "$w=new/erase/keep :/= $n", "$w $n", "no sign stands behind `$w`: `$w a b`"),
    sure(
        DRAWING,
        "$w=new/erase/keep ( $l:names )",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep [ $l:names ]",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep { $l:names }",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    told(
        DRAWING,
        "^$a = new/create/add/make/alloc $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    told(
        DRAWING,
        "^$k:word $a = new/create/make/new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    told(
        DRAWING,
        "^$a = new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    sure(
        DRAWING,
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase/delete_vertex/delete_edge/delete_face ( $l:names )",
        "erase $l",
        "`{}` is written `erase`",
    ),
    sure(
        DRAWING,
        "^add/create/insert/make/alloc/allocate/introduce/New ( $l:names )",
        "new $l",
        "`{}` is written `new`",
    ),
    sure(
        DRAWING,
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase $a $n:names",
        "erase $a $n",
        "`{}` is written `erase`",
    ),
    sure(
        DRAWING,
        "^add/create/insert/make/alloc/allocate/introduce/New $a $n:names",
        "new $a $n",
        "`{}` is written `new`",
    ),
    sure(
        DRAWING,
        "^preserve/retain/same/unchanged/keeps/Keep/stay/restate $a $n:names",
        "keep $a $n",
        "`{}` is written `keep`",
    ),
    // Statements of drawings.
    told(
        DRAWING,
        "^if/for/while/repeat/foreach/unless $h:inside { $b:inside } else { $c:inside }",
        "",
        DRAWN,
    ),
    told(DRAWING, "^if/for/while/repeat/foreach/unless $h:inside { $b:inside }", "", DRAWN),
    told(DRAWING, "^let/var/const/auto/val $l:line", "", VALUES),
    told(
        DRAWING,
        "^return $l:line",
        "",
        "what an op returns stands in its head: `op name(…) -> x { … }`",
    ),
    told(DRAWING, "^print/assert/must $l:line", "", STEPS),
    sure(
        DRAWING,
        "^boundary/border/Hole/holes/outside/exterior/boundary_loop/HOLE/rim $f :",
        "hole $f:",
        "a boundary loop is a `hole`",
    ),
    sure(
        DRAWING,
        "^Face/tri/triangle/quad/polygon/faces/facet/cell/poly/tris/FACE/pentagon/square/ngon $f :",
        "face $f:",
        "`{}` is written `face`",
    ),
    sure(DRAWING, "^Edge/edges/side/EDGE/link/pair $e :", "edge $e:", "`{}` is written `edge`"),
    sure(
        DRAWING,
        "^Vertex/vert/vertices/node/point/star/verts/spokes/VERTEX/ring/fan $v :",
        "vertex $v:",
        "`{}` is written `vertex`",
    ),
    sure(DRAWING, "^cycle/orbit/Loop/LOOP/contour $f :", "loop $f:", "`{}` is written `loop`"),
    told(
        DRAWING,
        "^halfedge/he/half_edge/Halfedge/dart/arc/halfedges/HalfedgeRef/path $h : $l:line",
        "",
        HALFEDGE,
    ),
    told(
        DRAWING,
        "^halfedge/he/half_edge/Halfedge/dart/arc/HalfedgeRef $h = $l:line",
        "",
        HALFEDGE,
    ),
    told(
        DRAWING,
        "^halfedge/halfedges/he/face/edge/vertex/hole/path/HalfedgeRef/VertexRef/EdgeRef/FaceRef $a $n:names $:end",
        "",
        DECLARED,
    ),
    told(DRAWING, "^twin/twins/opposite/pair $l:line", "", PAIRED),
    told(DRAWING, "^edge $e :/= $a:vertex $b:vertex $:end", "", OWN_ENDS),
    told(DRAWING, "^edge $e :/= $a:vertex ,/-/->/=>/.. $b:vertex $:end", "", OWN_ENDS),
    told(DRAWING, "^edge $e :/= ( $a:vertex , $b:vertex )", "", OWN_ENDS),
    told(
        DRAWING,
        "^edge $e : $a | $b | $c",
        "edge $e: $a | $b",
        "an edge has two halfedges: `edge $e: $a | $b`",
    ),
    sure(DRAWING, "^edge $e $a |/=/,/- $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e = $a | $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a ,/- $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a / $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a and/&/&&/~/<>/:/twin/with $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a | | $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a < -> $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a ->/=>/== $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= $a $b $:end", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= ( $a ,/| $b )", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= [ $a ,/| $b ]", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e :/= { $a ,/| $b }", "edge $e: $a | $b", PAIRED),
    sure(DRAWING, "^edge $e ( $a ,/| $b )", "edge $e: $a | $b", PAIRED),
    told(DRAWING, "^edge : $l:line", "", "an edge has a name: `edge e: a | d`"),
    told(DRAWING, "^face/hole/loop : $l:line", "", "a {} has a name: `{} f: v0 -a-> v1 …`"),
    told(DRAWING, "^vertex : $l:line", "", "a vertex has a name: `vertex v: a *S b`"),
    told(DRAWING, "^$a | $b $:end", "", "twins stand in an edge statement: `edge e: $a | $b`"),
    sure(
        DRAWING,
        "^$k=face/hole/loop $f =/( $v $d=-/=/=>",
        "$k $f: $v $d",
        "a colon stands behind the name: `$k $f: …`",
    ),
    sure(
        DRAWING,
        "^$k=face/hole/loop $f $v $d=-/=/=>",
        "$k $f: $v $d",
        "a colon stands behind the name: `$k $f: …`",
    ),
    sure(
        DRAWING,
        "^$k=face/hole/loop $f $e=each",
        "$k $f: $e",
        "a colon stands behind the name: `$k $f: …`",
    ),
    sure(
        DRAWING,
        "^vertex $v = $a",
        "vertex $v: $a",
        "a colon stands behind the name: `vertex $v: …`",
    ),
    sure(
        DRAWING,
        "^vertex $v $a $b",
        "vertex $v: $a $b",
        "a colon stands behind the name: `vertex $v: …`",
    ),
    told(
        DRAWING,
        "^$k=face/hole/loop $f :/=/( $a $b $l:line",
        "",
        "a loop has arrows with the names of its halfedges: `$k $f: v0 -a-> v1 -b-> v0`",
    ),
    told(
        DRAWING,
        "^$k=face/hole/loop $f :/=/( $a , $l:line",
        "",
        "a loop has arrows with the names of its halfedges: `$k $f: v0 -a-> v1 -b-> v0`",
    ),
    told(
        DRAWING,
        "^$k=face/hole/loop $f :/= (/[/{ $l:line",
        "",
        "a loop has arrows with the names of its halfedges: `$k $f: v0 -a-> v1 -b-> v0`",
    ),
    told(
        DRAWING,
        "^$f = face/hole/Face ( $l:line",
        "",
        "a face is drawn by its loop: `face $f: v0 -a-> v1 -b-> v0`",
    ),
    sure(DRAWING, "- ~- $a - ~->", "-$a->", "an arrow has one dash before its name: `-$a->`"),
    sure(DRAWING, "- ~- $a ->", "-$a->", "an arrow has one dash before its name: `-$a->`"),
    sure(DRAWING, "- $a - ~->", "-$a->", "an arrow is `-$a->`"),
    sure(DRAWING, "- $a - >", "-$a->", "an arrow is `-$a->`, without a space in `->`"),
    sure(
        DRAWING,
        "- [/(/< $a ]/)/> ->",
        "-$a->",
        "an arrow has the bare name of its halfedge: `-$a->`",
    ),
    sure(
        DRAWING,
        "- [/(/< $a ]/)/> - ~->",
        "-$a->",
        "an arrow has the bare name of its halfedge: `-$a->`",
    ),
    sure(DRAWING, "-> ~$a ~->", "-$a->", "an arrow is `-$a->`"),
    sure(DRAWING, "== $a == ~>", "=$a=>", "a path is `=$a=>`"),
    sure(DRAWING, "= $a = >", "=$a=>", "a path is `=$a=>`, without a space in `=>`"),
    sure(DRAWING, "- $a => ", "-$a->", "an arrow is `-$a->`, a path `=$a=>`"),
    sure(DRAWING, "=> $a =>", "=$a=>", "a path is `=$a=>`"),
    told(DRAWING, "= $a ->", "- $a ->", ARROW),
    told(DRAWING, "^face/hole/loop $f : $l:some < - $a -/-> $v", "", BACKWARDS),
    told(DRAWING, "< - $a -", "- $a ->", "arrows run forward, around the face: `v0 -$a-> v1`"),
    sure(
        DRAWING,
        "^$k=face/hole/loop $f : $l:some - $a - $v",
        "$k $f: $l -$a-> $v",
        "an arrow ends with `->`: `-$a-> $v`",
    ),
    sure(
        DRAWING,
        "^$k=face/hole/loop $f : $l:some - $a $v $d=-/=/=>",
        "$k $f: $l -$a-> $v $d",
        "an arrow ends with `->`: `-$a-> $v`",
    ),
    told(DRAWING, "$a - > $b", "$a => $b", "an arrow has the name of its halfedge: `$a -h-> $b`"),
    sure(DRAWING, "$a . ~. ~. $b", "$a => $b", "a path without a name is `=>`"),
    told(
        DRAWING,
        "$v:vertex , $w:vertex $d=-/=",
        "$v $d",
        "a loop names each of its vertices once: `v0 -a-> v1 -b-> v2`",
    ),
    sure(
        DRAWING,
        "^new $l:names : $k=vertex/edge/face/halfedge",
        "new $l",
        "names are listed without their kinds: what is drawn tells what they stand for",
    ),
    told(
        DRAWING,
        "^keep */all/everything/rest",
        "",
        "`keep` lists faces, edges and vertices by their names: `keep f0 f1 e`",
    ),
    told(
        DRAWING,
        ". ~. ~.",
        "",
        "spokes that have no name are a fan, `*S` or `*`; a path without a name is `=>`",
    ),
    // Assignments of drawings.
    told(
        DRAWING,
        "^$a ./-> $p=next/prev/twin/vertex/face/edge/halfedge/opposite/pair/origin ( ) = $v:line",
        "",
        POINTERS,
    ),
    told(
        DRAWING,
        "^$a ./-> $p=next/prev/twin/vertex/face/edge/halfedge/opposite/pair/origin = $v:line",
        "",
        POINTERS,
    ),
    told(
        DRAWING,
        "^$a ./-> $p=set_next/set_prev/set_twin/set_vertex/set_face/set_edge/set_halfedge/set_opposite/set_target/set_neighbors ( $x:inside ) $l:line",
        "",
        POINTERS,
    ),
    told(
        DRAWING,
        "^$a ./-> $p=setNext/setPrev/setTwin/setVertex/setFace/setEdge/setHalfedge/setOpposite/setTarget/setNeighbors ( $x:inside ) $l:line",
        "",
        POINTERS,
    ),
    told(DRAWING, "^$a ./-> $f:word ( $x:inside ) $l:line", "", CALLS),
    told(DRAWING, "^$f ( $x:inside ) $l:line", "", CALLS),
    told(
        DRAWING,
        "^$a . $b:word . $c:word = $v:line",
        "",
        "a component cannot be assigned by itself: `$a.$b = vec3(x, y, z)`",
    ),
    sure(DRAWING, "^$a -> $b:word =", "$a.$b =", "an attribute stands behind a dot: `$a.$b`"),
    sure(DRAWING, "$a . $b:word : = ", "$a.$b =", "it is set with `=`"),
    sure(DRAWING, "$a . $b:word : $v:line", "$a.$b = $v", "it is set with `=`"),
    fixed(
        DRAWING,
        "$a . $b:word + ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b + ($v)",
        "a change is written out: `$a.$b = $a.$b + …`",
    ),
    fixed(
        DRAWING,
        "$a . $b:word - ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b - ($v)",
        "a change is written out: `$a.$b = $a.$b - …`",
    ),
    fixed(
        DRAWING,
        "$a . $b:word * ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b * ($v)",
        "a change is written out: `$a.$b = $a.$b * …`",
    ),
    fixed(
        DRAWING,
        "$a . $b:word / ~= $v:line",
        "$a.$b = $v",
        "$a.$b = $a.$b / ($v)",
        "a change is written out: `$a.$b = $a.$b / …`",
    ),
    fixed(
        DRAWING,
        "^$a:vertex = $f=midpoint/centroid/mix/vec3 ( $v:line",
        "",
        "$a.position = $f($v",
        "`$a` is a vertex; where it is tells its `position`",
    ),
    told(
        DRAWING,
        "^$a:vertex = $v:plain",
        "",
        "`$a` is a vertex: what is set is an attribute, `$a.position = …`",
    ),
    told(
        DRAWING,
        "^$a = $v:plain",
        "",
        "what is set is an attribute of something drawn, `v.position = …`; a value is written where it is used",
    ),
    told(DRAWING, "^$t:word $a = $v:plain", "", VALUES),
    sure(
        DRAWING,
        "^$k=face/hole/loop/edge/vertex/new/keep/erase $l:some , $:end",
        "$k $l",
        "no comma stands behind a statement",
    ),
    // Loops of code.
    told(
        CODE,
        "^for ( $i:inside ; $c:inside ; $s:inside ) {",
        "repeat true {",
        "there are no counting loops: `repeat n { … }`, `while c { … }`, `for v in vertices { … }`",
    ),
    sure(CODE, "for/foreach ( $t:inside $n : $s:inside ) {", "for $n in $s {", LOOP),
    sure(CODE, "for/foreach ( $n : $s:inside ) {", "for $n in $s {", LOOP),
    sure(
        CODE,
        "for/foreach ( $t=let/var/const/auto $n in/of $s:inside ) {",
        "for $n in $s {",
        LOOP,
    ),
    sure(CODE, "for/foreach ( $n in/of $s:inside ) {", "for $n in $s {", LOOP),
    sure(
        CODE,
        "^foreach/forall/For/FOR/loop/every/iterate $n in",
        "for $n in",
        "`{}` is written `for`",
    ),
    sure(CODE, "^foreach/forall ( $n in $s:inside ) {", "for $n in $s {", LOOP),
    sure(CODE, "^for each/all/every $n in", "for $n in", "a loop is `for $n in … { … }`"),
    sure(CODE, "^for $t:word $n in", "for $n in", "a variable has no kind: `for $n in …`"),
    sure(CODE, "^for $n :/of/= $s:part {", "for $n in $s {", "a loop is `for $n in … { … }`"),
    told(
        CODE,
        "^for $n in $a:part . ~./.. $l:part {",
        "repeat true {",
        "there are no ranges: `repeat n { … }` does something `n` times",
    ),
    told(
        CODE,
        "^for $n in $a:part .5/.6/.7/.8/.9/.10/.3/.4/.2/.1/.20/.50/.100 {",
        "repeat true {",
        "there are no ranges: `repeat n { … }` does something `n` times",
    ),
    told(
        CODE,
        "^for $n in range ( $a:inside ) : $:end",
        "",
        "there are no ranges: `repeat n { … }` does something `n` times, in braces",
    ),
    told(CODE, "^$w=for/while/if/elif $l:part : $:end", "$w $l { }", BRACES),
    told(CODE, "^$w=else/repeat/try $l:part : $:end", "", BRACES),
    fixed(CODE, "$k=in edge {", "", "$k edges {", "the edges of the mesh are `edges`"),
    fixed(CODE, "$k=in vertex {", "", "$k vertices {", "the vertices of the mesh are `vertices`"),
    fixed(CODE, "$k=in face {", "", "$k faces {", "the faces of the mesh are `faces`"),
    told(
        CODE,
        "^do { $b:inside } while $c:line",
        "",
        "a loop asks before each turn: `while c { … }`",
    ),
    sure(CODE, "^loop {", "while true {", "`loop` is written `while true`"),
    told(CODE, "^switch/match $x:inside {", "{", CHOICE),
    told(CODE, "^try {", "{", "a refusal is asked for: `if split(e) { … } else { … }`"),
    told(
        CODE,
        "^throw/raise/panic $l:line",
        "",
        "a script is stopped by `assert c else \"…\"`, an op in steps refused by `require c else \"…\"`",
    ),
    sure(CODE, "$p=) then/do {", "$p {", "no `{}` stands before a brace"),
    sure(CODE, "$n then/do {", "$n {", "no `{}` stands before a brace"),
    sure(CODE, "^pass/noop $:end", "", "an empty block is `{ }`"),
    told(
        CODE,
        "^import/using/include/from $l:line",
        "",
        "files are used at the head of a file: `use \"std/triangle.hedge\"`",
    ),
    told(
        CODE,
        "^before/after { $b:inside }",
        "",
        "what is drawn is an operation: `op name(e: edge) { before { … } after { … } }`",
    ),
    told(CODE, "^end $:end", "", "a block ends with `}`"),
    // Variables.
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
    // Statements.
    told(
        CODE,
        "std : : cout/cerr $l:line",
        "",
        "values are printed by `print \"{count(edges)} edges\"`",
    ),
    told(
        CODE,
        "^cout/cerr < $l:line",
        "",
        "values are printed by `print \"{count(edges)} edges\"`",
    ),
    sure(
        CODE,
        "^print ( $l:inside ) $:end",
        "print $l",
        "what is printed stands without parentheses",
    ),
    sure(
        CODE,
        "print f $t:text",
        "print $t",
        "values stand in any text that is printed: `print \"{x}\"`",
    ),
    sure(
        CODE,
        "$w=assert/require ( $c:inside , $t:text ) $:end",
        "$w $c else $t",
        "the reason stands behind `else`",
    ),
    sure(
        CODE,
        "$w=assert/require $c:part ,/: $t:text",
        "$w $c else $t",
        "the reason stands behind `else`",
    ),
    sure(
        CODE,
        "= $a:some _if $c:some _else $b:line",
        "= if $c { $a } else { $b }",
        "a choice is `if c { x } else { y }`",
    ),
    sure(
        CODE,
        "return $a:some _if $c:some _else $b:line",
        "return if $c { $a } else { $b }",
        "a choice is `if c { x } else { y }`",
    ),
    sure(
        CODE | HEAD,
        "{ $a:some _if $c:some _else $b:some }",
        "{ if $c { $a } else { $b } }",
        "a choice is `if c { x } else { y }`",
    ),
    told(
        CODE,
        "^for $i , $v in $s:part {",
        "for $v in $s {",
        "a loop has one variable: `for $v in vertices { … }`; `var i = 0` and `i = i + 1` count",
    ),
    told(
        CODE,
        "^for $i in range/seq/xrange ( $n:inside ) {",
        "repeat $n {",
        "there are no ranges: `repeat n { … }` does something `n` times, `for e in edges { … }` \
         visits what there is",
    ),
    sure(
        CODE | PARTS,
        "$f ( mesh/bm/geometry/geom , ",
        "$f(",
        "a script has one mesh, which has no name: `$f(…)`",
    ),
    sure(
        CODE | PARTS,
        "in mesh/bm/geometry/self . $s=vertices/edges/faces/halfedges/holes",
        "in $s",
        "a script has one mesh, which has no name: `$s`",
    ),
    // Values.
    told(CODE | PARTS, "is not $b=None/null/nil/nullptr/NULL", "!= true", EXISTS),
    told(CODE | PARTS, "is $b=None/null/nil/nullptr/NULL", "!= true", EXISTS),
    sure(CODE | PARTS, "is not $b:word", "!= $b", "`is not` is written `!=`"),
    sure(CODE | PARTS, "is $b:word", "== $b", "`is` is written `==`"),
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
        "a pointer is read behind a dot: `h.$p`",
    ),
    sure(CODE | PARTS, "~-> ~$p:word", ".$p", "a pointer is read behind a dot: `h.$p`"),
    told(CODE | PARTS, ". $f:word ~( $x:inside )", "", CALLED),
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
    told(CODE | PARTS, "= | $x | $:end", "= $x", "the size of a number is `abs(x)`"),
    told(CODE | PARTS, "= | $x:line", "= true", "functions have names: `fn name(x: real) { … }`"),
    told(
        CODE | PARTS,
        "= $x => $l:line",
        "= true",
        "functions have names: `fn name(x: real) { … }`",
    ),
    fixed(
        CODE | PARTS,
        "print | $x |",
        "print $x",
        "print abs($x)",
        "the size of a number is `abs(x)`",
    ),
    fixed(CODE | PARTS, "| $x |", "$x", "abs($x)", "the size of a number is `abs(x)`"),
    sure(CODE | PARTS, "=>", ">=", "`{}` is written `>=`"),
    told(
        CODE | PARTS,
        "$a:word : : $b:word",
        "$b",
        "a name stands alone, without what it belongs to: `$b`",
    ),
    told(CODE | PARTS, "null/None/nullptr/nil", "true", EXISTS),
    told(PARTS, "^face/edge/vertex/hole/loop $n : $l:line", "", SIDES),
];

/// A piece of what is written in place of a pattern.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Its place in the template.
    pub place: Range<usize>,
    /// The hole it is, if it is one.
    pub hole: Option<&'static str>,
    /// Its kind and its text, if it is none.
    pub kind: TokenKind,
    pub word: &'static str,
}

/// One way of writing from elsewhere.
#[derive(Debug)]
pub(super) struct Habit {
    pub place: Places,
    pub says: &'static str,
    seen: Pattern,
    ours: Vec<Piece>,
    fix: Option<(Vec<Piece>, &'static str)>,
}

impl Habit {
    fn of(line: &Line) -> Self {
        let ours = pieces(line.ours);
        let is_ours = |piece: &Piece| {
            piece.hole.is_some() || piece.kind.spelling().is_some() || piece.word == "main"
        };
        debug_assert!(ours.iter().all(is_ours), "`{}` is not of the language", line.ours);
        Self {
            place: line.place,
            says: line.says,
            seen: Pattern::of(line.seen),
            ours,
            fix: line.fix.map(|fix| (pieces(fix), fix)),
        }
    }

    /// The pattern by which it is seen.
    pub(super) fn seen(&self) -> &Pattern {
        &self.seen
    }

    /// The pieces that the rest of the item is read with.
    pub(super) fn ours(&self) -> &[Piece] {
        &self.ours
    }

    /// The text in its place, and its template; nothing where that is not sure.
    pub(super) fn fix(&self) -> (&[Piece], &'static str) {
        self.fix.as_ref().map_or((&[], ""), |(pieces, template)| (pieces, template))
    }

    /// True if it is known what is written instead.
    pub(super) fn is_sure(&self) -> bool {
        self.fix.is_some()
    }

    /// True if the rest of the item may not be what was meant.
    pub(super) fn ends(&self) -> bool {
        self.fix.as_ref().is_none_or(|(fix, _)| fix.len() != self.ours.len())
    }

    /// The holes that may stand in what is said.
    pub(super) fn holes_of_says(&self) -> impl Iterator<Item = &'static str> {
        let pieces = pieces(self.says).into_iter();
        pieces.filter_map(|piece| piece.hole)
    }
}

/// The table, taken apart.
pub(super) fn habits() -> &'static [Habit] {
    static HABITS: LazyLock<Vec<Habit>> = LazyLock::new(|| LINES.iter().map(Habit::of).collect());
    &HABITS
}

/// The pieces of a template.
fn pieces(template: &'static str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while let Some(rest) = template.get(at..).filter(|rest| !rest.is_empty()) {
        let skipped = rest.len() - rest.trim_start().len();
        if skipped > 0 {
            at += skipped;
            continue;
        }
        let hole = rest.strip_prefix('$').map(|hole| {
            let end = hole.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(hole.len());
            &hole[..end]
        });
        let hole = hole.filter(|hole| !hole.is_empty());
        let (kind, length) = match hole {
            Some(hole) => (TokenKind::Word, hole.len() + 1),
            None => {
                let until = rest.find(['$', ' ']).filter(|&until| until > 0);
                let mut lexer = TokenKind::lexer(&rest[..until.unwrap_or(rest.len())]);
                let kind = lexer.next().and_then(Result::ok).unwrap_or(TokenKind::Word);
                (kind, lexer.slice().len().max(rest.chars().next().map_or(1, char::len_utf8)))
            }
        };
        let place = at..at + length;
        pieces.push(Piece { word: &template[place.clone()], place, hole, kind });
        at += length;
    }
    pieces
}
