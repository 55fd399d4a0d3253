#!/usr/bin/env python3
"""Writes live.html: one file with the engine, its workers, the style and the scripts, whose policy allows nothing else.

usage: assemble.py SOURCES MODULES VERSION REVISION LIVE.html
"""

import base64
import gzip
import hashlib
import pathlib
import re
import sys

MOST_BYTES = 900_000


def policy_hash(text):
    """Source expression of a content-security policy for a script or style with this text."""
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def main(sources, modules, version, revision, into):
    sources = pathlib.Path(sources)

    def text(*names):
        return "".join((sources / name).read_text() for name in names)

    def packed(name):
        module = (pathlib.Path(modules) / f"{name}.wasm").read_bytes()
        return base64.b64encode(gzip.compress(module, 9, mtime=0)).decode()

    style = text("analysis/page/page.css", "lib/live/live.css")
    script = text("analysis/page/shapes.js", "analysis/page/animation.js", "lib/live/live.js")
    parts = {
        "policy": f"default-src 'none'; style-src {policy_hash(style)}; script-src {policy_hash(script)} 'wasm-unsafe-eval'; "
        "worker-src blob:; img-src data:; base-uri 'none'; form-action 'none'",
        "style": style,
        "script": script,
        "worker": text("lib/live/engine.js", "lib/live/worker.js"),
        "engine": packed("rocking"),
        "fused": packed("fused"),
        "fusedrelaxed": packed("fused_relaxed"),
        "version": version,
        "revision": revision,
    }
    page = re.sub("@([a-z]+)@", lambda found: parts[found[1]], text("lib/live/live.html"))
    pathlib.Path(into).write_text(page)
    size = len(page.encode())
    print(f"{into}: {size} bytes")
    if size > MOST_BYTES:
        sys.exit(f"{into} has more than {MOST_BYTES} bytes")


if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
