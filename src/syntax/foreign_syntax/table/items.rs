//! Heads of items: declarations in the syntax of other languages.

use super::{Line, TYPED, fixed, sure, told};
use crate::syntax::foreign_syntax::place::PARAMETERS;

const CONSTANT: &str = "values stand in items: a constant is a function, `fn k() { 3 }`, a setting a parameter with a default, `script go(k: real = 3)`";
const ATTRIBUTE: &str = "an attribute is `attr $n: $k $t`";
const ARROW: &str = "what is returned stands behind an arrow: `-> $t`";
const QUOTED: &str = "a test has a name in quotes: `test \"…\" { … }`";
const STATEMENTS: &str = "statements stand in a script: `script go() { … }`";
const NO_TYPES: &str =
    "there are no types of one's own: values are kept at elements, `attr weight: edge real = 0`";

pub(super) const LINES: &[Line] = &[
    sure("; $n : $t:word", ", $n: $t", "parameters are separated by commas"),
    sure(
        "^def/function/func/fun/fn/void/auto/bool/define/sub/procedure/method/int/Mesh/EdgeRef/FaceRef/VertexRef/HalfedgeRef/optional $f ( $p:inside ) $r:part { $b=before/rule/after/steps",
        "op $f($p) $r { $b",
        "what is drawn is an operation, `op $f(…) { before { … } after { … } }`",
    ),
    sure(
        "private $k=def/function/func/fun/fn/void/auto/bool/define/sub/procedure/method/proc $f ( $p:inside ) $r:part { $b=before/rule/after/steps",
        "private op $f($p) $r { $b",
        "what is drawn is an operation, `private op $f(…) { before { … } after { … } }`",
    ),
    told(
        "^def $f ( $p:inside ) $r:part : $:end",
        "fn $f($p) { }",
        "a function is `fn $f(x: real) -> real { … }`, an operation `op $f(e: edge) { before { … } after { … } }`: with braces",
    ),
    told(
        "fn/op/script $f ( $p:inside ) $r:part : $:end",
        "fn $f($p) { }",
        "a block stands in braces: `{} $f(…) { … }`",
    ),
    sure(
        "^def/function/func/fun/define/sub/procedure/method/void/proc/lambda $f ( $p:inside )",
        "fn $f($p)",
        "a function is `fn`, an operation `op`, a program `script`",
    ),
    sure("^Fn/FN $f ( ", "fn $f(", "`{}` is written `fn`"),
    told(
        "^int/void/auto main ( $p:inside ) {",
        "fn main ( ) {",
        "a program is `script name() { … }`, with as many as are wanted in a file",
    ),
    fixed(
        "^$t:type $f ( $p:inside ) {",
        "fn $f($p) {",
        "fn $f($p) -> $t {",
        "a function is `fn $f(…) -> $t { … }`",
    ),
    told(
        "$k=op/fn/script $f < $x:inside > (",
        "$k $f (",
        "there are no templates: a type is written where it is meant",
    ),
    told(
        ") returns/return/yields $t:part {",
        ") {",
        "what is returned stands behind an arrow: `op flip(e: edge) -> m`, `fn f(x: real) -> real`",
    ),
    sure(
        ") ->/: $t=void/None/nothing/unit {",
        ") {",
        "`$t` is left out: what gives nothing has no arrow",
    ),
    told(") -> ( $a , $b:inside ) {", ") {", "an op returns one element, a function one value"),
    sure(
        "^operation/operator/rewrite/rule/transform/transformation/action/Op/OP/oper/operate/local_op $f (",
        "op $f(",
        "`{}` is written `op`",
    ),
    sure(
        "^main/program/algorithm/Script/proc/task/routine/macro $f (",
        "script $f(",
        "`{}` is written `script`",
    ),
    sure(
        "^from/use/import/include $p:text _use/import/as/hiding/show/with $l:line",
        "use $p",
        "a file is used whole, and has no other name: `use $p`",
    ),
    sure(
        "^use/import/include $p:text { $l:inside }",
        "use $p",
        "a file is used whole, by its path: `use $p`",
    ),
    fixed("^use < $p:some >", "", "use \"$p\"", "the path of a file stands in quotes"),
    sure(
        "^import/include/using/open/require/load/from/with/Use $p:text",
        "use $p",
        "`{}` is written `use`",
    ),
    told("^from $p:part import $l:line", "", "a file is used whole: `use \"std/triangle.hedge\"`"),
    told(
        "^import/include/using/open/from/load $p:line",
        "",
        "a file is used by its path: `use \"std/triangle.hedge\"`",
    ),
    sure(
        "^pub/public/static/export/extern/inline/virtual/async/override/protected/const/constexpr $k=op/fn/script/attr",
        "$k",
        "no `{}`: what a file declares, all files see that use it, unless it is `private`",
    ),
    sure(
        "^pub/public/static/export/extern/inline/virtual/async/override/protected/const/constexpr $:end",
        "",
        "no `{}`: what a file declares, all files see that use it, unless it is `private`",
    ),
    sure("^test $t:text ( ) {", "test $t {", "a test has no parameters: `test $t { … }`"),
    sure(
        "private $k=def/function/func/fun/define/sub/procedure/method/void/proc $f (",
        "private fn $f(",
        "`$k` is written `fn`",
    ),
    told(
        "^private $:end",
        "",
        "`private` stands right before `op`, `fn`, `script` or `attr`, behind the comment",
    ),
    sure("^template < $x:inside >", "", "there are no templates"),
    sure("^$m=main ~(", "script $m(", "a program is `script name() { … }`"),
    told(
        "$k=op/fn/script $a ~- ~$b:word ~(",
        "$k $a (",
        "a name has letters, digits and `_`: `$a_$b`",
    ),
    told(
        "script $f ( $p:inside ) ->/: $t:word {",
        "script $f($p) {",
        "a script gives no value; a `fn` does",
    ),
    sure(
        ") -> $m : $t=vertex/halfedge/edge/face",
        ") -> $m",
        "the drawing tells what `$m` is: `-> $m`",
    ),
    told("^let/var/const/constexpr/auto/val/global/define $n:part = $v:line", "", CONSTANT),
    told("^$n = $v:line", "", CONSTANT),
    told(
        "^for/if/while/repeat/drain/update/print/assert/must $l:inside { $b:inside }",
        "",
        STATEMENTS,
    ),
    told("^print/assert/must $l:line", "", STATEMENTS),
    told("^$n ( $a:inside ) $:end", "", STATEMENTS),
    told(
        "^class/struct/enum/interface/namespace/module/trait/impl/mesh/object $n:part { $b:inside }",
        "",
        NO_TYPES,
    ),
    told("^type/typedef/typename $l:line", "", NO_TYPES),
    sure("attribute/property/attrib $n :", "attr $n:", "`{}` is written `attr`"),
    sure("attr $t:type $k=vertex/halfedge/edge/face $n", "attr $n: $k $t", ATTRIBUTE),
    sure("attr $k=vertex/halfedge/edge/face $t:type $n", "attr $n: $k $t", ATTRIBUTE),
    sure("attr $k=vertex/halfedge/edge/face $n : $t:word", "attr $n: $k $t", ATTRIBUTE),
    sure("attr $k=vertex/halfedge/edge/face . $n : $t:word", "attr $n: $k $t", ATTRIBUTE),
    sure(
        "attr $n : $t:type $k=vertex/halfedge/edge/face",
        "attr $n: $k $t",
        "the kind of element stands before the type: `attr $n: $k $t`",
    ),
    sure("attr $n : $k=vertex/halfedge/edge/face : $t:word", "attr $n: $k $t", ATTRIBUTE),
    sure(
        "attr $n : $t:type per/of/on/for/at/each $k=vertex/halfedge/edge/face",
        "attr $n: $k $t",
        "the kind of element stands before the type: `attr $n: $k $t`",
    ),
    told(
        "attr $n : $t:type $:end",
        "",
        "an attribute belongs to a kind of element: `attr $n: vertex $t`",
    ),
    told(
        "attr $n : $t:type = $v:line",
        "",
        "an attribute belongs to a kind of element: `attr $n: vertex $t = $v`",
    ),
    told(
        "attr $n = $v:line",
        "",
        "an attribute has a kind of element and a type: `attr $n: vertex real = $v`",
    ),
    sure("$o=(/, const", "$o", "parameters have no `const`"),
    sure("$t:word & $n", "$t $n", "there are no references: an element is handed over as it is"),
    sure("$t:word & ~&", "$t", "there are no references: an element is handed over as it is"),
    sure("$o=(/, $t:word * $n", "$o$n: $t", TYPED).at(PARAMETERS),
    sure("$c=: & $t:word", "$c $t", "there are no references: an element is handed over as it is"),
    sure("$o=(/, $n $t:type", "$o$n: $t", TYPED).at(PARAMETERS),
    sure("$o=(/, $n = $t:type", "$o$n: $t", TYPED).at(PARAMETERS),
    sure("$o=(/, $t:word $n", "$o$n: $t", TYPED).at(PARAMETERS),
    sure(") : $t:word {", ") -> $t {", ARROW),
    sure(") => $t:word {", ") -> $t {", ARROW),
    sure(") $t:type {", ") -> $t {", ARROW),
    sure("fn $f ( $p:inside ) => $t:word {", "fn $f($p) -> $t {", ARROW),
    told(
        "^use $p:part { $b:inside }",
        "",
        "a file is used whole, by its path: `use \"std/triangle.hedge\"`",
    ),
    sure(
        "fn $f ( $p:inside ) =/=> $v:line",
        "fn $f($p) { $v }",
        "a function has a block: `fn $f(…) { … }`",
    ),
    told(
        "-> $o:word < $x:inside >",
        "",
        "an op says which element it returns, `-> m`; that it may refuse is understood",
    ),
    sure(
        "$k=script/fn $n {",
        "$k $n() {",
        "parentheses stand behind the name also where nothing is given: `$k $n() { … }`",
    ),
    told("op $n {", "op $n ( ) {", "an op says at which element it begins: `op $n(e: edge) { … }`"),
    fixed("test $n ( ) { $b:inside }", "", "test \"$n\" { $b }", QUOTED),
    fixed("test $n { $b:inside }", "", "test \"$n\" { $b }", QUOTED),
    told("test { $b:inside }", "", QUOTED),
    sure(
        ") keep/ensures/preserves/maintains/preserving/keeping/keep:",
        ") keeps",
        "`keeps` says what is to be proved besides",
    ),
];
