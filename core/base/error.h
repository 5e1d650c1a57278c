// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The few exception types, for trouble that comes from outside the program: files, options,
/// signals. What an algorithm declines to do is a value (remesh/verdict.h), not an exception.
#pragma once

#include <stdexcept>
#include <string>

namespace ameco {

/// Exit codes of the program; numbers other people's scripts rely on.
enum class ExitCode : int {
    ok = 0,
    internal = 1,      ///< a bug of ours
    usage = 2,         ///< wrong options
    check_failed = 3,  ///< a check or a gate said no
    file = 4,          ///< cannot read or write
    invalid_input = 5, ///< the file was read, its content is not a valid mesh or metric
    partial = 6,       ///< stopped early, the last good level is kept
    memory = 7,        ///< not enough memory
    not_built = 8,     ///< the feature was left out of this build
    cancelled = 130    ///< the user cancelled
};

/// Trouble from outside. The text is one line for the user: what, where, and what to do about it.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// A file cannot be opened, read or written.
class FileError : public Error {
public:
    explicit FileError(const std::string& text) : Error(ExitCode::file, text) {}
};

/// A file was read, but what it holds is not usable.
class InputError : public Error {
public:
    explicit InputError(const std::string& text) : Error(ExitCode::invalid_input, text) {}
};

/// An option or argument makes no sense.
class UsageError : public Error {
public:
    explicit UsageError(const std::string& text) : Error(ExitCode::usage, text) {}
};

/// An iteration the user chose does not converge on the data given.
class NotConverged : public Error {
public:
    explicit NotConverged(const std::string& text) : Error(ExitCode::check_failed, text) {}
};

/// What was made is not what it must be, and is therefore not delivered.
class CheckFailed : public Error {
public:
    explicit CheckFailed(const std::string& text) : Error(ExitCode::check_failed, text) {}
};

/// The user asked to stop.
class Cancelled : public Error {
public:
    Cancelled() : Error(ExitCode::cancelled, "cancelled") {}
};

} // namespace ameco
