"""conclude.py: what a reader should be able to conclude, with figures."""
import math

import plots
import rest
import runs


TIMED = ("strip", "sheet", "cantilever", "disc", "skirt_off", "skirt", "skirt_cotton", "tshirt")


def good(rows, **wanted):
    return [r for r in rows if r["status"] == "ok" and r.get("error_mm") is not None
            and all(r.get(k) == v for k, v in wanted.items())]


def cheapest(rows, limit_mm):
    """The point of mus_drape_step with the least CPU time whose error is at most limit_mm, or None."""
    points = [r for r in good(rows, variant="mus_drape_step") if r["error_mm"] <= limit_mm]
    return min(points, key=lambda r: r["cpu_s_per_s"]) if points else None


def largest_step(rows, integrator, precision=64):
    return max(good(rows, variant="mus_drape_step", integrator=integrator, precision=precision),
               key=lambda r: r["step_s"])


def text(jobs):
    told = (one_mm, implicit, stability, order, parted, energy, floats, stops, modules, model, command, settled)
    parts = [tell(jobs) for tell in told]
    return "## What to conclude\n\n" + "\n".join(f"{i + 1}. {part}" for i, part in enumerate(parts)) + "\n"


def one_mm(jobs):
    best = {name: cheapest(jobs[name], 1.0) for name in TIMED}
    ways = {(plots.NAME[b["integrator"]], b["precision"]) for b in best.values() if b}
    each = ", ".join(f"{name} {b['cpu_s_per_s']:.2g}" for name, b in best.items() if b)
    way = " or ".join(sorted(f"{name} in {'float' if p == 32 else 'double'}" for name, p in ways))
    held = all(b["step_s"] >= 0.99 * largest_step(jobs[name], b["integrator"], b["precision"])["step_s"]
               for name, b in best.items() if b)
    where = "at the largest step that was run" if held else "at the steps of the table below"
    return (f"**Over 0.1 s from rest 1 mm is cheapest with {way}, {where}**: {each} CPU s a simulated second (coarse "
            "meshes; see the mesh error for what they are worth).")


def implicit(jobs):
    told = []
    for name in ("sheet", "cantilever"):
        explicit = cheapest(jobs[name], 1.0)
        points = [r for r in good(jobs[name], variant="implicit, scipy") if r["error_mm"] <= 1.0]
        best = min(points, key=lambda r: r["cpu_s_per_s"]) if points else None
        shortest = min(r["step_s"] for r in good(jobs[name], variant="implicit, scipy"))
        told.append(f"{name} {best['integrator']} at {best['step_of_bound']:.2g} times RK4's bound, "
                    f"{best['exact'] / explicit['cpu_s_per_s']:.0f} times the seconds in its factors alone" if best else
                    f"{name} not reached with {1e3 * shortest:.2g} ms")
    return (f"**An implicit step on the same springs does not pay for 1 mm in motion**: {'; '.join(told)} "
            "(SuperLU's, by scipy).")


def stability(jobs):
    worst = {(name, i): largest_step(jobs[name], i)["error_mm"] for name in TIMED for i in ("rk4", "verlet")}
    name, stepper = max(worst, key=worst.get)
    moved = jobs[name][0]["motion_mm"]
    mesh = max(r["error_mm"] for r in jobs["cantilever_mesh"] if r["bending"] == "plate" and r["spacing_mm"] <= 10.1)
    small = sum(v <= 0.1 for v in worst.values())
    return (f"**In 0.1 s stability limits a run sooner than accuracy does**: at the largest step that was run the time "
            f"error of {small} of {len(worst)} scenes and steppers is at most 0.1 mm; the greatest is "
            f"{worst[name, stepper]:.2g} mm ({name}, {plots.NAME[stepper]}; its farthest node moves {moved:.2g} mm), "
            f"while a mesh of 10 mm is {mesh:.2g} mm wrong on the cantilever.")


def parted(jobs):
    times = {name: [r for r in jobs[f"parting_{name}"] if r["quantity"].startswith("time until")
                    and r["variant"] == "RK4, double"][0] for name in ("fall", "skirt_off", "skirt", "skirt_cotton",
                                                                       "tshirt")}
    each = ", ".join(f"{r['scene']} {'more than ' if r['value'] >= r['exact'] else ''}{r['value']:.2g}"
                     for r in times.values())
    agree, told = 0, 0
    for name in times:
        rows = [r for r in jobs[f"parting_{name}"] if "second half" in r["quantity"]]
        for quantity in dict.fromkeys(r["quantity"] for r in rows):
            one, other = [r for r in rows if r["quantity"] == quantity]
            told += 1
            agree += abs(one["value"] - other["value"]) <= max(one["error_mm"], other["error_mm"], 0.1)
    return (f"**After that no step gives the path of a node**: RK4 at its largest step and at half of it are 1 mm "
            f"apart after {each} s. Means over time remain: RK4 in double and Verlet in float agree within the spread of "
            f"starts (or 0.1 mm) in {agree} of {told} scalars.")


def energy(jobs):
    def lost(integrator):
        rows = [r for r in jobs["energy"] if r["quantity"].startswith("energy") and r["status"] == "ok"
                and r["integrator"] == integrator and r["precision"] == 64]
        return min(rows, key=lambda r: r["value"])

    ended = [r for r in jobs["energy"] if r["status"] == "diverged"]
    rk4, verlet = lost("rk4"), lost("verlet")
    stopped = f"; {len(ended)} runs ended with the guard's sentence" if ended else ""
    return (f"**Without damping RK4 loses energy, Verlet keeps it**: in {rk4['simulated_s']:.2g} s RK4 at "
            f"{rk4['step_of_bound']:g} of its bound loses {-100 * rk4['value']:.2g} % of the largest kinetic energy "
            f"({rk4['scene']}), Verlet at most {-100 * verlet['value']:.2g} % ({verlet['scene']}); none that came to "
            f"its end gained more than 1 %{stopped}.")


def command(jobs):
    rows = [r for r in jobs["command"] if r["quantity"] == "dressed"]
    good = [r for r in rows if r["status"] == "ok"]
    judged = [r for r in jobs["command"] if r["quantity"] != "dressed" and r["status"] == "ok"]
    within = sum(r["error_mm"] <= 2 * r["exact"] for r in judged)
    far = sorted(r["error_mm"] for r in judged)
    slow = max(good, key=lambda r: r["cpu_s"])
    return (f"**One call from pattern to rest**: {len(good)} of {len(rows)} garments and fabrics came to rest, the "
            f"slowest ({slow['scene']}) in {slow['cpu_s']:.2g} CPU s. They end {far[0]:.2g} to {far[-1]:.2g} mm from the "
            f"shape that Newton's method finds from there; the settle's own estimate holds to a factor of two in {within} of "
            f"{len(judged)}: **on a body with friction it is too small**, and no bound.")


def order(jobs):
    each = ", ".join("{} {:.2f} and {:.2f}".format(name, *(runs.order_of(jobs[name], i)[0] for i in ("rk4", "verlet")))
                     for name in ("strip", "sheet", "cantilever"))
    euler, _ = runs.order_of(jobs["strip"], "euler", variant="mus_integrate")
    held = [runs.order_of(jobs["skirt_off"], i, above=5.0)[0] for i in ("rk4", "verlet")]
    damped = [runs.order_of(jobs["skirt_damped"], i, above=a, most=9)[0] for i, a in (("rk4", 0.0), ("verlet", 1.5))]
    worn = [runs.order_of(jobs["skirt"], i, above=1.5, most=9)[0] for i in ("rk4", "verlet")]
    at = [largest_step(jobs["skirt"], i)["error_mm"] for i in ("rk4", "verlet")]
    return (f"**Order 4 (RK4) and 2 (Verlet) in smooth motion** ({each}), symplectic Euler {euler:.2f}; a skirt held "
            f"at its waist without a body {held[0]:.1f} and {held[1]:.1f}; with the fabric's dashpots {damped[0]:.1f} "
            f"and {damped[1]:.1f}, since velocity Verlet takes forces of velocity with order 1. **On the body, with "
            f"friction, contact takes the order away**: {say(worn[0])} and {say(worn[1])}; RK4 at its largest step is "
            f"then {at[0]:.2g} mm wrong and Verlet {at[1]:.2g} mm, for a quarter of the evaluations a step.")


def say(slope):
    return "no slope above the floor" if math.isnan(slope) else f"{slope:.1f}"


def floats(jobs):
    least = {name: min(r["error_mm"] for r in good(jobs[name], precision=32))
             for name in ("strip", "sheet", "cantilever", "disc")}
    each = ", ".join(f"{name} {v:.1g}" for name, v in least.items())
    return (f"**Float's floor of rounding** lies at {min(least.values()):.1g} to {max(least.values()):.1g} mm after "
            f"0.1 s ({each}; without contact); below a quarter of the bound float gets worse, since more roundings "
            "add up.")


def stops(jobs):
    rows = [r for name in ("strip", "sheet_integrate") for r in jobs[name]]
    caught = [r for r in rows if r["status"] == "diverged"]
    bound = {i: largest_step(jobs["sheet"], i)["step_s"] / largest_step(jobs["sheet"], i)["step_of_bound"] for i in
             ("rk4", "verlet")}
    said = sum(r["status"] == "refused" for name in jobs for r in jobs[name])
    paper = [r for r in jobs["cantilever_mesh"] if r.get("bending") == "paper"]
    paper.sort(key=lambda r: -r["spacing_mm"])
    first, last = paper[0], paper[-1]
    return (f"**Where each method stops**: on the sheet RK4 at {1e3 * bound['rk4']:.3g} ms and Verlet at "
            f"{1e3 * bound['verlet']:.3g} ms; all {said} steps above a bound were refused, all {len(caught)} that were "
            "forced at 1.5 and 2 times the bound were caught by the energy guard. The paper's springs stop at their "
            f"fitted curvature: their cantilever of 100 mm is {first['error_mm']:.0f} mm wrong at "
            f"{first['spacing_mm']:.3g} mm and {last['error_mm']:.0f} mm at {last['spacing_mm']:.3g} mm.")


def modules(jobs):
    def cost(variant, **more):
        return next(r["value"] for r in jobs["parts"] if r["variant"] == variant and r["precision"] == 32
                    and all(r.get(k) == v for k, v in more.items()))

    full = cost("all springs")
    on, off = cost("worn", contact="on"), cost("worn", contact="off")
    double = next(r["value"] for r in jobs["parts"] if r["variant"] == "all springs" and r["precision"] == 64)
    return (f"**What a module costs** (float, RK4, of {full:.1f} ns a node and step): bending "
            f"{full - cost('no bending'):+.1f}, shear {cost('no bending') - cost('no bending, no shear'):+.1f}, drag "
            f"{cost('air drag') - full:+.1f}, dashpots {cost('dashpots') - full:+.1f} ns; contact on the T-shirt "
            f"{on - off:+.1f} ns of {on:.1f}; double {double / full:.1f} times float. Off, its pass is not made: a "
            "table below names what each scene did without.")


def model(jobs):
    names = dict.fromkeys(r["quantity"].split(", ")[1] for r in jobs["disc_model"])
    each = []
    for name in names:
        rows = sorted((r for r in jobs["disc_model"] if r["quantity"].endswith(name)), key=lambda r: -r["spacing_mm"])
        each.append(f"{name} {rows[-1]['value']:.0f} % at {rows[-1]['spacing_mm']:g} mm"
                    + (f" ({rows[0]['value']:.0f} at {rows[0]['spacing_mm']:g})" if len(rows) > 1 else "")
                    + f", {rows[-1]['exact']:.0f} measured")
    ties = [r for r in jobs["limits"] if r["quantity"].startswith("lateral")]
    narrow = sorted(r["value"] for r in ties)
    return (f"**Against measured cloth**: fabrics whose bending and friction of bending were measured drape at "
            f"{'; '.join(each)}, nothing fitted. **What no setting cures**: a woven fabric narrows by "
            f"{narrow[0]:.3f} to {narrow[-1]:.3f} of its stretch in the model, by 0.07 to 0.38 in the laboratory; shear "
            "has no friction.")


def settled(jobs):
    rows = jobs["rest_tshirt"]
    nodes = rows[0]["nodes"]
    found = {limit: rest.reached(rows, "settle", "tshirt", nodes, limit) for limit in (10.0, 1.0)}
    anew = [r for r in rows if r["variant"] == "refit" and r["quantity"] == "distance from rest"]
    refit = {limit: rest.reached(rows, "refit", "tshirt", anew[0]["nodes"], limit) for limit in (10.0, 1.0)}
    spread = [r["error_mm"] for r in rows if r["quantity"] == "spread"]
    best = min(r["error_mm"] for r in rows if r["variant"] == "settle")

    def took(seconds):
        return f"{seconds[1]:.2g} s" if seconds else "not reached"

    return (f"**From flat panels to rest**: a T-shirt of {nodes} nodes is within 10 mm after {took(found[10.0])} and "
            f"within 1 mm after {took(found[1.0])} of CPU time, sewing included (aims 1.5 and 5 s; it ends {best:.2g} "
            f"mm away); a refit after 10 mm more girth takes {took(refit[10.0])} and {took(refit[1.0])} (a fifth of "
            f"the aims is 0.3 and 1 s). Other starts end {min(spread):.2g} to {max(spread):.2g} mm away: a draped "
            "shape is one of several.")
