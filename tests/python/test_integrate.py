"""The integrators with rate functions in Python."""
import math

import pytest

import muslin


def spring(omega):
    return lambda t, y: [y[1], -omega * omega * y[0]]


@pytest.mark.parametrize("method, error", [("rk4", 1e-9), ("verlet", 1e-4), ("euler", 1e-2)])
def test_a_spring_swings_as_the_cosine(method, error):
    y = muslin.integrate(spring(2.0), [1.0, 0.0], 0.005, 200, method=method)
    assert abs(y[0] - math.cos(2.0)) < error and abs(y[1] + 2.0 * math.sin(2.0)) < 2 * error


def test_float_is_that_of_float():
    y = muslin.integrate(spring(1.0), [1.0, 0.0], 0.01, 100, precision=32)
    assert 1e-9 < abs(y[0] - math.cos(1.0)) < 1e-5


def test_time_reaches_the_rate():
    y = muslin.integrate(lambda t, y: [2.0 * t], [0.0], 0.1, 10, start=3.0)
    assert y[0] == pytest.approx(4.0 * 4.0 - 3.0 * 3.0, rel=1e-14)


def test_a_run_that_blows_up_gives_the_last_good_state():
    with pytest.raises(muslin.MuslinError) as caught:
        muslin.integrate(spring(1.0), [1.0, 0.0], 3.0, 1000, energy=lambda t, y: 0.5 * (y[0] ** 2 + y[1] ** 2),
                         guard_every=1)
    assert caught.value.name == "MUS_ERR_DIVERGED" and "energy" in caught.value.text
    assert caught.value.done < 10 and abs(caught.value.state[0]) < 2.0


def test_an_exception_of_the_rate_comes_through_and_ends_the_run():
    calls = []

    def rate(t, y):
        calls.append(t)
        raise KeyError("no such force")

    with pytest.raises(KeyError):
        muslin.integrate(rate, [1.0, 0.0], 0.1, 1000000)
    assert len(calls) == 1


def test_a_rate_of_another_length_is_refused():
    with pytest.raises(ValueError, match="2 numbers, the state 3"):
        muslin.integrate(lambda t, y: [0.0, 0.0], [1.0, 2.0, 3.0], 0.1, 1)


def test_a_bad_step_and_a_bad_method_are_refused():
    with pytest.raises(muslin.MuslinError, match="step is -1"):
        muslin.integrate(spring(1.0), [1.0, 0.0], -1.0, 1)
    with pytest.raises(ValueError, match="rk4"):
        muslin.integrate(spring(1.0), [1.0, 0.0], 1.0, 1, method="magic")

