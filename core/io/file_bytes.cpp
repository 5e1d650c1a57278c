// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/file_bytes.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

namespace ameco {
namespace {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(const std::filesystem::path& path)
        : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Descriptor() {
        if (fd_ >= 0) {
            ::close(fd_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
    throw FileError(path.string() + ": " + what);
}

/// Ends zlib's state on every way out.
class Inflater {
public:
    explicit Inflater(const std::string& name) {
        // 15 bits of window, + 16 for the gzip wrapper.
        if (inflateInit2(&stream_, 15 + 16) != Z_OK) {
            throw FileError(name + ": zlib cannot be started");
        }
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    z_stream& stream() { return stream_; }

private:
    z_stream stream_{};
};

} // namespace

std::string unpack_gz(std::string_view packed, const std::string& name) {
    // Text of meshes shrinks 3 to 8 times; zlib's limit, 1030, is for files that fill memories.
    constexpr std::size_t largest_expansion = 64;
    constexpr std::size_t spare = std::size_t{1} << 20;
    Inflater inflater(name);
    z_stream& z = inflater.stream();
    std::string result;
    std::array<char, 1 << 16> buffer;
    std::size_t taken = 0;
    for (;;) {
        const std::size_t piece =
            std::min<std::size_t>(packed.size() - taken, std::numeric_limits<uInt>::max());
        // zlib's interface predates const; it does not write to its input.
        z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
        z.avail_in = static_cast<uInt>(piece);
        z.next_out = reinterpret_cast<Bytef*>(buffer.data());
        z.avail_out = static_cast<uInt>(buffer.size());
        const int status = inflate(&z, Z_NO_FLUSH);
        taken += piece - z.avail_in;
        result.append(buffer.data(), buffer.size() - z.avail_out);
        if (result.size() > spare + largest_expansion * packed.size()) {
            throw InputError(
                name + ": the gz data holds more than " + std::to_string(largest_expansion) +
                " times its size, which no mesh does; unpack it yourself if it is one");
        }
        if (status == Z_STREAM_END) {
            if (taken == packed.size()) {
                return result;
            }
            inflateReset(&z); // a gz file may consist of several members
        } else if (status != Z_OK) {
            const bool cut = status == Z_BUF_ERROR && taken == packed.size();
            throw InputError(name + ": the gz data is " + (cut ? "truncated" : "damaged") +
                             " after byte " + std::to_string(taken) +
                             "; compress or copy the file again");
        }
    }
}

FileBytes::FileBytes(const std::filesystem::path& path) {
    const Descriptor file(path);
    if (file.get() < 0) {
        fail(path, std::string("cannot be opened: ") + std::strerror(errno));
    }
    struct stat info {};
    if (::fstat(file.get(), &info) != 0) {
        fail(path, std::string("cannot be examined: ") + std::strerror(errno));
    }
    if (S_ISDIR(info.st_mode)) {
        fail(path, "is a folder, not a file; name a file in it");
    }
    if (!S_ISREG(info.st_mode)) {
        fail(path, "is not a regular file; copy its content to one first");
    }
    mapped_size_ = static_cast<std::size_t>(info.st_size);
    if (mapped_size_ == 0) {
        return;
    }
    void* mapping = ::mmap(nullptr, mapped_size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
    if (mapping == MAP_FAILED) {
        fail(path, std::string("cannot be read: ") + std::strerror(errno));
    }
    mapping_ = mapping;
    view_ = {static_cast<const char*>(mapping_), mapped_size_};
    if (view_.substr(0, 2) == "\x1f\x8b") {
        try {
            unpacked_ = unpack_gz(view_, path.string());
        } catch (...) {
            ::munmap(mapping_, mapped_size_); // no destructor runs for a half-made object
            throw;
        }
        view_ = unpacked_;
        was_compressed_ = true;
    }
}

void FileBytes::forget(const char* begin, const char* end) const {
    if (was_compressed_ || mapping_ == nullptr) {
        return;
    }
    // Whole pages only: bytes beside the part may still be wanted.
    static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const auto first = static_cast<std::size_t>(begin - view_.data() + static_cast<int>(page) - 1);
    const auto last = static_cast<std::size_t>(end - view_.data());
    const std::size_t from = first / page * page;
    const std::size_t to = last / page * page;
    if (from < to) {
        // It is advice: nothing depends on whether it is taken.
        static_cast<void>(::madvise(static_cast<char*>(mapping_) + from, to - from, MADV_DONTNEED));
    }
}

FileBytes::~FileBytes() {
    if (mapping_) {
        ::munmap(mapping_, mapped_size_);
    }
}

} // namespace ameco
