// SPDX-License-Identifier: AGPL-3.0-or-later
// Any bytes given to the reader of a format end in a mesh or in an Error: never in a crash. Built
// once for each format, with its name as AMECO_FUZZED_FORMAT.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/format.h"

#include <cstdio>
#include <cstdlib>

namespace {

const ameco::Format& fuzzed_format() {
    const ameco::Format* format = ameco::format_of_name(AMECO_FUZZED_FORMAT);
    if (format == nullptr || !format->reads()) {
        std::fputs("this build does not read " AMECO_FUZZED_FORMAT "\n", stderr);
        std::exit(1);
    }
    return *format;
}

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
    const ameco::Source source{
        "/nowhere/fuzz", "fuzz", bytes, {.surfaces = true, .from_memory = true}, nullptr};
    if (format.read != nullptr) {
        read([&] { static_cast<void>(format.read(source)); });
    } else {
        read([&] { static_cast<void>(format.read_tensors(source)); });
    }
    return 0;
}
