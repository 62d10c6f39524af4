//! Parts of an op.

use super::{Line, STEPS, sure, told};
use crate::syntax::foreign_syntax::place::PARTS;

const GUARDED: &str =
    "`guard simple` names a level; what has to hold is asked by `require c else \"…\"`";
const REQUIRED: &str = "what has to hold is asked by `require c else \"…\"`";

pub(super) const LINES: &[Line] = &[
    sure(
        PARTS,
        "^alias $a =/==/| $b $:end",
        "alias $a $b",
        "names that may be one stand side by side: `alias $a $b`",
    ),
    sure(
        PARTS,
        "^alias (/{/[ $l:names )/}/]",
        "alias $l",
        "names that may be one stand side by side, without brackets: `alias v2 v3`",
    ),
    told(PARTS, "^alias $a $:end", "", "`alias` lists two names or more, of which any may be one"),
    sure(
        PARTS,
        "^guard surface $a=simple",
        "guard $a",
        "one level is guarded: what is simple is a surface, too",
    ),
    told(
        PARTS,
        "^keeps/ensures/ensure/maintain/maintains/preserve/preserves $l:line",
        "",
        "what is to be proved stands in the head, `op flip(e: edge) keeps triangles {`; `guard simple` refuses what would break a level",
    ),
    sure(
        PARTS,
        "^require $a:some = $b:some",
        "require $a == $b",
        "whether two are equal is asked by `==`",
    ),
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
    sure(PARTS, "^guard $a:operand $o===/!=/</>/<=/>=", "require $a $o", GUARDED),
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
    told(PARTS, "^return $m $:end", "", "what an op returns stands in its head: `op … -> $m`"),
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
];
