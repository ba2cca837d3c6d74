/*
 * muslin/base.h: the ground that every other header stands on.
 *
 * Version, export macro, the list of statuses, and the context that carries the allocator, the log hook and the text
 * of the last error. Everything is made from a context; there is no global state. Units are SI everywhere: metre,
 * kilogram, second, radian. Frame: X to the wearer's left, Y up, Z forward, floor at Y = 0.
 *
 * Threads: one context, and all objects made from it, on one thread at a time; two contexts are independent.
 */
#ifndef MUSLIN_BASE_H
#define MUSLIN_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MUS_VERSION_MAJOR 0
#define MUS_VERSION_MINOR 2
#define MUS_VERSION_PATCH 0

/* Number of the binary interface: the soname of each library ends in it. It rises by one when a program that was
 * linked before cannot run with the library any more; functions and fields that are only added leave it as it is. */
#define MUS_ABI 1

#if defined(_WIN32)
#define MUS_API
#elif defined(__GNUC__)
#define MUS_API __attribute__((visibility("default")))
#else
#define MUS_API
#endif

/* "no such element": the index that stands for none. */
#define MUS_NONE (-1)

/* What a function that can fail returns. 0 is success; numbers are never reused. */
typedef int32_t mus_status;

/* X(number, name, sentence) */
#define MUS_STATUS_LIST(X)                                                        \
    X(0, OK, "done")                                                              \
    X(1, ERR_ARG, "an argument is outside its range")                             \
    X(2, ERR_MEMORY, "the allocator returned nothing")                            \
    X(3, ERR_VERSION, "a struct has a size that no release of the library had")   \
    X(4, ERR_STATE, "the call does not fit the state of the object")              \
    X(5, ERR_LIMIT, "a count or size is above what the library takes")            \
    X(6, ERR_FILE, "a file cannot be opened, read or written")                    \
    X(7, ERR_FORMAT, "a file is not what its format says")                        \
    X(8, ERR_UNSUPPORTED, "the request is known but not supported")               \
    X(9, ERR_TAPE, "measures are missing, out of range or contradict each other") \
    X(10, ERR_BODY, "no body can be made of these measures")                      \
    X(11, ERR_PATTERN, "the pattern is faulty")                                   \
    X(12, ERR_DESIGN, "the design cannot be drafted for these measures")          \
    X(13, ERR_MESH, "a panel cannot be meshed")                                   \
    X(14, ERR_STEP, "the time step is above the stability bound")                 \
    X(15, ERR_DIVERGED, "the motion diverged; the last good state is kept")       \
    X(16, ERR_SEW, "a seam cannot be closed")                                     \
    X(17, ERR_UNSETTLED, "rest was not reached within the budget")                \
    X(18, ERR_TANGLED, "cloth goes through cloth")                                \
    X(19, ERR_STOPPED, "the caller's progress function stopped the run")

#define MUS_STATUS_NAME(number, name, text) MUS_##name = number,
enum { MUS_STATUS_LIST(MUS_STATUS_NAME) MUS_STATUS_COUNT };
#undef MUS_STATUS_NAME

/** Name of a status ("MUS_ERR_ARG"), or "MUS_ERR_UNKNOWN". Static text. */
MUS_API const char *mus_status_name(mus_status status);

/** One sentence for a status. Static text. */
MUS_API const char *mus_status_text(mus_status status);

/** Version of the library that runs: `version` (3) gets major, minor, patch. */
MUS_API void mus_version(int32_t *version);

/** Levels of a log line. */
#define MUS_LOG_ERROR 0
#define MUS_LOG_WARNING 1
#define MUS_LOG_INFO 2

/**
 * The allocator hook, shaped like realloc.
 *
 * new_size 0 frees `ptr` (and returns NULL); ptr NULL allocates; otherwise the block grows or shrinks, keeping its
 * bytes. Blocks are aligned for any type. Returns NULL when there is no memory; the old block is then untouched.
 */
typedef void *(*mus_alloc_fn)(void *user, void *ptr, size_t old_size, size_t new_size);

/** The log hook: one line of UTF-8 text without a line end. */
typedef void (*mus_log_fn)(void *user, int32_t level, const char *text);

/* The allocator, the log hook and the text of the last error, for all objects that are made from it. */
typedef struct mus_context mus_context;

/** Options of a context. */
typedef struct mus_context_def {
    size_t size;        /* set by mus_context_def_init */
    mus_alloc_fn alloc; /* default NULL: malloc, realloc, free */
    void *alloc_user;   /* handed to alloc */
    mus_log_fn log;     /* default NULL: nothing is logged */
    void *log_user;     /* handed to log */
} mus_context_def;

/** Zero `def`, write the defaults and its size. `size` is sizeof(mus_context_def) of the caller. */
MUS_API void mus_context_def_init(mus_context_def *def, size_t size);

/**
 * Make a context.
 *
 * `def` may be NULL (all defaults). A def of an earlier release, which is shorter, is taken.
 * Errors:  MUS_ERR_ARG (out NULL); MUS_ERR_VERSION (size); MUS_ERR_MEMORY. *out is NULL after a failure
 * Memory:  one block from the allocator of `def`
 */
MUS_API mus_status mus_context_create(const mus_context_def *def, mus_context **out);

/** Free a context. All objects made from it must be gone. NULL is accepted. */
MUS_API void mus_context_destroy(mus_context *context);

/** Text of the last failure of this context, "" if none. Valid until the next call that fails. */
MUS_API const char *mus_context_error(const mus_context *context);

/** Bytes that objects of this context hold now (without the context itself). */
MUS_API size_t mus_context_bytes(const mus_context *context);

/** Allocations made through this context since it was made: the tests' proof that a step allocates nothing. */
MUS_API uint64_t mus_context_allocations(const mus_context *context);

/*
 * For libraries that stand beside libmuslin (print, exchange, a host's own readers): they fail, allocate and log
 * through the same context.
 */

/** Set the context's error text (copied, cut at 511 bytes) and return `status`. NULL context: just `status`. */
MUS_API mus_status mus_context_fail(mus_context *context, mus_status status, const char *text);

/** Memory through the context's allocator, counted in mus_context_bytes(): `ptr` NULL allocates `new_size` bytes,
 * new_size 0 frees, otherwise the block grows or shrinks keeping its bytes. New bytes are zero. NULL without memory
 * (the old block is then untouched). */
MUS_API void *mus_context_alloc(mus_context *context, void *ptr, size_t new_size);

/** One line to the context's log hook. */
MUS_API void mus_context_log(mus_context *context, int32_t level, const char *text);

#ifdef __cplusplus
}
#endif

#endif
