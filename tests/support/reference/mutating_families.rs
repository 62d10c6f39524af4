//! Small mutations that apply only to rules with families.

use hedgerow::diagram::{Role, Rule};

use super::mutating::refs;
use super::random::Random;

/// Changes a subscript, or replaces a single name by a family, or the reverse; `None` if the chosen
/// mutation does not apply.
pub fn mutate_family(rule: &mut Rule, random: &mut Random) -> Option<()> {
    let whole = rule.clone();
    let role = |name| whole.name(name).role;
    let side = match random.once_in(3) {
        true => &mut rule.before,
        false => &mut rule.after,
    };
    let mut places = refs(side);
    let count = places.len();
    if count == 0 {
        return None;
    }
    let families: Vec<_> = (0..count).filter(|&at| role(places[at].name) == Role::Family).collect();
    let turn = |random: &mut Random| *random.pick(&[-1, 1, 1, 2]).expect("a number");
    match random.below(4) {
        0 | 1 => places[*random.pick(&families)?].shift += turn(random),
        2 => {
            // All mentions of a family on this side: it is rotated relative to the others.
            let name = places[*random.pick(&families)?].name;
            let by = turn(random);
            let mentions = places.iter_mut().filter(|place| place.name == name);
            mentions.for_each(|place| place.shift += by);
        }
        _ => {
            let at = random.below(count);
            let kind = whole.kind(places[at].name);
            let others: Vec<_> =
                whole.names_of(kind).filter(|&name| role(name) != role(places[at].name)).collect();
            places[at].name = *random.pick(&others)?;
        }
    }
    for side in [&mut rule.before, &mut rule.after] {
        for orbit in &mut side.loops {
            orbit.end = orbit.items[0].from;
        }
    }
    Some(())
}
