"""The notebook runs, and has no outputs where it is kept."""

import pathlib

import pytest

NOTEBOOK = pathlib.Path(__file__).parents[2] / "examples" / "python" / "first_hour.ipynb"
if not NOTEBOOK.is_file():
    pytest.skip("the examples are not here", allow_module_level=True)
nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")


def test_it_runs(monkeypatch):
    monkeypatch.delenv("MPLBACKEND", raising=False)
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    kinds = {kind for output in shown for kind in output.get("data", {})}
    # The operation as a picture, and the lengths of edges.
    assert {"image/svg+xml", "image/png"} <= kinds
    text = "".join(output.get("text", "") for output in shown)
    assert "error[" in text and "Refused(" in text and "collapse" in text


def test_it_is_kept_without_outputs():
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    assert not any(cell.get("outputs") or cell.get("execution_count") for cell in notebook.cells)
