//! What really becomes of meshes: the literal rewrite at every match, and the machine.

use hedgerow::diagram::{Property, Rule};
use hedgerow::mesh::{Mesh, validate};
use hedgerow::rewrite::{Engine, Machine, Outcome, Plan};

use crate::battery::kept::lost;
use crate::battery::trial::Trial;
use support::reference::matching::{bound_by, matches_where};
use support::reference::printing::mesh_text;
use support::reference::rewriting::rewrite;
use support::reference::same::{identical, same_result};
use support::reference::truth::untrue;

/// What became of an op on meshes.
#[derive(Default)]
pub struct Experience {
    pub matches: usize,
    /// Matches whose rewrite needs a name that nothing binds.
    pub unwritable: usize,
    /// Rewrites that make something else than `after` draws.
    pub lies: usize,
    /// How many rewrites broke the mesh, and the smallest mesh.
    pub broken: usize,
    pub smallest: Option<(usize, String)>,
    /// Where machine and reference differ.
    pub differences: Vec<String>,
    pub applied: usize,
}

impl Experience {
    fn breaks(&mut self, mesh: &Mesh, place: &[u32], what: String) {
        self.broken += 1;
        let size = mesh.halfedge_count();
        if self.smallest.as_ref().is_none_or(|(known, _)| size < *known) {
            let text = format!("at {place:?} of\n{}{what}", mesh_text(mesh));
            self.smallest = Some((size, text));
        }
    }
}

/// The most matches looked at in one place.
const MOST: usize = 200;

/// Rewrites literally at every match of the rules, the same one written out for several sizes;
/// with a plan the machine has to agree with one of them, and native code with the machine. What
/// the machine makes has to keep the given properties.
pub fn experience(
    rules: &[&Rule],
    plan: Option<(&Plan, &[Property])>,
    trials: impl Iterator<Item = Trial>,
) -> Experience {
    let mut experience = Experience::default();
    let mut machine = Machine::default();
    let mut native = Machine::default();
    native.use_engine(Engine::NativeAtOnce);
    for Trial { mesh, places } in trials {
        for place in places {
            let mut most = 0;
            let mut results = Vec::new();
            for &rule in rules {
                let may_be_one = |left, right| rule.may_be_one(left, right);
                let bound = bound_by(rule, &place);
                let found = matches_where(rule, &mesh, &bound, MOST, &may_be_one);
                most = most.max(found.len());
                let rewritten = found.iter().map(|at| (rule, rewrite(rule, &mesh, at)));
                results.extend(rewritten);
            }
            experience.matches += results.len();
            for (rule, result) in &results {
                match result {
                    None => experience.unwritable += 1,
                    Some(result) => {
                        let becomes =
                            |what: &str| format!("becomes\n{}{what}\n", mesh_text(&result.mesh));
                        if let Err(invalid) = validate(&result.mesh) {
                            experience.breaks(&mesh, &place, becomes(&invalid.to_string()));
                        } else if let Some(untrue) = untrue(rule, result) {
                            experience.lies += 1;
                            if plan.is_some() {
                                experience.breaks(&mesh, &place, becomes(&untrue));
                            }
                        }
                    }
                }
            }
            let Some((plan, keeps)) = plan else {
                if experience.broken > 0 {
                    return experience; // one is enough
                }
                continue;
            };
            let mut result = mesh.clone();
            let slots: Vec<_> = place.iter().map(|&element| u64::from(element)).collect();
            let outcome = machine.apply(&mut result, plan, &slots);
            let mut again = mesh.clone();
            if native.apply(&mut again, plan, &slots) != outcome || !identical(&again, &result) {
                let what = format!("native code makes\n{}", mesh_text(&again));
                experience.breaks(&mesh, &place, what);
            }
            let difference = match outcome {
                Ok(Outcome::Applied { .. }) => {
                    experience.applied += 1;
                    if let Err(invalid) = validate(&result) {
                        let what = format!("the machine makes\n{}{invalid}\n", mesh_text(&result));
                        experience.breaks(&mesh, &place, what);
                    } else if let Some(property) = lost(keeps, &mesh, &result) {
                        let lost = property.word();
                        let what =
                            format!("the machine makes\n{}not `{lost}`\n", mesh_text(&result));
                        experience.breaks(&mesh, &place, what);
                    }
                    let literals = results.iter().filter_map(|(_, literal)| literal.as_ref());
                    let mut literals = literals.map(|literal| &literal.mesh);
                    let agrees = literals.any(|literal| same_result(&mesh, &result, literal));
                    match most {
                        0 => Some("the machine applies where nothing matches"),
                        MOST => None,
                        _ => (!agrees).then_some("the machine makes another mesh"),
                    }
                }
                Ok(Outcome::Refused { .. }) if !identical(&mesh, &result) => {
                    Some("the machine refuses and changes the mesh")
                }
                Ok(Outcome::Refused { .. }) if !results.is_empty() => {
                    Some("the machine refuses where the drawing matches")
                }
                Ok(Outcome::Refused { .. }) => None,
                Err(_) => Some("the machine traps"),
            };
            if let Some(difference) = difference {
                let size = mesh.halfedge_count();
                let before = mesh_text(&mesh);
                let after = mesh_text(&result);
                let text = format!(
                    "{difference}: at {place:?} of ({size} halfedges)\n{before}it makes\n{after}"
                );
                experience.differences.push(text);
            }
        }
    }
    experience
}
