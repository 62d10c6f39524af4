"""What a script did."""

from __future__ import annotations

from typing import NamedTuple


class Count(NamedTuple):
    """What became of the calls of an operation: how many were applied, and the refused by reason."""

    applied: int
    refused: dict

    def __repr__(self):
        return f"Count(applied={self.applied}, refused={self.refused})"


class Report(dict):
    """What a script did: a :class:`Count` for each operation that it may call, by name."""

    def __init__(self, ops=()):
        super().__init__({name: Count(*count) for name, count in dict(ops).items()})

    @property
    def applied(self):
        """How many calls of operations were applied."""
        return sum(count.applied for count in self.values())

    @property
    def refused(self):
        """How many calls of operations were refused."""
        return sum(sum(count.refused.values()) for count in self.values())

    def __str__(self):
        names = max([2, *map(len, self)])
        lines = [f"{'op':{names}}  applied  refused"]
        for name, count in self.items():
            lines.append(f"{name:{names}}  {count.applied:7}  {sum(count.refused.values()):7}")
            lines += [f"{'':{names}}  {'':7}  {n:7}  {why}" for why, n in count.refused.items()]
        return "\n".join(lines)

    def __repr__(self):
        return f"Report({dict.__repr__(self)})"
