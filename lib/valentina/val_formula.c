/*
 * val_formula.c: the value of a formula as Valentina writes it: numbers, names, + - * / ^, comparisons, && ||, a ? b :
 * c, and functions. A recursive descent, one function for each rank of the operators:
 *
 *     choice = any [? choice : choice]     any = all {|| all}     all = order {&& order}     order = sum {< sum}
 *     sum = product {+ product}     product = sign {* sign}     sign = [-] power     power = atom [^ sign]
 *
 * Angles are radians in sin and degrees in sinD. The depth of brackets and the length are limited, so that a file
 * cannot exhaust the stack or the time.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "valentina/val_file.h"

#define FORMULA_DEPTH 64      /* deepest brackets; chosen: those of real patterns reach 9 */
#define FORMULA_LENGTH 65536  /* [bytes] longest formula; chosen: those of real patterns reach 700 */
#define FORMULA_ARGUMENTS 64  /* most arguments of a function */

typedef struct formula {
    const char *at;
    const char *wrong; /* first fault; NULL: none */
    int32_t depth;
    mus__val_lookup lookup;
    const void *user;
} formula;

static double formula_choice(formula *f);


static void formula_fail(formula *f, const char *wrong)
{
    if (f->wrong == NULL) f->wrong = wrong;
}


/* take an operator when it comes next */
static bool formula_take(formula *f, const char *operator)
{
    f->at += strspn(f->at, " \t\r\n");
    const size_t n = strlen(operator);
    if (strncmp(f->at, operator, n) != 0) return false;
    f->at += n;
    return true;
}


/* the value of a function of one argument; false for an unknown name */
static bool formula_one(const char *name, size_t n, double x, double *out)
{
    const bool degrees = n > 1 && name[n - 1] == 'D' && n < 6;
    const double turn = degrees ? MUS__DEGREE : 1.0;
    const size_t m = degrees ? n - 1 : n;
#define NAMED(word) (m == sizeof word - 1 && memcmp(name, word, m) == 0)
    if (NAMED("sin")) *out = mus__sin(x * turn);
    else if (NAMED("cos")) *out = mus__cos(x * turn);
    else if (NAMED("tan")) *out = mus__tan(x * turn);
    else if (NAMED("asin")) *out = mus__asin(x) / turn;
    else if (NAMED("acos")) *out = mus__acos(x) / turn;
    else if (NAMED("atan")) *out = mus__atan2(x, 1.0) / turn;
    else if (NAMED("sqrt")) *out = sqrt(x);
    else if (NAMED("abs")) *out = fabs(x);
    else if (NAMED("rint")) *out = rint(x);
    else if (NAMED("sign")) *out = (x > 0.0) - (x < 0.0);
    else if (NAMED("exp")) *out = mus__exp(x);
    else if (NAMED("ln")) *out = mus__ln(x);
    else if (NAMED("log2")) *out = mus__ln(x) / mus__ln(2.0);
    else if (NAMED("log") || NAMED("log10")) *out = mus__ln(x) / mus__ln(10.0);
    else if (NAMED("degTorad")) *out = x * MUS__DEGREE;
    else if (NAMED("radTodeg")) *out = x / MUS__DEGREE;
    else return false;
#undef NAMED
    return true;
}


/* the value of a function of several arguments; false for an unknown name or a wrong number of them */
static bool formula_many(const char *name, size_t n, int32_t count, const double *x, double *out)
{
    double sum = 0.0, low = x[0], high = x[0];
    for (int32_t i = 0; i < count; i++) sum += x[i], low = fmin(low, x[i]), high = fmax(high, x[i]);
    if (n == 3 && memcmp(name, "min", n) == 0) *out = low;
    else if (n == 3 && memcmp(name, "max", n) == 0) *out = high;
    else if (n == 3 && memcmp(name, "sum", n) == 0) *out = sum;
    else if (n == 3 && memcmp(name, "avg", n) == 0) *out = sum / count;
    else if (n == 4 && memcmp(name, "fmod", n) == 0 && count == 2) *out = fmod(x[0], x[1]);
    else return count == 1 && formula_one(name, n, x[0], out);
    return true;
}


static double formula_name(formula *f)
{
    const char *name = f->at;
    while (isalnum((unsigned char)*f->at) || *f->at == '_' || *f->at == '@' || *f->at == '#' ||
           (unsigned char)*f->at >= 0x80)
        f->at++;
    const size_t n = (size_t)(f->at - name);
    double value = 0.0;
    if (!formula_take(f, "(")) {
        if (!f->lookup(f->user, name, n, &value)) {
            formula_fail(f, "is a name without a value");
            f->at = name;
        }
        return value;
    }
    double x[FORMULA_ARGUMENTS];
    int32_t count = 0;
    do x[count++] = formula_choice(f);
    while (f->wrong == NULL && count < FORMULA_ARGUMENTS && (formula_take(f, ";") || formula_take(f, ",")));
    if (!formula_take(f, ")")) formula_fail(f, "lacks a \")\"");
    if (f->wrong == NULL && !formula_many(name, n, count, x, &value)) {
        formula_fail(f, "is no function that muslin knows, or has a wrong number of arguments");
        f->at = name;
    }
    return value;
}


static double formula_atom(formula *f)
{
    f->at += strspn(f->at, " \t\r\n");
    double value = 0.0;
    if (f->wrong != NULL) return 0.0;
    if (formula_take(f, "(")) {
        value = formula_choice(f);
        if (!formula_take(f, ")")) formula_fail(f, "lacks a \")\"");
        return value;
    }
    const size_t n = mus__number_span(f->at);
    if (n > 0) {
        const char *wrong = NULL;
        char hold[64];
        if (n >= sizeof hold) {
            formula_fail(f, "is a number too long");
            return 0.0;
        }
        memcpy(hold, f->at, n);
        hold[n] = '\0';
        wrong = mus__number_read(hold, &value);
        if (wrong != NULL) formula_fail(f, "is not a number");
        f->at += n;
        return value;
    }
    if (isalpha((unsigned char)*f->at) || strchr("_@#", *f->at) != NULL || (unsigned char)*f->at >= 0x80) {
        if (*f->at != '\0') return formula_name(f);
    }
    formula_fail(f, "is no number, name or \"(\"");
    return 0.0;
}


static double formula_sign(formula *f)
{
    bool minus = false;
    for (;;) {
        if (formula_take(f, "-")) minus = !minus;
        else if (!formula_take(f, "+")) break;
    }
    double value = formula_atom(f);
    if (formula_take(f, "^")) {
        if (++f->depth > FORMULA_DEPTH) formula_fail(f, "is nested too deep");
        else value = mus__pow(value, formula_sign(f));
        f->depth--;
    }
    return minus ? -value : value;
}


static double formula_product(formula *f)
{
    double value = formula_sign(f);
    while (f->wrong == NULL) {
        if (formula_take(f, "*")) value *= formula_sign(f);
        else if (formula_take(f, "/")) value /= formula_sign(f);
        else break;
    }
    return value;
}


static double formula_sum(formula *f)
{
    double value = formula_product(f);
    while (f->wrong == NULL) {
        if (formula_take(f, "+")) value += formula_product(f);
        else if (formula_take(f, "-")) value -= formula_product(f);
        else break;
    }
    return value;
}


static double formula_order(formula *f)
{
    double value = formula_sum(f);
    while (f->wrong == NULL) {
        if (formula_take(f, "<=")) value = value <= formula_sum(f);
        else if (formula_take(f, ">=")) value = value >= formula_sum(f);
        else if (formula_take(f, "==")) value = value == formula_sum(f);
        else if (formula_take(f, "!=")) value = value != formula_sum(f);
        else if (formula_take(f, "<")) value = value < formula_sum(f);
        else if (formula_take(f, ">")) value = value > formula_sum(f);
        else break;
    }
    return value;
}


static double formula_all(formula *f)
{
    double value = formula_order(f);
    while (f->wrong == NULL && formula_take(f, "&&")) {
        const double other = formula_order(f);
        value = value != 0.0 && other != 0.0;
    }
    return value;
}


static double formula_any(formula *f)
{
    double value = formula_all(f);
    while (f->wrong == NULL && formula_take(f, "||")) {
        const double other = formula_all(f);
        value = value != 0.0 || other != 0.0;
    }
    return value;
}


static double formula_choice(formula *f)
{
    if (++f->depth > FORMULA_DEPTH) formula_fail(f, "is nested too deep");
    double value = f->wrong == NULL ? formula_any(f) : 0.0;
    if (f->wrong == NULL && formula_take(f, "?")) {
        const double yes = formula_choice(f);
        if (!formula_take(f, ":")) formula_fail(f, "lacks a \":\"");
        const double no = f->wrong == NULL ? formula_choice(f) : 0.0;
        value = value != 0.0 ? yes : no;
    }
    f->depth--;
    return value;
}


const char *mus__val_evaluate(const char *text, mus__val_lookup lookup, const void *user, double *out, const char **at)
{
    formula f = {.at = text, .lookup = lookup, .user = user};
    *out = 0.0;
    if (strlen(text) > FORMULA_LENGTH) formula_fail(&f, "is too long");
    const double value = f.wrong == NULL ? formula_choice(&f) : 0.0;
    f.at += strspn(f.at, " \t\r\n");
    if (f.wrong == NULL && *f.at != '\0') formula_fail(&f, "is not expected");
    if (f.wrong == NULL && !(fabs(value) < 1e12)) formula_fail(&f, "is not finite");
    *at = f.at;
    if (f.wrong == NULL) *out = value;
    return f.wrong;
}
