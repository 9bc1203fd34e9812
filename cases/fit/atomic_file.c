#include "atomic_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void complain(const char *path, const char *what, int error)
{
    fprintf(stderr, "%s: %s: %s\n", path, what, strerror(error));
}

static void release(lobe_atomic_file *file)
{
    free(file->path);
    free(file->temporary);
    memset(file, 0, sizeof *file);
}

bool lobe_atomic_open(lobe_atomic_file *file, const char *path)
{
    const size_t length = strlen(path) + 32;
    memset(file, 0, sizeof *file);
    file->path = malloc(length);
    file->temporary = malloc(length);
    if (!file->path || !file->temporary) {
        complain(path, "cannot open for writing", ENOMEM);
        release(file);
        return false;
    }
    strcpy(file->path, path);
    /* In the same directory, since rename does not cross file systems; with the process in its name, so that two
     * runs do not write into each other. */
    snprintf(file->temporary, length, "%s.new.%ld", path, (long)getpid());
    file->stream = fopen(file->temporary, "w");
    if (!file->stream) {
        complain(path, "cannot open for writing", errno);
        release(file);
        return false;
    }
    return true;
}

bool lobe_atomic_commit(lobe_atomic_file *file)
{
    int error = 0;
    errno = 0;
    if (fflush(file->stream) != 0 || ferror(file->stream))
        error = errno ? errno : EIO;
    else if (fsync(fileno(file->stream)) != 0 && errno != EINVAL && errno != EROFS) /* a pipe cannot sync */
        error = errno;
    if (fclose(file->stream) != 0 && !error)
        error = errno;
    if (!error && rename(file->temporary, file->path) != 0)
        error = errno;
    if (error) {
        complain(file->path, "cannot write", error);
        unlink(file->temporary);
    }
    release(file);
    return !error;
}

void lobe_atomic_abandon(lobe_atomic_file *file)
{
    if (!file->stream)
        return;
    fclose(file->stream);
    unlink(file->temporary);
    release(file);
}
