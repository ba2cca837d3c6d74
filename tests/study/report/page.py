"""page.py: the readable page: pictures, tables, what was left out; what a reader should conclude is in conclude.py."""
import re
import statistics

import conclude
import order
import plots
import rest

# scenes of the time error: what is seen
TIMED = {"strip": "hanging strip, bobbing", "sheet": "stretched sheet, let go from a bump",
         "cantilever": "cantilever, swinging down", "disc": "drape disc, swaying",
         "skirt_off": "skirt held at its waist, no body, swaying", "skirt": "skirt on a body with friction, swaying",
         "skirt_cotton": "skirt of cotton on a body with friction, swaying",
         "tshirt": "T-shirt on a body with friction, swaying"}
PARTED = ("fall", "skirt_off", "skirt", "skirt_cotton", "tshirt")


def write(into, jobs, claims, machine, swing, quick):
    """REPORT.md and its pictures."""
    pictures(into, jobs, machine)
    parts = [head(machine, swing, quick), conclude.text(jobs), time_part(jobs), parting_part(jobs), energy_part(jobs),
             mesh_part(jobs), contact_part(jobs), model_part(jobs), cost_part(jobs), command_part(jobs),
             sewing_part(jobs), rest_part(jobs), stopped_part(jobs), LEFT_OUT, checks(claims)]
    (into / "REPORT.md").write_text("\n".join(parts))


# ---- pictures ----

def pictures(into, jobs, machine):
    for name, title in TIMED.items():
        first = jobs[name][0]
        plots.work_precision(into / f"{name}.png", jobs[name],
                             f"{title}: {first['nodes']} nodes, {first['simulated_s']:.2g} s")
    plots.orders(into / "order.png", [("sheet, smooth", jobs["sheet"]), ("skirt held, no body", jobs["skirt_off"]),
                                      ("skirt on its body, friction", jobs["skirt"])])
    plots.curves(into / "mesh.png", mesh_panels(jobs))
    plots.curves(into / "speed.png", speed_panels(jobs, machine))
    plots.curves(into / "sewing.png", sewing_panels(jobs))
    plots.curves(into / "rest.png", rest_panels(jobs))


def _of(rows, **wanted):
    return [r for r in rows if all(r.get(k) == v for k, v in wanted.items())]


def _xy(rows, x, y):
    pairs = sorted((r[x], r[y]) for r in rows if r.get(y))
    return [p[0] for p in pairs], [p[1] for p in pairs]


def mesh_panels(jobs):
    exact = {"strip, bobbing": _of(jobs["strip_mesh"], quantity="bobbing of the free end"),
             "sheet, swing of 20 mm": jobs["sheet_mesh"],
             "cantilever, plate": _of(jobs["cantilever_mesh"], bending="plate", precision=64),
             "cantilever, paper's springs": _of(jobs["cantilever_mesh"], bending="paper")}
    drape = {f"{r}": [x for x in jobs["disc_mesh"] if x["quantity"].endswith(r) and x["bending"] == b
                      and x["variant"].endswith("seed 0") and x["precision"] == 32]
             for r, b in (("c = 3 cm", "plate"), ("c = 2 cm", "plate"))}
    drape.update({f"{r}, paper's springs": [x for x in jobs["disc_mesh"] if x["quantity"].endswith(r)
                                            and x["bending"] == "paper"] for r in ("c = 3 cm", "c = 2 cm")})
    return [("against the answer without a mesh", "spacing [mm]", "error [mm]",
             {k: _xy(v, "spacing_mm", "error_mm") for k, v in exact.items()}, {"across": [(1.0, "1 mm")]}),
            ("drape coefficient of a disc", "spacing [mm]", "coefficient [%]",
             {k: _xy(v, "spacing_mm", "value") for k, v in drape.items() if v}, {"ylog": False})]


def caches(machine, bytes_a_node):
    """[(nodes that fill a cache of one core, its name)]."""
    found = []
    for name, size, unit, copies in re.findall(r"(L\d\w?) ([\d.]+) (KiB|MiB)(?: \((\d+))?", machine["caches"]):
        if name != "L1i":
            size = float(size) * (1024 if unit == "KiB" else 1024 ** 2) / int(copies or 1)
            found.append((size / bytes_a_node, name))
    return found


def speed_panels(jobs, machine):
    lines = {f"{plots.NAME[i]}, {'double' if p == 64 else 'float'}":
             _xy(_of(jobs["speed"], integrator=i, precision=p), "nodes", "value")
             for i in ("rk4", "verlet") for p in (32, 64)}
    parts = [r for r in jobs["parts"] if r["precision"] == 32]
    names = ["T-shirt " + ("on its body" if r["contact"] == "on" else "without it") if r["scene"] == "tshirt"
             else r["variant"] for r in parts]
    bars = {"float": (names, [r["value"] for r in parts]),
            "double": (names, [r["value"] for r in jobs["parts"] if r["precision"] == 64])}
    bytes_a_node = _of(jobs["speed"], integrator="rk4", precision=32)[-1]["exact"]
    return [("a node and step, one thread", "nodes (dotted: a cache is full, float)", "ns", lines,
             {"upright": caches(machine, bytes_a_node)}),
            (f"parts of a scene, RK4, {parts[0]['nodes']} nodes", "ns a node and step", "", bars, {"bars": True})]


def sewing_panels(jobs):
    rows = jobs["sewing"]
    sewn, shape = "gap that welding closes", "shape at rest against the smallest distance"
    time = {v: _xy(_of(rows, quantity=sewn, variant=v), "value", "cpu_s") for v in ("one cut", "coarser cuts first")}
    gap = {"widest open pair 64 steps before the end, one cut":
           _xy(_of(rows, quantity=sewn, variant="one cut"), "value", "error_mm")}
    gap.update({f"shape at rest moved by (rms), {v}": _xy(_of(rows, quantity=shape, variant=v), "value", "error_rms_mm")
                for v in ("one cut", "coarser cuts first")})
    return [("T-shirt: CPU time of sewing", "collision distance [mm]", "CPU s", time, {}),
            ("what it costs", "collision distance [mm]", "mm", gap, {})]


def rest_panels(jobs):
    far = "distance from rest"
    names = {"settle": "settle (without sewing)", "refit": "refit after +10 mm of bust"}
    shirt = {name: _xy(_of(jobs["rest_tshirt"], quantity=far, variant=way), "cpu_s", "error_mm")
             for way, name in names.items()}
    hang = {}
    for name in hangs(jobs):
        for variant, style in (("settle", "-"), ("rk4, drag 7", ":")):
            rows = _of(jobs[name], quantity=far, variant=variant)
            hang[f"{rows[0]['nodes']} nodes, {variant}"] = _xy(rows, "cpu_s", "error_mm")
    limits = {"across": [(10.0, "10 mm"), (1.0, "1 mm")]}
    return [(f"T-shirt of {jobs['rest_tshirt'][0]['nodes']} nodes", "CPU s", "greatest distance from rest [mm]", shirt,
             dict(limits, upright=[(1.5, "10 mm aimed at"), (5.0, "1 mm aimed at")])),
            ("1 m square held at two corners", "CPU s", "greatest distance from rest [mm]", hang, limits)]


def hangs(jobs):
    return [name for name in jobs if name.startswith("rest_hang")]


# ---- text ----

def table(heads, lines):
    """A table of Markdown."""
    out = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(out + ["| " + " | ".join(str(cell) for cell in line) + " |" for line in lines]) + "\n"


def number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}g}"


def head(machine, swing, quick):
    return f"""# Error against run time{', the quick variant' if quick else ''}

Made by `make report{' QUICK=1' if quick else ''}`. All numbers are in [report.csv](report.csv), a row a point.

- Machine: {machine['processor']}, {machine['cores']} cores ({machine['caches']}), {machine['system']}.
- Compiler: {machine['compiler']}; flags `{machine['flags']}`; commit {machine['commit']}; {machine['python']}.
- Seconds are CPU seconds of a process pinned to one core, medians of repeats where a run is cheap. A fixed loop took
  {100 * swing:.1f} % more or less time at the end of the report than at its start; other work on the machine disturbs
  single figures by up to a third. Counts in the table do not depend on the machine.

Three errors are kept apart, never one number for all. *Time error*: the same mesh, against steps so small that they do
not matter. *Mesh error*: against the answer without a mesh. *Model error*: against measured cloth.
"""


def time_part(jobs):
    lines = []
    for name in TIMED:
        rows = jobs[name]
        floor = max(r["floor_mm"] for r in rows)
        for limit in (1.0, 0.01):
            best = conclude.cheapest(rows, limit)
            way = "none"
            if best:
                way = (f"{plots.NAME[best['integrator']]}, {best['precision']} bit, {1e3 * best['step_s']:.3g} ms "
                       f"({best['step_of_bound']:.2f} of the bound)")
            lines.append((name, f"{limit:g} mm", way, number(best and best["cpu_s_per_s"]),
                          number(best and best["error_mm"]), number(floor),
                          f"{number(rows[0]['motion_mm'])} / {number(rows[0]['motion_median_mm'])}"))
    pictures_of = "\n".join(f"![{title}]({name}.png)\n" for name, title in TIMED.items())
    return f"""## Time error

Reference of strip, sheet and cantilever: another program (springs and Runge-Kutta in numpy, or the closed form), at
1/64 of the largest step; beside it the library in double. Sheet and cantilever have a third program in their pictures:
implicit steps on the same springs, with scipy's factors (implicit.py). Of disc, skirt and T-shirt: RK4 in double at
1/64, beside it Verlet in double at 1/64. How far the two references are apart is the grey band in the pictures; an
error below it says nothing. All of these runs last 0.1 s and start at rest or near it; the last column is what an error
is to be held against. Longer runs follow below.

{table(('scene', 'wished', 'cheapest setting', 'CPU s a simulated s', 'its error [mm]', 'references apart [mm]',
        'moved, farthest / median node [mm]'), lines)}
{pictures_of}
Error against step, with slopes 4, 2, 1:

![order](order.png)
"""


def mesh_part(jobs):
    lines = []
    for name in ("strip_mesh", "sheet_mesh", "cantilever_mesh"):
        groups = {}
        for r in jobs[name]:
            what = r["quantity"] + (f", {r['bending']}" if r.get("bending") else "") + f", {r['precision']} bit"
            groups.setdefault(what, []).append(r)
        lines += [(r["scene"], what, f"{r['spacing_mm']:g}", r["nodes"], number(r["error_mm"]), told)
                  for what, rows in groups.items() for r, told in zip(rows, exact_or_order(rows))]
    parting = " ".join(f"A disc let go flat buckles: against *{r['variant']}* it is 1 mm off after {r['value']:.3g} s "
                       f"and {r['error_mm']:.0f} mm after {r['simulated_s']:g} s." for r in jobs["disc_parting"])
    return f"""## Mesh error

The strip at rest has none (M1). Strip, sheet and cantilever fall by 4 for each halving: order 2. With the paper's
springs over one node the cantilever gets limper with every refinement: there is nothing that it converges to (B6).

![mesh](mesh.png)

{table(('scene', 'quantity', 'spacing [mm]', 'nodes', 'error [mm]', 'order'), lines)}
Garments and discs have several shapes at rest, so their scalars are told over several starts.

{table(('scene', 'scalar', 'spacing [mm]', 'starts', 'median', 'range', 'order'), spreads(jobs))}
{parting}
"""


def spreads(jobs):
    groups = {}
    for r in jobs["disc_mesh"] + jobs["skirt_mesh"] + jobs["tshirt_mesh"]:
        if r.get("value") is not None and r.get("bending") != "paper" and r["precision"] == 32:
            groups.setdefault((r["scene"], r["quantity"], r["spacing_mm"]), []).append(r["value"])
    told = {}
    for scene, quantity, spacing in groups:
        told.setdefault((scene, quantity), []).append(spacing)
    lines = []
    for (scene, quantity, spacing), v in groups.items():
        meshes = sorted(told[scene, quantity], reverse=True)
        says = ""
        if spacing == meshes[-1]:
            values = [statistics.median(groups[scene, quantity, a]) for a in meshes]
            spread = max(max(groups[scene, quantity, a]) - min(groups[scene, quantity, a]) for a in meshes)
            says = order.of_scalars(meshes, values, spread)
        lines.append((scene, quantity, f"{spacing:g}", len(v), f"{statistics.median(v):.1f}",
                      f"{min(v):.1f} to {max(v):.1f}", says))
    return lines


def exact_or_order(rows):
    """Beside each row its order; rows at the floor of rounding are exact on every mesh."""
    worst = max(r["error_mm"] for r in rows)
    return ["exact"] * len(rows) if worst < 1e-6 else order.of_errors(rows)


def parting_part(jobs):
    parted, after, scalars = [], [], []
    for name in PARTED:
        rows = jobs[f"parting_{name}"]
        for r in rows:
            if r["quantity"].startswith("time until"):
                far = "not within the run" if r["value"] >= r["exact"] else f"{r['value']:.2g}"
                parted.append((r["scene"], r["variant"], far, f"{r['exact']:g}",
                               r["note"] if r["status"] != "ok" else ""))
            elif r["quantity"].startswith("places after"):
                after.append((r["scene"], r["variant"], f"{r['simulated_s']:g}", number(r["error_mm"]),
                              number(r["error_rms_mm"]), f"{number(r['motion_mm'])} / {number(r['motion_median_mm'])}"))
            else:
                scalars.append((r["scene"], r["quantity"], r["variant"], r["note"], f"{r['value']:.2f}",
                                number(r["error_mm"])))
    return f"""## Longer runs: until when places mean something, and what means something after that

Two runs of one scene that differ in their step, stepper or precision part: folds and slips make the motion chaotic.
Each setting is held against RK4 in double at half of its largest step; the runs have parted when the farthest node is 1
mm off.

{table(('scene', 'setting', 'parted after [s]', 'run [s]', ''), parted)}
How far they are apart over the first 0.1, 1 and 10 s, beside how far the cloth moved:

{table(('scene', 'setting', 'span [s]', 'greatest [mm]', 'rms [mm]', 'moved, farthest / median [mm]'), after)}
What stays are means: over the second half of the run and over starts that differ by at most 0.1 mm a node, median and
the distance of the quartiles. Two settings agree where their medians differ by no more than that.

{table(('scene', 'scalar', 'setting', '', 'median [mm]', 'quartiles apart [mm]'), scalars)}
"""


def energy_part(jobs):
    lines, momentum = [], []
    for r in jobs["energy"]:
        way = (r["scene"], plots.NAME[r["integrator"]], r["precision"], f"{r['step_of_bound']:g}",
               number(r["simulated_s"]))
        if r["quantity"].startswith("energy"):
            lines.append((*way, f"{100 * r['value']:+.2g}", f"{100 * r['exact']:.2g}", r["status"],
                          number(r["spring_evaluations"], 3)))
        else:
            momentum.append((*way, number(r["value"]), number(r["exact"])))
    return f"""## Energy and momentum

Nothing damps these scenes. Energy at the end against the start, and the greatest gain on the way, in percent of the
largest kinetic energy of the run. RK4 loses energy of its shortest waves at every step (its factor of growth is below 1
there), Verlet swings about the energy and keeps it in the mean. A run that gains 1 % is ended by the guard with a
sentence: `diverged`.

{table(('scene', 'stepper', 'bits', 'of its bound', 'run [s]', 'at the end [%]', 'gained on the way [%]', 'end',
        'spring evaluations'), lines)}
A stretched sheet in the air that nothing holds: greatest momentum, as a share of the sum of m |v|, and the same of the
turning momentum about the centre:

{table(('scene', 'stepper', 'bits', 'of its bound', 'run [s]', 'momentum', 'turning'), momentum)}
"""


def contact_part(jobs):
    lying = [r for r in jobs["contact"] if r["quantity"].startswith("places")]
    slip = [r for r in jobs["contact"] if r["quantity"].startswith("longest")]
    return f"""## Contact against answers that are not the library's

A row of nodes over a level cylinder, pinned on its top, without friction: the shape of least energy that keeps every
node outside, found by scipy from model.py's springs and the circle alone.

{table(('nodes', 'spacing [mm]', 'farthest node apart [mm]', 'rms [mm]'),
       [(r['nodes'], f"{r['spacing_mm']:.3g}", number(r['error_mm']), number(r['error_rms_mm'])) for r in lying])}
The same row, not held, with friction: the arm on the right that friction can just hold against one radius on the left,
by the capstan's law with the row's own weight (closed form in contact.py). Nodes lie on the circle as a polygon, which
is of first order in the spacing.

{table(('friction', 'nodes', 'held [radii]', 'law [radii]', 'apart'),
       [(r['variant'].split()[-1], r['nodes'], f"{r['value']:.3f}", f"{r['exact']:.3f}",
         f"{100 * (r['value'] / r['exact'] - 1):+.1f} %") for r in slip])}
"""


def command_part(jobs):
    lines = []
    for r in jobs["command"]:
        if r["quantity"] == "dressed":
            judged = [x for x in jobs["command"] if x["scene"] == r["scene"] and x["quantity"] != "dressed"]
            far = judged[0] if judged else None
            lines.append((r["scene"], r.get("nodes", 0), number(r["cpu_s"]), r["status"], number(r.get("value")),
                          r["note"], number(far and far["exact"]),
                          "-" if not far else number(far["error_mm"]) if far["status"] == "ok" else far["status"]))
    return f"""## The way that users go

`muslin dress` and mus_dress are one call: cut, sew, settle, by damped steps with raised inertia and none of the
steppers above. Its own estimate, rest_distance, is how far it expects the farthest node still to go; beside it stands
where Newton's method (newton.py) comes to rest from there. On a body with friction many shapes are at rest, and
Newton's lets nodes go or slide that it cannot hold: the distance holds that too.

{table(('garment, fabric', 'nodes', 'CPU s', 'end', 'residual, of a weight', '', 'estimate [mm]',
        "to Newton's shape [mm]"), lines)}
"""


def model_part(jobs):
    lines = [(r["scene"], r["quantity"], f"{r['spacing_mm']:g} mm" if r["scene"] == "disc" else r["variant"],
              number(r["value"], 3), number(r["exact"], 3))
             for r in jobs["disc_model"] + jobs["limits"]]
    return f"""## Model error

{table(('scene', 'quantity', 'case', 'model', 'measured'), lines)}
The drape coefficients use the bending and the friction of bending that were measured on the same fabric, with no factor
fitted; weight, shear and stretch are assumed (`muslin_fabric(5)` says which). `make fabric` has all fabrics. Fabrics whose bending was chosen to give their coefficient prove
nothing and are left out here.
"""


def cost_part(jobs):
    base = {p: _of(jobs["parts"], variant="all springs", precision=p)[0]["value"] for p in (32, 64)}
    lines = []
    for r in jobs["parts"]:
        if r["scene"] == "lattice":
            share = r["value"] / base[r["precision"]]
            lines.append((r["variant"], r["precision"], number(r["value"], 3), f"{share:.2f}", r["note"]))
        else:
            lines.append((f"T-shirt, body {r['contact']}", r["precision"], number(r["value"], 3), "-", r["note"]))
    many = [(r["threads"], r["precision"], number(r["value"], 3),
             number(1e9 * r["wall_s"] / (r["steps"] * r["nodes"]), 3), r["note"])
            for r in jobs["threads_1"] + jobs["threads_2"]]
    return f"""## What a step costs

![speed](speed.png)

{table(('RK4', 'bits', 'ns a node and step', 'of all springs', 'what it did without'), lines)}
Threads change seconds and never the state; the wall time also says what other work left of the second core:

{table(('threads', 'bits', 'CPU ns a node and step', 'wall ns', 'state after 50 steps'), many)}
"""


def sewing_part(jobs):
    rows, lines = jobs["sewing"], []
    for r in _of(rows, quantity="gap that welding closes"):
        shape = _of(rows, quantity="shape at rest against the smallest distance", variant=r["variant"],
                    value=r["value"])[0]
        lines.append((r["variant"], f"{r['value']:g}", number(r["cpu_s"]), number(r["simulated_s"]), r["steps"],
                      number(r["error_mm"]), f"{r['exact']:.2g}", f"{shape['error_rms_mm']:.1f}",
                      r["status"] if r["status"] != "ok" else ""))
    return f"""## Sewing against the collision distance

The paper's own trade (4.3): a larger collision distance sews sooner and joins what is farther apart. Welding leaves no
gap, so what one pays is the place where cloth is joined: how far the shape at rest (rms over nodes) moves from that of
the smallest distance. A garment's shapes at rest lie about as far apart for any other reason (see below).

![sewing](sewing.png)

{table(('way', 'distance [mm]', 'CPU s', 'cloth s', 'steps, all cuts', 'widest pair 64 steps before the end [mm]',
        'gap after [mm]', 'shape moved [mm]', ''), lines)}
"""


def rest_part(jobs):
    heads = ("scene", "way", "nodes", "to 10 mm: CPU s", "to 1 mm: CPU s", "with sewing, 10 and 1 mm")
    lines, shapes, statics = [], [], []
    for name in ["rest_tshirt"] + hangs(jobs):
        rows = jobs[name]
        for variant in dict.fromkeys(r["variant"] for r in rows if r["quantity"] == "distance from rest"):
            nodes = _of(rows, quantity="distance from rest", variant=variant)[0]["nodes"]
            ten, one = (rest.reached(rows, variant, rows[0]["scene"], nodes, limit) for limit in (10.0, 1.0))
            best = min(r["error_mm"] for r in _of(rows, quantity="distance from rest", variant=variant))
            lines.append((rows[0]["scene"], variant, nodes, number(ten and ten[0], 3),
                          number(one and one[0], 3) if one else f"not reached, {best:.2g} mm at the end",
                          f"{number(ten and ten[1], 3)}, {number(one and one[1], 3)}" if variant == "settle" else ""))
        shapes += [(r["scene"], r["nodes"], r["variant"], r["note"], number(r["cpu_s"]))
                   for r in _of(rows, quantity="shape at rest")]
        statics += [(r["nodes"], r["quantity"], f"{r['value']:.5f}", f"{r['exact']:.5f}",
                     f"{100 * (r['value'] / r['exact'] - 1):+.2f} %", r.get("note", ""))
                    for r in rows if r["quantity"] in ("largest strain at rest", "pins carry of the weight")]
    spread = [(r["variant"], number(r["error_mm"], 3), number(r["error_rms_mm"], 3), number(r["cpu_s"], 3), r["status"])
              for r in _of(jobs["rest_tshirt"], quantity="spread")]
    return f"""## To rest

CPU seconds from which on the cloth stays within 10 mm and 1 mm (its farthest node) of its shape at rest.

![rest](rest.png)

{table(heads, lines)}
Shapes at rest are found by another method than settle's: Newton's, with the true stiffness by differences of the forces
and Cholesky factors of it (newton.py), from where a run ended. It shares the forces with settle, and no time, mass or
damping. What lies on the body is held where it sticks, and judged: the skin must push it, and friction suffice. Factors
prove that the energy has a minimum there: a shape of its own, which no other method leaves. Of the hanging cloth, shapes
that are more than 1 mm apart have letters: where there are two, RK4 with drag and settle come to two equilibria, of the
same energy, and the one is the mirror image of the other: both are rest shapes.

{table(('scene', 'nodes', 'from', 'how it was found', 'CPU s'), shapes)}
The hanging cloth as settle leaves it in float, with the end that it has by itself, beside the static solver:

{table(('nodes', 'quantity', 'settle', 'static solver', 'apart', ''), statics)}
Other starts of the T-shirt, run to their own end, and their distance from that shape, the spread:

{table(('start', 'greatest [mm]', 'rms [mm]', 'CPU s', 'end'), spread)}
"""


def stopped_part(jobs):
    rows = [r for rows in jobs.values() for r in rows if r["status"] not in ("ok",)]
    groups = {}
    for r in rows:
        key = (r["status"], r["scene"], r.get("variant", ""), plots.NAME.get(r.get("integrator"), ""))
        groups.setdefault(key, []).append(r)
    lines = [(*key, len(v), v[0].get("note", "")) for key, v in sorted(groups.items())]
    return f"""## What was refused, blew up, or was not at rest in time

`refused`: mus_drape_step does not take a step above its bound. `diverged`: forced through mus_integrate, the energy
guard stopped it. `unsettled`: a settle ran out of its budget; its shape is in the table all the same.

{table(('status', 'scene', 'of', 'integrator', 'points', 'what it said (the first)'), lines)}
"""


LEFT_OUT = """## What was left out, and why

- A walking body: bodies that change their pose belong to a later issue; the T-shirt's stands still, and gravity tilts.
- Symplectic Euler through mus_drape_step: it is not one of its steppers. Through mus_integrate it is here, on a rate
  written in numpy, whose seconds say nothing of the library: those points are in the pictures of counts alone.
- mus_integrate in float: its points would lie on those of the float drape.
- An implicit step of the library: none is built; lib/integrate says why, with its measurement. The competitor here is
  another program's, in numpy and scipy.
- A second program of motion for disc and garments: springs of the strip are not public; the second reference is another
  stepper there.
- Sheet and strip with bending or paper's springs: both are straight or stretched, bending takes no part.
- Paper's springs below 10 mm on the disc: their stiffness grows with the fourth power of 1 / spacing, and with it time.
- Skirt and T-shirt below 5 mm, disc below 2.5 mm: minutes a point; order 2 is seen on the scenes with an answer.
- Work-precision over 1 and 10 s: the runs have parted by then; their distances stand beside the parting times.
- Threads above 2: the machine has two cores. Eleven repeats of runs above 0.3 s: fewer are made, their number is in the
  table. Instruction counts: the machine has no counters.
"""


def checks(claims):
    return "## What the report checks of itself\n\n" + "".join(
        f"- {'holds' if holds else '**does not hold**'}: {sentence}\n" for sentence, holds in claims)
