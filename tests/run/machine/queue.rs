//! Elements in the order of their keys.

use hedgerow::rewrite::queue::Queue;

#[test]
fn it_gives_what_sorting_gives() {
    let mut seed = 7_u64;
    let mut random = |below: u64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 33) % below
    };
    let mut keys = vec![0.0; 40];
    let mut queue = Queue::default();
    let mut queued = std::collections::BTreeSet::new();
    let mut taken = 0;
    for _ in 0..4000 {
        let id = random(40) as u32;
        match random(3) {
            0 => {
                queue.remove(id);
                queued.remove(&id);
            }
            1 => {
                keys[id as usize] = random(10) as f64 - 5.0;
                queue.put(id, keys[id as usize]);
                queued.insert(id);
            }
            _ => {
                let order = |a: &u32, b: &u32| {
                    let [x, y] = [a, b].map(|&id| keys[id as usize]);
                    x.total_cmp(&y).then(a.cmp(b))
                };
                let least = queued.iter().copied().min_by(order);
                assert_eq!(queue.least(), least);
                if let Some(least) = least {
                    queue.remove(least);
                    queued.remove(&least);
                    taken += 1;
                }
            }
        }
    }
    assert!(taken > 500);
}
