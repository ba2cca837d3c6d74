/*
 * fuzz.h: the fuzz targets: each takes any bytes, makes calls of the library of them, and must come back without a
 * crash, a leak, or a broken promise. `make fuzz SECONDS=n [TARGET=name]` runs them under libFuzzer with ASan and
 * UBSan; `make check` runs the same functions on the seeds of tests/fuzz/seeds and on damaged copies of them.
 */
#ifndef MUS_TESTS_FUZZ_H
#define MUS_TESTS_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "muslin/muslin.h"

/* name, and what the bytes are */
#define FUZZ_TARGETS(X)                                                                                                \
    X(pattern, "a pattern file of any form: read, written, read back, checked, its form")                              \
    X(dxf, "a DXF file, behind its line EOF a RUL file: read in two sizes, its seams proposed")                        \
    X(svg, "an SVG drawing: read, written, read back")                                                                 \
    X(val, "a drawing of Valentina, behind its line </pattern> measurements: without, with, in a size")              \
    X(tape, "a form of tape, and a tape file: read, completed, written, read back")                                    \
    X(fabric, "a fabric file: read, saved, read back")                                                                 \
    X(scan, "an OBJ file: read, and made a body")                                                                      \
    X(drape, "a pattern file: cut, placed, stepped five times")                                                        \
    X(print, "a pattern file: as sheet, PDF, SVG and DXF")                                                             \
    X(catalogue, "a catalogue file: opened, searched, added to")                                                       \
    X(batch, "a list of a batch, and the part of a garment of an earlier run")                                         \
    X(words, "words of a design: spelled, spelled again, drafted")                                                     \
    X(edits, "a design, numbers of edits and of their cells: with undo and redo, and all of them undone")              \
    X(defs, "words of option structs: of fabric, cloth and drape, with some of their words overwritten")               \
    X(options, "words of every other option struct, and numbers of setters")                                           \
    X(calls, "numbers of calls: on contexts, tapes, bodies, patterns, cloths, drapes, any order")                      \
    X(memory, "the number of an allocation that fails, once or from then on, and calls as above")

#define FUZZ_DECLARE(name, what) void fuzz_##name(const uint8_t *bytes, size_t size);
FUZZ_TARGETS(FUZZ_DECLARE)

/* ends the program with the sentence, unless `holds` */
void fuzz_must(bool holds, const char *sentence);

/* a context whose objects may hold 256 MiB together; and its end, which demands that nothing is left */
mus_context *fuzz_context(void);
void fuzz_context_end(mus_context *context);

/* let n allocations pass, then fail the next one (`forever`: all that follow); never again */
void fuzz_fail_after(uint32_t n, bool forever);
void fuzz_fail_never(void);

/* bytes that are taken from the front; zeros after the end */
typedef struct fuzz_input {
    const uint8_t *at;
    size_t left;
} fuzz_input;

uint32_t fuzz_take(fuzz_input *in, int count);             /* a number of `count` bytes, 1 to 4 */
int32_t fuzz_below(fuzz_input *in, int32_t n);             /* -1 .. n, mostly within 0 .. n - 1 */
double fuzz_real(fuzz_input *in, double low, double high); /* mostly within low .. high; else NaN, infinite, huge */

/* overwrites up to three words of a struct, from its byte `from` on: of 4 or 8 bytes, by odd numbers */
void fuzz_spoil(fuzz_input *in, void *def, size_t from, size_t size);

/* a template of mkstemp() and mkdtemp() in the folder TMPDIR, or /tmp; run.sh sets it to one in memory */
#define FUZZ_PATH 128
void fuzz_path(char *template);

/* the pattern in the bytes, or NULL */
mus_pattern *fuzz_pattern_of(mus_context *context, const uint8_t *bytes, size_t size);

#endif
