//! Lists of drawings: `new`, `erase` and `keep`.

use super::{Line, sure, told};
use crate::syntax::foreign_syntax::place::DRAWING;

pub(super) const LINES: &[Line] = &[
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=halfedge/halfedges/vertices/edges/faces/he/vert $n",
        "$w $l $n",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=vertex/edge/face $n $:end",
        "$w $l $n",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep $l:names $k=vertex/edge/face $n $e=new/erase/keep/edge/face/vertex/halfedge/,",
        "$w $l $n $e",
        "names are listed without their kinds: what is drawn tells them",
    ),
    sure(
        DRAWING,
        "^keep $e : $a | $b",
        "edge $e: $a | $b",
        "`keep $e` repeats the statement of `$e` and has none of its own: drawn anew it is `edge $e: $a | $b`",
    ),
    sure(
        DRAWING,
        "^keep $f : $v $d=-/=/=>",
        "face $f: $v $d",
        "`keep $f` repeats the statement of `$f` and has none of its own: drawn anew it is `face $f: …`",
    ),
    sure(DRAWING, "^$w=erase/keep/new $a : $n", "$w $a $n", "no sign stands in a list: `$w a b`"),
    sure(DRAWING, "$w=new/erase/keep :/= $n", "$w $n", "no sign stands behind `$w`: `$w a b`"),
    told(
        DRAWING,
        "^new vertex/edge/face/halfedge/Vertex/Edge/Face/Halfedge/HalfEdge ( $l:inside )",
        "",
        "what is new is listed by its name: `new v`",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep ( $l:names )",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep [ $l:names ]",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    sure(
        DRAWING,
        "$w=new/erase/keep { $l:names }",
        "$w $l",
        "names are listed without brackets: `$w a b`",
    ),
    told(
        DRAWING,
        "^$a = new/create/add/make/alloc $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    told(
        DRAWING,
        "^$k:word $a = new/create/make/new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    told(
        DRAWING,
        "^$a = new_vertex/new_edge/new_face/new_halfedge/emplace_vertex/emplace_edge/emplace_face/emplace_halfedge $l:line",
        "",
        "what is added is listed: `new $a`",
    ),
    sure(
        DRAWING,
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase/delete_vertex/delete_edge/delete_face ( $l:names )",
        "erase $l",
        "`{}` is written `erase`",
    ),
    sure(
        DRAWING,
        "^add/create/insert/make/alloc/allocate/introduce/New ( $l:names )",
        "new $l",
        "`{}` is written `new`",
    ),
    sure(
        DRAWING,
        "^delete/remove/del/destroy/discard/drop/kill/free/Erase $a $n:names",
        "erase $a $n",
        "`{}` is written `erase`",
    ),
    sure(
        DRAWING,
        "^add/create/insert/make/alloc/allocate/introduce/New $a $n:names",
        "new $a $n",
        "`{}` is written `new`",
    ),
    sure(
        DRAWING,
        "^preserve/retain/same/unchanged/keeps/Keep/stay/restate $a $n:names",
        "keep $a $n",
        "`{}` is written `keep`",
    ),
];
