"""plots.py: the pictures of the report, 1200 pixels wide.

Error against run time is drawn as work-precision diagrams are: both axes logarithmic, error falling to the right.
Points that were refused or blew up are crosses on the top edge.
"""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import matplotlib.ticker as ticker  # noqa: E402

WIDE, DPI = 12.0, 100
COLOUR = {"rk4": "#1f5fa8", "verlet": "#c4511d", "euler": "#3d8b37", "implicit Euler": "#7a4fa3",
          "implicit midpoint": "#a8860b"}
NAME = {"rk4": "RK4", "verlet": "Verlet", "euler": "symplectic Euler"}
plt.rcParams.update({"font.size": 11, "axes.grid": True, "grid.alpha": 0.3, "legend.fontsize": 9,
                     "axes.titlesize": 12, "lines.markersize": 5})


def _save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=DPI)
    plt.close(figure)


def _lines(rows, names=("integrator", "precision", "variant")):
    """{key: rows} of the good points, in order of the step."""
    lines = {}
    for r in rows:
        lines.setdefault(tuple(r.get(name) for name in names), []).append(r)
    return {key: sorted(line, key=lambda r: r.get("step_s") or 0.0) for key, line in lines.items()}


def _style(integrator, precision, variant):
    own = variant in ("mus_integrate", "implicit, scipy")
    return dict(color=COLOUR.get(integrator, "#555555"), linestyle=":" if own else "-" if precision == 64 else "--",
                marker="s" if own else "o" if precision == 64 else "^",
                markerfacecolor="none" if precision == 32 or own else None)


def _label(integrator, precision, variant):
    return f"{NAME.get(integrator, integrator)}, " + (variant.split(", ")[-1] if variant != "mus_drape_step"
                                                     else "double" if precision == 64 else "float")


def _key(r):
    return r.get("integrator"), r.get("precision"), r.get("variant"), r["status"]


def _crosses(axis, bad):
    """One cross on the top edge for each line that had refused or blown-up points, beside what stopped it."""
    seen = dict.fromkeys(_key(r) for r in bad)
    for i, (integrator, precision, variant, status) in enumerate(seen):
        x = 0.03 + 0.05 * i
        axis.plot([x], [0.985], "x", color=COLOUR.get(integrator, "#555555"), markersize=8, markeredgewidth=2,
                  transform=axis.transAxes, clip_on=False)
        axis.text(x, 0.955, f"{_label(integrator, precision, variant)}: {status}", rotation=90, fontsize=7, ha="center",
                  va="top", color=COLOUR.get(integrator, "#555555"), transform=axis.transAxes)


def _plain(axis, x=True, y=True):
    """Numbers as 0.1, 1, 20 on a short logarithmic axis, powers on a long one."""
    for side, wanted, limits in ((axis.xaxis, x, axis.get_xlim()), (axis.yaxis, y, axis.get_ylim())):
        if wanted and side.get_scale() == "log":
            short = max(limits) / min(limits) < 50
            side.set_minor_formatter(ticker.FuncFormatter(lambda v, _: f"{v:g}") if short else ticker.NullFormatter())
            if short:
                side.set_major_formatter(ticker.FuncFormatter(lambda v, _: f"{v:g}"))
                side.set_minor_locator(ticker.LogLocator(subs=(2, 5)))


def work_precision(path, rows, title, lines_at=()):
    """Error against seconds a simulated second, and against spring evaluations."""
    good = [r for r in rows if r["status"] == "ok" and r.get("error_mm")]
    bad = [r for r in rows if r["status"] != "ok"]
    figure, axes = plt.subplots(1, 2, figsize=(WIDE, 5.4), sharex=True)
    for axis, what in zip(axes, ("cpu_s_per_s", "spring_evaluations")):
        for key, line in _lines(good).items():
            line = [r for r in line if r.get(what)]
            if line:
                axis.plot([r["error_mm"] for r in line],
                          [r[what] / (r["simulated_s"] if what != "cpu_s_per_s" else 1) for r in line],
                          label=_label(*key), **_style(*key))
                if what == "cpu_s_per_s":
                    for r in (line[0], line[-1]):
                        axis.annotate(f"{1e3 * r['step_s']:.2g} ms", (r["error_mm"], r[what]), fontsize=8,
                                      xytext=(4, 4), textcoords="offset points", color=COLOUR.get(key[0]))
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.axvline(1.0, color="#888888", linestyle="--", linewidth=1)
        floor = max((r.get("floor_mm") or 0.0 for r in rows), default=0.0)
        if floor > 0.0:
            axis.axvspan(floor / 30, floor, color="#cccccc", alpha=0.6, linewidth=0)
    worst = max((r["error_mm"] for r in good), default=1.0)
    least = min((r["error_mm"] for r in good), default=1e-3)
    # room on the left for the crosses
    right = 0.3 * min(least, max(floor, least / 10))
    left = max(3.0, 3 * worst)
    axes[0].set_xlim(left * (left / right) ** (0.05 * len({_key(r) for r in bad}) if bad else 0.0), right)
    _crosses(axes[0], bad)
    axes[0].axhline(1.0, color="#888888", linestyle="--", linewidth=1)
    axes[0].text(0.99, 1.05, "real time: 50 frames of 20 ms", transform=axes[0].get_yaxis_transform(), ha="right",
                 fontsize=8, color="#555555")
    axes[0].text(1.0, 0.02, " 1 mm", transform=axes[0].get_xaxis_transform(), fontsize=8, color="#555555")
    axes[0].set_ylabel("CPU s a simulated s")
    axes[1].set_ylabel("spring evaluations a simulated s")
    for axis in axes:
        axis.set_xlabel("greatest error of a node [mm]")
        axis.legend(loc="best")
        _plain(axis)
    figure.suptitle(title + ("   (crosses: refused or blown up)" if bad else ""))
    _save(figure, path)


def orders(path, panels):
    """Error against step with slopes 4, 2, 1: panels are (title, rows)."""
    figure, axes = plt.subplots(1, len(panels), figsize=(WIDE, 5.2), squeeze=False)
    for axis, (title, rows) in zip(axes[0], panels):
        good = [r for r in rows if r["status"] == "ok" and r.get("error_mm")]
        for key, line in _lines(good).items():
            axis.plot([1e3 * r["step_s"] for r in line], [r["error_mm"] for r in line], label=_label(*key),
                      **_style(*key))
        axis.set_xscale("log")
        axis.set_yscale("log")
        if good:
            right = max(1e3 * r["step_s"] for r in good)
            top, low = max(r["error_mm"] for r in good), min(r["error_mm"] for r in good)
            for slope in (4, 2, 1):
                h = [right, max(right * (low / top) ** (1 / slope), min(1e3 * r["step_s"] for r in good))]
                axis.plot(h, [3 * top, 3 * top * (h[1] / h[0]) ** slope], color="#999999", linewidth=0.8,
                          linestyle="-.")
                axis.annotate(f"{slope}", (h[1], 3 * top * (h[1] / h[0]) ** slope), fontsize=9, color="#666666")
        axis.set_title(title)
        axis.set_xlabel("step [ms]")
        _plain(axis)
    axes[0][0].set_ylabel("greatest error of a node [mm]")
    axes[0][0].legend(loc="lower right")
    _save(figure, path)


def _bars(axis, title, label, lines):
    """Horizontal bars, one group a name."""
    for number, (name, (names, values)) in enumerate(lines.items()):
        axis.barh([i + 0.4 * number for i in range(len(names))], values, height=0.38, label=name)
        for i, value in enumerate(values):
            axis.text(value, i + 0.4 * number, f" {value:.0f}", va="center", fontsize=8)
    axis.set_yticks([i + 0.2 for i in range(len(names))], names, fontsize=9)
    axis.invert_yaxis()
    axis.set_title(title)
    axis.set_xlabel(label)
    axis.legend(loc="lower right")


def curves(path, panels, size=(WIDE, 5.2)):
    """Plain panels: (title, x label, y label, {label: (x, y)}, options with xlog, ylog, lines)."""
    figure, axes = plt.subplots(1, len(panels), figsize=size, squeeze=False)
    for axis, (title, x_label, y_label, lines, options) in zip(axes[0], panels):
        if options.get("bars"):
            _bars(axis, title, x_label, lines)
            continue
        for number, (label, (x, y)) in enumerate(lines.items()):
            axis.plot(x, y, label=label, marker="os^vDP*"[number % 7], **options.get("styles", {}).get(label, {}))
        axis.set_xscale("log" if options.get("xlog", True) else "linear")
        axis.set_yscale("log" if options.get("ylog", True) else "linear")
        for value, name in options.get("across", ()):
            axis.axhline(value, color="#888888", linestyle="--", linewidth=1)
            axis.text(0.99, value, name, transform=axis.get_yaxis_transform(), ha="right", va="bottom", fontsize=8)
        for value, name in options.get("upright", ()):
            axis.axvline(value, color="#888888", linestyle=":", linewidth=1)
            axis.text(value, 0.02, " " + name, transform=axis.get_xaxis_transform(), fontsize=8, rotation=90,
                      va="bottom")
        axis.set_title(title, fontsize=9 if options.get("small_title") else 12)
        axis.set_xlabel(x_label)
        axis.set_ylabel(y_label)
        axis.legend(loc=options.get("legend", "best"))
        _plain(axis)
    _save(figure, path)
