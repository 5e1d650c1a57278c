// SPDX-License-Identifier: AGPL-3.0-or-later
// Any bytes given to the reader of a format end in a mesh or in an Error: never in a crash. Built
// once for each format, with its name as AMECO_FUZZED_FORMAT. Readers that go through a library
// that reads files by name only get a file in memory.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/format.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace {

const ameco::Format& fuzzed_format() {
    const ameco::Format* format = ameco::format_of_name(AMECO_FUZZED_FORMAT);
    if (format == nullptr || !format->reads()) {
        std::fputs("this build does not read " AMECO_FUZZED_FORMAT "\n", stderr);
        std::exit(1);
    }
    return *format;
}

/// A file that exists while this does, in memory only.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : file_(::memfd_create("fuzz", 0)) {
        if (file_ < 0 ||
            ::write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
            std::perror("a file in memory");
            std::exit(1);
        }
    }
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

template <class F>
void read(F&& f) {
    try {
        f();
    } catch (const ameco::Error&) {
        // What is expected of most inputs.
    }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    ameco::set_thread_count(1); // the fuzzer's guidance needs runs that repeat exactly
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const ameco::Format& format = fuzzed_format();
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (std::string_view(AMECO_FUZZED_FORMAT) == "cgns") {
        const MemoryFile file(bytes);
        read([&] { static_cast<void>(format.read({file.path(), "fuzz", bytes, {}, nullptr})); });
        return 0;
    }
    const ameco::Source source{
        "/nowhere/fuzz", "fuzz", bytes, {.surfaces = true, .from_memory = true}, nullptr};
    if (format.read != nullptr) {
        read([&] { static_cast<void>(format.read(source)); });
    } else {
        read([&] { static_cast<void>(format.read_tensors(source)); });
    }
    return 0;
}
