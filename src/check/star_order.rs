//! Order of stars: a vertex statement of `after` is the ring of spokes, in order.

use crate::diagram::{NameId, Spoke};

/// A piece of a ring of spokes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// A named spoke.
    Spoke(NameId),
    /// A run of spokes in a named fan.
    Fan(NameId),
    /// A run of other spokes.
    Rest,
}

/// True if the statement, read as a cycle, describes the ring: each spoke and fan where it is
/// stated, each `*` any run without names.
pub(super) fn agrees(stated: &[Spoke], ring: &[Token]) -> bool {
    let count = ring.len();
    (0..count.max(1)).any(|start| {
        let turned: Vec<_> = (0..count).map(|at| ring[(start + at) % count]).collect();
        // A statement may begin in the middle of a run without a name.
        matches(stated, &turned) || {
            let split = turned.first() == Some(&Token::Rest);
            split && matches(stated, &[turned.as_slice(), &[Token::Rest]].concat())
        }
    })
}

fn matches(stated: &[Spoke], ring: &[Token]) -> bool {
    match (stated, ring) {
        ([], ring) => ring.is_empty(),
        ([Spoke::Halfedge(name), stated @ ..], [Token::Spoke(spoke), ring @ ..]) => {
            name.name == *spoke && matches(stated, ring)
        }
        ([Spoke::Halfedge(_), ..], _) => false,
        ([Spoke::Fan(name), rest @ ..], ring) => {
            let here = ring.first() == Some(&Token::Fan(name.name));
            matches(rest, if here { &ring[1..] } else { ring })
        }
        ([Spoke::Rest(_), rest @ ..], ring) => {
            matches(rest, ring)
                || (ring.first() == Some(&Token::Rest) && matches(stated, &ring[1..]))
        }
    }
}
