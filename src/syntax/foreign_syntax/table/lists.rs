//! Lists of drawings: `new`, `erase` and `keep`.

use super::{Line, sure, told};

const WITHOUT_KINDS: &str = "names are listed without their kinds: what is drawn tells them";

pub(super) const LINES: &[Line] = &[
    sure(
        "$w=new/erase/keep $l:names _$k=halfedge/halfedges/vertices/edges/faces/he/vert $n",
        "$w $l $n",
        WITHOUT_KINDS,
    ),
    sure(
        "$w=new/erase/keep $l:names _$k=vertex/edge/face/hole $n $m:names $:end",
        "$w $l $n $m",
        WITHOUT_KINDS,
    ),
    sure(
        "$w=new/erase/keep $l:names _$k=vertex/edge/face $n $e=new/erase/keep/edge/face/vertex/halfedge/,",
        "$w $l $n $e",
        WITHOUT_KINDS,
    ),
    sure(
        "^keep $e : $a | $b",
        "edge $e: $a | $b",
        "`keep $e` repeats the statement of `$e` and has none of its own: drawn anew it is `edge $e: $a | $b`",
    ),
    sure(
        "^keep $f : $v $d=-/=/=>",
        "face $f: $v $d",
        "`keep $f` repeats the statement of `$f` and has none of its own: drawn anew it is `face $f: …`",
    ),
    sure("^$w=erase/keep/new $a : $n", "$w $a $n", "no sign stands in a list: `$w a b`"),
    sure("$w=new/erase/keep :/= $n", "$w $n", "no sign stands behind `$w`: `$w a b`"),
    told(
        "^new vertex/edge/face/halfedge/Vertex/Edge/Face/Halfedge/HalfEdge ( $l:inside )",
        "",
        "what is new is listed by its name: `new v`",
    ),
    sure("$w=new/erase/keep ( $l:names )", "$w $l", "names are listed without brackets: `$w a b`"),
    sure("$w=new/erase/keep [ $l:names ]", "$w $l", "names are listed without brackets: `$w a b`"),
    sure("$w=new/erase/keep { $l:names }", "$w $l", "names are listed without brackets: `$w a b`"),
    told("^$a = new/create/add/make/alloc $l:line", "", "what is added is listed: `new $a`"),
    told(
        "^$k:word $a = new/create/make/new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    told(
        "^$a = new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    sure(
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase/delete_vertex/delete_edge/delete_face ( $l:names )",
        "erase $l",
        "`{}` is written `erase`",
    ),
    sure(
        "^add/create/insert/make/alloc/allocate/introduce/New ( $l:names )",
        "new $l",
        "`{}` is written `new`",
    ),
    sure(
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase $a $n:names",
        "erase $a $n",
        "`{}` is written `erase`",
    ),
    sure(
        "^add/create/insert/make/alloc/allocate/introduce/New $a $n:names",
        "new $a $n",
        "`{}` is written `new`",
    ),
    sure(
        "^preserve/retain/same/unchanged/keeps/Keep/stay/restate $a $n:names",
        "keep $a $n",
        "`{}` is written `keep`",
    ),
];
