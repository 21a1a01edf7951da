// Runs a command and writes what it took, as JSON, to a file. usage: measure RESULT.json COMMAND [ARGUMENT...]
// A program of its own because Linux keeps a process's peak memory across exec: a child of Python never reports less than
// Python had. Exits as the command does.
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <cstring>

extern char** environ;

namespace {

double seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: measure RESULT.json COMMAND [ARGUMENT...]\n");
        return 2;
    }
    const auto begin = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int error = posix_spawnp(&child, argv[2], nullptr, nullptr, argv + 2, environ);
    if (error != 0) {
        std::fprintf(stderr, "measure: %s: %s\n", argv[2], std::strerror(error));
        return 127;
    }
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child) {
        std::perror("measure: wait4");
        return 127;
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;

    std::FILE* result = std::fopen(argv[1], "w");
    if (result == nullptr) {
        std::perror(argv[1]);
        return 127;
    }
    std::fprintf(result, "{\"wall_s\": %.6f, \"cpu_s\": %.6f, \"peak_bytes\": %lld}\n", wall.count(),
                 seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<long long>(usage.ru_maxrss) * 1024);
    std::fclose(result);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
