/*
 * target_clones.h: one function, compiled for several widths of vector, chosen when the library is loaded.
 *
 * With contraction off every width gives the same bits. Not under sanitizers, whose runtime is not up yet when the
 * choice is made; nor with a C library that cannot choose (musl has no ifunc).
 */
#ifndef MUS_BASE_TARGET_CLONES_H
#define MUS_BASE_TARGET_CLONES_H

#include <stdint.h> /* which C library: __GLIBC__ */

#if defined(__x86_64__) && defined(__linux__) && defined(__GLIBC__) && defined(__GNUC__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(MUS_NO_CLONES)
#if defined(__clang__)
#if __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer) || \
    __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer) || __clang_major__ < 14
#define MUS_CLONES
#else
#define MUS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#else
#define MUS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#else
#define MUS_CLONES
#endif

/* inlined into the cloned function, so that it is compiled for each width */
#define MUS_INLINE inline __attribute__((always_inline))

/* "no two elements of these arrays overlap": the loop may be vectorised without a check */
#if defined(__clang__)
#define MUS_IVDEP _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define MUS_IVDEP _Pragma("GCC ivdep")
#else
#define MUS_IVDEP
#endif

/* the loop of at most eight turns below is written out */
#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 8)
#define MUS_UNROLL _Pragma("GCC unroll 8")
#else
#define MUS_UNROLL
#endif

/* the loop below stays one: it becomes a vector where writing it out would make numbers of it */
#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 8)
#define MUS_ROLLED _Pragma("GCC unroll 1")
#else
#define MUS_ROLLED
#endif

#endif
