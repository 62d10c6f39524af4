//! Loops of scripts and functions.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, PARTS};

const LOOP: &str = "a loop is `for v in vertices where … { … }`";
const COUNTED: &str = "a loop over ints is `for i in 0..n { … }`: from 0 up to, but without, n";
const BRACES: &str = "a block stands in braces: `$w … { … }`";
const LEAST: &str = "`drain` takes the least key first; `by -x` takes the greatest";
const ORDERED: &str =
    "`for` has no order; `drain $n in … by x while … { … }` takes the least first";
const PARALLEL: &str = "`where` is tested on all threads: `parallel for $n in … where … { … }`";
const SEVERAL: &str =
    "a choice among several is `if x == 1 { … } else if x == 2 { … } else { … }`, also as a value";
const STOPPED: &str = "a script is stopped by `assert c else \"…\"`, an op in steps refused by `require c else \"…\"`";

const COLON: &str = "no `:` stands before a brace";
const ALONE: &str = "a single statement stands in braces, too: `$k … { $f … }`";
const ALONE_THEN: &str = "a statement stands in braces, without `then`: `if … { $f … }`";
const ALL: &str = "a single statement stands in braces, too: `for $n in … { $f … }`";

pub(super) const LINES: &[Line] = &[
    // Without braces. Statements begin with a word.
    sure(CODE, "^if ( $c:inside ) then $f:verb $r:part ;", "if $c { $f $r }", ALONE_THEN),
    told(CODE, "^if $c:value then $f:verb $r:line", "if $c { $f $r }", ALONE_THEN),
    sure(CODE, "^$k=if/while ( $c:inside ) $f:verb $r:part ;", "$k $c { $f $r }", ALONE),
    sure(CODE, "^$k=if/while ( $c:inside ) $f=break/continue $:end", "$k $c { $f }", ALONE),
    sure(
        CODE,
        "^$k=else if ( $c:inside ) $f:verb $r:part ;",
        "else if $c { $f $r }",
        "a single statement stands in braces, too: `else if … { $f … }`",
    ),
    sure(CODE, "^$k=else $f:verb $r:part ;", "else { $f $r }", ALONE),
    fixed(
        CODE,
        "^for/foreach ( $t:inside $n : $s:inside ) $f=for/if/while $r:part ;",
        "for $n in $s { }",
        "for $n in $s { $f $r; }",
        ALL,
    ),
    sure(
        CODE,
        "^for/foreach ( $t:inside $n : $s:inside ) $f:verb $r:part ;",
        "for $n in $s { $f $r }",
        ALL,
    ),
    fixed(
        CODE,
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $n = $a:bound ; $n < $b:bound ; $n:next ) $f=for/if/while $r:part ;",
        "for $n in $a..$b { }",
        "for $n in $a..$b { $f $r; }",
        ALL,
    ),
    sure(
        CODE,
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $n = $a:bound ; $n < $b:bound ; $n:next ) $f:verb $r:part ;",
        "for $n in $a..$b { $f $r }",
        ALL,
    ),
    told(
        CODE,
        "^for $n in $s=vertices/edges/faces/halfedges/holes $:end",
        "for $n in $s { }",
        "what is done for each stands in braces: `for $n in $s { … }`",
    ),
    sure(CODE, "^for $n in $s=vertices/edges/faces/halfedges/holes : {", "for $n in $s {", COLON),
    sure(CODE, "^$k=for/if/while $c:some : {", "$k $c {", COLON),
    sure(
        CODE,
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $i = $a:bound ; $i < $n:bound ; $i:next ) {",
        "for $i in $a..$n {",
        COUNTED,
    ),
    sure(
        CODE,
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $i = $a:bound ; $i <= $n:bound ; $i:next ) {",
        "for $i in $a..$n + 1 {",
        COUNTED,
    ),
    told(
        CODE,
        "^for ( $i:inside ; $c:inside ; $s:inside ) {",
        "repeat true {",
        "a loop is `for i in 0..n { … }`, `while c { … }` or `for v in vertices { … }`",
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
    sure(CODE, "^for parallel $n in", "parallel for $n in", PARALLEL),
    sure(
        CODE,
        "^parallel_for/parfor/pfor/parallelfor/prange $n in",
        "parallel for $n in",
        PARALLEL,
    ),
    sure(CODE, "^par for $n in", "parallel for $n in", PARALLEL),
    sure(CODE, "^parallel for each/all/every $n in", "parallel for $n in", PARALLEL),
    sure(CODE, "^parallel foreach/forall $n in", "parallel for $n in", PARALLEL),
    told(CODE, "^parallel for $n in $s:some by $k:some {", "parallel for $n in $s {", ORDERED),
    sure(CODE, "^for each/all/every $n in", "for $n in", "a loop is `for $n in … { … }`"),
    sure(CODE, "^for $t:word $n in", "for $n in", "a variable has no kind: `for $n in …`"),
    sure(CODE, "^for $i in/= $a:part to/upto/through $b:part {", "for $i in $a..$b + 1 {", COUNTED),
    told(CODE, "^for $i in/= $a:part ,/:/downto $b:part {", "for $i in $a..$b {", COUNTED),
    sure(CODE, "^for $n :/of/= $s:part {", "for $n in $s {", "a loop is `for $n in … { … }`"),
    sure(CODE, "^for $i in $a:part .. = $n:part {", "for $i in $a..$n + 1 {", COUNTED),
    sure(CODE, "^repeat $i in/=/: $a:part .. $n:part {", "for $i in $a..$n {", COUNTED),
    sure(CODE, "^repeat $i in/=/: $n:some {", "for $i in 0..$n {", COUNTED),
    sure(CODE, "^repeat $n:some times/time/x {", "repeat $n {", "it is `repeat n { … }`"),
    sure(CODE, "^drain min/least/smallest/lowest $n in", "drain $n in", LEAST),
    told(CODE, "^drain max/most/largest/greatest/highest $n in", "drain $n in", LEAST),
    sure(
        CODE,
        "^drain $n in $s:some while $c:some by $k:some {",
        "drain $n in $s by $k while $c {",
        "the key stands before the condition: `drain $n in … by … while … { … }`",
    ),
    fixed(
        CODE,
        "by $k:some desc/descending/decreasing $o={/while",
        "by $k $o",
        "by -($k) $o",
        LEAST,
    ),
    sure(CODE, "by $k:some asc/ascending/increasing $o={/while", "by $k $o", LEAST),
    told(CODE, "^for $n in $s:some order/sorted/sort by $k:some {", "for $n in $s {", ORDERED),
    told(
        CODE,
        "^for $i in $a:part .. $n:part step/by - $s:part {",
        "for $i in $a..$n {",
        "a range has no step: `var $i = $a`, then `while $i > $n { … $i = $i - $s }`",
    ),
    told(
        CODE,
        "^for $i in $a:part .. $n:part step/by $s:part {",
        "for $i in $a..$n {",
        "a range has no step: `var $i = $a`, then `while $i < $n { … $i = $i + $s }`",
    ),
    told(CODE, "^for $n in $s:some by $k:some {", "for $n in $s {", ORDERED),
    sure(
        CODE,
        "^for $n in $s:part { $b:inside } where $c:part $:end",
        "for $n in $s where $c { $b }",
        "a condition stands before the block: `for $n in … where … { … }`",
    ),
    told(
        CODE,
        "^for $n in range ( $a:inside ) : $:end",
        "",
        "a loop over ints is `for $n in 0..n { … }`, in braces",
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
    told(CODE, "^switch/match $x:inside { $b:inside }", "", SEVERAL),
    told(CODE, "^switch/match $x:inside {", "{", SEVERAL),
    told(CODE | PARTS, "$w==/return/( switch/match $x:inside { $b:inside }", "$w true", SEVERAL),
    told(CODE, "^try {", "{", "a refusal is asked for: `if split(e) { … } else { … }`"),
    told(CODE, "^throw/raise/panic $l:line", "", STOPPED),
    told(CODE, "^error/fail/abort/die $t:text", "", STOPPED),
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
];
