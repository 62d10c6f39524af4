"""The stubs say what there is."""

import ast
from pathlib import Path

import pytest

import hedgerow

STUBS = ast.parse(Path(hedgerow.__file__).with_suffix(".pyi").read_text())
CLASSES = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}


def names(body):
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, ast.ImportFrom):
            yield from (alias.asname or alias.name for alias in node.names)


def public(thing):
    return {name for name in dir(thing) if not name.startswith("_")}


def test_the_module():
    assert set(hedgerow.__all__) <= set(names(STUBS.body))


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_a_class(name):
    told = {one for one in names(CLASSES[name].body) if not one.startswith("_")}
    there = getattr(hedgerow, name)
    of_tables = {"next", "prev", "twin", "vertex", "edge", "face", "halfedge"}
    inherited = public(dict) if issubclass(there, dict) else public(tuple) if issubclass(there, tuple) else set()
    of_instances = set(getattr(there, "__init__").__code__.co_names) if hasattr(there.__init__, "__code__") else set()
    assert told - of_tables - of_instances <= public(there), told - public(there)
    assert public(there) - inherited <= told, public(there) - inherited - told
