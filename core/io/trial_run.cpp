// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/trial_run.h"

#include "core/base/error.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>

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

/// What a child says of its end, before the text of an error.
enum Kind : char { input_error = 'i', file_error = 'f', out_of_memory = 'm' };

void say(int pipe, Kind kind, const std::string& text) {
    const std::string message = std::string(1, kind) + text;
    static_cast<void>(!::write(pipe, message.data(), message.size()));
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool with_sanitizer = true;
#elif defined(__has_feature)
constexpr bool with_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool with_sanitizer = false;
#endif

/// What the child may use beyond what there is: libraries have tables of their own. A sanitizer
/// keeps freed memory for a while, and pads every piece.
std::int64_t allowance(const TrialMemory& memory) {
    constexpr std::int64_t least = std::int64_t{with_sanitizer ? 1024 : 32} << 20;
    return least + memory.per_byte * (with_sanitizer ? 4 : 1) * memory.bytes;
}

[[noreturn]] void run_and_exit(const std::function<void()>& f, std::int64_t bytes, int pipe) {
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
    } catch (const FileError& error) {
        say(pipe, file_error, error.what());
    } catch (const std::bad_alloc&) {
        say(pipe, out_of_memory, "");
    } catch (const std::exception& error) {
        say(pipe, input_error, error.what());
    }
    ::_exit(0); // neither buffers nor static objects are the child's to end
}

/// All that is written into the other end of a pipe until that is closed.
std::string read_all(int pipe) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
        if (count > 0) {
            text.append(buffer.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return text;
        }
    }
}

struct Outcome {
    bool survived = true;
    std::string message; ///< a Kind and a text; empty if nothing was thrown
};

Outcome try_out(const std::function<void()>& f, std::int64_t bytes) {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return {}; // no pipe, no process to be had: as if there were no trials
    }
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        run_and_exit(f, bytes, ends[1]);
    }
    ::close(ends[1]);
    Outcome outcome;
    if (child > 0) {
        outcome.message = read_all(ends[0]);
        int status = 0;
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        outcome.survived = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    ::close(ends[0]);
    return outcome;
}

} // namespace

void require_survival(const std::string& name, const char* library, const TrialMemory& memory,
                      const std::function<void()>& read) {
    const std::int64_t bytes = allowance(memory);
    const Outcome outcome = try_out(read, bytes);
    if (!outcome.survived) {
        throw InputError(name + ": " + library + " breaks down over it; the file is damaged");
    }
    if (outcome.message.empty()) {
        return;
    }
    const std::string text = outcome.message.substr(1);
    switch (outcome.message.front()) {
    case file_error:
        throw FileError(text);
    case out_of_memory:
        throw InputError(name + ": asks for more memory than the " + std::to_string(bytes >> 20) +
                         " MiB that a file of this size can need; it is damaged");
    default:
        throw InputError(text);
    }
}

} // namespace ameco
