"""test_catalogue.py: a catalogue from Python: added, found, explained."""
import pytest

import muslin


def tube(width, label=""):
    pattern = muslin.Pattern("tube")
    panel = pattern.add_panel("tube")
    points = [pattern.add_point(panel, x, y) for x, y in ((0, 0), (width, 0), (width, 0.4), (0, 0.4))]
    edges = [pattern.add_edge(points[i], points[(i + 1) % 4]) for i in range(4)]
    pattern.set_outline(panel, edges)
    pattern.add_seam(edges[1], edges[3])
    if label:
        pattern.set_label(edges[0], label)
    return pattern


def test_patterns_are_found_by_how_they_are_sewn(tmp_path):
    path = str(tmp_path / "tubes.db")
    with muslin.Catalogue(path, writable=True) as catalogue:
        with catalogue.together():
            first, second = catalogue.add(tube(0.5), "plain"), catalogue.add(tube(0.5, "hem"), "hemmed")
        with pytest.raises(RuntimeError):
            with catalogue.together():
                catalogue.add(tube(0.7), "lost")
                raise RuntimeError
    with muslin.Catalogue(path) as catalogue:
        assert len(catalogue) == 2
        assert catalogue.exact(tube(0.9)) == [first]
        assert catalogue.containing(tube(0.1)) == [first, second]
        (number, distance, exact), _ = catalogue.nearest(tube(0.6))
        assert number == first and exact and catalogue.name(number) == "plain"
        parts, text = catalogue.explain(tube(0.6), number)
        assert list(parts) == ["pieces", "seams", "surface", "openings", "panels", "cloth"]
        assert sum(parts.values()) == pytest.approx(distance) and "openings: 0.60 0.60 m against 0.50 0.50 m" in text
        with pytest.raises(muslin.MuslinError):
            catalogue.add(tube(0.5), "more")


def test_forms_and_homology_are_the_libraries_own():
    assert tube(0.5).form() == tube(0.8).form() != tube(0.5, "hem").form()
    assert tube(0.5).form(labels=False) == tube(0.5, "hem").form(labels=False)
    homology = tube(0.5).homology()
    assert homology["betti"] == (1, 1, 0) or list(homology["betti"]) == [1, 1, 0]
    assert len(tube(0.5).boundary(1)) == 2 and tube(0.5).homology(sewn=False)["cells"][0] == 4
