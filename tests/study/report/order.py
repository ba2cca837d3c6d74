"""order.py: the order of a scalar or of an error in the spacing, or the word that it has none."""
import math

NONE = "does not converge"


def of_errors(rows):
    """[order beside each row]: of an error against the row before it, with coarser spacing; "" for the first."""
    found, last = [], None
    for r in rows:
        if last is None or not r["error_mm"] or not last["error_mm"]:
            found.append("")
        else:
            slope = math.log(last["error_mm"] / r["error_mm"]) / math.log(last["spacing_mm"] / r["spacing_mm"])
            found.append(f"{slope:.1f}" if slope > 0.5 else NONE)
        last = r
    return found


def of_scalars(spacings, values, spread):
    """What three spacings, each half of the one before, say of a scalar: its order and its value without a mesh
    (Richardson), or why neither can be told. spread: the range over starts, which a difference must exceed."""
    if len(values) < 3:
        return "fewer than three spacings"
    (a, b, c), (x, y, z) = spacings[-3:], values[-3:]
    if not (abs(a / b - 2) < 0.01 and abs(b / c - 2) < 0.01):
        return "spacings not halved"
    if abs(y - z) <= spread:
        return f"moves by {abs(y - z):.2g}, less than starts do ({spread:.2g})"
    ratio = (x - y) / (y - z)
    if ratio <= math.sqrt(2.0):
        return NONE + f" (moves by {abs(x - y):.2g}, then {abs(y - z):.2g})"
    return f"order {math.log2(ratio):.1f}, {z + (z - y) / (ratio - 1):.4g} without a mesh"
