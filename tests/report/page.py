"""page.py: the readable page: what was found in sentences with their figures, pictures, what was left out."""
import plots
import runs


def write(into, jobs, claims, machine, swing, quick):
    """REPORT.md and its pictures."""
    pictures(into, jobs)
    parts = [head(machine, swing, quick), conclusions(jobs), time_part(jobs), mesh_part(jobs), checks(claims)]
    (into / "REPORT.md").write_text("\n".join(parts))


def pictures(into, jobs):
    plots.work_precision(into / "strip.png", jobs["strip"], "Hanging strip, 16 cells, 0.1 s of bobbing")
    plots.work_precision(into / "sheet.png", jobs["sheet"], "Stretched sheet, 51 x 51 nodes, 0.1 s")
    plots.orders(into / "order.png", [("strip", jobs["strip"]), ("sheet", jobs["sheet"])])


# ---- text ----

def table(heads, lines):
    """A table of Markdown."""
    out = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(out + ["| " + " | ".join(str(cell) for cell in line) + " |" for line in lines]) + "\n"


def head(machine, swing, quick):
    return f"""# Error against run time{', the quick variant' if quick else ''}

Made by `make report{' QUICK=1' if quick else ''}`; all numbers are in [report.csv](report.csv).
Machine: {machine['processor']}, {machine['cores']} cores ({machine['caches']}), {machine['system']}.
Compiler: {machine['compiler']}; flags: {machine['flags']}; commit {machine['commit']}; {machine['python']}.
Seconds are CPU seconds of the process, medians of repeats where a run is cheap; the same loop took {100 * swing:.1f} % more
or less time at the end of the report than at its start.

Three errors are kept apart. *Time error*: same mesh, against a reference with steps so small that they do not matter.
*Mesh error*: against the answer without a mesh, or by Richardson's extrapolation. *Model error*: against measured cloth.
"""


def _of(rows, **wanted):
    return [r for r in rows if all(r.get(k) == v for k, v in wanted.items()) and r["status"] == "ok"]


def _least_error(rows):
    return min(r["error_mm"] for r in rows)


def conclusions(jobs):
    sheet = jobs["sheet"]
    floor = max(r["floor_mm"] for r in sheet)
    rk4, _ = runs.order_of(sheet, floor, "rk4")
    verlet, _ = runs.order_of(sheet, floor, "verlet")
    single = _least_error(_of(sheet, precision=32, variant="mus_drape_step"))
    return f"""## What to conclude

1. In smooth motion RK4 is of order {rk4:.2f} and Verlet of order {verlet:.2f}.
2. Float ends at {single:.1e} mm on the sheet.
"""


def time_part(jobs):
    strip, sheet = (max(r["floor_mm"] for r in jobs[name]) for name in ("strip", "sheet"))
    return f"""## Time error

Two references: numpy's own springs and Runge-Kutta (another program) or the closed form, and the library in double, at
1/64 of the largest step. They agree to {strip:.1e} mm (strip) and {sheet:.1e} mm (sheet): the grey bands.

![strip](strip.png)

![sheet](sheet.png)

![order](order.png)
"""


def mesh_part(jobs):
    rows = [(r["scene"], r["quantity"], f"{r['spacing_mm']:g}", r["nodes"], f"{r['error_mm']:.2e}")
            for name in ("strip_mesh", "sheet_mesh") for r in jobs[name]]
    return "## Mesh error\n\n" + table(("scene", "quantity", "spacing [mm]", "nodes", "error [mm]"), rows)


def checks(claims):
    return "## What the report checks of itself\n\n" + "".join(
        f"- {'holds' if holds else '**does not hold**'}: {sentence}\n" for sentence, holds in claims)
