//! Work on all cores, with the results of one thread.
//!
//! Work is cut into parts, and the results are put together in their order, so the outcome depends
//! neither on the number of parts nor on the order in which threads finish. A pool of threads is
//! made when it is first needed. A caller inside a pool of `rayon` stays in that pool. Without the
//! feature `threads` everything runs on the calling thread.

#[cfg(feature = "threads")]
use std::collections::VecDeque;
use std::ops::Range;
#[cfg(feature = "threads")]
use std::sync::mpsc::channel;

#[cfg(feature = "threads")]
pub use pool::{set_threads, threads};
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// The number of threads that work is given to.
#[cfg(not(feature = "threads"))]
pub fn threads() -> usize {
    1
}

/// Whether the caller runs on a thread of a pool.
pub(crate) fn is_at_work() -> bool {
    #[cfg(feature = "threads")]
    return rayon::current_thread_index().is_some();
    #[cfg(not(feature = "threads"))]
    false
}

/// Runs `work` for each worker on the threads of the pool, and calls `meanwhile` on this thread at
/// intervals of `every` until all are done.
pub(crate) fn each_at_work<W: Send>(
    workers: &mut [W],
    work: impl Fn(&mut W) + Sync,
    every: std::time::Duration,
    mut meanwhile: impl FnMut(),
) {
    #[cfg(feature = "threads")]
    {
        // When all senders have been dropped, all workers are done.
        use std::sync::mpsc::{RecvTimeoutError, channel};
        let (sender, receiver) = channel::<()>();
        let senders: Vec<_> = workers.iter().map(|_| sender.clone()).collect();
        drop(sender);
        let work = &work;
        pool::scope(|scope| {
            for (worker, sender) in workers.iter_mut().zip(senders) {
                scope.spawn(move |_| {
                    work(worker);
                    drop(sender);
                });
            }
            while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(every) {
                meanwhile();
            }
        });
    }
    #[cfg(not(feature = "threads"))]
    for worker in workers {
        let _ = every; // nobody else works
        work(worker);
        meanwhile();
    }
}

/// Ranges that cover the numbers below `count`, several for each thread, with at least `least`
/// numbers each where there are enough: fewer are not worth a thread.
pub(crate) fn parts(count: usize, least: usize) -> Vec<Range<usize>> {
    let threads = threads();
    let parts = if threads == 1 { 1 } else { (threads * 4).min(count / least.max(1)).max(1) };
    cut(count, parts)
}

/// `parts` ranges of about the same size that cover the numbers below `count`.
pub(crate) fn cut(count: usize, parts: usize) -> Vec<Range<usize>> {
    let bound = |part: usize| (count as u128 * part as u128 / parts as u128) as usize;
    (0..parts).map(|part| bound(part)..bound(part + 1)).collect()
}

/// The results for all items, in order.
pub(crate) fn map<I: Send, T: Send>(items: Vec<I>, work: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "threads")]
    if items.len() > 1 && threads() > 1 {
        let mut results: Vec<Option<T>> = items.iter().map(|_| None).collect();
        pool::scope(|scope| {
            for (item, result) in items.into_iter().zip(&mut results) {
                scope.spawn(|_| *result = Some(work(item)));
            }
        });
        return results.into_iter().flatten().collect();
    }
    items.into_iter().map(work).collect()
}

/// The results for all numbers below `count`, in order; parts have `least` numbers or more.
pub(crate) fn collect<T: Send>(
    count: usize,
    least: usize,
    work: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    collect_with_room(count, count, least, work)
}

/// As [`collect`], in a vector with capacity `room`.
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

/// Passes the results for all items to `take`, in order, which runs while the next items are worked
/// on. Stops at the first error.
pub(crate) fn in_order<I: Send, T: Send, E>(
    items: impl IntoIterator<Item = I>,
    work: impl Fn(I) -> T + Sync,
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let mut items = items.into_iter();
    #[cfg(feature = "threads")]
    if threads() > 1 {
        let (ahead, work) = (4 * threads(), &work);
        return pool::scope(|scope| {
            let mut results = VecDeque::with_capacity(ahead);
            loop {
                while results.len() < ahead
                    && let Some(item) = items.next()
                {
                    let (sender, receiver) = channel();
                    // The receiver is gone if an earlier result was an error.
                    scope.spawn(move |_| _ = sender.send(work(item)));
                    results.push_back(receiver);
                }
                // A sender is dropped without a result if the work panics, as the scope will.
                let Some(result) = results.pop_front().and_then(pool::received) else {
                    return Ok(());
                };
                take(result)?;
            }
        });
    }
    items.try_for_each(|item| take(work(item)))
}

/// The consecutive parts of a slice, which have the given lengths.
pub(crate) fn split<T>(
    mut slice: &mut [T],
    lengths: impl Iterator<Item = usize>,
) -> impl Iterator<Item = &mut [T]> {
    lengths.map_while(move |length| slice.split_off_mut(..length))
}

/// The concatenated parts.
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
    use std::sync::mpsc::Receiver;
    use std::sync::{Arc, Mutex, PoisonError};

    use rayon::{Scope, ThreadPool, ThreadPoolBuilder, Yield};

    /// The threads of this process, and the number that was requested.
    struct Pool {
        wanted: Option<NonZeroUsize>,
        /// With the id of the process: after a fork, the threads are those of the parent.
        made: Option<(u32, usize, Option<Arc<ThreadPool>>)>,
    }

    static POOL: Mutex<Pool> = Mutex::new(Pool { wanted: None, made: None });

    /// Sets how many threads work is given to; `None` stands for the number in `HEDGEROW_THREADS`
    /// or, without one, the number of cores. Running work keeps its threads.
    pub fn set_threads(count: Option<NonZeroUsize>) {
        let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
        pool.wanted = count;
        if let Some((process, _, made)) = pool.made.take()
            && process != std::process::id()
        {
            std::mem::forget(made);
        }
    }

    /// The number of threads that work is given to.
    pub fn threads() -> usize {
        match rayon::current_thread_index() {
            Some(_) => rayon::current_num_threads(),
            None => current().0,
        }
    }

    /// Runs work on the threads of the pool.
    pub(super) fn within<T: Send>(work: impl FnOnce() -> T + Send) -> T {
        if rayon::current_thread_index().is_some() {
            return work();
        }
        match current().1 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Runs `work` on this thread; what it spawns runs on the threads of the pool, and has ended
    /// when this returns.
    pub(super) fn scope<'s, T>(work: impl FnOnce(&Scope<'s>) -> T) -> T {
        match current().1 {
            Some(pool) if rayon::current_thread_index().is_none() => pool.in_place_scope(work),
            _ => rayon::in_place_scope(work),
        }
    }

    /// The value that work that was started sends; `None` if it panics. A thread of a pool does what it has
    /// started itself meanwhile, since others may be busy.
    pub(super) fn received<T>(receiver: Receiver<T>) -> Option<T> {
        while rayon::yield_local() == Some(Yield::Executed) {
            if let Ok(result) = receiver.try_recv() {
                return Some(result);
            }
        }
        receiver.recv().ok()
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
            // Work can always go on without a pool.
            Some(Err(_)) | None => (1, None),
        };
        // A pool from before a fork has its threads in the parent process only: it is leaked, not
        // shut down.
        std::mem::forget(pool.made.take());
        pool.made = Some((process, threads, made.clone()));
        (threads, made)
    }

    /// The stack size of a thread in bytes: that which the first thread of a program usually has.
    const STACK: usize = 8 << 20;

    /// The most threads that a pool has.
    const MOST: usize = 256;
}
