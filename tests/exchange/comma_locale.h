/*
 * comma_locale.h: switch the process to a locale with a decimal comma: an installed one, or one that localedef makes in
 * the scratch folder. False, and a printed line, where there is neither.
 */
#ifndef MUS_TESTS_COMMA_LOCALE_H
#define MUS_TESTS_COMMA_LOCALE_H

#include <locale.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"


static inline bool comma_locale(void)
{
    char made[512], command[1024];
    support_scratch("de_DE.UTF-8", made, sizeof made);
    for (int attempt = 0; attempt < 2; attempt++) {
        const char *const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "es_ES.UTF-8", "de_DE", "fr_FR"};
        for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
            if (setlocale(LC_ALL, names[i]) != NULL && strcmp(localeconv()->decimal_point, ",") == 0) return true;
        snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 '%s' >/dev/null 2>&1", made);
        if (attempt > 0 || system(command) != 0) break;
        *strrchr(made, '/') = '\0';
        setenv("LOCPATH", made, 1);
    }
    setlocale(LC_ALL, "C");
    printf("skipped: no locale with a decimal comma\n");
    return false;
}

#endif
