"""parting.py: how long two runs of one scene stay together, and what they agree on after that.

Each scene runs for `seconds` from one state with five settings: RK4 in double at 0.95 and at half of its bound (the
latter is what the others are held against), Verlet in double and in float, RK4 in float. The parting time is the first
at which the farthest node is 1 mm off. After it places say nothing, and scalars do: means over the second half of the
run of the height of the lowest fiftieth of the nodes (the hem) and of the centre of mass, over `seeds` starts that
differ by at most 0.1 mm a node: median and quartiles of the two settings that users run, RK4 in double and Verlet in
float. """
import numpy as np

import garment
import measure
import muslin
import scene_fall
import scene_garments

SETTINGS = {"RK4, half the bound, double": (64, "rk4", 0.475), "RK4, double": (64, "rk4", 0.95),
            "RK4, float": (32, "rk4", 0.95), "Verlet, double": (64, "verlet", 0.95),
            "Verlet, float": (32, "verlet", 0.95)}
SEEDED = ("RK4, double", "Verlet, float")
FIRST = next(iter(SETTINGS))


def garments(design, contact, spacing, fabric=None):
    """make(precision, integrator) of a garment at rest on its body, which gravity then tilts."""
    tape = muslin.Tape.read(garment.TAPE)
    pattern, body = muslin.draft(design, tape), muslin.Body(tape)
    cloth = muslin.Cloth(pattern, muslin.Fabric(fabric), spacing=spacing)
    still = scene_garments.at_rest(cloth, body)
    return scene_garments.maker(cloth, body, still, contact)


def fall():
    trial = scene_fall.trial()

    def make(**options):
        return trial.drape(**options)

    return make


def apart(scene, seconds=10.0, looks=500, seeds=5, **how):
    """Rows of a scene: parting times, distance at 0.1, 1 and 10 s beside the motion, scalars over seeds."""
    make = fall() if scene == "fall" else garments(how.pop("design"), spacing=how.pop("spacing", 0.03), **how)
    name, seeds = scene, range(seeds + 1)
    paths, lines = {}, {}
    for setting, (precision, integrator, share) in SETTINGS.items():
        drape = make(precision=precision, integrator=integrator)
        state = np.array(drape.positions), np.array(drape.velocities)
        count, h = measure.steps_in(seconds / looks, drape.step_bound, share)
        before = drape.report
        found = {}
        paths[setting] = run(drape, state, count, h, looks, found)
        lines[setting] = dict(scene=name, error="time", variant=setting, integrator=integrator, precision=precision,
                              contact="on" if how.get("contact") == "on" else "off", threads=1, nodes=len(drape),
                              step_s=h, step_of_bound=share, **found, **measure.counts(drape, before, integrator))
    held, rows = paths[FIRST], []
    for setting in list(SETTINGS)[1:]:
        both = min(len(paths[setting]), len(held))
        far = 1e3 * np.linalg.norm(paths[setting][:both] - held[:both], axis=2)
        late = np.flatnonzero(far.max(1) > 1.0)
        part = seconds / looks * float(late[0] + 1) if len(late) else np.inf
        rows.append(measure.row(**lines[setting], quantity="time until 1 mm apart [s]", value=min(part, seconds),
                                exact=seconds, simulated_s=seconds))
        for span in (0.1, 1.0, 10.0):
            last = round(span / seconds * looks)
            if 0 < last <= both:
                rows.append(measure.row(**{**lines[setting], "status": "ok", "note": ""},
                                        quantity=f"places after {span:g} s", simulated_s=span,
                                        **measure.distance(paths[setting][:last], held[:last]),
                                        **measure.motion(held[:last], state[0])))
    for setting in SEEDED:
        rows += scalars(make, setting, seeds, seconds, looks, lines[setting])
    return rows


def run(drape, state, count, h, looks, found):
    """Positions (looks x nodes x 3); `found` has the status, and a run that was stopped ends there."""
    found.update(status="ok", note="")
    drape.set_state(*state)
    path = []
    for _ in range(looks):
        try:
            drape.step(count, h)
        except muslin.MuslinError as error:
            found.update(status="diverged" if error.name == "MUS_ERR_DIVERGED" else error.name, note=error.text)
            break
        path.append(np.array(drape.positions))
    return np.array(path)


def scalars(make, setting, seeds, seconds, looks, line):
    precision, integrator, share = SETTINGS[setting]
    hems, centres = [], []
    for seed in seeds:
        drape = make(precision=precision, integrator=integrator)
        places = np.array(drape.positions)
        places += 1e-4 * (2.0 * np.random.default_rng(seed).random(places.shape) - 1.0) * (seed > 0)
        count, h = measure.steps_in(seconds / looks, drape.step_bound, share)
        path = run(drape, (places, np.zeros_like(places)), count, h, looks, {})
        half = path[len(path) // 2:]
        hems.append(1e3 * float(np.mean([scene_garments.lowest(x) for x in half])))
        centres.append(1e3 * float(half[..., 1].mean()))
    rows = []
    for quantity, values in (("height of the hem, mean of the second half [mm]", hems),
                             ("height of the middle, mean of the second half [mm]", centres)):
        low, middle, high = np.percentile(values, (25, 50, 75))
        rows.append(measure.row(**{**line, "status": "ok"} | {"note": f"{len(values)} starts"}, quantity=quantity,
                                value=float(middle), error_mm=float(high - low), simulated_s=seconds))
    return rows
