/* absent.h: put before every file of the module: what wasi-libc does not declare. */
char *realpath(const char *path, char *resolved);
