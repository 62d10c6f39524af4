//! Parts of an op.

use super::{Line, STEPS, sure, told};

const GUARDED: &str =
    "`guard simple` names a level; what has to hold is asked by `require c else \"…\"`";
const REQUIRED: &str = "what has to hold is asked by `require c else \"…\"`";
const ALTERNATIVE: &str = "an alternative is `rule $n { … }`";
const REFUSED: &str = "an op refuses by `require c else \"…\"`, with what has to hold";
const REASON: &str = "the reason of a refusal stands behind `else`";

pub(super) const LINES: &[Line] = &[
    sure(
        "^alias $a =/==/| $b $:end",
        "alias $a $b",
        "names that may be one stand side by side: `alias $a $b`",
    ),
    sure(
        "^alias (/{/[ $l:names )/}/]",
        "alias $l",
        "names that may be one stand side by side, without brackets: `alias v2 v3`",
    ),
    told("^alias $a $:end", "", "`alias` lists two names or more, of which any may be one"),
    sure(
        "^guard surface $a=simple",
        "guard $a",
        "one level is guarded: what is simple is a surface, too",
    ),
    told(
        "^keeps/ensures/ensure/maintain/maintains/preserve/preserves $l:line",
        "",
        "what is to be proved stands in the head, `op flip(e: edge) keeps triangles {`; `guard simple` refuses what would break a level",
    ),
    sure(
        "^require $a:some = $b:some",
        "require $a == $b",
        "whether two are equal is asked by `==`",
    ),
    sure("->/=>/,/;/→/⇒/⟶ $a=after", "$a", "nothing stands between the parts of an op"),
    sure("->/=>/→/⇒/⟶ {", "after {", "what an op leaves is `after { … }`"),
    sure("$s=before/after/steps :/= {", "$s {", "`$s` is followed by its brace"),
    sure("$s=before/after/steps :/= $:end", "$s {", "`$s { … }` has braces"),
    sure(
        "$s=before/after $k=face/hole/loop/edge/vertex/new/keep/erase",
        "$s { $k",
        "`$s` is followed by a brace: `$s { … }`",
    ),
    sure(
        "^pre/given/lhs/match/from/old/input/find/left/where/when/source/initial/original/start/precondition/LHS/pattern/Before/BEFORE/begin {",
        "before {",
        "`before { … }` is what an op finds; `{}` is not written",
    ),
    sure(
        "^post/then/rhs/to/becomes/result/new/output/replace/right/do/target/into/final/afterwards/yields/produces/RHS/After/AFTER/become/replacement/end {",
        "after {",
        "`after { … }` is what an op leaves; `{}` is not written",
    ),
    sure("^alternative/case/or/variant/option/Rule $n {", "rule $n {", ALTERNATIVE),
    sure("rule : $n {", "rule $n {", ALTERNATIVE),
    sure("rule $n : {", "rule $n {", ALTERNATIVE),
    sure("rule $n ( ) {", "rule $n {", ALTERNATIVE),
    told("rule {", "", "alternatives have names: `rule interior { … }`"),
    told(
        "rule $n:text {",
        "",
        "the name of an alternative stands without quotes: `rule interior { … }`",
    ),
    told(
        "if $c:inside { return/refuse/fail/abort/break $r:inside } $b=before",
        "$b",
        "an op refuses by `require c else \"…\"`, with what has to hold, behind its `before`",
    ),
    sure(
        "if $c:inside { return/refuse/fail/abort/reject/stop/exit/throw/raise/break }",
        "require not ($c)",
        REFUSED,
    ),
    sure("if $c:inside { return false/none/nil/null/nullptr }", "require not ($c)", REFUSED),
    sure(
        "if $c:inside { return/refuse/fail/abort/reject/stop/exit/throw/raise/break $r:text }",
        "require not ($c) else $r",
        REFUSED,
    ),
    told(
        "if $c:inside { return/refuse/fail/abort/reject/stop/exit/throw/raise/break $r:inside }",
        "require not ($c)",
        REFUSED,
    ),
    sure("if ( $c:inside ) return ; $:end", "require not ($c)", REFUSED),
    told("if ( $c:inside ) return $r:line", "require not ($c)", REFUSED),
    sure("^assert ~! ( $c:some , $t:text )", "require $c else $t", REFUSED),
    sure("^assert ~! ( $c:inside )", "require $c", REFUSED),
    sure("^unless/refuse/reject/forbid $c:line", "require not ($c)", REFUSED),
    sure(
        "^guard ( $l=map/surface/simple )",
        "guard $l",
        "a level stands without parentheses: `guard $l`",
    ),
    sure("^guard ( $c:inside )", "require $c", GUARDED),
    sure("^guard $b=not/! $c:part", "require not $c", GUARDED),
    sure("^guard $a:operand $o===/!=/</>/<=/>=", "require $a $o", GUARDED),
    sure("^guard $f ( $c:inside )", "require $f($c)", GUARDED),
    sure("$w=require/guard :", "$w", "no colon stands behind `$w`"),
    sure(
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition ( $c:inside , $t:text )",
        "require $c else $t",
        REQUIRED,
    ),
    sure("^require ( $c:inside , $t:text )", "require $c else $t", REASON),
    sure("^require $c:part ,/: $t:text", "require $c else $t", REASON),
    sure(
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition :",
        "require",
        REQUIRED,
    ),
    sure("^only if", "require", REQUIRED),
    sure(
        "^assert/requires/when/where/precondition/check/ensure/only/provided/Require/demand/expect/assume/condition",
        "require",
        REQUIRED,
    ),
    sure("^guards/level/guarantee $l=map/surface/simple", "guard $l", "`{}` is written `guard`"),
    sure("^aliases/allow/may_alias $a $b", "alias $a $b", "`{}` is written `alias`"),
    told("^for/while/if/repeat/drain/update $h:inside { $b:inside } else { $c:inside }", "", STEPS),
    told("^for/while/if/repeat/drain/update $h:inside { $b:inside }", "", STEPS),
    told("^return $m $:end", "", "what an op returns stands in its head: `op … -> $m`"),
    told("^let/var/print/return/must/const/auto $l:line", "", STEPS),
    told("^$n ( $a:inside ) $l:line", "", STEPS),
    told("^$n . $l:line", "", STEPS),
    told("^$n ->/= $l:line", "", STEPS),
    told("^$t:word $n = $l:line", "", STEPS),
    told("^each $i { $b:inside }", "", "what is drawn stands in `before { … }` or `after { … }`"),
];
