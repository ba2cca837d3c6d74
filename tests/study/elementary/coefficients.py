#!/usr/bin/env python3
"""coefficients.py [table]: the constants of lib/base/elementary.c, computed in 300 bits; or tests/base/elementary_table.h.

Polynomials are minimax: Remez exchange (Remez 1934) on the weighted error of the leading terms that elementary.c adds
exactly. Printed: each coefficient as the double next to it, and the error of the polynomial before that rounding.
"""
import random
import sys

from mpmath import mp, mpf, matrix, lu_solve, sin, cos, tan, asin, acos, atan, atan2, atanh, exp, log, pi, sqrt, hypot

mp.prec = 300


def remez(f, weight, low, high, degree):
    """The coefficients of the polynomial that minimises the largest |weight (f - p)| on [low, high], and that error."""
    low, high = mpf(low), mpf(high)
    at = lambda i, n: (low + high) / 2 - (high - low) / 2 * cos(pi * i / n)
    x = [at(i, degree + 1) for i in range(degree + 2)]
    grid = [at(i, 1500) for i in range(1501)]
    for _ in range(12):
        rows, right = matrix(degree + 2, degree + 2), matrix(degree + 2, 1)
        for i, t in enumerate(x):
            for j in range(degree + 1):
                rows[i, j] = t**j
            rows[i, degree + 1] = (-1)**i / weight(t)
            right[i] = f(t)
        c = lu_solve(rows, right)
        error = [weight(t) * (f(t) - sum(c[j] * t**j for j in range(degree + 1))) for t in grid]
        peaks, k = [], 0
        while k < len(grid):  # the largest error of each run of one sign
            best, positive = k, error[k] >= 0
            while k < len(grid) and (error[k] >= 0) == positive:
                best = k if abs(error[k]) > abs(error[best]) else best
                k += 1
            peaks.append(grid[best])
        if len(peaks) != degree + 2:
            break
        x = peaks
    return [c[j] for j in range(degree + 1)], abs(c[degree + 1])


def show(name, result):
    print(f"{name}: error 2^{float(mp.log(result[1], 2)):.1f}")
    for c in result[0]:
        print("   ", float(c).hex())


def show_pair(name, value):
    print(f"{name}: {float(value).hex()} {float(value - mpf(float(value))).hex()}")


def show_parts(name, value, bits):
    parts = []
    for n in bits:
        mantissa, exponent = mp.frexp(value)
        part = mp.floor(mantissa * 2**n) * mpf(2)**(exponent - n) if n < 53 else mpf(float(value))
        parts.append(float(part).hex())
        value -= part
    print(f"{name}:", *parts)


def constants():
    tiny, eighth = mpf(10)**-12, (pi / 4)**2 * mpf("1.0001")
    odd = lambda f: lambda z: (f(sqrt(z)) / sqrt(z) - 1) / z
    show("sin r = r + r z P(z), z = r^2", remez(odd(sin), lambda z: z, tiny, eighth, 6))
    show("cos r = 1 - z / 2 + z^2 P(z)", remez(lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2, lambda z: z * z, tiny, eighth, 5))
    show("atan u = u + u z P(z)", remez(odd(atan), lambda z: z, tiny, mpf("0.0040"), 4))
    show("atanh s = s + s z P(z)", remez(odd(atanh), lambda z: z, tiny, mpf("0.0006"), 4))
    half = log(2) / 2 * mpf("1.0001")
    show("exp r = 1 + r + r^2 P(r)", remez(lambda r: (exp(r) - 1 - r) / r**2 if abs(r) > 1e-20 else mpf(1) / 2,
                                           lambda r: r * r + mpf("0.004"), -half, half, 10))
    show_pair("pi", pi)
    show_pair("pi / 2", pi / 2)
    show_parts("pi / 2 in parts", pi / 2, (33, 33, 33, 53))
    show_parts("ln 2 in parts", log(2), (42, 53))
    print("2 / pi, 1 / ln 2:", float(2 / pi).hex(), float(1 / log(2)).hex())
    for i in range(9):
        show_pair(f"atan {i}/8", atan(mpf(i) / 8))
    for i in range(11, 24):
        show_pair(f"log {i}/16", log(mpf(i) / 16))


def table():
    """Rows of a function's number, its arguments, and its exact value as a double and the rest."""
    draw = random.Random(25)
    wide = lambda low, high: draw.choice((-1, 1)) * 2.0**draw.uniform(low, high)
    one = (("sin", sin, lambda: wide(-20, 19)), ("cos", cos, lambda: wide(-20, 19)), ("tan", tan, lambda: wide(-20, 19)),
           ("asin", asin, lambda: wide(-9, 0)), ("acos", acos, lambda: wide(-9, 0)), ("exp", exp, lambda: wide(-9, 9)),
           ("ln", log, lambda: abs(wide(-900, 900))), ("ln", log, lambda: draw.uniform(0.9, 1.1)))
    two = (("atan2", atan2, lambda: (wide(-9, 9), wide(-9, 9))), ("hypot", hypot, lambda: (wide(-9, 9), wide(-9, 9))),
           ("pow", lambda x, y: x**y, lambda: (abs(wide(-5, 5)), wide(-5, 7))))
    print("/* elementary_table.h: exact values of lib/base/elementary.c's functions, written by\n"
          " * tests/study/elementary/coefficients.py table (mpmath, 300 bits). */")
    for name, f, argument in one:
        for _ in range(6):
            x = argument()
            row(name, x, 0.0, f(mpf(x)))
    for name, f, argument in two:
        for _ in range(6):
            x, y = argument()
            row(name, x, y, f(mpf(x), mpf(y)))


def row(name, x, y, value):
    print(f'{{"{name}", {x.hex()}, {y.hex()}, {float(value).hex()}, {float(value - mpf(float(value))).hex()}}},')


if __name__ == "__main__":
    table() if sys.argv[1:] == ["table"] else constants()
