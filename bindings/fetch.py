"""fetch.py: packages of pip and npm for the commands of the hosts; a failure is one sentence."""
import pathlib
import shutil
import subprocess
import sys


def install(*command, cwd=None, made=None):
    """Run an installer. When it fails, remove the folder `made`, so that the next run begins anew, and exit 1."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True)
    if done.returncode == 0:
        return
    if made is not None:
        shutil.rmtree(made, ignore_errors=True)
    told = [line.strip() for line in (done.stderr + done.stdout).splitlines() if "error" in line.lower()]
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: packages could not be fetched, which needs the network "
             f"({pathlib.Path(words[0]).name} {' '.join(words[1:])}): {told[0] if told else done.returncode}")
