"""Poses and movements from Python: names, angles, posed bodies, errors."""
import math

import pytest

import muslin


def test_named_poses_and_movements_are_listed():
    assert {"a", "t", "sit", "squat", "bend"} <= set(muslin.poses()) and len(muslin.poses()) >= 12
    assert {"walk", "arm_raise", "sit_down"} <= set(muslin.moves())


def test_a_pose_is_read_and_written_by_joint():
    pose = muslin.Pose("sit")
    assert pose["knee_left"] == (pytest.approx(math.pi / 2), 0.0, 0.0)
    pose["knee_left"] = (1.0, 0.0, 0.0)
    pose.place = (0.0, 0.5, 0.0)
    assert pose["knee_left"] == (1.0, 0.0, 0.0) and pose.place == (0.0, 0.5, 0.0)
    assert muslin.Pose(neck=(0.1, 0.2, 0.3))["neck"] == (0.1, 0.2, 0.3)
    assert muslin.joint_limits("knee_left")[0] == (0.0, pytest.approx(math.radians(135)))


def test_what_joints_do_not_do_is_refused_by_name():
    with pytest.raises(muslin.MuslinError, match="elbow_right flexion is -57"):
        muslin.Pose(elbow_right=(-1.0, 0.0, 0.0)).check()
    with pytest.raises(muslin.MuslinError, match="fly"):
        muslin.Pose("fly")
    with pytest.raises(muslin.MuslinError, match="crawl"):
        muslin.Move("crawl")
    with pytest.raises(ValueError):
        muslin.Move([0.0, 1.0], [muslin.Pose()])


def test_a_posed_body_keeps_its_measures():
    body = muslin.Body(muslin.Tape.size("W40"))
    rest = body.landmark("crown")
    sitting = body.posed(body.fit(muslin.Pose("sit")))
    assert sitting.made == body.made and sitting.volume == pytest.approx(body.volume)
    assert sitting.landmark("crown")[1] < rest[1] - 0.3
    assert min(row[1] for row in sitting.vertices.tolist()) == pytest.approx(0.0, abs=2e-3)
    assert sitting.stance["hip_left"] == muslin.Pose("sit")["hip_left"]
    walk = body.move("walk")
    assert walk.period == pytest.approx(muslin.Move("walk", stature=1.68).period)
    assert body.stance["shoulder_left"] == body.rest_pose["shoulder_left"]


def test_both_feet_of_a_lunge_stand():
    body = muslin.Body(muslin.Tape.size("W40"))
    lunge = muslin.Pose("lunge")
    assert lunge.feet == muslin.FOOT_LEFT | muslin.FOOT_RIGHT and muslin.Pose("knee_up").feet == muslin.FOOT_RIGHT
    rest, posed = body.vertices.tolist(), body.posed(body.fit(lunge)).vertices.tolist()
    for side in (1.0, -1.0):
        foot = [now[1] for was, now in zip(rest, posed) if was[1] < 0.06 and side * was[0] > 0.0]
        assert min(foot) == pytest.approx(0.0, abs=1e-4)
    apart = muslin.Pose(hip_left=(1.5, 0.0, 0.0))
    apart.feet = muslin.FOOT_LEFT | muslin.FOOT_RIGHT
    with pytest.raises(muslin.MuslinError, match="do not reach the floor together"):
        body.fit(apart)


def test_a_walk_is_periodic():
    walk = muslin.Move("walk", stature=1.68)
    assert walk.period == walk.duration > 0.8
    assert walk.at(0.2)["knee_left"] == pytest.approx(walk.at(0.2 + walk.period)["knee_left"])
    assert walk.at(0.2)["knee_left"] == pytest.approx(walk.at(0.2 + walk.period / 2)["knee_right"])


def test_a_movement_of_keys():
    nod = muslin.Move([0.0, 1.0, 2.0], [muslin.Pose(), muslin.Pose(neck=(0.4, 0.0, 0.0)), muslin.Pose()])
    assert nod.period == 0.0 and nod.duration == 2.0
    # the natural spline through (0,0), (1,1), (2,0) has S(0.5) = 0.6875
    assert nod.at(0.5)["neck"][0] == pytest.approx(0.4 * 0.6875)
    assert nod.at(9.0)["neck"] == (0.0, 0.0, 0.0)
