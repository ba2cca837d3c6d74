/*
 * ieee.h: refuses a compiler that was told to be loose with numbers. The library tells broken numbers from good ones by
 * NaN and infinity, splits numbers into exact parts (geom/predicate.c), and promises the same bits from every compiler.
 */
#ifndef MUS_BASE_IEEE_H
#define MUS_BASE_IEEE_H

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error "muslin needs the arithmetic of IEEE 754: build it without -ffast-math, -Ofast and what they stand for"
#endif

/* the x87 unit of 32-bit x86 rounds each result twice: exact parts are not exact, and meshes come out otherwise */
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "muslin needs the arithmetic of IEEE 754: build it for 32-bit x86 with -msse2 -mfpmath=sse"
#endif

/* gcc 12 fuses products and sums of neighbours to vfmaddsub, also with -ffp-contract=off: other last digits */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__FP_FAST_FMA)
#error "muslin needs the arithmetic of IEEE 754: build it with -mno-fma -mno-fma4 -mno-avx512f"
#endif

#endif
