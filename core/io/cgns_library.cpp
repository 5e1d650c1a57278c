// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/cgns_library.h"

namespace ameco::cgns {
namespace {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

} // namespace

File::File(const std::filesystem::path& path, int mode, std::string name)
    : lock_(library_mutex()), name_(std::move(name)), mode_(mode) {
    require(cg_open(path.c_str(), mode, &id_), "cannot be opened");
}

File::~File() {
    if (id_ >= 0) {
        cg_close(id_);
    }
}

void File::fail(const std::string& what) const {
    if (mode_ == CG_MODE_WRITE) {
        throw FileError(name_ + ": " + what);
    }
    throw InputError(name_ + ": " + what);
}

void File::require(int status, const std::string& what) const {
    if (status != CG_OK) {
        fail(what + ": " + cg_get_error());
    }
}

void File::close() {
    const int id = id_;
    id_ = -1;
    require(cg_close(id), "cannot be written");
}

} // namespace ameco::cgns
