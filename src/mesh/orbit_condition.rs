//! The conditions of the levels, each on one orbit.

/// A condition of a level on one orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OrbitCondition {
    /// A loop has three sides or more.
    ThreeSides,
    /// A loop meets no vertex twice.
    MeetsOnce,
    /// A loop has no more than one corner at a vertex.
    CornerOnce,
    /// A vertex has two spokes or more, or none at all.
    TwoSpokes,
    /// At most one corner of a vertex lies in a hole.
    OneHole,
    /// No loop lies around a vertex twice.
    FacesDiffer,
    /// No two edges join a vertex to the same neighbor.
    NeighborsDiffer,
    /// No other edge has the ends of that of the halfedge.
    SingleEdge,
    /// No two faces around a vertex have the same set of corners.
    CornersDiffer,
    /// No other face around a given vertex of a face has the same set of corners as the face.
    CornersOwn,
}

impl OrbitCondition {
    /// All conditions, in the order in which they are declared.
    #[cfg(feature = "native")]
    pub(crate) const ALL: [Self; 10] = [
        Self::ThreeSides,
        Self::MeetsOnce,
        Self::CornerOnce,
        Self::TwoSpokes,
        Self::OneHole,
        Self::FacesDiffer,
        Self::NeighborsDiffer,
        Self::SingleEdge,
        Self::CornersDiffer,
        Self::CornersOwn,
    ];

    /// The name of the function that tests it.
    pub fn word(self) -> &'static str {
        match self {
            Self::ThreeSides => "three_sides",
            Self::MeetsOnce => "meets_once",
            Self::CornerOnce => "corner_once",
            Self::TwoSpokes => "two_spokes",
            Self::OneHole => "one_hole",
            Self::FacesDiffer => "faces_differ",
            Self::NeighborsDiffer => "neighbors_differ",
            Self::SingleEdge => "single_edge",
            Self::CornersDiffer => "corners_differ",
            Self::CornersOwn => "corners_own",
        }
    }
}
