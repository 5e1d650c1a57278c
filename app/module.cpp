// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/module.h"

#include "core/base/error.h"

#include <filesystem>
#include <system_error>

#include <dlfcn.h>

namespace ameco {
namespace {

namespace fs = std::filesystem;

fs::path program_folder() {
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure);
    return failure ? fs::path(".") : program.parent_path();
}

std::string last_message() {
    const char* const message = dlerror();
    return message != nullptr ? message : "unknown reason";
}

} // namespace

void* load_symbol(const std::string& name, const std::string& symbol) {
    const std::string file = "lib" + name + ".so";
    const fs::path here = program_folder();
    for (const char* const folder : {".", AMECO_MODULE_FOLDER, "../gui"}) {
        const fs::path path = (here / folder / file).lexically_normal();
        std::error_code ignored;
        if (!fs::exists(path, ignored)) {
            continue;
        }
        void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (module == nullptr) {
            throw Error(ExitCode::not_built, path.string() + ": cannot be loaded (" +
                                                 last_message() +
                                                 "): install the libraries it was built with");
        }
        void* const function = dlsym(module, symbol.c_str());
        if (function == nullptr) {
            throw Error(ExitCode::not_built, path.string() + ": is not of this program (" +
                                                 last_message() + "): install both anew");
        }
        return function;
    }
    throw Error(ExitCode::not_built,
                file +
                    " is missing: this ameco was built without it, since VTK's rendering was not "
                    "found");
}

} // namespace ameco
