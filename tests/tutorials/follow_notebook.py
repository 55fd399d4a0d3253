"""Runs the code cells of a notebook in their order, in one namespace, and compares what they print with what is stored.

usage: follow_notebook.py NOTEBOOK [--store]

`--store` writes what the cells print and draw into the notebook instead. Jupyter is not needed.
"""

import base64
import contextlib
import io
import json
import os
import sys
import traceback


def run(code, number, names):
    """What a cell prints; ends the program if it fails."""
    printed = io.StringIO()
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(code, f"<cell {number}>", "exec"), names)
    except Exception:
        sys.exit(f"cell {number} failed\n{printed.getvalue()}{traceback.format_exc()}")
    return printed.getvalue()


def drawings(names):
    """The figures that a cell has left open, as PNG; they are closed."""
    plt = names.get("plt")
    pictures = []
    for figure in map(plt.figure, plt.get_fignums()) if plt else ():
        picture = io.BytesIO()
        figure.savefig(picture, format="png", dpi=100, metadata={"Software": None})
        pictures.append(base64.b64encode(picture.getvalue()).decode())
        plt.close(figure)
    return pictures


def outputs_of(printed, pictures):
    outputs = [{"name": "stdout", "output_type": "stream", "text": printed.splitlines(True)}] if printed else []
    return outputs + [{"data": {"image/png": picture}, "metadata": {}, "output_type": "display_data"}
                      for picture in pictures]


def text_of(outputs):
    return "".join("".join(output["text"]) for output in outputs if output["output_type"] == "stream")


def follow(path, store):
    with open(path, encoding="utf-8") as file:
        notebook = json.load(file)
    names, runs = {"__name__": "__main__"}, 0
    for number, cell in enumerate(notebook["cells"], 1):
        if cell["cell_type"] != "code":
            continue
        printed, runs = run("".join(cell["source"]), number, names), runs + 1
        outputs = outputs_of(printed, drawings(names))
        if store:
            cell["outputs"], cell["execution_count"] = outputs, runs
        elif printed != text_of(cell["outputs"]):
            sys.exit(f"cell {number} printed something else than is stored:\n{printed}")
        elif len(outputs) != len(cell["outputs"]):
            sys.exit(f"cell {number} drew something else than is stored")
    if runs == 0:
        sys.exit(f"{path}: has no code")
    if store:
        with open(path, "w", encoding="utf-8") as file:
            json.dump(notebook, file, indent=1, ensure_ascii=False)
            file.write("\n")
    print(f"{path}: {runs} cells of code")


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    follow(os.path.abspath(sys.argv[1]), "--store" in sys.argv[2:])
