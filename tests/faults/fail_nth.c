/* Preloaded: lets the call number FAULT_CALL on files below FAULT_FOLDER fail with FAULT_ERROR; calls
   that make processes count as well. The name of the call that failed goes into the file FAULT_NAME. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int calls;
static pid_t owner;

static int below(const char* path) {
  const char* folder = getenv("FAULT_FOLDER");
  return folder && path && strstr(path, folder) != NULL;
}

static int file_below(int file) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = 0;
  return below(path);
}

/* Whether the call is to fail; errno is set then. */
static int fails(const char* name) {
  const char *number = getenv("FAULT_CALL"), *error = getenv("FAULT_ERROR");
  if (!owner) owner = getpid();
  if (owner != getpid()) return 0;
  if (++calls != (number ? atoi(number) : 0)) return 0;
  const char* said = getenv("FAULT_NAME");
  FILE* file = said ? fopen(said, "w") : NULL;
  if (file) {
    fprintf(file, "%s\n", name);
    fclose(file);
  }
  errno = error ? atoi(error) : ENOSPC;
  return 1;
}


#define NEXT(type, name) ((type)dlsym(RTLD_NEXT, name))

ssize_t write(int file, const void* bytes, size_t size) {
  if (file_below(file) && fails("write")) return -1;
  return NEXT(ssize_t (*)(int, const void*, size_t), "write")(file, bytes, size);
}

int fsync(int file) {
  if (file_below(file) && fails("fsync")) return -1;
  return NEXT(int (*)(int), "fsync")(file);
}

int rename(const char* from, const char* to) {
  if (below(to) && fails("rename")) return -1;
  return NEXT(int (*)(const char*, const char*), "rename")(from, to);
}

int link(const char* from, const char* to) {
  if (below(to) && fails("link")) return -1;
  return NEXT(int (*)(const char*, const char*), "link")(from, to);
}

int linkat(int a, const char* from, int b, const char* to, int flags) {
  if (below(to) && fails("linkat")) return -1;
  return NEXT(int (*)(int, const char*, int, const char*, int), "linkat")(a, from, b, to, flags);
}

int mkdir(const char* path, mode_t mode) {
  if (below(path) && fails("mkdir")) return -1;
  return NEXT(int (*)(const char*, mode_t), "mkdir")(path, mode);
}

static int open_flagged(const char* name, const char* path, int flags, mode_t mode) {
  if ((flags & (O_CREAT | O_WRONLY | O_RDWR)) && below(path) && fails(name)) return -1;
  return NEXT(int (*)(const char*, int, ...), name)(path, flags, mode);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (mode_t)va_arg(rest, int);
  va_end(rest);
  return open_flagged("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (mode_t)va_arg(rest, int);
  va_end(rest);
  return open_flagged("open64", path, flags, mode);
}

pid_t fork(void) {
  if (fails("fork")) return -1;
  return NEXT(pid_t (*)(void), "fork")();
}

int pipe2(int ends[2], int flags) {
  if (fails("pipe2")) return -1;
  return NEXT(int (*)(int*, int), "pipe2")(ends, flags);
}
