//! Statements of drawings.

use super::{Line, STEPS, VALUES, sure, told};
use crate::syntax::foreign_syntax::place::{DRAWING, PARTS};

const HALFEDGE: &str =
    "a halfedge is drawn in its loop, `face f: v0 -a-> v1 …`, and has no statement of its own";
const DECLARED: &str = "names are not declared: what is drawn tells what they stand for";
const PAIRED: &str = "an edge is a pair of twins with a bar between them: `edge e: a | d`";
const OWN_ENDS: &str = "an edge names its two halfedges, not its ends: `edge e: a | d` where `v0 -a-> v1` and `v1 -d-> v0`";
const BACKWARDS: &str = "arrows run forward, around the face: `v0 -$a-> v1`";
const DRAWN: &str = "a drawing has no `{}`: alternatives are `rule name { … }`, a refusal is `require c else \"…\"`, and `each i { … }` repeats a period";
const AROUND: &str = "the index runs around, after the last comes the first: `v[i+1]`";
const FORWARD: &str = "an index does not run backwards: a subscript is `i`, or `i` plus or minus a constant of at most 4, as in `v[i+1]`";
const PERIOD: &str = "a period ends with an arrow: behind it the next one begins";
const EACH: &str = "a period is repeated by `each`: `$k $f: each $i { … }`";
const UNNAMED_EDGE: &str = "a pair of halfedges is an edge: `edge $e: …`";
const UNNAMED_FACE: &str = "a cycle of arrows is a face: `face $f: …`";
const UNNAMED_LOOP: &str =
    "a loop begins with its kind and its name: `face f: $v …`, or with `hole`, `loop`";
const UNNAMED_RIM: &str =
    "a statement begins with its kind, on both sides: `face $f: …`, `hole $f: …`, `loop $f: …`";
const UNNAMED_VERTEX: &str = "spokes belong to a vertex: `vertex $v: …`";
const OUTER: &str = "the twin has a name of its own: `edge $e: $a | $a'`";
const ARROW: &str = "a halfedge is drawn `v0 -a-> v1`, a path `v0 =P=> v1`";
const TWIN: &str = "the twin has a name of its own: it is drawn `-$h'->`, and `edge e: $h | $h'` says whose twin it is";
const POINTED: &str =
    "what is drawn has a name of its own: `$h.$p` follows from the loops and edges that are drawn";
const NAMED: &str = "an arrow has the name of its halfedge: `v0 -a-> v1`";
const COLON: &str = "a colon stands behind the name: `$k $f: …`";
const ARROWS: &str =
    "a loop has arrows with the names of its halfedges: `$k $f: v0 -a-> v1 -b-> v0`";
const EACH_PERIOD: &str = "a period is repeated by `each $i { … }`";

pub(super) const LINES: &[Line] = &[
    told("~[ - $x:inside ]", "[ $x ]", FORWARD).at(DRAWING | PARTS),
    told(
        "^if/for/while/repeat/foreach/unless $h:inside { $b:inside } else { $c:inside }",
        "",
        DRAWN,
    ),
    told("^if/for/while/repeat/foreach/unless $h:inside { $b:inside }", "", DRAWN),
    told("^let/var/const/auto/val $l:line", "", VALUES),
    told("^return $m $:end", "", "what an op returns stands in its head: `op … -> $m`"),
    told("^return $l:line", "", "what an op returns stands in its head: `op name(…) -> x { … }`"),
    told("^print/assert/must $l:line", "", STEPS),
    // If another part follows instead, the mistake is a missing `}` before the line.
    told(
        "^guard/alias/require/keeps $l:line $n=}/face/hole/loop/edge/vertex/new/keep/erase",
        "$n",
        "`{}` stands between `before { … }` and `after { … }`, not in them",
    ),
    sure(
        "^each $i { $k=face/hole/loop/edge/vertex $b:inside }",
        "$k $b",
        "a statement with a subscript holds for every index already, and has no `each`",
    ),
    sure("$c=: for/forall/foreach/every/all/repeat $i {", "$c each $i {", EACH_PERIOD),
    sure("$c=: for each/all/every $i {", "$c each $i {", EACH_PERIOD),
    sure(
        "$e=each $i in $r:part {",
        "$e $i {",
        "`each $i` goes all the way around: it has no range",
    ),
    sure(
        "^$k=face/hole/loop/vertex $f $c=: { $a:word ~[ $i ] $l:inside }",
        "$k $f $c each $i { $a[$i] $l }",
        EACH,
    ),
    sure(
        "each $i (/[ $l:inside )/] $:end",
        "each $i { $l }",
        "a period stands in braces: `each $i { … }`",
    ),
    sure(
        "$e=each $i { $a:word [ $i ] $l:inside $d=->/=> $a:word [ $i + 1 ] }",
        "$e $i { $a[$i] $l $d }",
        PERIOD,
    ),
    told("$e=each $i { $l:inside $d=->/=> $v }", "$e $i { $l $d }", PERIOD),
    sure("[ ( $i $s=+/- $n:number ) %/mod $m:some ]", "[$i $s $n]", AROUND),
    sure("[ $i $s=+/- $n:number %/mod $m:some ]", "[$i $s $n]", AROUND),
    told(
        "^outer/outside/boundary/border/exterior : $l:line",
        "",
        "a boundary loop is a hole and has a name: `hole f1: v0 -a-> v1 =P=> v0`",
    ),
    sure(
        "^outer/outside/boundary/border/exterior face/loop/hole $f :",
        "hole $f:",
        "a boundary loop is a `hole`",
    ),
    told("^edge $e :/= $a | $b ./-> $t:word $l:part $:end", "", OUTER),
    told("^edge $e :/= $a | twin/opposite/pair/sym ( $b ) $:end", "", OUTER),
    told("^edge $e :/= $a | ~ $b $:end", "", OUTER),
    told(
        "^vertex $v : $a ->/=>/-/=/> $l:line",
        "",
        "the spokes of a vertex stand side by side, counterclockwise: `vertex $v: a *S b`",
    ),
    sure(
        "^vertex $v : {/(/[ $l:inside }/)/] $:end",
        "vertex $v: $l",
        "the spokes of a vertex stand side by side, without brackets",
    ),
    told(
        "^vertex $v : $l:part .. ~. $m:line",
        "",
        "spokes that have no name are a fan: `*S`, or `*` without a name",
    ),
    sure("- $a .. ~. ->", "=$a=>", "a path is `=$a=>`"),
    sure("~ $a ~ >", "=$a=>", "a path is `=$a=>`"),
    sure(
        "^boundary/border/Hole/holes/outside/exterior/boundary_loop/HOLE/rim $f :",
        "hole $f:",
        "a boundary loop is a `hole`",
    ),
    sure(
        "^Face/tri/triangle/quad/polygon/faces/facet/cell/poly/tris/FACE/pentagon/square/ngon $f :",
        "face $f:",
        "`{}` is written `face`",
    ),
    sure("^Edge/edges/side/EDGE/link/pair $e :", "edge $e:", "`{}` is written `edge`"),
    sure(
        "^Vertex/vert/vertices/node/point/star/verts/spokes/VERTEX/ring/fan $v :",
        "vertex $v:",
        "`{}` is written `vertex`",
    ),
    sure("^cycle/orbit/Loop/LOOP/contour $f :", "loop $f:", "`{}` is written `loop`"),
    told(
        "^halfedge/he/half_edge/Halfedge/dart/arc/halfedges/HalfedgeRef/path $h : $l:line",
        "",
        HALFEDGE,
    ),
    told("^halfedge/he/half_edge/Halfedge/dart/arc/HalfedgeRef $h = $l:line", "", HALFEDGE),
    told(
        "^halfedge/halfedges/he/path/HalfedgeRef/VertexRef/EdgeRef/FaceRef $a $n:names $:end",
        "",
        DECLARED,
    ),
    // A single name begins a statement.
    told("^face/edge/vertex/hole $a _$b $n:names $:end", "", DECLARED),
    told("^face/edge/vertex/hole $a _, $n:names $:end", "", DECLARED),
    told("^twin/twins/opposite/pair $l:line", "", PAIRED),
    told("^edge $e :/= $a:vertex $b:vertex $:end", "", OWN_ENDS),
    told("^edge $e :/= $a:vertex ,/-/->/=>/.. $b:vertex $:end", "", OWN_ENDS),
    told("^edge $e :/= ( $a:vertex , $b:vertex )", "", OWN_ENDS),
    told(
        "^edge $e : $a | $b | $c",
        "edge $e: $a | $b",
        "an edge has two halfedges: `edge $e: $a | $b`",
    ),
    sure("^edge $e $a |/=/,/- $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e = $a | $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a ,/- $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a / $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a and/&/&&/~/<>/:/twin/with $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a | | $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a < -> $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a ->/=>/== $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= $a $b $:end", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= ( $a ,/| $b )", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= [ $a ,/| $b ]", "edge $e: $a | $b", PAIRED),
    sure("^edge $e :/= { $a ,/| $b }", "edge $e: $a | $b", PAIRED),
    sure("^edge $e ( $a ,/| $b )", "edge $e: $a | $b", PAIRED),
    told("^edge : $l:line", "", "an edge has a name: `edge e: a | d`"),
    told("^face/hole/loop : $l:line", "", "a {} has a name: `{} f: v0 -a-> v1 …`"),
    told("^vertex : $l:line", "", "a vertex has a name: `vertex v: a *S b`"),
    sure("^$e : $a | $b", "edge $e: $a | $b", UNNAMED_EDGE),
    sure("$s=| $b _$e : $c | $d", "$s $b edge $e: $c | $d", UNNAMED_EDGE),
    told("^$f:rim : $v $d=-/=/=>", "loop $f: $v $d", UNNAMED_RIM),
    told("^$f:rim : $e=each $i {", "loop $f: $e $i {", UNNAMED_RIM),
    sure("^$f : $v $d=-/=/=>", "face $f: $v $d", UNNAMED_FACE),
    sure("^$f : $e=each $i { $v $d=-/=/=>", "face $f: $e $i { $v $d", UNNAMED_FACE),
    told("^$v -/=/=> $l:part ->/=> $v $:end", "", UNNAMED_LOOP),
    sure("^$v:vertex : $a", "vertex $v: $a", UNNAMED_VERTEX),
    sure("^$v:vertex : *", "vertex $v: *", UNNAMED_VERTEX),
    told("^$a | $b $:end", "", "twins stand in an edge statement: `edge e: $a | $b`"),
    sure("^$k=face/hole/loop $f =/( $v $d=-/=/=>", "$k $f: $v $d", COLON),
    sure("^$k=face/hole/loop $f $v $d=-/=/=>", "$k $f: $v $d", COLON),
    sure("^$k=face/hole/loop $f $e=each", "$k $f: $e", COLON),
    sure("^vertex $v = $a", "vertex $v: $a", "a colon stands behind the name: `vertex $v: …`"),
    sure("^vertex $v $a $b", "vertex $v: $a $b", "a colon stands behind the name: `vertex $v: …`"),
    told("^face/hole/loop $f :/=/( $a ~-> $l:line", "", NAMED),
    told("^$k=face/hole/loop $f :/=/( $a $b $l:line", "", ARROWS),
    told("^$k=face/hole/loop $f :/=/( $a , $l:line", "", ARROWS),
    told("^$k=face/hole/loop $f :/= (/[/{ $l:line", "", ARROWS),
    told(
        "^$f = face/hole/Face ( $l:line",
        "",
        "a face is drawn by its loop: `face $f: v0 -a-> v1 -b-> v0`",
    ),
    sure("- ~- $a - ~->", "-$a->", "an arrow has one dash before its name: `-$a->`"),
    sure("- ~- $a ->", "-$a->", "an arrow has one dash before its name: `-$a->`"),
    sure("- $a - ~->", "-$a->", "an arrow is `-$a->`"),
    sure("- $a - >", "-$a->", "an arrow is `-$a->`, without a space in `->`"),
    sure("- [/(/< $a ]/)/> ->", "-$a->", "an arrow has the bare name of its halfedge: `-$a->`"),
    sure("- [/(/< $a ]/)/> - ~->", "-$a->", "an arrow has the bare name of its halfedge: `-$a->`"),
    told("~-> ~$a ~->", "- $a ->", NAMED),
    sure("-> ~$a ~->", "-$a->", "an arrow is `-$a->`"),
    sure("== $a == ~>", "=$a=>", "a path is `=$a=>`"),
    sure("= $a = >", "=$a=>", "a path is `=$a=>`, without a space in `=>`"),
    sure("- $a => ", "-$a->", "an arrow is `-$a->`, a path `=$a=>`"),
    sure("=> $a =>", "=$a=>", "a path is `=$a=>`"),
    told("- $h . twin ->", "- $h ->", TWIN),
    told("- $h . $p:word ->", "- $h ->", POINTED),
    told("= $a ->", "- $a ->", ARROW),
    told("^face/hole/loop $f : $l:some < - $a -/-> $v", "", BACKWARDS),
    told("< - $a -", "- $a ->", "arrows run forward, around the face: `v0 -$a-> v1`"),
    sure(
        "^$k=face/hole/loop $f : $l:some - $a - $v",
        "$k $f: $l -$a-> $v",
        "an arrow ends with `->`: `-$a-> $v`",
    ),
    sure(
        "^$k=face/hole/loop $f : $l:some - $a $v $d=-/=/=>",
        "$k $f: $l -$a-> $v $d",
        "an arrow ends with `->`: `-$a-> $v`",
    ),
    told("$a - > $b", "$a => $b", "an arrow has the name of its halfedge: `$a -h-> $b`"),
    sure("$a .. ~. $b", "$a => $b", "a path without a name is `=>`"),
    told(
        "$v:vertex , $w:vertex $d=-/=",
        "$v $d",
        "a loop names each of its vertices once: `v0 -a-> v1 -b-> v2`",
    ),
    sure(
        "^new $l:names : $k=vertex/edge/face/halfedge",
        "new $l",
        "names are listed without their kinds: what is drawn tells what they stand for",
    ),
    told(
        "^keep */all/everything/rest",
        "",
        "`keep` lists faces, edges and vertices by their names: `keep f0 f1 e`",
    ),
    told(
        ".. ~.",
        "",
        "spokes that have no name are a fan, `*S` or `*`; a path without a name is `=>`",
    ),
];
