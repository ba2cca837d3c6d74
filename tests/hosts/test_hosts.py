"""Hosts of bindings/ that are cheap to try: C++ under the sanitizers, LuaJIT. All of them: `make check-hosts`."""
import shutil
import subprocess

import pytest

import hosts


@pytest.fixture(scope="module", autouse=True)
def scratch(tmp_path_factory):
    hosts.OUT = tmp_path_factory.mktemp("hosts")


# a host that is not installed cannot be tried; .ci/run installs g++ and LuaJIT
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


@pytest.mark.skipif(shutil.which("gcc") is None, reason="gcc is not installed")
def test_the_pdf_writer_of_the_page_has_the_calls_that_the_sheet_makes(tmp_path):
    web = hosts.BINDINGS / "web/src"
    for number, source in enumerate((hosts.ROOT / "lib/paperfile/pdf.c", web / "pdf_page.c")):
        hosts.run("gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{web}", f"-I{hosts.ROOT / 'include'}",
                  f"-I{hosts.ROOT / 'lib'}", "-c", source, "-o", tmp_path / f"{number}.o")
    calls = {name for name in hosts.run("nm", "-u", tmp_path / "0.o").split() if name.startswith("cairo_")}
    assert calls <= set(hosts.run("nm", tmp_path / "1.o").split())
