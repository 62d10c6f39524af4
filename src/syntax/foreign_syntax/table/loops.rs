//! Loops of scripts and functions.

use super::{Line, fixed, sure, told};
use crate::syntax::foreign_syntax::place::{CODE, PARTS};

const LOOP: &str = "a loop is `for v in vertices where … { … }`";
const COUNTED: &str = "a loop over ints is `for i in 0..n { … }`: from 0 up to, but without, n";
const BRACES: &str = "a block stands in braces: `$w … { … }`";
const FILTERED: &str = "a loop over some elements is `for $n in … where … { … }`";
const FILTER: &str = "`drain` has no `where`: its body begins with `if not (…) { continue }`, and leaves out what is not meant";
const LEAST: &str = "`drain` takes the least key first; `by -x` takes the greatest";
const ORDERED: &str =
    "`for` has no order; `drain $n in … by x while … { … }` takes the least first";
const PARALLEL: &str = "`where` is tested on all threads: `parallel for $n in … where … { … }`";
const SEVERAL: &str =
    "a choice among several is `if x == 1 { … } else if x == 2 { … } else { … }`, also as a value";
const STOPPED: &str = "a script is stopped by `assert c else \"…\"`, an op in steps refused by `require c else \"…\"`";

const EQUAL: &str = "whether two are equal is asked by `==`";
const ASKED: &str = "what an op returns, unless it refuses, is `if let $n = $f(…) { … }`";

const COLON: &str = "no `:` stands before a brace";
const ALONE: &str = "a single statement stands in braces, too: `$k … { $f … }`";
const ALONE_THEN: &str = "a statement stands in braces, without `then`: `if … { $f … }`";
const ALL: &str = "a single statement stands in braces, too: `for $n in … { $f … }`";

pub(super) const LINES: &[Line] = &[
    // Without braces. Statements begin with a word.
    sure("^if ( $c:inside ) then $f:verb $r:part ;", "if $c { $f $r }", ALONE_THEN),
    told("^if $c:value then $f:verb $r:line", "if $c { $f $r }", ALONE_THEN),
    sure("^$k=if/while ( $c:inside ) $f:verb $r:part ;", "$k $c { $f $r }", ALONE),
    sure("^$k=if/while ( $c:inside ) $f=break/continue $:end", "$k $c { $f }", ALONE),
    sure(
        "^$k=else if ( $c:inside ) $f:verb $r:part ;",
        "else if $c { $f $r }",
        "a single statement stands in braces, too: `else if … { $f … }`",
    ),
    sure("^$k=else $f:verb $r:part ;", "else { $f $r }", ALONE),
    fixed(
        "^for/foreach ( $t:inside $n : $s:inside ) $f=for/if/while $r:part ;",
        "for $n in $s { }",
        "for $n in $s { $f $r; }",
        ALL,
    ),
    sure(
        "^for/foreach ( $t:inside $n : $s:inside ) $f:verb $r:part ;",
        "for $n in $s { $f $r }",
        ALL,
    ),
    fixed(
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $n = $a:bound ; $n < $b:bound ; $n:next ) $f=for/if/while $r:part ;",
        "for $n in $a..$b { }",
        "for $n in $a..$b { $f $r; }",
        ALL,
    ),
    sure(
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $n = $a:bound ; $n < $b:bound ; $n:next ) $f:verb $r:part ;",
        "for $n in $a..$b { $f $r }",
        ALL,
    ),
    told(
        "^for $n in $s=vertices/edges/faces/halfedges/holes $:end",
        "for $n in $s { }",
        "what is done for each stands in braces: `for $n in $s { … }`",
    ),
    sure("^for $n in $s:some , if/where/when $c:some {", "for $n in $s where $c {", FILTERED),
    sure("^for $n in $s=vertices/edges/faces/halfedges/holes : {", "for $n in $s {", COLON),
    sure("^$k=for/if/while $c:some : {", "$k $c {", COLON),
    sure(
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $i = $a:bound ; $i < $n:bound ; $i:next ) {",
        "for $i in $a..$n {",
        COUNTED,
    ),
    sure(
        "^for ( $t=let/var/int/auto/size_t/unsigned/long $i = $a:bound ; $i <= $n:bound ; $i:next ) {",
        "for $i in $a..$n + 1 {",
        COUNTED,
    ),
    told(
        "^for ( $i:inside ; $c:inside ; $s:inside ) {",
        "repeat true {",
        "a loop is `for i in 0..n { … }`, `while c { … }` or `for v in vertices { … }`",
    ),
    sure("for/foreach ( $t:inside $n : $s:inside ) {", "for $n in $s {", LOOP),
    sure("for/foreach ( $n : $s:inside ) {", "for $n in $s {", LOOP),
    sure("for/foreach ( $t=let/var/const/auto $n in/of $s:inside ) {", "for $n in $s {", LOOP),
    sure("for/foreach ( $n in/of $s:inside ) {", "for $n in $s {", LOOP),
    sure("^foreach/forall/For/FOR/loop/every/iterate $n in", "for $n in", "`{}` is written `for`"),
    sure("^foreach/forall ( $n in $s:inside ) {", "for $n in $s {", LOOP),
    sure("^for parallel $n in", "parallel for $n in", PARALLEL),
    sure("^parallel_for/parfor/pfor/parallelfor/prange $n in", "parallel for $n in", PARALLEL),
    sure("^par for $n in", "parallel for $n in", PARALLEL),
    sure("^parallel for each/all/every $n in", "parallel for $n in", PARALLEL),
    sure("^parallel foreach/forall $n in", "parallel for $n in", PARALLEL),
    told("^parallel for $n in $s:some by $k:some {", "parallel for $n in $s {", ORDERED),
    sure("^for each/all/every $n in", "for $n in", "a loop is `for $n in … { … }`"),
    sure("^for $t:word $n in", "for $n in", "a variable has no kind: `for $n in …`"),
    sure("^for $i in/=/from $a:part to/upto/through $b:part {", "for $i in $a..$b + 1 {", COUNTED),
    told("^for $i in/= $a:part ,/:/downto $b:part {", "for $i in $a..$b {", COUNTED),
    sure("^for $n : $t:word in", "for $n in", "a variable has no kind: `for $n in …`"),
    sure("^for $n :/of/= $s:part {", "for $n in $s {", "a loop is `for $n in … { … }`"),
    sure("^for $i in $a:part .. = $n:part {", "for $i in $a..$n + 1 {", COUNTED),
    sure("^repeat $i in/=/: $a:part .. $n:part {", "for $i in $a..$n {", COUNTED),
    sure("^repeat $i in/=/: $n:some {", "for $i in 0..$n {", COUNTED),
    sure("^repeat $n:some times/time/x {", "repeat $n {", "it is `repeat n { … }`"),
    told("^drain $n in $s:some where $c:some by $k:some {", "", FILTER),
    told("^drain $n in $s:some by $k:some where $c:some {", "", FILTER),
    sure("^drain min/least/smallest/lowest $n in", "drain $n in", LEAST),
    told("^drain max/most/largest/greatest/highest $n in", "drain $n in", LEAST),
    sure(
        "^drain $n in $s:some while $c:some by $k:some {",
        "drain $n in $s by $k while $c {",
        "the key stands before the condition: `drain $n in … by … while … { … }`",
    ),
    fixed("by $k:some desc/descending/decreasing $o={/while", "by $k $o", "by -($k) $o", LEAST),
    sure("by $k:some asc/ascending/increasing $o={/while", "by $k $o", LEAST),
    told("^for $n in $s:some order/sorted/sort by $k:some {", "for $n in $s {", ORDERED),
    told(
        "^for $i in $a:part .. $n:part step/by - $s:part {",
        "for $i in $a..$n {",
        "a range has no step: `var $i = $a`, then `while $i > $n { … $i = $i - $s }`",
    ),
    told(
        "^for $i in $a:part .. $n:part step/by $s:part {",
        "for $i in $a..$n {",
        "a range has no step: `var $i = $a`, then `while $i < $n { … $i = $i + $s }`",
    ),
    told("^for $n in $s:some by $k:some {", "for $n in $s {", ORDERED),
    sure(
        "^for $n in $s:part { $b:inside } where $c:part $:end",
        "for $n in $s where $c { $b }",
        "a condition stands before the block: `for $n in … where … { … }`",
    ),
    told(
        "^for $n in range ( $a:inside ) : $:end",
        "",
        "a loop over ints is `for $n in 0..n { … }`, in braces",
    ),
    sure("if $n:variable = $f ( $a:inside ) {", "if $n == $f($a) {", EQUAL),
    sure("if $n = $f ( $a:inside ) {", "if let $n = $f($a) {", ASKED),
    sure("if ( $n = $f ( $a:inside ) ) {", "if let $n = $f($a) {", ASKED),
    told("^$w=for/while/if/elif $l:part : $:end", "$w $l { }", BRACES),
    told("^$w=else/repeat/try $l:part : $:end", "", BRACES),
    fixed("$k=in edge {", "", "$k edges {", "the edges of the mesh are `edges`"),
    fixed("$k=in vertex {", "", "$k vertices {", "the vertices of the mesh are `vertices`"),
    fixed("$k=in face {", "", "$k faces {", "the faces of the mesh are `faces`"),
    told("^do { $b:inside } while $c:line", "", "a loop asks before each turn: `while c { … }`"),
    sure("^loop {", "while true {", "`loop` is written `while true`"),
    told("^switch/match $x:inside { $b:inside }", "", SEVERAL),
    told("^switch/match $x:inside {", "{", SEVERAL),
    told("$w==/return/( switch/match $x:inside { $b:inside }", "$w true", SEVERAL).at(CODE | PARTS),
    told("^try {", "{", "a refusal is asked for: `if split(e) { … } else { … }`"),
    told("^throw/raise/panic $l:line", "", STOPPED),
    told("^error/fail/abort/die $t:text", "", STOPPED),
    sure("$p=) then/do {", "$p {", "no `{}` stands before a brace"),
    sure("$n then/do {", "$n {", "no `{}` stands before a brace"),
    sure("^pass/noop $:end", "", "an empty block is `{ }`"),
    told(
        "^import/using/include/from $l:line",
        "",
        "files are used at the head of a file: `use \"std/triangle.hedge\"`",
    ),
    told(
        "^before/after { $b:inside }",
        "",
        "what is drawn is an operation: `op name(e: edge) { before { … } after { … } }`",
    ),
    told("^end $:end", "", "a block ends with `}`, without `end`"),
];
