// SPDX-License-Identifier: AGPL-3.0-or-later
// Formats of several files: any bytes in any of them end in a mesh or in an Error, never in a
// crash. Built once for each format, with the names of its files, the first of which is read, as
// AMECO_FUZZED_FILES. The fuzzer's bytes are the files one behind another, with lines of
// `separator` between them.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/io.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace {

namespace fs = std::filesystem;

constexpr std::string_view separator = "\n==== next file\n";
constexpr std::array names{AMECO_FUZZED_FILES};

/// A folder of this process, made at its first use. The fuzzer never ends in an orderly way, so the
/// few small files stay.
const fs::path& folder() {
    static const fs::path path = [] {
        std::string name = (fs::temp_directory_path() / "ameco_fuzz_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            std::perror("a folder for the files");
            std::exit(1);
        }
        return fs::path(name);
    }();
    return path;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    ameco::set_thread_count(1); // the fuzzer's guidance needs runs that repeat exactly
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    for (const char* name : names) {
        const std::size_t end = rest.find(separator);
        const std::string_view part = rest.substr(0, end);
        std::ofstream file(folder() / name, std::ios::binary);
        file.write(part.data(), static_cast<std::streamsize>(part.size()));
        rest = end == std::string_view::npos ? "" : rest.substr(end + separator.size());
    }
    try {
        static_cast<void>(ameco::read_mesh(folder() / names[0], {.surfaces = true}));
    } catch (const ameco::Error&) {
        // What is expected of most inputs.
    }
    return 0;
}
