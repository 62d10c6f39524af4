//! Work on all cores, with the results of one thread.
//!
//! Work is cut into parts, and what comes of them is put together in their order; so nothing shows
//! how many parts there were, or which thread was done first. A pool of threads is made when it is
//! first wanted. Who calls from within a pool of `rayon` keeps to that pool. Without the feature
//! `threads` all is done by the thread that asks.

use std::ops::Range;

#[cfg(feature = "threads")]
pub use pool::{set_threads, threads};
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// The number of threads that work is given to.
#[cfg(not(feature = "threads"))]
pub fn threads() -> usize {
    1
}

/// True if who asks is one of those who took work.
#[cfg(feature = "native")]
pub(crate) fn is_at_work() -> bool {
    #[cfg(feature = "threads")]
    return rayon::current_thread_index().is_some();
    #[cfg(not(feature = "threads"))]
    false
}

/// Lets each worker work on a thread of its own, and does `meanwhile` here, again and again after so
/// long, until all are done.
#[cfg(feature = "native")]
pub(crate) fn each_at_work<W: Send>(
    workers: &mut [W],
    work: impl Fn(&mut W) + Sync,
    every: std::time::Duration,
    mut meanwhile: impl FnMut(),
) {
    #[cfg(feature = "threads")]
    {
        // When all senders have been dropped, all are done.
        use std::sync::mpsc::{RecvTimeoutError, channel};
        let (sender, receiver) = channel::<()>();
        let senders: Vec<_> = workers.iter().map(|_| sender.clone()).collect();
        drop(sender);
        let work = &work;
        pool::beside(
            |scope| {
                for (worker, sender) in workers.iter_mut().zip(senders) {
                    scope.spawn(move |_| {
                        work(worker);
                        drop(sender);
                    });
                }
            },
            || {
                while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(every) {
                    meanwhile();
                }
            },
        );
    }
    #[cfg(not(feature = "threads"))]
    for worker in workers {
        let _ = every; // nobody else works
        work(worker);
        meanwhile();
    }
}

/// Ranges that cover the numbers below `count`, some for each thread: of `least` numbers or more
/// each, since less is not worth a thread.
pub(crate) fn parts(count: usize, least: usize) -> Vec<Range<usize>> {
    let threads = threads();
    let parts = if threads == 1 { 1 } else { (threads * 4).min(count / least.max(1)).max(1) };
    cut(count, parts)
}

/// So many ranges of about the same size that cover the numbers below `count`.
pub(crate) fn cut(count: usize, parts: usize) -> Vec<Range<usize>> {
    let bound = |part: usize| (count as u128 * part as u128 / parts as u128) as usize;
    (0..parts).map(|part| bound(part)..bound(part + 1)).collect()
}

/// The answers for all items, in order.
pub(crate) fn map<I: Send, T: Send>(items: Vec<I>, work: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "threads")]
    if items.len() > 1 && threads() > 1 {
        return pool::within(|| items.into_par_iter().with_max_len(1).map(work).collect());
    }
    items.into_iter().map(work).collect()
}

/// The answers for all numbers below `count`, in order; parts have `least` numbers or more.
pub(crate) fn collect<T: Send>(
    count: usize,
    least: usize,
    work: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    collect_with_room(count, count, least, work)
}

/// As [`collect`], in a vector with room for so many.
pub(crate) fn collect_with_room<T: Send>(
    room: usize,
    count: usize,
    least: usize,
    work: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    let mut all = Vec::with_capacity(room);
    #[cfg(feature = "threads")]
    if count >= 2 * least && threads() > 1 {
        let numbers = (0..count).into_par_iter().with_min_len(least);
        pool::within(|| all.par_extend(numbers.map(work)));
        return all;
    }
    #[cfg(not(feature = "threads"))]
    let _ = least; // nothing is cut
    all.extend((0..count).map(work));
    all
}

/// Hands the answers for all items to `take`, in order, and takes the next items while others are
/// worked at. The first error ends it.
pub(crate) fn in_order<I: Send, T: Send, E>(
    items: impl IntoIterator<Item = I>,
    work: impl Fn(I) -> T + Sync,
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let mut items = items.into_iter();
    #[cfg(feature = "threads")]
    if threads() > 1 {
        let mut some = || -> Vec<I> { items.by_ref().take(4 * threads()).collect() };
        let (mut now, mut ready): (_, Vec<T>) = (some(), Vec::new());
        while !now.is_empty() || !ready.is_empty() {
            let mut answers: Vec<Option<T>> = now.iter().map(|_| None).collect();
            now = pool::beside(
                |scope| {
                    for (item, answer) in now.into_iter().zip(&mut answers) {
                        let work = &work;
                        scope.spawn(move |_| *answer = Some(work(item)));
                    }
                },
                || ready.drain(..).try_for_each(&mut take).map(|()| some()),
            )?;
            ready.extend(answers.into_iter().flatten());
        }
        return Ok(());
    }
    items.try_for_each(|item| take(work(item)))
}

/// What came of parts, one after the other.
pub(crate) fn joined<T>(parts: Vec<Vec<T>>) -> Vec<T> {
    let size: usize = parts.iter().map(Vec::len).sum();
    let mut parts = parts.into_iter();
    let mut all = parts.next().unwrap_or_default();
    all.reserve_exact(size - all.len());
    parts.for_each(|mut part| all.append(&mut part));
    all
}

#[cfg(feature = "threads")]
mod pool {
    use std::num::NonZeroUsize;
    use std::sync::{Arc, Mutex, PoisonError};

    use rayon::{Scope, ThreadPool, ThreadPoolBuilder};

    /// The threads of this process, and the number that was asked for.
    struct Pool {
        wanted: Option<NonZeroUsize>,
        /// With the number of the process: after a fork the threads are those of another.
        made: Option<(u32, usize, Option<Arc<ThreadPool>>)>,
    }

    static POOL: Mutex<Pool> = Mutex::new(Pool { wanted: None, made: None });

    /// Says how many threads work is given to from now on; with `None`, as many as `HEDGEROW_THREADS`
    /// says or, if it says no number, as there are cores. Work that goes on keeps its threads.
    pub fn set_threads(count: Option<NonZeroUsize>) {
        let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
        (pool.wanted, pool.made) = (count, None);
    }

    /// The number of threads that work is given to.
    pub fn threads() -> usize {
        match rayon::current_thread_index() {
            Some(_) => rayon::current_num_threads(),
            None => current().0,
        }
    }

    /// Does work with the threads of the pool.
    pub(super) fn within<T: Send>(work: impl FnOnce() -> T + Send) -> T {
        if rayon::current_thread_index().is_some() {
            return work();
        }
        match current().1 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Starts work with the threads of the pool, and does `meanwhile` here.
    pub(crate) fn beside<'s, T>(
        start: impl FnOnce(&Scope<'s>),
        meanwhile: impl FnOnce() -> T,
    ) -> T {
        let scope = |scope: &Scope<'s>| {
            start(scope);
            meanwhile()
        };
        match current().1 {
            Some(pool) if rayon::current_thread_index().is_none() => pool.in_place_scope(scope),
            _ => rayon::in_place_scope(scope),
        }
    }

    /// The number of threads, and the pool if it could be made.
    fn current() -> (usize, Option<Arc<ThreadPool>>) {
        let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
        let process = std::process::id();
        if let Some((of, threads, made)) = &pool.made
            && *of == process
        {
            return (*threads, made.clone());
        }
        let wanted = pool.wanted.or_else(|| std::env::var("HEDGEROW_THREADS").ok()?.parse().ok());
        let threads = wanted.or_else(|| std::thread::available_parallelism().ok());
        let threads = threads.map_or(1, NonZeroUsize::get).min(MOST);
        let made = (threads > 1).then(|| {
            let name = |thread| format!("hedgerow {thread}");
            let builder = ThreadPoolBuilder::new().num_threads(threads).thread_name(name);
            builder.stack_size(STACK).build()
        });
        let (threads, made) = match made {
            Some(Ok(made)) => (threads, Some(Arc::new(made))),
            // One can always go on alone.
            Some(Err(_)) | None => (1, None),
        };
        // The threads of another process are none of this one's: nobody waits for them.
        std::mem::forget(pool.made.take());
        pool.made = Some((process, threads, made.clone()));
        (threads, made)
    }

    /// The bytes of the stack of a thread: as many as the first thread of a program usually has.
    const STACK: usize = 8 << 20;

    /// The most threads that a pool has.
    const MOST: usize = 256;
}
