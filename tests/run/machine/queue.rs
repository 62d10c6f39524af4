//! Elements in the order of their keys.

use std::collections::BTreeSet;

use hedgerow::rewrite::queue::Queue;
use support::dice::Dice;

const MANY: usize = 700;

#[test]
fn it_gives_what_sorting_gives() {
    let mut dice = Dice(7);
    // Some agree in their first bits, or are equal.
    let some = [0.0, -0.0, 1.0, 1.0 + 1e-9, 1.0 + 2e-9, -3.5, -3.5 - 1e-8, 1e-310, f64::INFINITY];
    let mut keys = vec![f64::NAN; MANY];
    let mut queue = Queue::default();
    let mut queued = BTreeSet::new();
    let (mut taken, mut most) = (0, 0);
    for turn in 0..60_000 {
        let id = dice.below(MANY);
        // It fills, and runs empty.
        let comes = if turn / 10_000 % 2 == 0 { 12 } else { 1 };
        match dice.below(4 + comes) {
            0 => {
                queue.remove(id as u32);
                queued.remove(&id);
            }
            1..4 => {
                let order = |a: &usize, b: &usize| {
                    let (x, y) = (keys[*a], keys[*b]);
                    x.partial_cmp(&y).expect("numbers").then(a.cmp(b))
                };
                let least = queued.iter().copied().min_by(order);
                assert_eq!(queue.least(), least.map(|id| id as u32));
                if let Some(least) = least {
                    queue.remove(least as u32);
                    queued.remove(&least);
                    taken += 1;
                }
            }
            _ => {
                let key = match dice.below(3) {
                    0 => dice.below(1000) as f64 - 500.5,
                    _ => some[dice.below(some.len())],
                };
                queue.set(id as u32, key);
                // What has its key already stays where it is.
                if keys[id] != key {
                    keys[id] = key;
                    match key == f64::INFINITY {
                        true => queued.remove(&id),
                        false => queued.insert(id),
                    };
                }
            }
        }
        most = most.max(queued.len());
    }
    assert!(taken > 10_000 && most > 300, "{taken} taken, {most} at once");
}
