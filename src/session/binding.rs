//! Columns of attributes on the mesh: found when something is first asked or called.

use super::engine::Engine;
use super::{Error, Session};
use crate::run::Columns;

/// For what the columns of an item are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Bound {
    /// For nothing.
    No,
    /// To ask: the mesh may lack attributes, and have other defaults.
    ToAsk,
    /// To change the mesh, which has the attributes and their defaults.
    ToChange,
}

impl Bound {
    /// What it takes to run something that changes the mesh, or does not.
    pub(super) fn to_run(changes: bool) -> Self {
        if changes { Self::ToChange } else { Self::ToAsk }
    }
}

impl Session {
    /// Finds the columns of an item for what is wanted, unless they are known; `known` is for what
    /// they are.
    pub(super) fn bind(
        &mut self,
        columns: &Columns,
        wanted: Bound,
        known: impl Fn(&mut Engine) -> &mut Bound,
    ) -> Result<(), Error> {
        if *known(&mut self.engine) >= wanted {
            return Ok(());
        }
        let found = match wanted {
            Bound::ToChange => {
                if columns.replace_stand_ins(&mut self.mesh) {
                    self.engine.unbind();
                    self.masks.forget();
                }
                columns.bind(&mut self.mesh).map(|places| (places, Vec::new()))
            }
            Bound::No | Bound::ToAsk => columns.bind_to_ask(&mut self.mesh),
        };
        match found {
            Ok((places, defaults)) => {
                for own in defaults {
                    if self.engine.defaults.iter().all(|other| other.0 != own.0) {
                        self.engine.defaults.push(own);
                    }
                }
                for (column, place) in self.engine.columns.iter_mut().zip(places) {
                    *column = place.or(*column);
                }
                self.engine.machine.use_columns(self.engine.columns.clone());
                *known(&mut self.engine) = wanted;
                Ok(())
            }
            Err(conflict) => {
                // It is unknown which of the columns are on the mesh.
                self.engine.unbind();
                Err(self.error(conflict))
            }
        }
    }

    /// Asks something while the attributes have the defaults of the program, and gives the mesh its
    /// own ones back.
    pub(super) fn with_own_defaults<T>(&mut self, ask: impl FnOnce(&mut Self) -> T) -> T {
        self.exchange_defaults();
        let answer = ask(self);
        self.exchange_defaults();
        answer
    }

    fn exchange_defaults(&mut self) {
        for (column, default) in &mut self.engine.defaults {
            self.mesh.swap_default(*column, default);
        }
    }
}
