/* What the drivers of Microsoft's compilers share: files, messages on one line, the list of jobs.
 *
 * A driver's only argument is a text file, or - for standard input, with one job a line, words parted by tabs. For each job one line goes
 * to stdout. A driver ends with the number of failed jobs, at most 100, or with 101 to 104 where it cannot work.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BAD_USAGE = 101, NO_LIBRARY = 102, NO_ENTRY_POINT = 103, CANNOT_WRITE = 104 };

static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *text = malloc(*size + 1);
    *size = fread(text, 1, *size, file);
    text[*size] = 0;
    fclose(file);
    return text;
}

/* Line breaks become " | ". */
static void print_one_line(const char *text)
{
    for (; *text; text++) {
        if (*text == '\r') continue;
        if (*text == '\n') { if (text[1]) fputs(" | ", stdout); }
        else putchar(*text == '\t' ? ' ' : *text);
    }
}

/* Calls run, which returns 1 for a failed job, on each line of the list. */
static int run_jobs(const char *list, int (*run)(char *line))
{
    FILE *jobs = strcmp(list, "-") ? fopen(list, "r") : stdin;
    if (!jobs) { fprintf(stderr, "cannot start: no list of jobs at %s\n", list); return BAD_USAGE; }
    int failures = 0;
    static char line[65536];
    while (fgets(line, sizeof line, jobs)) {
        if (line[0] == '\n' || line[0] == '\r') continue;
        failures += run(line);
        fflush(stdout);
    }
    return failures > 100 ? 100 : failures;
}
