#!/usr/bin/env python3
"""agent.py: the tools of muslin.agent, called by the official client of the protocol over standard input and output.

Ten calls go from a tape to a PDF; then file names that lead out of the folder are tried. One line a call; exit 1 when a
claim does not hold. Runs itself in an environment with the packages mcp and numpy, made in MUSLIN_OUT/hosts/agent.
"""
import asyncio
import json
import os
import pathlib
import sys
import tempfile
import time
import venv

import hosts

HOME = hosts.OUT / "agent"
HOSTILE = ["../secret.json", "/etc/passwd", "..", ".", "", "a/b.json", "link.json", ".hidden.json", "folder.json",
           "..\\secret.json", "secret.json\0.json", "~/x.json", "file:///etc/passwd.json", "secret.tape"]


async def ask(client, tool, **arguments):
    """(answer as a value, bytes of all texts, images) of a call; RuntimeError with the words of a refusal."""
    result = await client.call_tool(tool, arguments)
    texts = [part.text for part in result.content if part.type == "text"]
    if result.is_error:
        raise RuntimeError(" ".join(texts))
    images = [part for part in result.content if part.type == "image"]
    return json.loads(texts[0]), sum(map(len, texts)), images


async def way(client, folder):
    """From the tape to the paper in ten calls."""
    calls = [("make_tape", {"file": "ada.tape", "measures": {"stature": "171 cm", "bust": "94 cm", "waist": "75 cm",
                                                             "hip": "101 cm"}}),
             ("body", {"wearer": "ada.tape"}), ("designs", {"words": "skirt", "most": 5}),
             ("draft", {"what": "skirt", "wearer": "ada.tape", "file": "skirt.json"}),
             ("describe", {"file": "skirt.json"}),
             ("edit", {"file": "skirt.json", "operation": "lengthen", "save_as": "long.json",
                       "arguments": {"panel": 0, "point": [0, 0.1], "direction": [1, 0], "amount": 0.0}}),
             ("dress", {"file": "long.json", "wearer": "ada.tape", "fabric": "denim", "spacing_mm": 25}),
             ("dress", {"file": "long.json", "wearer": "W46", "spacing_mm": 30, "yaw": 180}),
             ("fit", {"file": "long.json"}), ("print_pattern", {"file": "long.json", "pdf": "long.pdf"})]
    for tool, arguments in calls:
        start = time.time()
        answer, length, images = await ask(client, tool, **arguments)
        shown = "".join(f", picture of {len(image.data) * 3 // 4} bytes" for image in images)
        print(f"ok   {tool}: {length} bytes{shown}, {time.time() - start:.2f} s: {json.dumps(answer)[:80]}", flush=True)
        assert length < 6000 and (tool not in ("body", "dress") or len(images) == 1), (tool, length)
        assert tool != "dress" or answer["status"] == "MUS_OK", answer
    assert (folder / "long.pdf").read_bytes().startswith(b"%PDF")


async def refused(client, folder):
    """How many hostile calls were refused, and no file came to be outside."""
    before, count = sorted(folder.parent.rglob("*")), 0
    for name in HOSTILE:
        for tool, arguments in (("describe", {"file": name}), ("body", {"wearer": name}),
                                ("draft", {"what": "skirt", "wearer": "W40", "file": name}),
                                ("draft", {"what": "skirt", "wearer": name, "file": "x.json"}),
                                ("make_tape", {"file": name, "measures": {}, "size": "W40"}),
                                ("print_pattern", {"file": "long.json", "pdf": name}),
                                ("edit", {"file": "long.json", "operation": "merge_edges", "arguments": {"edge": 0},
                                          "save_as": name})):
            if tool == "make_tape" and name == "secret.tape":
                continue  # a plain name: this one may be written
            try:
                await ask(client, tool, **arguments)
            except RuntimeError as error:
                assert "treasure" not in str(error) and "root:" not in str(error), error
                assert any(word in str(error) for word in ("plain file name", "not a file of", "there is no")), error
                count += 1
            else:
                raise AssertionError(f"{tool} took {arguments}")
    for operation in ("write", "close", "__init__", "context", "join"):
        try:
            await ask(client, "edit", file="long.json", operation=operation, arguments={}, save_as="x.json")
        except RuntimeError:
            count += 1
        else:
            raise AssertionError(f"edit took {operation}")
    assert sorted(folder.parent.rglob("*")) == before, "a file came to be"
    print(f"ok   {count} hostile calls refused")


async def main():
    from mcp import Client, StdioServerParameters
    with tempfile.TemporaryDirectory() as name:
        outer = pathlib.Path(name).resolve()
        folder = outer / "given"
        (folder / "folder.json").mkdir(parents=True)
        (outer / "secret.json").write_text("treasure")
        (folder / "link.json").symlink_to(outer / "secret.json")
        server = StdioServerParameters(command=sys.executable, args=["-m", "muslin.agent", str(folder)],
                                       env={"PYTHONPATH": str(hosts.BINDINGS / "python"), "MUSLIN_LIB": str(hosts.LIB)})
        async with Client(server) as client:
            await way(client, folder)
            await refused(client, folder)


if __name__ == "__main__":
    python = HOME / "bin/python"
    if pathlib.Path(sys.prefix) != HOME:
        if not python.exists():
            venv.create(HOME, with_pip=True)
            hosts.fetch.install(python, "-m", "pip", "install", "-q", "mcp>=2", "numpy", made=HOME)
        os.execv(python, [str(python), __file__])
    asyncio.run(main())
