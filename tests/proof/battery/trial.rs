//! Where an op is tried: random completions of its drawing, and random maps.

use hedgerow::diagram::Op;
use hedgerow::mesh::Mesh;

use support::reference::completion::complete;
use support::reference::examples::elements;
use support::reference::maps::random_map;
use support::reference::random::Random;

/// Where an op is tried.
#[derive(Clone)]
pub struct Trial {
    pub mesh: Mesh,
    /// The elements given, each choice of them.
    pub places: Vec<Vec<u32>>,
}

/// Random maps that serve all mutants.
pub struct Pool {
    maps: Vec<Mesh>,
    completions: usize,
}

/// All choices of the elements given; of two or more only some.
fn places(op: &Op, mesh: &Mesh, random: &mut Random) -> Vec<Vec<u32>> {
    let choices: Vec<_> = op.params.iter().map(|param| elements(mesh, param.ty)).collect();
    match choices.as_slice() {
        [only] => only.iter().map(|&element| vec![element]).collect(),
        many => {
            let mut pick = || many.iter().map(|choice| random.pick(choice).copied()).collect();
            (0..12).filter_map(|_| pick()).collect()
        }
    }
}

impl Pool {
    pub fn new(maps: usize, completions: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let maps = (0..maps).map(|_| random_map(2 + 2 * random.below(7), &mut random)).collect();
        Self { maps, completions }
    }

    /// These meshes, and no completions.
    pub fn of(maps: Vec<Mesh>) -> Self {
        Self { maps, completions: 0 }
    }

    /// The meshes on which an op is tried, one after the other. With families these are the op
    /// written out for some sizes.
    pub fn trials<'a>(
        &'a self,
        ops: &'a [Op],
        random: &'a mut Random,
    ) -> impl Iterator<Item = Trial> + 'a {
        (0..self.completions + self.maps.len()).filter_map(move |at| {
            let op = &ops[at % ops.len()];
            let rule = &op.rules[0];
            if at >= self.completions {
                let mesh = self.maps[at - self.completions].clone();
                let places = places(op, &mesh, random);
                return Some(Trial { mesh, places });
            }
            let completion = complete(rule, random)?;
            let mut places = places(op, &completion.mesh, random);
            let meant = rule.params.iter().map(|name| completion.elements[(*name)?.index()]);
            if let Some(meant) = meant.collect::<Option<Vec<_>>>() {
                // Where it is meant to match, and where it nearly does.
                if op.params.iter().all(|param| param.ty == op.params[0].ty) {
                    let turns = 1..op.params.len();
                    places.extend(turns.map(|turn| [&meant[turn..], &meant[..turn]].concat()));
                    let mut swapped = meant.clone();
                    swapped.swap(0, op.params.len() - 1);
                    places.push(swapped);
                }
                places.retain(|place| *place != meant);
                places.insert(0, meant);
            }
            Some(Trial { mesh: completion.mesh, places })
        })
    }
}
