// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The whole content of a file as bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ameco {

/// The content of a file, mapped into memory; gz-compressed content (recognised by its first
/// bytes) is unpacked.
///
/// Mapping keeps a large file out of our memory: the mesh made from it is all there is. A file
/// that another program cuts short while we read it ends the process (SIGBUS); the price of this.
class FileBytes {
public:
    /// \throws FileError   not a regular file, cannot be opened or read
    /// \throws InputError  gz data that cannot be unpacked
    explicit FileBytes(const std::filesystem::path& path);
    ~FileBytes();
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    [[nodiscard]] std::string_view view() const { return view_; }
    /// Lets the system take back the memory of a part of the view, which will not be read again
    /// soon: a reader that is done with a part needs memory for its own result only. The bytes stay
    /// readable.
    void forget(const char* begin, const char* end) const;
    [[nodiscard]] bool was_compressed() const { return was_compressed_; }

private:
    void* mapping_ = nullptr;
    std::size_t mapped_size_ = 0;
    std::string unpacked_;
    std::string_view view_;
    bool was_compressed_ = false;
};

/// Unpacks gz data.
/// \param name  of the file, for messages
/// \throws InputError  damaged, truncated, or more than 64 times (and 1 MiB) larger than packed
[[nodiscard]] std::string unpack_gz(std::string_view packed, const std::string& name);

} // namespace ameco
