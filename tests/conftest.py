"""What the Python tests share: where the programs, the data and the package are."""
import os
import subprocess
import sys

import pytest

from places import BIN, DATA, ROOT

os.environ["LC_ALL"] = "C.UTF-8"  # the command speaks the language of the environment, the tests read English
sys.path.insert(0, str(ROOT / "bindings" / "python"))


@pytest.fixture(scope="session")
def root():
    """The repository."""
    return ROOT


@pytest.fixture(scope="session")
def command():
    """Run the command: command("draft", "--tape", path, ...) gives the finished process; `code` is what it must end
    with (None: any)."""
    def run(*arguments, code=0, **options):
        done = subprocess.run([str(BIN / "muslin"), *map(str, arguments)], capture_output=True, timeout=300, **options)
        if code is not None:
            assert done.returncode == code, done.stderr.decode("utf-8", "replace")
        return done
    return run


@pytest.fixture(scope="session")
def data():
    """Path of a file of the real data; the test is skipped, with the path, where it is not there."""
    def path(relative):
        if not (DATA / relative).exists():
            pytest.skip(f"no {DATA / relative} (set MUSLIN_DATA)")  # real data lies outside the repository
        return DATA / relative
    return path


@pytest.fixture
def timeless():
    """A report of `muslin dress` without the time that it took: what is the same in each run."""
    def without(report):
        starts = [{name: value for name, value in start.items() if name != "seconds"} for start in report["starts"]]
        return {**{name: value for name, value in report.items() if name != "seconds"}, "starts": starts}
    return without
