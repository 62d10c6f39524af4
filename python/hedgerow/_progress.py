"""How far a script is."""

from __future__ import annotations


class _Bar:
    """A bar of tqdm that follows the outermost loop."""

    def __init__(self, make, name):
        self._bar = make(desc=name, leave=False)

    def __call__(self, done, total):
        if total is not None:
            self._bar.total = total
        self._bar.n = done
        self._bar.refresh()

    def close(self):
        self._bar.close()


def progress(wanted, name):
    """What is told how far the outermost loop is: ``True`` is a bar of tqdm, and so is the class
    ``tqdm`` itself; else it is called with the turns done, and how many there are or ``None``."""
    if wanted is False:
        return None
    if wanted is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            raise ImportError(
                "`progress=True` shows a bar of tqdm: pip install tqdm, "
                "or give a function of (done, total)"
            ) from None
        return _Bar(tqdm, name)
    if isinstance(wanted, type) and hasattr(wanted, "update"):
        return _Bar(wanted, name)
    if callable(wanted):
        return wanted
    raise TypeError("`progress` wants True, tqdm, or a function of (done, total)")
