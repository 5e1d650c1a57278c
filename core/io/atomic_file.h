// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A file that appears whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace ameco {

/// Writes to a temporary file beside the target and renames it at the end.
///
/// Until `commit` the target stays as it was. Without `commit` (an exception is on its way, say)
/// the destructor removes the temporary file; a killed process leaves it behind, under the name
/// `.<target>.<process>-<count>.tmp`. Data is not forced to the disk: this guards against our own
/// trouble, not against a power cut.
class AtomicFile {
public:
    /// \throws FileError  the folder is missing or not writable, or the target is no regular file
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// At least `bytes` bytes of buffer to write into; say how many were used with `used`.
    /// \param bytes  at most `max_room`
    [[nodiscard]] char* room(std::size_t bytes) {
        if (buffer_size - filled_ < bytes) {
            flush();
        }
        return buffer_.get() + filled_;
    }
    void used(std::size_t bytes) { filled_ += bytes; }

    void write(const void* data, std::size_t bytes);

    /// Where the content is until `commit`, for a library that writes files by itself.
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

    /// Bytes written so far.
    [[nodiscard]] std::int64_t position() const {
        return flushed_ + static_cast<std::int64_t>(filled_);
    }

    /// Puts the file at its place.
    /// \throws FileError  the last bytes cannot be written, or the file cannot be renamed
    void commit();

    static constexpr std::size_t max_room = 4096;

private:
    static constexpr std::size_t buffer_size = std::size_t{1} << 20;

    void flush();
    void write_through(const char* data, std::size_t bytes);
    [[noreturn]] void fail(const char* what, int error) const;

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    std::unique_ptr<char[]> buffer_;
    std::size_t filled_ = 0;
    std::int64_t flushed_ = 0;
    int fd_ = -1;
};

/// Writes a file of known content. \throws FileError
void write_whole_file(const std::filesystem::path& path, std::string_view content);

/// Makes a folder and those above it, where they are not there.
/// \throws FileError
void create_folder(const std::filesystem::path& folder);

} // namespace ameco
