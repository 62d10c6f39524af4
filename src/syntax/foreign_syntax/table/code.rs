//! Other statements of scripts and functions.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, HEAD, PARTS};

const CHANGED: &str = "a script changes a mesh by calling operations: `dissolve_edge(e)`";
const REFUSED: &str = "`must` stops where an op refuses, `if let x = …` asks";

const PRINTED: &str = "values are printed by `print \"{count(edges)} edges\"`";
const PRINT: &str = "a value is printed by `print $x`";
const NOT_STD: &str = "no `std::` stands in front";
const RANGE: &str = "a range is `0..n`: from 0 up to, but without, n";
const CHOICE: &str = "a choice is `if c { x } else { y }`";
const REASON: &str = "the reason stands behind `else`";

pub(super) const LINES: &[Line] = &[
    sure("^std :: $c=cout/cerr", "$c", NOT_STD),
    sure("^cout/cerr < ~< $x:text $:end", "print $x", PRINT),
    sure("^cout/cerr < ~< $x:text < ~< endl $:end", "print $x", PRINT),
    sure("^cout/cerr < ~< $x:text < ~< std :: endl $:end", "print $x", PRINT),
    sure("^cout/cerr < ~< $x:operand $:end", "print $x", PRINT),
    sure("^cout/cerr < ~< $x:operand < ~< endl $:end", "print $x", PRINT),
    sure("^cout/cerr < ~< $x:operand < ~< std :: endl $:end", "print $x", PRINT),
    sure("^console . log/info/debug/error ~( $x:inside )", "print $x", PRINTED),
    told("^println/print/eprintln/printf ~! ( $t:text , $x:inside )", "print $x", PRINTED),
    sure("^println/print/eprintln/printf ~! ( $x:inside )", "print $x", PRINTED),
    sure("^assert ~! ( $c:some , $t:text )", "assert $c else $t", REASON),
    sure("^assert ~! ( $c:inside )", "assert $c", "a condition stands behind `assert`: no `!`"),
    told("^cout/cerr < $l:line", "", PRINTED),
    sure("^print : $l:line", "print $l", "no colon stands behind `print`"),
    told(
        "$t:text % $l:line",
        "$t",
        "values stand in a text that is printed: `print \"n={count(edges)}\"`",
    )
    .at(CODE | PARTS),
    sure("^$f ( $a:inside ) ~!/?", "must $f($a)", REFUSED),
    sure("= $f ( $a:inside ) ~!/? $:end", "= must $f($a)", REFUSED),
    sure("$w=can/why ( $f , $a:inside )", "$w $f($a)", "`$w` stands before the call: `$w $f(…)`"),
    sure("$w=can/why ( $f ( $a:inside ) )", "$w $f($a)", "`$w` stands before the call: `$w $f(…)`"),
    told(
        "^attr $l:line",
        "",
        "an attribute is declared beside scripts, not in them: `attr weight: edge real = 0`",
    ),
    told(
        "^private attr $l:line",
        "",
        "an attribute is declared beside scripts, not in them: `private attr weight: edge real = 0`",
    ),
    sure("^private $k=let/var", "$k", "a variable is seen in its block only"),
    sure(
        "^private $k=fn/op/script",
        "$k",
        "what is `private` is declared beside scripts, not in them",
    ),
    told(
        "^$k=fn/op/script $f ( $p:inside ) $r:part { $b:inside }",
        "",
        "`$k $f` is declared beside what calls it, not in it",
    ),
    told("^erase/keep/new $n:part $:end", "", CHANGED),
    told(
        "^delete/remove $n $:end",
        "",
        "a script changes a mesh by calling operations: `dissolve_edge(e)`, `open_face(f)`; many faces \
         are deleted by `std/delete.hedge`",
    ),
    told("= new vertex/edge/face/halfedge $l:line", "= true", CHANGED),
    sure(
        "^print ( f $t:text ) $:end",
        "print $t",
        "values stand in any text that is printed, without parentheses: `print \"{x}\"`",
    ),
    told(
        "^print $a:operand is $l:line",
        "print $a",
        "commas stand between values that are printed, and words stand in quotes",
    ),
    sure("^print ( $l:inside ) $:end", "print $l", "what is printed stands without parentheses"),
    sure(
        "print f $t:text",
        "print $t",
        "values stand in any text that is printed: `print \"{x}\"`",
    ),
    sure("$w=assert/require ( $c:inside , $t:text ) $:end", "$w $c else $t", REASON),
    sure("$w=assert/require $c:part ,/: $t:text", "$w $c else $t", REASON),
    sure("= $a:value _if $c:value _else $b:whole", "= if $c { $a } else { $b }", CHOICE),
    sure("return $a:value _if $c:value _else $b:whole", "return if $c { $a } else { $b }", CHOICE),
    sure("{ $a:value _if $c:value _else $b:value }", "{ if $c { $a } else { $b } }", CHOICE)
        .at(CODE | HEAD),
    told(
        "^for $i , $v in $s:part {",
        "for $v in $s {",
        "a loop has one variable: `for $v in vertices { … }`; `var i = 0` and `i = i + 1` count",
    ),
    fixed(
        "^for $i in range/seq/xrange ( len ( $s:inside ) ) {",
        "for $i in 0..1 {",
        "for $i in 0..count($s) {",
        RANGE,
    ),
    sure(
        "^for $i in range/seq/xrange ( $a:part , $n:part ) {",
        "for $i in $a..$n {",
        "a range is `a..n`: from a up to, but without, n",
    ),
    sure("^for $i in range/seq/xrange ( $n:part ) {", "for $i in 0..$n {", RANGE),
    sure(
        "$f ( mesh/bm/geometry/geom , ",
        "$f(",
        "a script has one mesh, which has no name: `$f(…)`",
    )
    .at(CODE | PARTS),
    sure(
        "in mesh/bm/geometry/self . $s=vertices/edges/faces/halfedges/holes",
        "in $s",
        "a script has one mesh, which has no name: `$s`",
    )
    .at(CODE | PARTS),
];
