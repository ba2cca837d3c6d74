#!/usr/bin/env python3
"""run.py NAME [ARGUMENT ...]: the script behind `make NAME` for the hosts of bindings/."""
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
SCRIPTS = {
    "wheel": "bindings/python/wheel.py",
    "check-wheel": "tests/hosts/wheel.py",
    "extensions": "bindings/extensions.py",
    "debian": "bindings/packaging/debian.py",
    "check-inkscape": "tests/hosts/inkscape.py",
    "check-blender": "tests/hosts/blender.py",
    "check-agent": "tests/hosts/agent.py",
    "check-cluster": "tests/hosts/cluster.py",
    "web": "bindings/web/build.py",
    "web-serve": "bindings/web/serve.py",
    "check-web": "tests/hosts/web.py",
    "check-hosts": "tests/hosts/hosts.py",
}

if __name__ == "__main__":
    os.execv(sys.executable, [sys.executable, str(ROOT / SCRIPTS[sys.argv[1]]), *sys.argv[2:]])
