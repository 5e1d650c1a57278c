// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ameco {
namespace {

/// A file without a name, in memory.
class MemoryFile {
public:
    MemoryFile() : descriptor_(::memfd_create("ameco", MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// \return whether all of it was written
    [[nodiscard]] bool write(const std::string& bytes) const {
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
            if (count < 0 && errno != EINTR) {
                return false;
            }
            done += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        return true;
    }

    [[nodiscard]] std::string content() const {
        const off_t size = ::lseek(descriptor_, 0, SEEK_END);
        std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                          static_cast<off_t>(done));
            if (count == 0 || (count < 0 && errno != EINTR)) {
                break;
            }
            done += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        bytes.resize(done);
        return bytes;
    }

private:
    int descriptor_;
};

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

[[noreturn]] void work_and_exit(const std::function<std::string()>& work,
                                const ChildOptions& options, const MemoryFile& result,
                                const MemoryFile& output) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : std::array{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGINT}) {
        static_cast<void>(::signal(signal, SIG_DFL));
    }
    const int printed =
        options.keep_output ? output.descriptor() : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(printed, STDOUT_FILENO);
    ::dup2(printed, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (const std::int64_t space = address_space(); options.memory > 0 && space > 0) {
        limit(RLIMIT_AS, space + options.memory);
    }
    bool good = false;
    try {
        good = result.write(work());
    } catch (...) { // the caller hears of it as of a crash
    }
    std::fflush(stdout);
    ::_exit(good ? 0 : 1); // static objects are not the child's to end
}

/// Waits for the child's end; ends it when asked to stop. \return its status
int wait_for(pid_t child, const ChildOptions& options, ChildOutcome& outcome) {
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(child, &status, options.monitor != nullptr ? WNOHANG : 0);
        if (ended == child || (ended < 0 && errno != EINTR)) {
            return status;
        }
        if (options.monitor == nullptr) {
            continue;
        }
        if (options.monitor->stop_requested() && !outcome.stopped) {
            outcome.stopped = true;
            ::kill(child, SIGKILL);
        }
        options.monitor->progress(0, options.step);
        const timespec pause{0, 20'000'000};
        ::nanosleep(&pause, nullptr);
    }
}

} // namespace

ChildOutcome run_in_child(const std::function<std::string()>& work, const ChildOptions& options) {
    ChildOutcome outcome;
    const MemoryFile result, output;
    if (result.descriptor() < 0 || output.descriptor() < 0) {
        return outcome;
    }
    std::fflush(stdout); // or the child would have our unwritten text, too
    const pid_t child = ::fork();
    if (child == 0) {
        work_and_exit(work, options, result, output);
    }
    if (child < 0) {
        return outcome;
    }
    outcome.started = true;
    const int status = wait_for(child, options, outcome);
    outcome.survived = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    outcome.output = output.content();
    if (outcome.survived) {
        outcome.result = result.content();
    }
    return outcome;
}

} // namespace ameco
