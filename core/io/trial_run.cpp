// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/trial_run.h"

#include "core/base/child_process.h"
#include "core/base/error.h"

#include <new>

namespace ameco {
namespace {

/// What a child says of its end, before the text of an error.
enum Kind : char { input_error = 'i', file_error = 'f', out_of_memory = 'm' };

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

/// Reads, and says how it ended: nothing, or a Kind and a text.
std::string outcome_of(const std::function<void()>& read) {
    const auto said = [](Kind kind, const std::string& text) {
        return std::string(1, kind) + text;
    };
    try {
        read();
    } catch (const FileError& error) {
        return said(file_error, error.what());
    } catch (const std::bad_alloc&) {
        return said(out_of_memory, "");
    } catch (const std::exception& error) {
        return said(input_error, error.what());
    }
    return {};
}

} // namespace

void require_survival(const std::string& name, const char* library, const TrialMemory& memory,
                      const std::function<void()>& read) {
    const std::int64_t bytes = allowance(memory);
    const ChildOutcome outcome = run_in_child([&] { return outcome_of(read); }, {.memory = bytes});
    if (outcome.started && !outcome.survived) { // without a process, as if there were no trials
        throw InputError(name + ": " + library + " breaks down over it; the file is damaged");
    }
    if (outcome.result.empty()) {
        return;
    }
    const std::string text = outcome.result.substr(1);
    switch (outcome.result.front()) {
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
