//! Assignments of drawings.

use super::{Line, VALUES, fixed, sure, told};

const POINTERS: &str = "pointers are not assigned: `next` and `face` follow from the loops that `after` draws, `twin` from its edges, `edge e: a | d`";
const CALLS: &str = "a drawing calls nothing: it says what there is before and after; scripts call operations, `flip(e)`";
const COMPONENT: &str = "a component cannot be assigned by itself: `$a.$b = vec3(x, y, z)`";
const CHANGE: &str = "a change is written out: `$a.$b = $a.$b $o …`";

pub(super) const LINES: &[Line] = &[
    told(
        "^$a ./-> $p=next/prev/twin/vertex/face/edge/halfedge/opposite/pair/origin ( ) = $v:line",
        "",
        POINTERS,
    ),
    told(
        "^$a ./-> $p=next/prev/twin/vertex/face/edge/halfedge/opposite/pair/origin = $v:line",
        "",
        POINTERS,
    ),
    told(
        "^$a ./-> $p=set_next/set_prev/set_twin/set_vertex/set_face/set_edge/set_halfedge/set_opposite/set_target/set_neighbors ( $x:inside ) $l:line",
        "",
        POINTERS,
    ),
    told(
        "^$a ./-> $p=setNext/setPrev/setTwin/setVertex/setFace/setEdge/setHalfedge/setOpposite/setTarget/setNeighbors ( $x:inside ) $l:line",
        "",
        POINTERS,
    ),
    told("^$a ./-> $f:word ( $x:inside ) $l:line", "", CALLS),
    told("^$f ( $x:inside ) $l:line", "", CALLS),
    told(
        "$a . $b=position . x = $v:line",
        "",
        "a component cannot be assigned by itself: `$a.$b = vec3($v, $a.$b.y, $a.$b.z)`",
    ),
    told(
        "$a . $b=position . y = $v:line",
        "",
        "a component cannot be assigned by itself: `$a.$b = vec3($a.$b.x, $v, $a.$b.z)`",
    ),
    told(
        "$a . $b=position . z = $v:line",
        "",
        "a component cannot be assigned by itself: `$a.$b = vec3($a.$b.x, $a.$b.y, $v)`",
    ),
    told("$a . $b:word . $c:word $o=+/-/*// ~= $v:line", "", COMPONENT),
    told("$a . $b:word . $c:word = $v:line", "", COMPONENT),
    sure("^$a -> $b:word =", "$a.$b =", "an attribute stands behind a dot: `$a.$b`"),
    sure("$a . $b:word : = ", "$a.$b =", "it is set with `=`"),
    sure("$a . $b:word : $v:line", "$a.$b = $v", "it is set with `=`"),
    fixed(
        "$a . $b:word $o=+/- ~= ( $x:inside , $y:inside , $z:inside ) $:end",
        "$a.$b = $x",
        "$a.$b = $a.$b $o vec3($x, $y, $z)",
        CHANGE,
    ),
    fixed("$a . $b:word $o=+/-/*// ~= $v:line", "$a.$b = $v", "$a.$b = $a.$b $o ($v)", CHANGE),
    fixed(
        "^$a:vertex = $f=midpoint/centroid/mix/vec3 ( $v:line",
        "",
        "$a.position = $f($v",
        "`$a` is a vertex; where it is tells its `position`",
    ),
    told(
        "^$a:vertex = $v:plain",
        "",
        "`$a` is a vertex: what is set is an attribute, `$a.position = …`",
    ),
    told(
        "^$a = $v:plain",
        "",
        "what is set is an attribute of something drawn, `v.position = …`; a value is written where it is used",
    ),
    told("^$t:word $a = $v:plain", "", VALUES),
    sure(
        "^$k=face/hole/loop/edge/vertex/new/keep/erase $l:some , $:end",
        "$k $l",
        "no comma stands behind a statement",
    ),
];
