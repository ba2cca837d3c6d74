#!/usr/bin/env python3
"""hosts.py [HOST...]: the example of each host of bindings/ dresses a T-shirt to the state hash of the command.

One line a host: its hash and whether it is the command's, or what the machine lacks. Exit 1 when a hash differs. The
programs and the library are those of MUSLIN_BIN and MUSLIN_LIB, or of the build folder MUSLIN_OUT (build), where hosts/
takes what is built here. `julia-chroot` is tried when it is named: it makes a Debian 11 (root, some minutes).
"""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINDINGS = ROOT / "bindings"
sys.path.append(str(BINDINGS))
import fetch  # noqa: E402, F401: used by the scripts beside this one

BUILD = pathlib.Path(os.environ.get("MUSLIN_OUT", ROOT / "build")).resolve()
BIN = pathlib.Path(os.environ.get("MUSLIN_BIN", BUILD / "bin")).resolve()
LIB = pathlib.Path(os.environ.get("MUSLIN_LIB", BUILD / "lib/libmuslin.so")).resolve()
OUT = BUILD / "hosts"
SCENE = ("tshirt", "W40", "30")  # design, table size, spacing [mm]
STRICT = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wsign-conversion", "-Werror"]
BUILT_BY = ["gcc", "libc6-dev", "make", "pkg-config", "python3", "libcairo2-dev", "libpango1.0-dev",
            "libjansson-dev", "libyaml-dev", "libexpat1-dev", "libsqlite3-dev"]
SANITIZE = ["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=undefined"]


class Skipped(Exception):
    """What the machine lacks."""


def need(*programs):
    """The path of each program."""
    paths = [shutil.which(program) for program in programs]
    if None in paths:
        raise Skipped(f"{programs[paths.index(None)]} is not installed")
    return paths


def run(*command, cwd=None, **environment):
    """What a command prints, less the blanks round it; RuntimeError with its words when it fails."""
    done = subprocess.run(list(map(str, command)), cwd=cwd, capture_output=True, text=True, timeout=500,
                          env={**os.environ, "MUSLIN_LIB": str(LIB), **environment})
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr or done.stdout}")
    return done.stdout.strip()


def by_command():
    """The hash that every host must print."""
    design, size, spacing = SCENE
    report = run(BIN / "muslin", "dress", "--design", design, "--size", size, "--spacing", spacing, "--json")
    return json.loads(report)["state_hash"]


def compiled(compiler, source, *flags):
    """A C++ program of a source and muslin.hpp, laid out as an installation has it."""
    headers = OUT / "include/muslin"
    headers.mkdir(parents=True, exist_ok=True)
    shutil.copy(BINDINGS / "cpp/muslin.hpp", headers)
    program = OUT / f"{source.stem}-{pathlib.Path(compiler).name}{'-asan' if flags else ''}"
    run(compiler, *STRICT, *flags, f"-I{headers.parent}", f"-I{ROOT / 'include'}", source, f"-L{LIB.parent}",
        "-lmuslin", f"-Wl,-rpath,{LIB.parent}", "-o", program)
    return program


def cpp(name):
    compiler, = need(name)
    return run(compiled(compiler, BINDINGS / "cpp/tshirt.cpp"), *SCENE)


def cpp_asan():
    compiler, = need("g++")
    return run(compiled(compiler, BINDINGS / "cpp/tshirt.cpp", *SANITIZE), *SCENE)


def lua():
    luajit, = need("luajit")
    return run(luajit, BINDINGS / "lua/tshirt.lua", *SCENE)


def ctypes():
    program = "import sys, muslin; d, s, mm = sys.argv[1:]; " \
              "print(muslin.dress(d, muslin.Tape.size(s), spacing=0.001 * float(mm)).drape.state_hash)"
    return run(sys.executable, "-c", program, *SCENE, PYTHONPATH=str(BINDINGS / "python"))


def cffi():
    if importlib.util.find_spec("cffi") is None:
        raise Skipped("the Python package cffi is not installed")
    design, size, spacing = SCENE
    return run(sys.executable, ROOT / "tests/abi/dress_cffi.py", BINDINGS / "abi/muslin_flat.h", LIB, design, size,
               0.001 * float(spacing))


def node():
    program, npm = need("node", "npm")
    package = OUT / "node"
    shutil.copytree(BINDINGS / "node", package, dirs_exist_ok=True, ignore=shutil.ignore_patterns("node_modules"))
    if not (package / "node_modules/typescript").exists():
        try:
            run(npm, "install", "--no-audit", "--no-fund", cwd=package)
        except RuntimeError as error:
            raise Skipped("npm could not install koffi and typescript") from error
    here = {"MUSLIN_ABI_JSON": str(BINDINGS / "abi/muslin_abi.json")}
    (package / "index.d.ts").write_text(run(program, package / "types.js", **here))
    shutil.copy(ROOT / "tests/hosts/types.ts", package)
    run(program, "node_modules/typescript/bin/tsc", "--noEmit", "--strict", "--target", "es2022", "--module",
        "nodenext", "--types", "node", "types.ts", cwd=package)
    run(program, "--expose-gc", ROOT / "tests/hosts/objects.mjs", package / "index.js", **here)
    return run(program, package / "tshirt.js", *SCENE, **here)


def rust(example):
    cargo, = need("cargo")
    where = {"CARGO_TARGET_DIR": str(OUT / "rust"), "MUSLIN_LIB_DIR": str(LIB.parent), "MUSLIN_STATIC": "1"}
    if example == "tshirt":
        run(cargo, "test", "-q", "--offline", "--locked", cwd=BINDINGS / "rust", **where)
    return run(cargo, "run", "-q", "--offline", "--locked", "--example", example, "--", *SCENE, cwd=BINDINGS / "rust",
               **where)


def julia():
    program, = need("julia")
    project = f"--project={BINDINGS / 'julia'}"
    try:
        run(program, project, "-e", "using Pkg; Pkg.instantiate()")
    except RuntimeError as error:
        raise Skipped("Pkg could not install JSON") from error
    return run(program, project, BINDINGS / "julia/tshirt.jl", *SCENE)


def julia_chroot():
    """Julia of Debian 11, the last Debian that has it, in a system of its own: the library is built there, and JSON is
    tests/hosts/julia/JSON.jl, because nothing can be fetched there."""
    mmdebstrap, _ = need("mmdebstrap", "unshare")
    system = OUT / "julia"
    tree = system / "muslin"
    if not (system / "usr/bin/julia").exists():
        run(mmdebstrap, "--variant=apt", f"--include={','.join(BUILT_BY)},julia", "bullseye", system)
    shutil.copytree(ROOT, tree, dirs_exist_ok=True, ignore=shutil.ignore_patterns("build", ".git"))
    run("chroot", system, "make", "-s", "-C", "/muslin", f"-j{os.cpu_count()}", "lib")
    with_proc = 'mount -t proc proc "$1/proc" && exec chroot "$@"'  # Julia wants /proc; the mount ends with the command
    return run("unshare", "--mount", "sh", "-c", with_proc, "sh", system, "julia", "/muslin/bindings/julia/tshirt.jl",
               *SCENE, MUSLIN_LIB="/muslin/build/lib",
               JULIA_LOAD_PATH="/muslin/bindings/julia/src:/muslin/tests/hosts/julia:@stdlib")


HOSTS = {"g++": lambda: cpp("g++"), "clang++": lambda: cpp("clang++"), "g++ with ASan and UBSan": cpp_asan,
         "luajit": lua, "python (ctypes)": ctypes, "python (cffi)": cffi, "node": node,
         "cargo": lambda: rust("tshirt"), "cargo (muslin-sys)": lambda: rust("tshirt_sys"), "julia": julia}
WHEN_ASKED = {"julia-chroot": julia_chroot}


def main():
    asked = sys.argv[1:] or HOSTS
    want = by_command()
    OUT.mkdir(parents=True, exist_ok=True)
    counts = {"equal": 0, "skipped": 0, "failed": 0}
    print(f"{'the command':24} {want}")
    for host in asked:
        try:
            got = {**HOSTS, **WHEN_ASKED}[host]()
            end = "equal" if got == want else "failed"
            print(f"{host:24} {got} {'equal' if end == 'equal' else 'DIFFERS'}", flush=True)
        except Skipped as lack:
            end = "skipped"
            print(f"{host:24} skipped: {lack}", flush=True)
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            end = "failed"
            print(f"{host:24} FAILED: {error}", flush=True)
        counts[end] += 1
    print(f"{counts['equal']} passed, {counts['failed']} failed, {counts['skipped']} skipped")
    return 1 if counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
