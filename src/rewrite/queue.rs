//! Elements in the order of their keys: a binary heap that knows where each element stands
//! (Williams, Algorithm 232: Heapsort, 1964), so that one in the middle can move or leave.
//!
//! The keys are kept by whoever has the queue. Of equal keys the lower number comes first, so
//! that the order does not depend on how the queue came about.

/// The place of what is not queued.
const NOWHERE: u32 = u32::MAX;

/// A queue of elements by number.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: Vec<u32>,
    /// By element its place in the heap.
    places: Vec<u32>,
}

impl Queue {
    /// The element with the least key.
    pub(super) fn least(&self) -> Option<u32> {
        self.heap.first().copied()
    }

    /// Puts an element where its key belongs, whether it is queued already or not.
    pub(super) fn put(&mut self, id: u32, keys: &[f64]) {
        let index = id as usize;
        if self.places.len() <= index {
            self.places.resize(index + 1, NOWHERE);
        }
        let mut at = self.places[index] as usize;
        if self.places[index] == NOWHERE {
            at = self.heap.len();
            self.heap.push(id);
            self.places[index] = at as u32;
        }
        let at = self.rise(at, keys);
        self.sink(at, keys);
    }

    /// Takes an element out, if it is queued.
    pub(super) fn remove(&mut self, id: u32, keys: &[f64]) {
        let Some(place) = self.places.get_mut(id as usize) else {
            return;
        };
        let at = std::mem::replace(place, NOWHERE) as usize;
        if at >= self.heap.len() {
            return;
        }
        self.heap.swap_remove(at);
        if let Some(&moved) = self.heap.get(at) {
            self.places[moved as usize] = at as u32;
            let at = self.rise(at, keys);
            self.sink(at, keys);
        }
    }

    fn is_before(&self, left: usize, right: usize, keys: &[f64]) -> bool {
        let [left, right] = [self.heap[left], self.heap[right]];
        let [first, second] = [keys[left as usize], keys[right as usize]];
        first < second || (first == second && left < right)
    }

    fn exchange(&mut self, left: usize, right: usize) {
        self.heap.swap(left, right);
        for at in [left, right] {
            self.places[self.heap[at] as usize] = at as u32;
        }
    }

    fn rise(&mut self, mut at: usize, keys: &[f64]) -> usize {
        while at > 0 && self.is_before(at, (at - 1) / 2, keys) {
            self.exchange(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
        at
    }

    fn sink(&mut self, mut at: usize, keys: &[f64]) {
        loop {
            let (left, right) = (2 * at + 1, 2 * at + 2);
            let mut first = at;
            for child in [left, right] {
                if child < self.heap.len() && self.is_before(child, first, keys) {
                    first = child;
                }
            }
            if first == at {
                return;
            }
            self.exchange(at, first);
            at = first;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
                    queue.remove(id, &keys);
                    queued.remove(&id);
                }
                1 => {
                    keys[id as usize] = random(10) as f64 - 5.0;
                    queue.put(id, &keys);
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
                        queue.remove(least, &keys);
                        queued.remove(&least);
                        taken += 1;
                    }
                }
            }
        }
        assert!(taken > 500);
    }
}
