//! Chains: what `before` says about the orbit of each vertex.
//!
//! Following the stated links cuts the ports at a vertex into chains, each with an entry and an
//! exit. What lies between the exit of one chain and the entry of the next, clockwise, is outside
//! the drawing: an arc.

use super::port::{Links, Port};
use crate::diagram::{Drawing, NameId};

/// Ports in a row, clockwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Chain {
    /// The ports; the first is the entry, the last the exit.
    pub ports: Vec<Port>,
    /// True if the last links to the first: then the chain is the whole orbit.
    pub closed: bool,
}

impl Chain {
    /// The port that an arc leads to.
    pub fn entry(&self) -> Port {
        self.ports[0]
    }

    /// The port that an arc leaves from.
    pub fn exit(&self) -> Port {
        *self.ports.last().expect("a chain has a port")
    }
}

/// The chains of one vertex.
#[derive(Clone, Debug)]
pub(super) struct Corner {
    /// The vertex.
    pub vertex: NameId,
    pub chains: Vec<Chain>,
}

/// The vertex a port lies at before.
pub(super) fn vertex_before(drawing: &Drawing, port: Port) -> Option<NameId> {
    match port {
        Port::Out(item) => drawing.origin_before(item),
        Port::In(item) => drawing.target_before(item),
    }
}

/// The vertex a port lies at after.
pub(super) fn vertex_after(drawing: &Drawing, port: Port) -> Option<NameId> {
    match port {
        Port::Out(item) => drawing.origin_after(item),
        Port::In(item) => drawing.target_after(item),
    }
}

/// The chains of each vertex of `before`, in order of first mention.
pub(super) fn corners(drawing: &Drawing, links: &Links) -> Vec<Corner> {
    let mut corners: Vec<Corner> = Vec::new();
    for chain in chains_of(links) {
        let Some(vertex) = vertex_before(drawing, chain.entry()) else { continue };
        match corners.iter_mut().find(|corner| corner.vertex == vertex) {
            Some(corner) => corner.chains.push(chain),
            None => corners.push(Corner { vertex, chains: vec![chain] }),
        }
    }
    corners
}

/// All chains of a side.
pub(super) fn chains_of(links: &Links) -> Vec<Chain> {
    let mut seen = vec![false; links.ports.iter().map(|port| port.index() + 1).max().unwrap_or(0)];
    let mut chains = Vec::new();
    let entries = links.ports.iter().filter(|&&port| !links.is_reached(port));
    // Ports that no entry leads to lie on closed chains.
    for &start in entries.chain(&links.ports) {
        if seen[start.index()] {
            continue;
        }
        let mut chain = Chain { ports: Vec::new(), closed: false };
        let mut at = Some(start);
        while let Some(port) = at {
            if std::mem::replace(&mut seen[port.index()], true) {
                chain.closed = true;
                break;
            }
            chain.ports.push(port);
            at = links.next(port);
        }
        chains.push(chain);
    }
    chains
}
