//! Signs: operators, arrows, ends of lines.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{ANY, CODE, DRAWING, HEAD, PARTS};

const END: &str = "no `;`: a statement ends where the next one begins";
const POWER: &str = "a power is `pow(x, y)`, a square `x * x`";
const CHOICE: &str = "a choice is `if c { x } else { y }`";
const CHANGE: &str = "a change is written out: `x = x mod 2`, `c = c and d`";

/// The sign at the end of a statement, where no other line says more of what follows it.
pub(super) const ENDS: &[Line] = &[
    // What begins like this would go on with what stands before the sign.
    told(ANY, "; $:sign", "", END),
    sure(ANY, ";", "", END),
];

pub(super) const LINES: &[Line] = &[
    told(CODE | PARTS | DRAWING, "&&/&/%/^ ~= $v:line", "= $v", CHANGE),
    told(CODE | PARTS | DRAWING, "| ~| ~= $v:line", "= $v", CHANGE),
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
    told(
        ANY,
        "×",
        "*",
        "a product of numbers is `x * y`, the cross product of vectors `cross(p, q)`",
    ),
    told(
        ANY,
        "·/⋅",
        "*",
        "a product of numbers is `x * y`, the dot product of vectors `dot(p, q)`",
    ),
    sure(ANY, "∗", "*", "`{}` is written `*`"),
    sure(ANY, "÷", "/", "`{}` is written `/`"),
    sure(DRAWING, "−/–/—/─ $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`"),
    sure(DRAWING, "- $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`"),
    sure(DRAWING, "= $a ⇒", "=$a=>", "a path is typed `=$a=>`"),
    sure(ANY, "−/–/—/─", "-", "`{}` is written `-`"),
    sure(ANY, "→/⟶/➔", "->", "`{}` is written `->`"),
    sure(ANY, "⇒", "=>", "`{}` is written `=>`"),
    sure(DRAWING, "…", "=>", "a path without a name is `=>`"),
    fixed(CODE, "∈", "in", "in", "`{}` is written `in`"),
    // After one of these tokens, the operand is the whole base of the power.
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else $x:operand * ~* $n:exponent",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else $x:operand ^ $n:exponent",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else ( $x:inside ) * ~* $n:exponent",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    fixed(
        CODE | PARTS,
        "$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else ( $x:inside ) ^ $n:exponent",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ),
    told(CODE | PARTS, "* ~*", "*", POWER),
    told(ANY, "^", "*", POWER),
    sure(CODE, "= $c:value ? $a:value : $b:whole", "= if $c { $a } else { $b }", CHOICE),
    sure(CODE, "return $c:value ? $a:value : $b:whole", "return if $c { $a } else { $b }", CHOICE),
    sure(CODE, "print $c:value ? $a:value : $b:whole", "print if $c { $a } else { $b }", CHOICE),
    sure(CODE | HEAD, "{ $c:value ? $a:value : $b:value }", "{ if $c { $a } else { $b } }", CHOICE),
    sure(
        CODE | PARTS,
        "$o=(/, $c:bound ? $a:bound : $b:bound $p=)/,",
        "$o if $c { $a } else { $b } $p",
        CHOICE,
    ),
    told(ANY, "? $a:part : $b:line", "", CHOICE),
];
