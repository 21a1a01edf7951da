/* A libEGL that loads and then fails at its first real call, in one of the ways that drivers do. */
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

typedef void* Display;

Display eglGetDisplay(void* native) {
    (void)native;
    return NULL;
}

Display eglGetCurrentDisplay(void) { return NULL; }

int eglGetError(void) { return 0x3000; }

const char* eglQueryString(Display display, int name) {
    (void)display;
    (void)name;
#if defined(HANGS)
    /* A FIFO that stays open for as long as this process lives, and first holds its number. */
    const char* fifo = getenv("SPHEREVIEW_TEST_FIFO");
    if (fifo != NULL) {
        const pid_t self = getpid();
        if (write(open(fifo, O_WRONLY), &self, sizeof self) < 0) exit(7);
    }
    for (;;) pause();
#elif defined(CRASHES)
    *(volatile int*)NULL = 1;
#elif defined(EXITS)
    exit(7);
#endif
    return NULL;
}
