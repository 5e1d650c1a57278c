// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/atomic_file.h"

#include "core/base/error.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace ameco {
namespace {

/// A name in the target's folder that no other writer uses: rename is atomic within one folder
/// only, and two of our processes, or two threads of one, may write there at once.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
    static std::atomic<unsigned> count{0};
    std::filesystem::path name = ".";
    name += target.filename();
    name += "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp";
    return target.parent_path() / name;
}

std::string remedy(int error) {
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        return "; create its folder first, or write elsewhere";
    case EACCES:
    case EPERM:
    case EROFS:
        return "; choose a folder you may write to";
    case ENOSPC:
    case EDQUOT:
        return "; free some space, or write elsewhere";
    case ENAMETOOLONG:
        return "; choose a shorter name";
    default:
        return "";
    }
}

} // namespace

void AtomicFile::fail(const char* what, int error) const {
    throw FileError(target_.string() + ": " + what + ": " + std::strerror(error) + remedy(error));
}

AtomicFile::AtomicFile(const std::filesystem::path& target) : target_(target) {
    std::error_code ignored;
    if (std::filesystem::is_symlink(target, ignored)) {
        // Renaming onto a link would replace the link, not the file it stands for.
        const std::filesystem::path real = std::filesystem::weakly_canonical(target, ignored);
        target_ = real.empty() ? target : real;
    }
    const auto status = std::filesystem::status(target_, ignored);
    if (std::filesystem::is_directory(status)) {
        throw FileError(target_.string() + ": is a folder; name a file in it");
    }
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        throw FileError(target_.string() + ": is not a regular file; write elsewhere");
    }
    buffer_ = std::make_unique_for_overwrite<char[]>(buffer_size);
    // A file of this name can only be the remainder of a killed process with our number.
    do {
        temporary_ = temporary_name(target_);
        fd_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (fd_ < 0 && errno == EEXIST);
    if (fd_ < 0) {
        fail("cannot be written", errno);
    }
}

AtomicFile::~AtomicFile() {
    if (fd_ >= 0) {
        ::close(fd_);
        ::unlink(temporary_.c_str());
    }
}

void AtomicFile::write(const void* data, std::size_t bytes) {
    if (bytes > buffer_size - filled_) {
        flush();
    }
    if (bytes > buffer_size) {
        write_through(static_cast<const char*>(data), bytes);
        return;
    }
    if (bytes > 0) {
        std::memcpy(buffer_.get() + filled_, data, bytes);
        filled_ += bytes;
    }
}

void AtomicFile::write_through(const char* data, std::size_t bytes) {
    while (bytes > 0) {
        const ssize_t written = ::write(fd_, data, bytes);
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            fail("cannot be written", errno);
        }
        data += written;
        bytes -= static_cast<std::size_t>(written);
        flushed_ += written;
    }
}

void AtomicFile::flush() {
    const std::size_t bytes = filled_;
    filled_ = 0;
    write_through(buffer_.get(), bytes);
}

void AtomicFile::commit() {
    flush();
    // Some file systems report trouble with earlier writes only now.
    const int closed = ::close(fd_);
    const int close_error = errno;
    fd_ = -1;
    if (closed == 0 && ::rename(temporary_.c_str(), target_.c_str()) == 0) {
        return;
    }
    const int error = closed == 0 ? errno : close_error;
    ::unlink(temporary_.c_str());
    fail(closed == 0 ? "cannot be put in place" : "cannot be written", error);
}

void write_whole_file(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content.data(), content.size());
    file.commit();
}

void create_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw FileError(folder.string() + ": cannot be made a folder" +
                        (failure ? " (" + failure.message() + ")" : "") + ": choose another place");
    }
}

} // namespace ameco
