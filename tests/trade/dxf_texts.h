/*
 * dxf_texts.h: DXF files of the trade's dialects, as small texts.
 */
#ifndef MUS_TESTS_DXF_TEXTS_H
#define MUS_TESTS_DXF_TEXTS_H

#define DXF_VERTEX(x, y) "0\nVERTEX\n8\n1\n10\n" x "\n20\n" y "\n"
#define DXF_CHAIN(a, b, c, d) "0\nPOLYLINE\n8\n1\n66\n1\n70\n0\n" DXF_VERTEX(a, b) DXF_VERTEX(c, d) "0\nSEQEND\n"
#define DXF_TEXT(layer, x, y, text) "0\nTEXT\n8\n" layer "\n10\n" x "\n20\n" y "\n40\n1\n1\n" text "\n"
/* half a front, w inches wide and 10 long, on the fold at x = 0; four open polylines in any order and direction */
#define DXF_HALF(name, size, w)                                                                                      \
    "0\nBLOCK\n8\n1\n70\n64\n2\n" name "\n10\n0\n20\n0\n" DXF_TEXT("1", "1", "1", "PIECE NAME: FRONT")               \
    DXF_TEXT("1", "1", "1", "Size: " size) DXF_CHAIN("0", "0", w, "0") DXF_CHAIN(w, "10,0", w, "0,0")               \
    DXF_CHAIN(w, "10", "0", "10") DXF_CHAIN("0", "10", "0", "0") "0\nLINE\n8\n6\n10\n0\n20\n-1\n11\n0\n21\n11\n"      \
    "0\nLINE\n8\n7\n10\n2\n20\n2\n11\n2\n21\n8\n0\nPOINT\n8\n2\n10\n" w "\n20\n0\n0\nPOINT\n8\n4\n10\n" w "\n20\n4\n"  \
    DXF_TEXT("2", w, "0", "# 1") DXF_TEXT("2", w, "10", "# 1") DXF_TEXT("2", "0", "0", "# 2")                        \
    DXF_TEXT("2", "0", "10", "# 2") "0\nPOINT\n8\n13\n10\n1\n20\n5\n" DXF_TEXT("13", "1", "5", "D") "0\nENDBLK\n"

/* as Gerber writes: no tables, nested sizes, inches, decimal commas, an outline of open polylines, a mirror line */
static const char dxf_gerber[] =
    "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" DXF_HALF("FRONT_40", "40", "5,0")
    DXF_HALF("FRONT_42", "42", "6,0") "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" DXF_TEXT("1", "0", "0", "Style Name: VEST")
    DXF_TEXT("1", "0", "0", "SAMPLE SIZE: 40") DXF_TEXT("1", "0", "0", "UNITS: ENGLISH") "0\nENDSEC\n0\nEOF\n";

static const char rul_gerber[] = "ANSI/AAMA VERSION: 1.0.0\r\nUNITS: ENGLISH\r\nSAMPLE SIZE: 40\r\n"
                                 "NUMBER OF SIZES: 3\r\nSIZE LIST: 38 40 42\r\nRULE: DELTA 1\r\n"
                                 "-0.5, 0 0, 0 1.0, 0\r\nRULE: DELTA 2\r\n0, 0 0, 0\r\n0, 0\r\nEND\r\n";

#endif
