"""energy.py: what each step does to energy and momentum of cloth that nothing damps, over seconds.

The energy is the library's own report of it (kinetic, elastic, of gravity; a second program agrees with it, `muslin
verify`). Without damping and without contact nothing changes it, and nothing changes the momentum of a sheet that
nothing holds: what changes is the step's error, told as a share of the largest kinetic energy, and of m |v|.
"""
import numpy as np

import measure
import muslin
import scene_cantilever
import scene_fall
import scene_sheet
import scene_strip

SHARES = (0.99, 0.5, 0.25, 0.125)


def scenes(sheet_cells):
    """{name: trial} of the scenes with an answer; the sheet coarser than in its time error."""
    strip, _ = scene_strip.trial(16)
    return {"strip": strip, "fall": scene_fall.trial(), "cantilever": scene_cantilever.trial(10),
            "sheet": scene_sheet.sheet(sheet_cells, scene_sheet.bump, scene_sheet.BUMP)}


def drift(seconds=10.0, sheet_cells=16, looks=200, shares=SHARES):
    """Energy at the end and the greatest on the way, for each scene, stepper and share of the bound."""
    rows = []
    for name, trial in scenes(sheet_cells).items():
        for integrator in ("rk4", "verlet"):
            for precision, of in ((64, shares), (32, shares[:1])):
                for share in of:
                    rows.append(one(name, trial, integrator, precision, share, seconds, looks))
    return rows + [momentum(integrator, precision, seconds, sheet_cells, share)
                   for integrator in ("rk4", "verlet") for precision in (64, 32) for share in (0.99, 0.25)]


def one(name, trial, integrator, precision, share, seconds, looks):
    drape = trial.drape(precision, integrator)
    first = share * drape.step_bound
    mass = trial.lattice.mass.reshape(-1)
    start, moving, most, status, note = drape.report["energy"], 0.0, 0.0, "ok", ""
    before = drape.report
    try:
        for _ in range(looks):
            h = share * drape.step_bound  # of the pose
            drape.step(max(1, int(seconds / looks / h)), h)
            speed = np.array(drape.velocities)
            moving = max(moving, 0.5 * float((mass * (speed ** 2).sum(1)).sum()))
            most = max(most, drape.report["energy"] - start)
    except muslin.MuslinError as error:
        status, note = ("diverged" if error.name == "MUS_ERR_DIVERGED" else error.name), error.text
    return trial.row(**{"integrator": integrator, "precision": precision, "variant": "mus_drape_step", "step_s": first,
                        "step_of_bound": share, "status": status, "note": note,
                        "value": (drape.report["energy"] - start) / moving, "exact": most / moving,
                        **measure.counts(drape, before, integrator)}) | {
        "error": "energy", "quantity": "energy at the end, share of the largest kinetic", "simulated_s": drape.time}


def momentum(integrator, precision, seconds, cells, share):
    """A sheet in the air, let go from a bump: no force from outside."""
    trial = scene_sheet.sheet(cells, scene_sheet.bump, scene_sheet.BUMP)
    cloth = muslin.Cloth.grid(trial.rows, trial.columns, trial.cell, muslin.Fabric(damping=0.0, **trial.fabric),
                              coarser=0)
    drape = muslin.Drape(cloth, precision=precision, integrator=integrator, gravity=(0.0, 0.0, 0.0), drag=0.0)
    drape.set_state(*trial.state)
    mass, whole, turned = np.asarray(cloth.masses)[:, None], 0.0, 0.0
    for _ in range(250):
        h = share * drape.step_bound  # of the pose: where the sheet goes slack the bound falls
        drape.step(max(1, int(seconds / 250 / h)), h)
        x, v = np.array(drape.positions), np.array(drape.velocities)
        scale = float((mass * np.linalg.norm(v, axis=1, keepdims=True)).sum())
        centre = (mass * x).sum(0) / mass.sum()
        spin = float((mass * np.linalg.norm(x - centre, axis=1, keepdims=True)
                      * np.linalg.norm(v, axis=1, keepdims=True)).sum())
        whole = max(whole, float(np.linalg.norm((mass * v).sum(0))) / scale)
        turned = max(turned, float(np.linalg.norm((mass * np.cross(x - centre, v)).sum(0))) / spin)
    return trial.row(integrator=integrator, precision=precision, variant="mus_drape_step", step_s=h,
                     step_of_bound=share, value=whole, exact=turned) | {
        "error": "energy", "quantity": "momentum, share of m |v|; exact: of the turning one",
        "simulated_s": drape.time, "scene": "sheet, free"}
