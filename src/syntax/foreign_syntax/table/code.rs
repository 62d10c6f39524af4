//! Other statements of scripts and functions.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, HEAD, PARTS};

const CHANGED: &str = "a script changes a mesh by calling operations: `dissolve_edge(e)`";
const REFUSED: &str = "`must` stops where an op refuses, `if let x = …` asks";

const PRINTED: &str = "values are printed by `print \"{count(edges)} edges\"`";
const PRINT: &str = "a value is printed by `print $x`";
const NOT_STD: &str = "no `std::` stands in front";
const RANGE: &str = "a range is `0..n`: from 0 up to, but without, n";

pub(super) const LINES: &[Line] = &[
    sure(CODE, "^std :: $c=cout/cerr", "$c", NOT_STD),
    sure(CODE, "^cout/cerr < ~< $x:text $:end", "print $x", PRINT),
    sure(CODE, "^cout/cerr < ~< $x:text < ~< endl $:end", "print $x", PRINT),
    sure(CODE, "^cout/cerr < ~< $x:text < ~< std :: endl $:end", "print $x", PRINT),
    sure(CODE, "^cout/cerr < ~< $x:operand $:end", "print $x", PRINT),
    sure(CODE, "^cout/cerr < ~< $x:operand < ~< endl $:end", "print $x", PRINT),
    sure(CODE, "^cout/cerr < ~< $x:operand < ~< std :: endl $:end", "print $x", PRINT),
    sure(CODE, "^console . log/info/debug/error ~( $x:inside )", "print $x", PRINTED),
    sure(CODE, "^println/print/eprintln/printf ! ( $t:text , $x:inside )", "print $x", PRINTED),
    sure(CODE, "^println/print/eprintln/printf ! ( $x:inside )", "print $x", PRINTED),
    told(CODE, "^cout/cerr < $l:line", "", PRINTED),
    sure(CODE, "^print : $l:line", "print $l", "no colon stands behind `print`"),
    told(
        CODE | PARTS,
        "$t:text % $l:line",
        "$t",
        "values stand in a text that is printed: `print \"n={count(edges)}\"`",
    ),
    sure(CODE, "^$f ( $a:inside ) ~!/?", "must $f($a)", REFUSED),
    sure(CODE, "= $f ( $a:inside ) ~!/? $:end", "= must $f($a)", REFUSED),
    sure(
        CODE,
        "$w=can/why ( $f , $a:inside )",
        "$w $f($a)",
        "`$w` stands before the call: `$w $f(…)`",
    ),
    sure(
        CODE,
        "$w=can/why ( $f ( $a:inside ) )",
        "$w $f($a)",
        "`$w` stands before the call: `$w $f(…)`",
    ),
    told(
        CODE,
        "^attr $l:line",
        "",
        "an attribute is declared beside scripts, not in them: `attr weight: edge real = 0`",
    ),
    told(
        CODE,
        "^private attr $l:line",
        "",
        "an attribute is declared beside scripts, not in them: `private attr weight: edge real = 0`",
    ),
    sure(CODE, "^private $k=let/var", "$k", "a variable is seen in its block only"),
    sure(
        CODE,
        "^private $k=fn/op/script",
        "$k",
        "what is `private` is declared beside scripts, not in them",
    ),
    told(
        CODE,
        "^$k=fn/op/script $f ( $p:inside ) $r:part { $b:inside }",
        "",
        "`$k $f` is declared beside what calls it, not in it",
    ),
    told(CODE, "^erase/keep/new $n:part $:end", "", CHANGED),
    told(
        CODE,
        "^delete/remove $n $:end",
        "",
        "a script changes a mesh by calling operations: `dissolve_edge(e)`, `open_face(f)`; many faces \
         are deleted by `std/delete.hedge`",
    ),
    told(CODE, "= new vertex/edge/face/halfedge $l:line", "= true", CHANGED),
    sure(
        CODE,
        "^print ( f $t:text ) $:end",
        "print $t",
        "values stand in any text that is printed, without parentheses: `print \"{x}\"`",
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
        "= $a:value _if $c:value _else $b:whole",
        "= if $c { $a } else { $b }",
        "a choice is `if c { x } else { y }`",
    ),
    sure(
        CODE,
        "return $a:value _if $c:value _else $b:whole",
        "return if $c { $a } else { $b }",
        "a choice is `if c { x } else { y }`",
    ),
    sure(
        CODE | HEAD,
        "{ $a:value _if $c:value _else $b:value }",
        "{ if $c { $a } else { $b } }",
        "a choice is `if c { x } else { y }`",
    ),
    told(
        CODE,
        "^for $i , $v in $s:part {",
        "for $v in $s {",
        "a loop has one variable: `for $v in vertices { … }`; `var i = 0` and `i = i + 1` count",
    ),
    fixed(
        CODE,
        "^for $i in range/seq/xrange ( len ( $s:inside ) ) {",
        "for $i in 0..1 {",
        "for $i in 0..count($s) {",
        RANGE,
    ),
    sure(
        CODE,
        "^for $i in range/seq/xrange ( $a:part , $n:part ) {",
        "for $i in $a..$n {",
        "a range is `a..n`: from a up to, but without, n",
    ),
    sure(CODE, "^for $i in range/seq/xrange ( $n:part ) {", "for $i in 0..$n {", RANGE),
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
];
