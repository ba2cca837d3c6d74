#!/usr/bin/env python3
"""panel_names.py: names are for messages: no file that arranges, sews, drapes or fits a garment decides by a name.

In the rooms below the name of a panel, an edge, a pattern or a cloth may only be an argument of a function that writes a
message. A name that is compared, searched, or passed to another function is a fault, and so is a search for a panel or
an edge by name. What a panel is, its label and its sides tell (muslin_pattern(5)). Before it reads lib/, the guard reads
the faults planted below and must find each.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("arrange", "contact", "selfcontact", "sim", "drape", "dress", "fit")
MESSAGES = {"snprintf", "mus__fail", "mus__reason_start_tangled", "mus__diagnosis_set"}
NAME = r"\bmus_(?:pattern|cloth)_(?:(?:panel|edge)_)?name(?=\()|->names?\b"
SEARCH = r"\bmus_pattern_find_(?:panel|edge)(?=\()"
PLANTED = [
    'if (strstr(mus_cloth_panel_name(cloth, p), "sleeve") != NULL)\n',
    "const char *name = mus_pattern_panel_name(pattern, p);\n    if (name[0] == 'f')\n",
    "const char *title = a > b ? mus_cloth_name(cloth) : NULL;\n    look_for(title, &out);\n",
    "if (memcmp(cloth->names, word, 4) == 0)\n",
    'panel = mus_pattern_find_panel(pattern, "front");\n',
]


def plain(text):
    """The text without remarks; texts and letters are empty, and every line is where it was."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match[0]) if match[0][0] == "/" else match[0][0] * 2
    return re.sub(r"/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'", blank, text, flags=re.S)


def call_around(text, at):
    """The function whose argument list, or the keyword whose brackets, `at` stands in; "" outside of brackets."""
    depth = 0
    while at > 0 and (depth > 0 or text[at - 1] not in ";{}"):
        at -= 1
        depth += {")": 1, "]": 1, "(": -1, "[": -1}.get(text[at], 0)
        if depth < 0:
            called = re.search(r"(\w+)\s*$", text[:at])
            if text[at] == "(" and called:
                return called[1]
            depth = 0
    return ""


def faults(text):
    """(position, what) of each use of a name in a function that is no message."""
    for match in re.finditer(SEARCH, text):
        yield match.start(), "searches by name"
    taken = set()
    for match in re.finditer(NAME, text):
        around = call_around(text, match.start())
        if around in MESSAGES:
            continue
        begin = max(text.rfind(mark, 0, match.start()) for mark in ";{}") + 1
        variables = re.findall(r"(\w+)\s*(?<![=!<>])=(?!=)", text[begin:match.start()])
        taken.update(variables)
        if around or not variables:
            yield match.start(), f"uses a name in {around or 'an expression'}"
    for variable in taken:
        for match in re.finditer(rf"(?<![\w.>]){variable}\b(?!\s*=[^=])", text):
            around = call_around(text, match.start())
            if around not in MESSAGES:
                yield match.start(), f"uses the name `{variable}` in {around or 'an expression'}"


def functions(text):
    """(position, text) of each function: from the end of the one before to the brace that closes it."""
    begin = 0
    for end in [*(match.end() for match in re.finditer(r"^}", text, flags=re.M)), len(text)]:
        yield begin, text[begin:end]
        begin = end


def main():
    missed = [text for text in PLANTED if not list(faults(plain(text)))]
    found = [f"the guard does not find the planted fault {text!r}" for text in missed]
    for room in ROOMS:
        for file in sorted((ROOT / "lib" / room).glob("*.[ch]")):
            text = plain(file.read_text())
            for begin, body in functions(text):
                for at, what in sorted(faults(body)):
                    found.append(f"{file.relative_to(ROOT)}:{text.count(chr(10), 0, begin + at) + 1}: {what}")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
