//! Setting attributes and positions from arrays.
//!
//! Neither changes pointers, so the level of the mesh stays known.

use super::{Error, Session};
use crate::mesh::{ColumnData, ElementKind, glam::DVec3, is_public_name};
use crate::run::replace_stand_in;

impl Session {
    /// Sets the values of an attribute, one for each slot of a kind, alive or dead. If there is no
    /// attribute of that name, it is added; its default for new elements is then zero, until a
    /// program declares another.
    ///
    /// # Errors
    /// The name has other characters than letters, digits, `_` and `'`, or the number of values is
    /// not that of the slots (`wrong-argument`), or there is an attribute
    /// of that name with values of another type (`attribute-conflict`). Nothing has changed.
    pub fn set_attribute(
        &mut self,
        kind: ElementKind,
        name: &str,
        values: ColumnData,
    ) -> Result<(), Error> {
        if !is_public_name(name) {
            let message = format!("`{name}` is not a name that a program can contain, nor a file");
            return Err(self.wrong("wrong-argument", message));
        }
        let slots = self.mesh.capacity(kind);
        if values.len() != slots {
            let what = format!("values for the attribute `{name}`");
            return Err(self.wrong_length(&what, values.len(), (kind, slots)));
        }
        let is_new = self.mesh.find_column(kind, name).is_none();
        let zero = values.attribute_type().zero();
        let column = self.mesh.add_column(kind, name, zero).map_err(|conflict| {
            self.wrong("attribute-conflict", format!("{conflict} on this mesh"))
        })?;
        self.mesh.set_values(column, values);
        if replace_stand_in(&mut self.mesh, kind, name) || is_new {
            // Its default becomes that of the program.
            self.engine.unbind();
        }
        self.masks.forget();
        Ok(())
    }

    /// Removes an attribute. Returns whether there was one of that name.
    pub fn remove_attribute(&mut self, kind: ElementKind, name: &str) -> bool {
        let Some(column) = self.mesh.find_column(kind, name) else { return false };
        self.mesh.remove_column(column);
        self.engine.unbind();
        self.masks.forget();
        true
    }

    /// Sets the positions of all vertices from one position for each slot; those of dead slots are
    /// ignored.
    ///
    /// # Errors
    /// The number of positions is not that of the slots, or the position of a living vertex is not
    /// finite (`wrong-argument`). Nothing has changed.
    pub fn set_positions(&mut self, positions: &[DVec3]) -> Result<(), Error> {
        let slots = self.mesh.capacity(ElementKind::Vertex);
        if positions.len() != slots {
            let of = (ElementKind::Vertex, slots);
            return Err(self.wrong_length("positions", positions.len(), of));
        }
        let living: Vec<_> = self.mesh.vertices().collect();
        if let Some(stray) = living.iter().find(|v| !positions[v.index()].is_finite()) {
            let message = format!("the position of {stray} is not finite");
            return Err(self.wrong("wrong-argument", message));
        }
        for vertex in living {
            self.mesh.set_position(vertex, positions[vertex.index()]);
        }
        self.masks.forget();
        Ok(())
    }

    fn wrong_length(&self, what: &str, given: usize, (kind, slots): (ElementKind, usize)) -> Error {
        let message = format!(
            "there are {given} {what}, and {slots} places for {} (the number of the last and one \
             more)",
            kind.plural()
        );
        self.wrong("wrong-argument", message)
    }
}
