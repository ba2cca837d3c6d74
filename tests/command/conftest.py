"""What the tests of the command share: one line on standard error, a locale with a decimal comma, drafted patterns."""
import os
import pathlib
import shutil
import subprocess

import pytest


def comma_environment(folder):
    """Environment of a locale whose decimal point is a comma, installed or made in `folder`, or None."""
    places = [os.environ.get("LOCPATH"), str(folder)] if shutil.which("localedef") else [os.environ.get("LOCPATH")]
    for place in places:
        if place == str(folder):
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], capture_output=True)
        for name in ("de_DE.UTF-8", "fr_FR.UTF-8"):
            # numbers alone: the language of what the command prints is that of messages
            environment = {**os.environ, "LC_ALL": "", "LANG": "C", "LC_MESSAGES": "C", "LC_NUMERIC": name}
            if place:
                environment["LOCPATH"] = place
            done = subprocess.run(["locale", "decimal_point"], capture_output=True, text=True, env=environment)
            if done.stdout.strip() == ",":
                return environment
    return None


@pytest.fixture(scope="session")
def comma(tmp_path_factory):
    """Options for a run under a decimal comma."""
    environment = comma_environment(tmp_path_factory.mktemp("locale"))
    if environment is None:
        # a bare image ships neither such a locale nor its sources, and the claim is about that locale only
        pytest.skip("no locale with a decimal comma, and no localedef that makes one")
    return {"env": environment}


@pytest.fixture(scope="session")
def one_line():
    """The text of a failed run: nothing on standard output, one line on standard error that names the command."""
    def text(done):
        said = done.stderr.decode()
        assert done.stdout == b""
        assert said.startswith("muslin") and said.count("\n") == 1 and said.endswith("\n"), said
        assert len(said) < 600, said
        return said
    return text


@pytest.fixture(scope="session")
def program(root):
    """Path of the command, for tests that run it in a way of their own."""
    return pathlib.Path(os.environ.get("MUSLIN_BIN", root / "build" / "bin")) / "muslin"


@pytest.fixture(scope="session")
def tape(root):
    return root / "examples" / "tapes" / "w40.tape"


@pytest.fixture(scope="session")
def patterns(tmp_path_factory, command, tape):
    """Drafted patterns as muslin JSON, by the name of their design."""
    folder, made = tmp_path_factory.mktemp("patterns"), {}

    def draft(design):
        if design not in made:
            made[design] = folder / f"{design}.json"
            command("draft", "--design", design, "--tape", tape, "-o", made[design])
        return made[design]
    return draft
