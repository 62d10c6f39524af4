//! The columns of a mesh: attributes by name, and their values.

use super::attribute::{Attribute, Column, ColumnConflict, ColumnData, ColumnId, Value};
use super::connectivity::Mesh;
use super::id::ElementKind;

impl Mesh {
    /// Adds a column with `default` in every slot. If there is one of that name and type, returns
    /// it unchanged.
    pub fn add_column(
        &mut self,
        kind: ElementKind,
        name: &str,
        default: Value,
    ) -> Result<ColumnId, ColumnConflict> {
        if let Some(id) = self.find_column(kind, name) {
            let has = self.columns[kind as usize].0[id.place as usize].attribute_type();
            let wanted = default.attribute_type();
            return match has == wanted {
                true => Ok(id),
                false => Err(ColumnConflict { kind, name: name.to_owned(), has, wanted }),
            };
        }
        let id = self.append_column(kind, name, default);
        self.note_added(id);
        Ok(id)
    }

    /// Adds a column of a new name, without a note in the journal: what is rolled back leaves it.
    pub(crate) fn append_column(
        &mut self,
        kind: ElementKind,
        name: &str,
        default: Value,
    ) -> ColumnId {
        let mut data = default.column(self.capacity(kind));
        // Room for as many values as the tables have room for elements.
        data.reserve(self.reserved(kind));
        let columns = &mut self.columns[kind as usize].0;
        columns.push(Column { name: name.to_owned(), default, data });
        ColumnId { kind, place: columns.len() as u32 - 1 }
    }

    /// Sets the value that new elements get. Returns false, and changes nothing, if the type is not
    /// the column's.
    #[must_use]
    pub fn set_default(&mut self, id: ColumnId, default: Value) -> bool {
        let column = self.column(id).filter(|it| it.attribute_type() == default.attribute_type());
        let was = column.map(|column| column.default);
        if was.is_some_and(|was| !was.is_identical(default)) {
            self.note_default(id);
            self.swap_default(id, &mut { default });
        }
        was.is_some()
    }

    /// Fills every slot with the default, without a note in the journal: for scratch columns.
    pub(crate) fn clear_column(&mut self, id: ColumnId) {
        if let Some(column) = self.column_mut(id) {
            column.data.fill(column.default);
        }
    }

    /// Removes a column. Ids of other columns of its kind are invalid afterwards.
    pub fn remove_column(&mut self, id: ColumnId) {
        if let Some(column) = self.take_column(id) {
            self.note_removed(id, column);
        }
    }

    /// Removes a column, without a note in the journal.
    pub(super) fn take_column(&mut self, id: ColumnId) -> Option<Column> {
        let columns = &mut self.columns[id.kind as usize].0;
        (columns.len() > id.place as usize).then(|| columns.remove(id.place as usize))
    }

    pub fn find_column(&self, kind: ElementKind, name: &str) -> Option<ColumnId> {
        let place = self.columns[kind as usize].0.iter().position(|c| c.name == name)?;
        Some(ColumnId { kind, place: place as u32 })
    }

    /// The columns of a kind, in the order they were added.
    pub fn columns(&self, kind: ElementKind) -> impl Iterator<Item = (ColumnId, &Column)> {
        let columns = self.columns[kind as usize].0.iter().enumerate();
        columns.map(move |(place, column)| (ColumnId { kind, place: place as u32 }, column))
    }

    /// The columns of all kinds that are written to files.
    pub fn public_columns(&self) -> impl Iterator<Item = (ColumnId, &Column)> {
        let all = ElementKind::ALL.into_iter().flat_map(|kind| self.columns(kind));
        all.filter(|(_, column)| column.is_public())
    }

    /// The column; `None` if the id is one of another mesh and this one has no such column.
    pub fn column(&self, id: ColumnId) -> Option<&Column> {
        self.columns[id.kind as usize].0.get(id.place as usize)
    }

    #[inline]
    fn column_mut(&mut self, id: ColumnId) -> Option<&mut Column> {
        self.columns[id.kind as usize].0.get_mut(id.place as usize)
    }

    /// The value of a living element.
    pub fn value(&self, id: ColumnId, index: u32) -> Option<Value> {
        if !self.is_alive(id.kind, index) {
            return None;
        }
        self.column(id)?.data.get(index as usize)
    }

    /// Writes the value of a living element. Returns false, and writes nothing, if the element is
    /// not alive or the type is not the column's.
    #[must_use]
    pub fn set_value(&mut self, id: ColumnId, index: u32, value: Value) -> bool {
        self.note_value(id, index);
        self.is_alive(id.kind, index)
            && self.column_mut(id).is_some_and(|column| column.data.set(index as usize, value))
    }

    /// The value in a slot, living or dead.
    pub(super) fn value_at(&self, id: ColumnId, index: u32) -> Option<Value> {
        self.column(id)?.data.get(index as usize)
    }

    /// Writes to a slot, living or dead; does nothing if there is none or the type is another. Not
    /// noted in the journal.
    pub(super) fn put_value(&mut self, id: ColumnId, index: u32, value: Value) {
        if let Some(column) = self.column_mut(id) {
            column.data.set(index as usize, value);
        }
    }

    /// Replaces all values of a column, one for each slot; does nothing if their type or number is
    /// another.
    pub fn set_values(&mut self, id: ColumnId, data: ColumnData) {
        let fits = |column: &Column| {
            column.attribute_type() == data.attribute_type() && column.data.len() == data.len()
        };
        if self.column(id).is_some_and(fits) {
            self.note_values(id);
            self.put_values(id, data);
        }
    }

    /// Replaces all values of a column, without a note in the journal.
    pub(super) fn put_values(&mut self, id: ColumnId, data: ColumnData) {
        if let Some(column) = self.column_mut(id) {
            column.data = data;
        }
    }

    /// Exchanges all values of a column with `data`.
    pub(super) fn swap_values(&mut self, id: ColumnId, data: &mut ColumnData) {
        if let Some(column) = self.column_mut(id) {
            std::mem::swap(&mut column.data, data);
        }
    }

    /// Exchanges the default of a column with `default`.
    pub(crate) fn swap_default(&mut self, id: ColumnId, default: &mut Value) {
        if let Some(column) = self.column_mut(id) {
            std::mem::swap(&mut column.default, default);
        }
    }

    /// Inserts a column where it was before its removal.
    pub(super) fn put_column(&mut self, id: ColumnId, column: Column) {
        let columns = &mut self.columns[id.kind as usize].0;
        columns.insert(columns.len().min(id.place as usize), column);
    }

    /// All values of a column by slot, dead slots included; `None` if the type is another.
    #[inline]
    pub fn values<T: Attribute>(&self, id: ColumnId) -> Option<&[T]> {
        T::slice(&self.column(id)?.data)
    }

    /// The values of a column, for writing. The caller first calls [`Mesh::note_value`] for each
    /// value that it writes. `None` for the column of another mesh.
    #[doc(hidden)]
    #[inline]
    pub fn column_data_mut(&mut self, id: ColumnId) -> Option<&mut ColumnData> {
        Some(&mut self.column_mut(id)?.data)
    }

    /// The values of a column of this type, to be changed; `None` for another type. A journal that
    /// is kept records them all.
    #[inline]
    pub fn values_mut<T: Attribute>(&mut self, id: ColumnId) -> Option<&mut [T]> {
        self.note_values(id);
        let column = self.column_mut(id)?;
        T::slice_mut(&mut column.data)
    }
}
