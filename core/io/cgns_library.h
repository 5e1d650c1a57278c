// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What our reader and our writer of CGNS share: an open file, and one error for what fails.
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <mutex>
#include <string>

#include <cgnslib.h>

namespace ameco::cgns {

/// Name of the descriptor of a boundary condition that holds number and name of the patch.
inline constexpr const char* patch_descriptor = "ameco patch";
/// Characters of a name, without the 0 behind it.
inline constexpr std::size_t name_length = 32;

/// An open file. libcgns keeps its state in global variables, so there is one at a time.
class File {
public:
    /// \param mode  CG_MODE_READ or CG_MODE_WRITE
    /// \throws InputError when it cannot be opened for reading
    File(const std::filesystem::path& path, int mode, std::string name);
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    [[nodiscard]] int id() const { return id_; }
    /// \throws InputError with libcgns's own words if `status` is no success
    void require(int status, const std::string& what) const;
    [[noreturn]] void fail(const std::string& what) const;
    /// Writes what is left. \throws FileError
    void close();

private:
    std::unique_lock<std::mutex> lock_;
    std::string name_;
    int mode_;
    int id_ = -1;
};

} // namespace ameco::cgns
