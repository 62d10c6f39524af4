//! SmallMap about elements: the last note about each counts.

use std::collections::HashMap;
use std::hash::Hash;

/// Up to so many notes are searched one by one; that is what most operations make.
const FEW: usize = 24;

/// SmallMap by key.
#[derive(Debug)]
pub struct SmallMap<K, V> {
    few: Vec<(K, V)>,
    many: HashMap<K, V>,
}

impl<K, V> Default for SmallMap<K, V> {
    fn default() -> Self {
        Self { few: Vec::new(), many: HashMap::new() }
    }
}

impl<K: Copy + Eq + Hash, V: Copy> SmallMap<K, V> {
    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.few.clear();
        if !self.many.is_empty() {
            self.many.clear();
        }
    }

    /// One more note.
    pub fn set(&mut self, key: K, value: V) {
        match self.few.len() < FEW {
            true => self.few.push((key, value)),
            false => {
                self.many.insert(key, value);
            }
        }
    }

    /// The last note with the key.
    pub fn get(&self, key: K) -> Option<V> {
        // What is among the many was noted after the few.
        let late = match self.many.is_empty() {
            true => None,
            false => self.many.get(&key).copied(),
        };
        late.or_else(|| {
            let mut early = self.few.iter().rev();
            early.find(|note| note.0 == key).map(|note| note.1)
        })
    }
}
