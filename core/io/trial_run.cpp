// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/trial_run.h"

#include "core/base/error.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ameco {
namespace {

/// Size of our address space; 0 where the system does not tell.
std::int64_t address_space() {
    long long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lld", &pages) != 1) {
            pages = 0;
        }
        std::fclose(file);
    }
    return pages * ::sysconf(_SC_PAGESIZE);
}

void limit(int resource, std::int64_t value) {
    const rlimit both{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
    static_cast<void>(::setrlimit(static_cast<__rlimit_resource>(resource), &both));
}

[[noreturn]] void run_and_exit(const std::function<void()>& f, std::int64_t bytes) {
    for (const int signal : std::array{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGINT}) {
        static_cast<void>(::signal(signal, SIG_DFL));
    }
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (const std::int64_t space = address_space(); space > 0) {
        limit(RLIMIT_AS, space + bytes);
    }
    try {
        f();
    } catch (...) {
        // What is thrown here will be thrown again, where somebody listens.
    }
    ::_exit(0); // neither buffers nor static objects are the child's to end
}

bool survives(const std::function<void()>& f, std::int64_t bytes) {
    const pid_t child = ::fork();
    if (child == 0) {
        run_and_exit(f, bytes);
    }
    if (child < 0) {
        return true; // no process to be had: as if there were no trials
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            return true;
        }
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

void require_survival(const std::string& name, const char* library, std::int64_t bytes,
                      const std::function<void()>& read) {
    // What a library and we need of memory for a good file, generously.
    constexpr std::int64_t least = std::int64_t{256} << 20;
    constexpr std::int64_t per_byte = 64;
    if (!survives(read, least + per_byte * bytes)) {
        throw InputError(name + ": " + library + " breaks down over it; the file is damaged");
    }
}

} // namespace ameco
