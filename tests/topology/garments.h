/*
 * garments.h: sewn garments as words and seams, with the answers of two independent programs.
 *
 * A panel is a cyclic word of edge names ("h0-": passed against its direction); a seam joins the end of one edge to the
 * start of the other, "direct" start to start. The first part of the table comes from a Python program
 * by union-find and walking, the rows "1f" from another by Smith normal form over the integers; the betti numbers of
 * all rows are of a third program, elimination over the rationals in Python. MUS_NONE stands for what a surface with
 * three sheets at an edge does not have.
 */
#ifndef MUS_TESTS_GARMENTS_H
#define MUS_TESTS_GARMENTS_H

#include <stddef.h>
#include <stdint.h>

typedef struct garment {
    const char *name, *panels, *seams;
    int32_t vertices, edges, faces, euler, components, loops, orientable, manifold, genus, betti1, betti2;
    const char *rims; /* the edges of each loop in order, NULL where the source has no list */
} garment;

/* clang-format off */
static const garment garments[] = {
    {"paper fig.8: body + sleeve",
     "A: a1 a2 a3 a4 a5 a6; B: b1 b2 b3 b4 b5",
     "A.a5 B.b5",
     9, 10, 2, 1, 1, 1, 1, 1, 0, 0, 0,
     "A.a1 A.a2 A.a3 A.a4 B.b1 B.b2 B.b3 B.b4 A.a6"},
    {"one panel (disc)",
     "A: a b c d",
     "",
     4, 4, 1, 1, 1, 1, 1, 1, 0, 0, 0,
     "A.a A.b A.c A.d"},
    {"one panel, one dart at the edge",
     "A: w1 d1 d2 w2 r h l",
     "A.d1 A.d2",
     6, 6, 1, 1, 1, 1, 1, 1, 0, 0, 0,
     "A.w1 A.w2 A.r A.h A.l"},
    {"tube (sleeve)",
     "A: hem u1 cap u2",
     "A.u1 A.u2",
     2, 3, 1, 0, 1, 2, 1, 1, 0, 1, 0,
     "A.hem | A.cap"},
    {"T-shirt",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL; SL: hem underB "
     "capB capF underF; SR: hem underF capF capB underB",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; F.armR "
     "SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB",
     10, 16, 4, -2, 1, 4, 1, 1, 0, 3, 0,
     "F.hem B.hem | F.neck B.neck | SL.hem | SR.hem"},
    {"trousers",
     "FL: waist crotch inseam hem out; BR: waist crotch inseam hem out; FR: waist out hem inseam crotch; "
     "BL: waist out hem inseam crotch",
     "FL.out BL.out; FL.inseam BL.inseam; FR.out BR.out; FR.inseam BR.inseam; FL.crotch FR.crotch; "
     "BL.crotch BR.crotch",
     9, 14, 4, -1, 1, 3, 1, 1, 0, 2, 0,
     "FL.waist FR.waist BR.waist BL.waist | FL.hem BL.hem | BR.hem FR.hem"},
    {"trousers, 1 dart per piece",
     "FL: w1 d1 d2 w2 crotch inseam hem out; BR: w1 d1 d2 w2 crotch inseam hem out; FR: w1 d1 d2 w2 out "
     "hem inseam crotch; BL: w1 d1 d2 w2 out hem inseam crotch",
     "FL.out BL.out; FL.inseam BL.inseam; FR.out BR.out; FR.inseam BR.inseam; FL.crotch FR.crotch; "
     "BL.crotch BR.crotch; FL.d1 FL.d2; BR.d1 BR.d2; FR.d1 FR.d2; BL.d1 BL.d2",
     17, 22, 4, -1, 1, 3, 1, 1, 0, 2, 0,
     "FL.w1 FL.w2 FR.w1 FR.w2 BR.w1 BR.w2 BL.w1 BL.w2 | FL.hem BL.hem | BR.hem FR.hem"},
    {"trousers, fly open",
     "FL: waist fly crotch inseam hem out; BR: waist crotch inseam hem out; FR: waist out hem inseam "
     "crotch fly; BL: waist out hem inseam crotch",
     "FL.out BL.out; FL.inseam BL.inseam; FR.out BR.out; FR.inseam BR.inseam; FL.crotch FR.crotch; "
     "BL.crotch BR.crotch",
     11, 16, 4, -1, 1, 3, 1, 1, 0, 2, 0,
     "FL.waist FL.fly FR.fly FR.waist BR.waist BL.waist | FL.hem BL.hem | BR.hem FR.hem"},
    {"skirt, 2 panels",
     "G0: hem right w0 left; G1: hem right w0 left",
     "G0.right G1.left; G1.right G0.left",
     4, 6, 2, 0, 1, 2, 1, 1, 0, 1, 0,
     "G0.hem G1.hem | G0.w0 G1.w0"},
    {"skirt, 2 panels, 2 darts each",
     "G0: hem right w0 a0 b0 w1 a1 b1 w2 left; G1: hem right w0 a0 b0 w1 a1 b1 w2 left",
     "G0.a0 G0.b0; G0.a1 G0.b1; G1.a0 G1.b0; G1.a1 G1.b1; G0.right G1.left; G1.right G0.left",
     12, 14, 2, 0, 1, 2, 1, 1, 0, 1, 0,
     "G0.hem G1.hem | G0.w0 G0.w1 G0.w2 G1.w0 G1.w1 G1.w2"},
    {"skirt, 6 gores",
     "G0: hem right w0 left; G1: hem right w0 left; G2: hem right w0 left; G3: hem right w0 left; G4: hem "
     "right w0 left; G5: hem right w0 left",
     "G0.right G1.left; G1.right G2.left; G2.right G3.left; G3.right G4.left; G4.right G5.left; G5.right "
     "G0.left",
     12, 18, 6, 0, 1, 2, 1, 1, 0, 1, 0,
     "G0.hem G1.hem G2.hem G3.hem G4.hem G5.hem | G0.w0 G5.w0 G4.w0 G3.w0 G2.w0 G1.w0"},
    {"wrap skirt (3 panels, open)",
     "G0: hem right w0 left; G1: hem right w0 left; G2: hem right w0 left",
     "G0.right G1.left; G1.right G2.left",
     8, 10, 3, 1, 1, 1, 1, 1, 0, 0, 0,
     "G0.hem G1.hem G2.hem G2.right G2.w0 G1.w0 G0.w0 G0.left"},
    {"circle skirt, 1 panel 1 seam",
     "A: waist cb1 hem cb2",
     "A.cb1 A.cb2",
     2, 3, 1, 0, 1, 2, 1, 1, 0, 1, 0,
     "A.waist | A.hem"},
    {"bodice with darts, closed",
     "FL: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; BR: cb w1 wd1 wd2 w2 side1 side2 arm sh neck; "
     "FR: neck sh arm side2 bd2 bd1 side1 w2 wd2 wd1 w1 cf; BL: neck sh arm side2 side1 w2 wd2 wd1 w1 cb",
     "FL.side1 BL.side1; FL.side2 BL.side2; FL.bd1 FL.bd2; FL.wd1 FL.wd2; BL.wd1 BL.wd2; FL.sh BL.sh; "
     "FR.side1 BR.side1; FR.side2 BR.side2; FR.bd1 FR.bd2; FR.wd1 FR.wd2; BR.wd1 BR.wd2; FR.sh BR.sh; "
     "BL.cb BR.cb; FL.cf FR.cf",
     24, 30, 4, -2, 1, 4, 1, 1, 0, 3, 0,
     "FL.w1 FL.w2 BL.w2 BL.w1 BR.w1 BR.w2 FR.w2 FR.w1 | FL.arm BL.arm | FL.neck FR.neck BR.neck BL.neck | "
     "BR.arm FR.arm"},
    {"bodice no darts, closed",
     "FL: cf w1 side arm sh neck; BR: cb w1 side arm sh neck; FR: neck sh arm side w1 cf; BL: neck sh arm "
     "side w1 cb",
     "FL.side BL.side; FL.sh BL.sh; FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FL.cf FR.cf",
     12, 18, 4, -2, 1, 4, 1, 1, 0, 3, 0,
     "FL.w1 BL.w1 BR.w1 FR.w1 | FL.arm BL.arm | FL.neck FR.neck BR.neck BL.neck | BR.arm FR.arm"},
    {"bodice with darts, open front",
     "FL: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; BR: cb w1 wd1 wd2 w2 side1 side2 arm sh neck; "
     "FR: neck sh arm side2 bd2 bd1 side1 w2 wd2 wd1 w1 cf; BL: neck sh arm side2 side1 w2 wd2 wd1 w1 cb",
     "FL.side1 BL.side1; FL.side2 BL.side2; FL.bd1 FL.bd2; FL.wd1 FL.wd2; BL.wd1 BL.wd2; FL.sh BL.sh; "
     "FR.side1 BR.side1; FR.side2 BR.side2; FR.bd1 FR.bd2; FR.wd1 FR.wd2; BR.wd1 BR.wd2; FR.sh BR.sh; "
     "BL.cb BR.cb",
     26, 31, 4, -1, 1, 3, 1, 1, 0, 2, 0,
     "FL.cf FL.w1 FL.w2 BL.w2 BL.w1 BR.w1 BR.w2 FR.w2 FR.w1 FR.cf FR.neck BR.neck BL.neck FL.neck | FL.arm "
     "BL.arm | BR.arm FR.arm"},
    {"sleeveless dress (bodice+skirt)",
     "FL: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; BR: cb w1 wd1 wd2 w2 side1 side2 arm sh neck; "
     "FR: neck sh arm side2 bd2 bd1 side1 w2 wd2 wd1 w1 cf; BL: neck sh arm side2 side1 w2 wd2 wd1 w1 cb; "
     "sF: hem sideL wL2 a2 b2 wL1 wR1 a1 b1 wR2 sideR; sB: hem sideR wR2 a1 b1 wR1 wL1 a2 b2 wL2 sideL",
     "FL.side1 BL.side1; FL.side2 BL.side2; FL.bd1 FL.bd2; FL.wd1 FL.wd2; BL.wd1 BL.wd2; FL.sh BL.sh; "
     "FR.side1 BR.side1; FR.side2 BR.side2; FR.bd1 FR.bd2; FR.wd1 FR.wd2; BR.wd1 BR.wd2; FR.sh BR.sh; "
     "BL.cb BR.cb; FL.cf FR.cf; sF.sideL sB.sideL; sF.sideR sB.sideR; sF.a1 sF.b1; sF.a2 sF.b2; sB.a1 "
     "sB.b1; sB.a2 sB.b2; FL.w1 sF.wL1; FL.w2 sF.wL2; FR.w1 sF.wR1; FR.w2 sF.wR2; BL.w1 sB.wL1; BL.w2 "
     "sB.wL2; BR.w1 sB.wR1; BR.w2 sB.wR2",
     30, 38, 6, -2, 1, 4, 1, 1, 0, 3, 0,
     "FL.arm BL.arm | FL.neck FR.neck BR.neck BL.neck | BR.arm FR.arm | sF.hem sB.hem"},
    {"sleeveless jumpsuit",
     "FL: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; BR: cb w1 wd1 wd2 w2 side1 side2 arm sh neck; "
     "FR: neck sh arm side2 bd2 bd1 side1 w2 wd2 wd1 w1 cf; BL: neck sh arm side2 side1 w2 wd2 wd1 w1 cb; "
     "sFL: w1 d1 d2 w2 crotch inseam hem out; sBR: w1 d1 d2 w2 crotch inseam hem out; sFR: w1 d1 d2 w2 out "
     "hem inseam crotch; sBL: w1 d1 d2 w2 out hem inseam crotch",
     "FL.side1 BL.side1; FL.side2 BL.side2; FL.bd1 FL.bd2; FL.wd1 FL.wd2; BL.wd1 BL.wd2; FL.sh BL.sh; "
     "FR.side1 BR.side1; FR.side2 BR.side2; FR.bd1 FR.bd2; FR.wd1 FR.wd2; BR.wd1 BR.wd2; FR.sh BR.sh; "
     "BL.cb BR.cb; FL.cf FR.cf; sFL.out sBL.out; sFL.inseam sBL.inseam; sFR.out sBR.out; sFR.inseam "
     "sBR.inseam; sFL.crotch sFR.crotch; sBL.crotch sBR.crotch; sFL.d1 sFL.d2; sBR.d1 sBR.d2; sFR.d1 "
     "sFR.d2; sBL.d1 sBL.d2; FL.w2 sFL.w1; FL.w1 sFL.w2; FR.w1 sFR.w1; FR.w2 sFR.w2; BL.w1 sBL.w1; BL.w2 "
     "sBL.w2; BR.w2 sBR.w1; BR.w1 sBR.w2",
     33, 44, 8, -3, 1, 5, 1, 1, 0, 4, 0,
     "FL.arm BL.arm | FL.neck FR.neck BR.neck BL.neck | BR.arm FR.arm | sFL.hem sBL.hem | sBR.hem sFR.hem"},
    {"T-shirt, front re-cut round a pocket",
     "F: hem sideL armL shL neck shR armR sideR br1 pl pb pr po br2; B: hem sideR armR shR neck shL armL "
     "sideL; SL: hem underB capB capF underF; SR: hem underF capF capB underB; U: o r b l",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; F.armR "
     "SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB; F.br1 F.br2; F.pl U.l; F.pb U.b; "
     "F.pr U.r; F.po U.o",
     14, 21, 5, -2, 1, 4, 1, 1, 0, 3, 0,
     NULL},
    {"T-shirt + patch pocket (3 sides)",
     "F: hem sideL armL shL neck shR armR sideR br1 pl pb pr po br2; B: hem sideR armR shR neck shL armL "
     "sideL; SL: hem underB capB capF underF; SR: hem underF capF capB underB; P: o r b l; U: o r b l",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; F.armR "
     "SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB; F.br1 F.br2; F.pl U.l; F.pb U.b; "
     "F.pr U.r; F.po U.o; P.l U.l direct; P.b U.b direct; P.r U.r direct",
     14, 22, 6, -2, 1, -1, 1, 0, -1, 3, 0,
     NULL},
    {"T-shirt + patch sewn on 4 sides",
     "F: hem sideL armL shL neck shR armR sideR br1 pl pb pr po br2; B: hem sideR armR shR neck shL armL "
     "sideL; SL: hem underB capB capF underF; SR: hem underF capF capB underB; P: o r b l; U: o r b l",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; F.armR "
     "SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB; F.br1 F.br2; F.pl U.l; F.pb U.b; "
     "F.pr U.r; F.po U.o; P.l U.l direct; P.b U.b direct; P.r U.r direct; P.o U.o direct",
     14, 21, 6, -1, 1, -1, 1, 0, -1, 3, 1,
     NULL},
    {"Moebius scarf",
     "A: b e1 t e2",
     "A.e1 A.e2 direct",
     2, 3, 1, 0, 1, 1, 0, 1, -1, 1, 0,
     "A.b A.t"},
    {"sleeveless top + hood",
     "FL: cf w1 side arm sh neck; BR: cb w1 side arm sh neck; FR: neck sh arm side w1 cf; BL: neck sh arm "
     "side w1 cb; HL: nF nB crown face; HR: face crown nB nF",
     "FL.side BL.side; FL.sh BL.sh; FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FL.cf FR.cf; HL.crown "
     "HR.crown; HL.nF FL.neck; HL.nB BL.neck; HR.nF FR.neck; HR.nB BR.neck",
     13, 21, 6, -2, 1, 4, 1, 1, 0, 3, 0,
     "FL.w1 BL.w1 BR.w1 FR.w1 | FL.arm BL.arm | BR.arm FR.arm | HL.face HR.face"},
    {"princess left front (shoulder)",
     "BR: cb w1 side arm sh neck; FR: neck sh arm side w1 cf; BL: neck shc shs arm side w1 cb; FLc: cf w1 "
     "pr shc neck; FLs: pr w2 side arm shs",
     "FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FLc.pr FLs.pr; FLc.cf FR.cf; FLs.side BL.side; FLc.shc "
     "BL.shc; FLs.shs BL.shs",
     14, 21, 5, -2, 1, 4, 1, 1, 0, 3, 0,
     "BR.w1 FR.w1 FLc.w1 FLs.w2 BL.w1 | BR.arm FR.arm | BR.neck BL.neck FLc.neck FR.neck | BL.arm FLs.arm"},
    {"raglan tee",
     "F: hem sideL ragL neck ragR sideR; B: hem sideR ragR neck ragL sideL; SL: hem underB ragB neck ragF "
     "underF; SR: hem underF ragF neck ragB underB",
     "F.sideL B.sideL; F.sideR B.sideR; F.ragL SL.ragF; B.ragL SL.ragB; SL.underF SL.underB; F.ragR "
     "SR.ragF; B.ragR SR.ragB; SR.underF SR.underB",
     10, 16, 4, -2, 1, 4, 1, 1, 0, 3, 0,
     "F.hem B.hem | F.neck SR.neck B.neck SL.neck | SL.hem | SR.hem"},
    {"dolman tee",
     "F: hem sideL underL cuffL overL neck overR cuffR underR sideR; B: hem sideR underR cuffR overR neck "
     "overL cuffL underL sideL",
     "F.sideL B.sideL; F.underL B.underL; F.overL B.overL; F.overR B.overR; F.underR B.underR; F.sideR "
     "B.sideR",
     10, 14, 2, -2, 1, 4, 1, 1, 0, 3, 0,
     "F.hem B.hem | F.cuffL B.cuffL | F.neck B.neck | F.cuffR B.cuffR"},
    {"T-shirt + turtleneck tube",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL; SL: hem underB "
     "capB capF underF; SR: hem underF capF capB underB; T: n1 n2 e1 top e2",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; F.armR "
     "SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB; T.e1 T.e2; T.n1 F.neck; T.n2 "
     "B.neck",
     11, 18, 5, -2, 1, 4, 1, 1, 0, 3, 0,
     "F.hem B.hem | SL.hem | SR.hem | T.top"},
    {"ERROR: hood panels cut mirrored",
     "FL: cf w1 side arm sh neck; BR: cb w1 side arm sh neck; FR: neck sh arm side w1 cf; BL: neck sh arm "
     "side w1 cb; HL: face crown nB nF; HR: nF nB crown face",
     "FL.side BL.side; FL.sh BL.sh; FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FL.cf FR.cf; HL.crown "
     "HR.crown; HL.nF FL.neck; HL.nB BL.neck; HR.nF FR.neck; HR.nB BR.neck",
     11, 21, 6, -4, 1, 4, 1, 1, 1, 5, 0,
     "FL.w1 BL.w1 BR.w1 FR.w1 | FL.arm BL.arm | BR.arm FR.arm | HL.face HR.face"},
    {"ERROR: one sleeve left off",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL; SL: hem underB "
     "capB capF underF",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; "
     "SL.underF SL.underB",
     9, 14, 3, -2, 1, 4, 1, 1, 0, 3, 0,
     "F.hem B.hem | F.neck B.neck | F.armR B.armR | SL.hem"},
    {"ERROR: sleeve not attached",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL; SL: hem underB "
     "capB capF underF; SR: hem underF capF capB underB",
     "F.sideL B.sideL; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; "
     "SL.underF SL.underB; SR.underF SR.underB",
     12, 18, 4, -2, 2, 6, 1, 1, -1, 4, 0,
     "F.hem B.hem | F.neck B.neck | F.armR B.armR | SL.hem | SR.hem | SR.capF SR.capB"},
    {"ERROR: one side seam twisted",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL; SL: hem underB "
     "capB capF underF; SR: hem underF capF capB underB",
     "F.sideL B.sideL direct; F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; "
     "F.armR SR.capF; B.armR SR.capB; SL.underF SL.underB; SR.underF SR.underB",
     9, 16, 4, -3, 1, 4, 0, 1, -1, 4, 0,
     "F.hem B.hem | F.neck B.neck | SL.hem | SR.hem"},
    {"ERROR: inseams sewn F-F, B-B (=maxi skirt)",
     "FL: waist crotch inseam hem out; BR: waist crotch inseam hem out; FR: waist out hem inseam crotch; "
     "BL: waist out hem inseam crotch",
     "FL.out BL.out; FR.out BR.out; FL.crotch FR.crotch; BL.crotch BR.crotch; FL.inseam FR.inseam; "
     "BL.inseam BR.inseam",
     10, 14, 4, 0, 1, 2, 1, 1, 0, 1, 0,
     "FL.waist FR.waist BR.waist BL.waist | FL.hem BL.hem BR.hem FR.hem"},
    {"1f panel hexagon",
     "A: e0 e1 e2 e3 e4 e5",
     "",
     6, 6, 1, 1, 1, 1, 1, 1, 0, 0, 0,
     NULL},
    {"1f paper body+sleeve 1 seam",
     "A: e0 e1 e2 e3 e4 e5; B: e0 e1 e2 e3 e4",
     "A.e4 B.e4",
     9, 10, 2, 1, 1, 1, 1, 1, 0, 0, 0,
     NULL},
    {"1f sleeve (1 panel rolled)",
     "S: e0 e1 e2 e3",
     "S.e0 S.e2",
     2, 3, 1, 0, 1, 2, 1, 1, 0, 1, 0,
     NULL},
    {"1f mobius (twisted)",
     "S: e0 e1 e2 e3",
     "S.e0 S.e2 direct",
     2, 3, 1, 0, 1, 1, 0, 1, -1, 1, 0,
     NULL},
    {"1f skirt 2 panels",
     "F: e0 e1 e2 e3; B: e0 e1 e2 e3",
     "F.e1 B.e3; F.e3 B.e1",
     4, 6, 2, 0, 1, 2, 1, 1, 0, 1, 0,
     NULL},
    {"1f skirt dart sewn",
     "F: e0 e1 e2 e3 e4 e5 e6; B: e0 e1 e2 e3",
     "F.e4 B.e3; F.e6 B.e1; F.e1 F.e2",
     6, 8, 2, 0, 1, 2, 1, 1, 0, 1, 0,
     NULL},
    {"1f skirt dart unsewn",
     "F: e0 e1 e2 e3 e4 e5 e6; B: e0 e1 e2 e3",
     "F.e4 B.e3; F.e6 B.e1",
     7, 9, 2, 0, 1, 2, 1, 1, 0, 1, 0,
     NULL},
    {"1f panel with fisheye dart (hole, unsewn)",
     "F: br h1- h0- br- e0 e1 e2 e3",
     "",
     6, 7, 1, 0, 1, 2, 1, 1, 0, 1, 0,
     NULL},
    {"1f panel with fisheye dart sewn",
     "F: br h1- h0- br- e0 e1 e2 e3",
     "F.h0 F.h1",
     6, 6, 1, 1, 1, 1, 1, 1, 0, 0, 0,
     NULL},
    {"1f sleeveless / T body",
     "F: e0 e1 e2 e3 e4 e5 e6 e7; B: e0 e1 e2 e3 e4 e5 e6 e7",
     "F.e1 B.e7; F.e7 B.e1; F.e3 B.e5; F.e5 B.e3",
     8, 12, 2, -2, 1, 4, 1, 1, 0, 3, 0,
     NULL},
    {"1f T-shirt with sleeves",
     "F: e0 e1 e2 e3 e4 e5 e6 e7; B: e0 e1 e2 e3 e4 e5 e6 e7; SR: e0 e1 e2 e3 e4; SL: e0 e1 e2 e3 e4",
     "F.e1 B.e7; F.e7 B.e1; F.e3 B.e5; F.e5 B.e3; SR.e2 SR.e4; SL.e2 SL.e4; SR.e0 F.e2; SR.e1 B.e6; SL.e0 "
     "B.e2; SL.e1 F.e6",
     10, 16, 4, -2, 1, 4, 1, 1, 0, 3, 0,
     NULL},
    {"1f open-front vest",
     "FR: e0 e1 e2 e3 e4 e5; FL: e0 e1 e2 e3 e4 e5; B: e0 e1 e2 e3 e4 e5 e6 e7",
     "FR.e1 B.e7; FR.e3 B.e5; FL.e1 B.e1; FL.e3 B.e3",
     12, 16, 3, -1, 1, 3, 1, 1, 0, 2, 0,
     NULL},
    {"1f pillow/bag closed",
     "F: e0 e1 e2 e3; B: e0 e1 e2 e3",
     "F.e0 B.e0; F.e1 B.e3; F.e2 B.e2; F.e3 B.e1",
     4, 4, 2, 2, 1, 0, 1, 1, 0, 0, 1,
     NULL},
    {"1f patch pocket on panel",
     "P: br h3- h2- h1- h0- br- e0 e1 e2 e3; I: e0 e1 e2 e3; K: e0 e1 e2 e3",
     "P.h0 I.e0 direct; P.h1 I.e1 direct; P.h2 I.e2 direct; P.h3 I.e3 direct; I.e1 K.e1 direct; I.e2 K.e2 "
     "direct; I.e3 K.e3 direct",
     8, 10, 3, 1, 1, -1, 1, 0, -1, 0, 0,
     NULL},
    {"1f patch sewn all round",
     "P: br h3- h2- h1- h0- br- e0 e1 e2 e3; I: e0 e1 e2 e3; K: e0 e1 e2 e3",
     "P.h0 I.e0 direct; P.h1 I.e1 direct; P.h2 I.e2 direct; P.h3 I.e3 direct; I.e0 K.e0 direct; I.e1 K.e1 "
     "direct; I.e2 K.e2 direct; I.e3 K.e3 direct",
     8, 9, 3, 2, 1, -1, 1, 0, -1, 0, 1,
     NULL},
    {"1f trousers",
     "FL: e0 e1 e2 e3 e4; FR: e0 e1 e2 e3 e4; BL: e0 e1 e2 e3 e4; BR: e0 e1 e2 e3 e4",
     "FR.e1 BR.e1 direct; FR.e3 BR.e3 direct; FL.e1 BL.e1 direct; FL.e3 BL.e3 direct; FL.e4 FR.e4 direct; "
     "BL.e4 BR.e4 direct",
     9, 14, 4, -1, 1, 3, 1, 1, 0, 2, 0,
     NULL},
    {"1f trousers and waistband",
     "FL: e0 e1 e2 e3 e4; FR: e0 e1 e2 e3 e4; BL: e0 e1 e2 e3 e4; BR: e0 e1 e2 e3 e4; W: e0 e1 e2 e3 e4 e5 "
     "e6",
     "FR.e1 BR.e1 direct; FR.e3 BR.e3 direct; FL.e1 BL.e1 direct; FL.e3 BL.e3 direct; FL.e4 FR.e4 direct; "
     "BL.e4 BR.e4 direct; W.e4 W.e6; W.e0 FR.e0 direct; W.e1 BR.e0; W.e2 BL.e0 direct; W.e3 FL.e0",
     10, 16, 5, -1, 1, 3, 1, 1, 0, 2, 0,
     NULL},
    {"1f trousers and waistband, one piece reversed",
     "FL: e0 e1 e2 e3 e4; FR: e0 e1 e2 e3 e4; BL: e0 e1 e2 e3 e4; BR: e0 e1 e2 e3 e4; W: e0 e1 e2 e3 e4 e5 "
     "e6",
     "FR.e1 BR.e1 direct; FR.e3 BR.e3 direct; FL.e1 BL.e1 direct; FL.e3 BL.e3 direct; FL.e4 FR.e4 direct; "
     "BL.e4 BR.e4 direct; W.e4 W.e6; W.e0 FR.e0 direct; W.e1 BR.e0 direct; W.e2 BL.e0 direct; W.e3 FL.e0",
     9, 16, 5, -2, 1, 3, 0, 1, -1, 3, 0,
     NULL},
    {"1f dress sleeves+waist seam",
     "F: e0 e1 e2 e3 e4 e5 e6 e7; B: e0 e1 e2 e3 e4 e5 e6 e7; SF: e0 e1 e2 e3; SB: e0 e1 e2 e3; SR: e0 e1 "
     "e2 e3 e4; SL: e0 e1 e2 e3 e4",
     "F.e1 B.e7; F.e7 B.e1; F.e3 B.e5; F.e5 B.e3; SR.e2 SR.e4; SL.e2 SL.e4; SR.e0 F.e2; SR.e1 B.e6; SL.e0 "
     "B.e2; SL.e1 F.e6; SF.e1 SB.e3; SF.e3 SB.e1; SF.e0 F.e4; SB.e0 B.e4",
     12, 20, 6, -2, 1, 4, 1, 1, 0, 3, 0,
     NULL},
};
/* clang-format on */

#define GARMENTS ((int)(sizeof garments / sizeof garments[0]))

#endif
