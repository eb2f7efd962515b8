/* Preloaded: lets one call fail with FAULT_ERROR (-1: kills the process there), the number FAULT_CALL of the group FAULT_GROUP:
     files   what makes, writes, moves or flushes files below FAULT_FOLDER, and starts processes
     mmap    memory by the page, and files in memory
     malloc  memory
   in the process that is started with this, or, where FAULT_CHILD is set, in the programs that it
   starts. FAULT_NAME: a file for the name of the call that failed; FAULT_COUNT: one for the number of
   calls. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#define NEXT(type, name) ((type)dlsym(RTLD_NEXT, name))

static long calls, wanted;
static long* counted;
static int error_number, active;
static char group[16], folder[4096], said[4096];
static void* (*real_mmap)(void*, size_t, int, int, int, off_t);
extern void* __libc_malloc(size_t);

static const char* value_of(const char* name) {
  const char* value = getenv(name);
  return value ? value : "";
}

__attribute__((constructor)) static void begin(void) {
  const int child = *value_of("FAULT_STARTED") != 0;
  real_mmap = NEXT(void* (*)(void*, size_t, int, int, int, off_t), "mmap");
  snprintf(group, sizeof group, "%s", value_of("FAULT_GROUP"));
  snprintf(folder, sizeof folder, "%s", value_of("FAULT_FOLDER"));
  snprintf(said, sizeof said, "%s", value_of("FAULT_NAME"));
  wanted = atol(value_of("FAULT_CALL"));
  error_number = atoi(value_of("FAULT_ERROR"));
  setenv("FAULT_STARTED", "1", 1);
  const int file = *value_of("FAULT_COUNT") ? open(value_of("FAULT_COUNT"), O_RDWR) : -1;
  if (file >= 0) counted = real_mmap(NULL, sizeof *counted, PROT_WRITE, MAP_SHARED, file, 0);
  if (file >= 0) close(file);
  active = child == (*value_of("FAULT_CHILD") != 0);
}

static int below(const char* path) { return *folder && path && strstr(path, folder) != NULL; }

static int file_below(int file) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = 0;
  return below(path);
}

/* Whether the call is to fail; errno is set then. */
static int fails(const char* of, const char* name) {
  if (!active || strcmp(of, group) != 0) return 0;
  const long call = __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST);
  if (counted) *counted = call;
  if (call != wanted) return 0;
  active = 0;
  const int file = *said ? open(said, O_WRONLY | O_CREAT | O_TRUNC, 0600) : -1;
  if (file >= 0) {
    dprintf(file, "%s\n", name);
    close(file);
  }
  if (error_number < 0) raise(SIGKILL);
  errno = error_number;
  return 1;
}

static int file_fails(const char* name) { return fails("files", name); }

ssize_t write(int file, const void* bytes, size_t size) {
  if (file_below(file) && file_fails("write")) return -1;
  return NEXT(ssize_t (*)(int, const void*, size_t), "write")(file, bytes, size);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  if (file_below(file) && file_fails("pwrite")) return -1;
  return NEXT(ssize_t (*)(int, const void*, size_t, off64_t), "pwrite64")(file, bytes, size, at);
}

int ftruncate64(int file, off64_t size) {
  if (file_below(file) && file_fails("ftruncate")) return -1;
  return NEXT(int (*)(int, off64_t), "ftruncate64")(file, size);
}

int fsync(int file) {
  if (file_below(file) && file_fails("fsync")) return -1;
  return NEXT(int (*)(int), "fsync")(file);
}

int rename(const char* from, const char* to) {
  if (below(to) && file_fails("rename")) return -1;
  return NEXT(int (*)(const char*, const char*), "rename")(from, to);
}

int link(const char* from, const char* to) {
  if (below(to) && file_fails("link")) return -1;
  return NEXT(int (*)(const char*, const char*), "link")(from, to);
}

int linkat(int a, const char* from, int b, const char* to, int flags) {
  if (below(to) && file_fails("linkat")) return -1;
  return NEXT(int (*)(int, const char*, int, const char*, int), "linkat")(a, from, b, to, flags);
}

int mkdir(const char* path, mode_t mode) {
  if (below(path) && file_fails("mkdir")) return -1;
  return NEXT(int (*)(const char*, mode_t), "mkdir")(path, mode);
}

static int open_flagged(const char* name, const char* path, int flags, mode_t mode) {
  if ((flags & (O_CREAT | O_WRONLY | O_RDWR)) && below(path) && file_fails(name)) return -1;
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

static FILE* stream_of(const char* name, const char* path, const char* mode) {
  if (strpbrk(mode, "wa+") && below(path) && file_fails(name)) return NULL;
  return NEXT(FILE * (*)(const char*, const char*), name)(path, mode);
}

FILE* fopen(const char* path, const char* mode) { return stream_of("fopen", path, mode); }
FILE* fopen64(const char* path, const char* mode) { return stream_of("fopen64", path, mode); }

/* What the library's own streams write does not come by write(). */
int fflush(FILE* stream) {
  if (stream && file_below(fileno(stream)) && file_fails("fflush")) return EOF;
  return NEXT(int (*)(FILE*), "fflush")(stream);
}

int fclose(FILE* stream) {
  if (file_below(fileno(stream)) && file_fails("fclose")) {
    NEXT(int (*)(FILE*), "fclose")(stream);
    errno = error_number;
    return EOF;
  }
  return NEXT(int (*)(FILE*), "fclose")(stream);
}

pid_t fork(void) {
  if (file_fails("fork")) return -1;
  return NEXT(pid_t (*)(void), "fork")();
}

typedef int (*spawner)(pid_t*, const char*, const posix_spawn_file_actions_t*,
                       const posix_spawnattr_t*, char* const[], char* const[]);

int posix_spawn(pid_t* pid, const char* path, const posix_spawn_file_actions_t* files,
                const posix_spawnattr_t* how, char* const words[], char* const values[]) {
  if (file_fails("posix_spawn")) return error_number;
  return NEXT(spawner, "posix_spawn")(pid, path, files, how, words, values);
}

int pipe2(int ends[2], int flags) {
  if (file_fails("pipe2")) return -1;
  return NEXT(int (*)(int*, int), "pipe2")(ends, flags);
}

void* mmap(void* at, size_t size, int protection, int flags, int file, off_t offset) {
  if (fails("mmap", "mmap")) return MAP_FAILED;
  if (!real_mmap) real_mmap = NEXT(void* (*)(void*, size_t, int, int, int, off_t), "mmap");
  return real_mmap(at, size, protection, flags, file, offset);
}

void* malloc(size_t size) {
  if (active && fails("malloc", "malloc")) return NULL;
  return __libc_malloc(size);
}
