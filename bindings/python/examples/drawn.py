"""A skirt that is drawn here, not drafted: two panels, two seams, a waist that is held."""
from __future__ import annotations

import muslin


def panel(pattern: muslin.Pattern, name: str, waist: float, hem: float, length: float) -> dict[str, int]:
    """A trapezium, the waist up; its edges by name."""
    number = pattern.add_panel(name)
    corners = [(-hem / 2, 0.0), (hem / 2, 0.0), (waist / 2, length), (-waist / 2, length)]
    points = [pattern.add_point(number, x, y) for x, y in corners]
    names = ("hem", "left", "waist", "right")
    edges = {name: pattern.add_edge(points[i], points[(i + 1) % 4], name=name) for i, name in enumerate(names)}
    pattern.set_outline(number, list(edges.values()))
    for label in ("hem", "waist"):
        pattern.set_label(edges[label], label)
    pattern.set_hold(edges["waist"], "waist")
    return edges


def main() -> None:
    body = muslin.Body("W40")
    skirt = muslin.Pattern("drawn skirt")
    front, back = (panel(skirt, name, 0.42, 0.62, 0.6) for name in ("front", "back"))
    skirt.set_sides(skirt.panel("front"), "front")
    skirt.set_sides(skirt.panel("back"), "back")
    # seen from outside, the right edge of the front lies at the left edge of the back
    skirt.add_seam(front["left"], back["right"])
    skirt.add_seam(front["right"], back["left"])
    for label in ("waist", "hem"):
        skirt.add_opening(label)
    muslin.arrange(skirt, body)
    dressed = muslin.dress(skirt, body, spacing=0.025)
    print(dressed.status, {level["level"]: round(level["garment"], 3) for level in dressed.fit().levels})


if __name__ == "__main__":
    main()
