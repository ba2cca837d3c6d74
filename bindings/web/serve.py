#!/usr/bin/env python3
"""serve.py [PORT]: show MUSLIN_OUT/web on this machine (make web-serve)."""
import functools
import http.server
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ.get("MUSLIN_OUT", ROOT / "build")).resolve() / "web"


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".js": "text/javascript",
                      ".wasm": "application/wasm", ".webmanifest": "application/manifest+json"}

    def log_message(self, *_):
        pass


def server(port=0):
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), functools.partial(Handler, directory=str(FOLDER)))


if __name__ == "__main__":
    if not (FOLDER / "index.html").exists():
        sys.exit(f"serve.py: {FOLDER} is not built; make web")
    made = server(int(sys.argv[1]) if len(sys.argv) > 1 else 8765)
    print(f"http://127.0.0.1:{made.server_address[1]}/ shows {FOLDER}; Ctrl-C ends it", flush=True)
    try:
        made.serve_forever()
    except KeyboardInterrupt:
        pass
