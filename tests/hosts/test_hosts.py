"""Hosts of bindings/ that are cheap to try: C++ under the sanitizers, LuaJIT. All of them: `make check-hosts`."""
import shutil
import subprocess

import pytest

import hosts


@pytest.fixture(scope="module", autouse=True)
def scratch(tmp_path_factory):
    hosts.OUT = tmp_path_factory.mktemp("hosts")


@pytest.mark.skipif(shutil.which("g++") is None, reason="g++ is not installed")
def test_handles_of_cpp_move_throw_and_leak_nothing(command):
    program = hosts.compiled("g++", hosts.ROOT / "tests/hosts/handles.cpp", *hosts.SANITIZE)
    assert len(hosts.run(program)) == 16


def test_the_header_of_cpp_is_short():
    assert (hosts.BINDINGS / "cpp/muslin.hpp").read_text().count("\n") <= 300


@pytest.mark.skipif(shutil.which("luajit") is None, reason="luajit is not installed")
def test_luajit_dresses_as_the_command():
    assert hosts.lua() == hosts.by_command()


@pytest.mark.skipif(shutil.which("luajit") is None, reason="luajit is not installed")
def test_luajit_raises_frees_and_calls_back(tmp_path):
    hosts.run("luajit", hosts.ROOT / "tests/hosts/objects.lua", hosts.BINDINGS / "lua/?.lua", tmp_path / "p.json")
