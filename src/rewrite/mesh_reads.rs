//! Reads of the mesh on the paths of a key: pointers, orbits, and the reads of questions.

use super::paths::{Fields, Node, Step, Unbounded};
use super::reads::{Nodes, Reads, unite};
use super::{ElementField, HalfedgeField, Question, Walk};

impl Reads<'_> {
    pub(super) fn read(&mut self, nodes: &[Node], fields: Fields) {
        for &node in nodes {
            self.paths.read(node, fields);
        }
    }

    fn steps(&mut self, nodes: &[Node], step: Step) -> Result<Nodes, Unbounded> {
        let mut reached = Nodes::new();
        for &node in nodes {
            unite(&mut reached, &[self.paths.child(node, step)?]);
        }
        Ok(reached)
    }

    pub(super) fn load(
        &mut self,
        nodes: &[Node],
        field: HalfedgeField,
    ) -> Result<Nodes, Unbounded> {
        self.read(nodes, Fields::pointer(field));
        self.steps(nodes, Step::Pointer(field))
    }

    pub(super) fn first(&mut self, nodes: &[Node], of: ElementField) -> Result<Nodes, Unbounded> {
        self.read(nodes, Fields::FIRST);
        self.steps(nodes, Step::First(of))
    }

    /// All halfedges of the orbits of some halfedges.
    pub(super) fn orbit(&mut self, nodes: &[Node], walk: Walk) -> Result<Nodes, Unbounded> {
        let orbit = self.steps(nodes, Step::Orbit(walk))?;
        match walk {
            Walk::Loop => self.read(&orbit, Fields::pointer(HalfedgeField::Next)),
            Walk::Star => {
                let before = self.load(&orbit, HalfedgeField::Prev)?;
                self.read(&before, Fields::pointer(HalfedgeField::Twin));
            }
        }
        Ok(orbit)
    }

    fn spokes(&mut self, vertices: &[Node]) -> Result<Nodes, Unbounded> {
        let first = self.first(vertices, ElementField::Vertex)?;
        self.orbit(&first, Walk::Star)
    }

    /// Notes reads of the positions of the origins of halfedges.
    fn positions(&mut self, halfedges: &[Node]) -> Result<(), Unbounded> {
        let vertices = self.load(halfedges, HalfedgeField::Vertex)?;
        self.read(&vertices, Fields::POSITION);
        Ok(())
    }

    pub(super) fn holes(&mut self, halfedges: &[Node]) -> Result<Nodes, Unbounded> {
        let faces = self.load(halfedges, HalfedgeField::Face)?;
        self.read(&faces, Fields::HOLE);
        Ok(faces)
    }

    /// Notes the reads of the mesh that the answer to a question depends on, or a superset.
    pub(super) fn ask(
        &mut self,
        question: Question,
        of: &[Node],
        and: &[Node],
    ) -> Result<(), Unbounded> {
        match question {
            Question::Degree => drop(self.spokes(of)?),
            Question::BoundaryVertex => {
                let spokes = self.spokes(of)?;
                self.holes(&spokes)?;
            }
            Question::Adjacent => {
                for vertex in [of, and] {
                    let spokes = self.spokes(vertex)?;
                    let twins = self.load(&spokes, HalfedgeField::Twin)?;
                    self.load(&twins, HalfedgeField::Vertex)?;
                }
            }
            Question::NormalVertex => {
                let spokes = self.spokes(of)?;
                self.faces_at(&spokes)?;
            }
            Question::BoundaryEdge | Question::LengthEdge => {
                let half = self.first(of, ElementField::Edge)?;
                let twin = self.load(&half, HalfedgeField::Twin)?;
                for half in [half, twin] {
                    match question {
                        Question::BoundaryEdge => drop(self.holes(&half)?),
                        _ => self.positions(&half)?,
                    }
                }
            }
            Question::LinkCondition | Question::StarShaped | Question::KernelCentroid => {
                let half = self.first(of, ElementField::Edge)?;
                let twin = self.load(&half, HalfedgeField::Twin)?;
                for half in [half, twin] {
                    self.holes(&half)?;
                    let end = self.load(&half, HalfedgeField::Vertex)?;
                    let spokes = self.spokes(&end)?;
                    self.faces_at(&spokes)?;
                }
            }
            Question::FaceSize => {
                let first = self.first(of, ElementField::Face)?;
                self.orbit(&first, Walk::Loop)?;
            }
            Question::Area | Question::NormalFace | Question::CentroidFace => {
                let first = self.first(of, ElementField::Face)?;
                let corners = self.orbit(&first, Walk::Loop)?;
                self.positions(&corners)?;
            }
        }
        Ok(())
    }

    /// Notes reads of everything that a question may use of the loops at halfedges: pointers,
    /// corners, and the ends and loops across their edges.
    fn faces_at(&mut self, halfedges: &[Node]) -> Result<(), Unbounded> {
        let faces = self.holes(halfedges)?;
        self.first(&faces, ElementField::Face)?;
        let sides = self.orbit(halfedges, Walk::Loop)?;
        self.load(&sides, HalfedgeField::Prev)?;
        self.positions(&sides)?;
        let twins = self.load(&sides, HalfedgeField::Twin)?;
        self.load(&twins, HalfedgeField::Vertex)?;
        Ok(())
    }
}
