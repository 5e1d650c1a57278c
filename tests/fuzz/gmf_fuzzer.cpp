// SPDX-License-Identifier: AGPL-3.0-or-later
// Any bytes given to the Medit readers end in a mesh, in tensors, or in an Error: never in a crash.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/file_bytes.h"
#include "core/io/gmf.h"

namespace {

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
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    read([&] { static_cast<void>(ameco::gmf::read_mesh(bytes, "fuzz.mesh")); });
    read([&] { static_cast<void>(ameco::gmf::read_tensors(bytes, "fuzz.sol")); });
    if (bytes.substr(0, 2) == "\x1f\x8b") {
        read([&] { static_cast<void>(ameco::unpack_gz(bytes, "fuzz.mesh.gz")); });
    }
    return 0;
}
