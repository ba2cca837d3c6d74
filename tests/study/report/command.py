"""command.py: the way that users go: one call dresses a body (mus_dress, `muslin dress`), several garments and fabrics.

CPU seconds of the whole call, how it ended, and what the settle says of itself: rest_distance, how far its farthest
node is expected still to go. Beside it stands how far that node is from the shape that Newton's method finds from there
(newton.py), where the factors prove a minimum: an estimate below the truth is a fault of the estimate.
"""
import numpy as np

import garment
import measure
import muslin
import newton

PLAN = [("tshirt", "jersey"), ("tshirt", "cotton"), ("skirt", "jersey"), ("skirt", "denim"),
        ("full_skirt_midi", "jersey"), ("shirt", "cotton"), ("jeans", "denim"), ("leggings", "jersey")]
NEWTON_MOST = 6000  # nodes: Newton's factors of more take minutes


def dressed(plan=PLAN, spacing=0.02, self_contact=0):
    tape = muslin.Tape.read(garment.TAPE)
    body, rows = muslin.Body(tape), []
    for design, fabric in plan:
        rows += one(design, fabric, muslin.draft(design, tape), body, spacing, self_contact)
    return rows


def one(design, fabric, pattern, body, spacing, self_contact):
    made = {}

    def run():
        made["it"] = muslin.dress(pattern, body, fabric, strict=False, spacing=spacing, self_contact=self_contact)

    taken = measure.seconds_of(run, most=1)
    end = made["it"]
    line = dict(scene=f"{design}, {fabric}", error="rest", variant="mus_dress", precision=32, contact="on", threads=1,
                spacing_mm=1e3 * spacing, status="ok" if end.status == "MUS_OK" else end.status)
    if end.drape is None:
        return [measure.row(**line, quantity="dressed", note=end.reason.text, **taken)]
    report = end.drape.report
    line.update(nodes=len(end.drape))
    rows = [measure.row(**line, quantity="dressed", value=report["residual"], exact=0.0, **taken,
                        note=f"{len(end.starts)} starts; strain at most {100 * report['max_strain']:.2g} %",
                        steps=report["steps"], spring_evaluations=report["spring_evaluations"],
                        contact_queries=report["contact_queries"])]
    if end.status == "MUS_OK" and len(end.drape) <= NEWTON_MOST:
        rows.append(judged(end, fabric, body, line))
    return rows


def judged(end, fabric, body, line):
    """The settle's estimate beside the distance to the nearest minimum, as Newton's method finds it."""
    drape = muslin.Drape(end.cloth, body, precision=64)
    drape.place()
    drape.warm(end.drape)
    said = 1e3 * end.drape.report["rest_distance"]
    line = dict(line, quantity="rest_distance [mm] beside Newton's", exact=said)
    try:
        places, how = newton.rest(drape, end.cloth, np.array(drape.positions), body=body,
                                  friction=muslin.Fabric(fabric).values()["friction"])
    except (muslin.MuslinError, np.linalg.LinAlgError) as error:
        return measure.row(**{**line, "status": "no minimum", "note": str(error)})
    far = measure.distance(np.array(end.drape.positions)[None], places[None])
    return measure.row(**{**line, "status": how["status"], "note": how["note"]}, value=far["error_mm"],
                       error_mm=far["error_mm"], error_rms_mm=far["error_rms_mm"], cpu_s=how["cpu_s"])
