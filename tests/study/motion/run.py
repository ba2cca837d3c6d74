#!/usr/bin/env python3
"""Garments on a body that moves: every named pose, and a walk of 240 frames.

For each garment and pose or movement `muslin dress` runs once; a row says how deep the deepest node of any frame was
below the skin, how far a node went between two frames at most, how far the garment slid along the body, and whether
a step was refused. A row holds when nothing is deeper than 2 mm, no node jumps 50 mm (at 60 frames a second, a swinging
knee itself goes 25), the middle of the cloth has slid less than 60 mm in a walk, and every step was made. Whether the
cloth came to rest in a pose is told, and is not part of that. --film leaves pictures and an animated .glb of a walk.
With --mesh and --tape a scanned body takes the poses and walks.
"""
import argparse
import json
import pathlib
import subprocess
import sys

DEPTH_MM, JUMP_MM, SLID_MM = 2.0, 50.0, 60.0


def dress(command, folder, *arguments):
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    done = subprocess.run([command, "dress", *map(str, arguments), "--report", report, "--quiet"], capture_output=True)
    if not report.exists():
        return None, done.stderr.decode().strip()
    return json.loads(report.read_text()), done.stderr.decode().strip()


def row(name, moves, report, said, frames):
    """One line, and whether it holds."""
    if report is None or "motion" not in report:
        print(f"{name:44} no report: {said}")
        return False
    motion = report["motion"]
    depth = max(report["max_penetration_mm"], motion["max_penetration_mm"])
    whole = motion["frames"] == frames if moves else report["status"] in ("settled", "not settled")
    jump = motion["max_jump_mm"] < JUMP_MM
    slid = not moves or abs(motion["slid_mm"]) < SLID_MM
    holds = whole and jump and slid and depth < DEPTH_MM
    print(f"{name:44} {report['status']:12} depth {depth:5.2f} mm  jump {motion['max_jump_mm']:5.1f} mm  "
          f"slid {motion['slid_mm']:6.1f} mm  parts {motion['step_parts']}  steps {motion['steps']:6d}  "
          f"{motion['seconds']:6.1f} s  {'yes' if holds else 'NO'}{'' if whole else '  ' + said}", flush=True)
    return holds


def main():
    parse = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parse.add_argument("--command", required=True)
    parse.add_argument("--out", required=True, type=pathlib.Path)
    parse.add_argument("--garments", default="tshirt,skirt")
    parse.add_argument("--size", default="W40")
    parse.add_argument("--mesh", help="the body is this scan, in place of that of the size; wants --tape")
    parse.add_argument("--tape", help="the sheet that garments are drafted by, in place of the size")
    parse.add_argument("--spacing", default="10")
    parse.add_argument("--poses", help="names in place of all")
    parse.add_argument("--moves", default="walk")
    parse.add_argument("--count", type=int, default=240)
    parse.add_argument("--film", action="store_true", help="pictures and an animated .glb of each movement")
    own = parse.parse_args()
    own.out.mkdir(parents=True, exist_ok=True)
    listed = subprocess.run([own.command, "body", "--poses"], capture_output=True, check=True).stdout.decode()
    names = [line.split() for line in listed.splitlines()]
    poses = own.poses.split(",") if own.poses is not None else [name for kind, name in names if kind == "pose"]
    passed = failed = 0
    for garment in own.garments.split(","):
        sheet = ["--tape", own.tape] if own.tape else ["--size", own.size]
        what = ["--design", garment, *sheet, *(["--mesh", own.mesh] if own.mesh else []), "--spacing", own.spacing]
        for pose in filter(None, poses):
            holds = row(f"{garment} {pose}", False, *dress(own.command, own.out, *what, "--pose", pose), 0)
            passed, failed = passed + holds, failed + (not holds)
        for move in filter(None, own.moves.split(",")):
            film = []
            if own.film:
                frames = own.out / f"{garment}_{move}"
                frames.mkdir(exist_ok=True)
                film = ["--frames", frames, "--glb", own.out / f"{garment}_{move}.glb", "--pixels", "900x900"]
            holds = row(f"{garment} {move}", True,
                        *dress(own.command, own.out, *what, "--move", move, "--count", own.count, *film), own.count)
            passed, failed = passed + holds, failed + (not holds)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
