//! Pictures of operations.

use std::borrow::Cow;

use super::{Error, Op};
use crate::analysis::example;
use crate::diagram;
use crate::draw::{COLUMNS, draw_op, text_op};

impl Op {
    /// The picture of the operation, before and after, as SVG; for an operation in steps, an
    /// example of what it does.
    ///
    /// # Errors
    /// The operation is in steps, and no example was found (`no-example`).
    pub fn svg(&self) -> Result<String, Error> {
        Ok(draw_op(&*self.diagram()?).svg())
    }

    /// The same picture as text.
    ///
    /// # Errors
    /// As for [`svg`](Self::svg).
    pub fn drawn(&self) -> Result<String, Error> {
        Ok(text_op(&*self.diagram()?, COLUMNS).trim_end().to_owned())
    }

    fn diagram(&self) -> Result<Cow<'_, diagram::Op>, Error> {
        let analysis = &self.program.0.analysis;
        if let Some(drawn) = &analysis.program.ops[self.index].diagram {
            return Ok(Cow::Borrowed(drawn));
        }
        example(&analysis.program, self.index, &analysis.plans)
            .map(Cow::Owned)
            .map_err(|none| Error::nowhere("no-example", none.to_string(), &self.program.0.sources))
    }
}
