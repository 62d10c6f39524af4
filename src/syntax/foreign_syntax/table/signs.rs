//! Signs: operators, arrows, ends of lines.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, DRAWING, HEAD, PARTS};

const END: &str = "no `;`: a statement ends where the next one begins";
const POWER: &str = "a power is `pow(x, y)`, a square `x * x`";
const CHOICE: &str = "a choice is `if c { x } else { y }`";
const CHANGE: &str = "a change is written out: `x = x mod 2`, `c = c and d`";

/// The sign at the end of a statement, where no other line says more of what follows it.
pub(super) const ENDS: &[Line] = &[
    // What begins like this would go on with what stands before the sign.
    told("; $:sign", "", END),
    sure(";", "", END),
];

pub(super) const LINES: &[Line] = &[
    told("&&/&/%/^ ~= $v:line", "= $v", CHANGE).at(CODE | PARTS | DRAWING),
    told("| ~| ~= $v:line", "= $v", CHANGE).at(CODE | PARTS | DRAWING),
    sure("&&/&/∧", "and", "`{}` is written `and`"),
    sure("| ~|", "or", "`||` is written `or`").at(CODE | PARTS),
    sure("∨", "or", "`{}` is written `or`"),
    sure("!/¬", "not", "`{}` is written `not`"),
    sure("%", "mod", "`%` is written `mod`"),
    sure("== ~=", "==", "`===` is written `==`").at(CODE | PARTS),
    sure("!= ~=", "!=", "`!==` is written `!=`").at(CODE | PARTS),
    sure("< ~>", "!=", "`<>` is written `!=`").at(CODE | PARTS),
    sure("= ~<", "<=", "`=<` is written `<=`").at(CODE | PARTS),
    sure("≤", "<=", "`{}` is written `<=`"),
    sure("≥", ">=", "`{}` is written `>=`"),
    sure("≠", "!=", "`{}` is written `!=`"),
    told("×",
        "*",
        "a product of numbers is `x * y`, the cross product of vectors `cross(p, q)`",
    ),
    told("·/⋅",
        "*",
        "a product of numbers is `x * y`, the dot product of vectors `dot(p, q)`",
    ),
    sure("∗", "*", "`{}` is written `*`"),
    sure("÷", "/", "`{}` is written `/`"),
    sure("−/–/—/─ $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`").at(DRAWING),
    sure("- $a →/⟶/➔", "-$a->", "an arrow is typed `-$a->`").at(DRAWING),
    sure("= $a ⇒", "=$a=>", "a path is typed `=$a=>`").at(DRAWING),
    sure("−/–/—/─", "-", "`{}` is written `-`"),
    sure("→/⟶/➔", "->", "`{}` is written `->`"),
    sure("⇒", "=>", "`{}` is written `=>`"),
    sure("…", "=>", "a path without a name is `=>`").at(DRAWING),
    fixed("∈", "in", "in", "`{}` is written `in`").at(CODE),
    // After one of these tokens, the operand is the whole base of the power.
    fixed("$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else $x:operand * ~* $n:exponent",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ).at(CODE | PARTS),
    fixed("$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else $x:operand ^ $n:exponent",
        "$b $x * $n",
        "$b pow($x, $n)",
        POWER,
    ).at(CODE | PARTS),
    fixed("$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else ( $x:inside ) * ~* $n:exponent",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ).at(CODE | PARTS),
    fixed("$b=(/,/=/+/-/{/}/</>/<=/>=/==/!=/return/print/and/or/not/if/while/where/by/assert/require/else ( $x:inside ) ^ $n:exponent",
        "$b ( $x ) * $n",
        "$b pow($x, $n)",
        POWER,
    ).at(CODE | PARTS),
    told("* ~*", "*", POWER).at(CODE | PARTS),
    told("^", "*", POWER),
    sure("= $c:value ? $a:value : $b:whole", "= if $c { $a } else { $b }", CHOICE).at(CODE),
    sure("return $c:value ? $a:value : $b:whole", "return if $c { $a } else { $b }", CHOICE).at(CODE),
    sure("print $c:value ? $a:value : $b:whole", "print if $c { $a } else { $b }", CHOICE).at(CODE),
    sure("{ $c:value ? $a:value : $b:value }", "{ if $c { $a } else { $b } }", CHOICE).at(CODE | HEAD),
    sure("$o=(/, $c:bound ? $a:bound : $b:bound $p=)/,",
        "$o if $c { $a } else { $b } $p",
        CHOICE,
    ).at(CODE | PARTS),
    told("? $a:part : $b:line", "", CHOICE),
];
