// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The module's only visible symbol.
#include "core/base/parallel.h"
#include "gui/render/render_picture.h"

#include <exception>
#include <new>

extern "C" __attribute__((visibility("default"))) void
ameco_render_picture(const ameco::gui::RenderJob& job, ameco::gui::RenderResult& result) {
    using ameco::ExitCode;
    try {
        ameco::set_thread_count(job.threads);
        result.png = ameco::gui::to_png(ameco::gui::render_picture(job, result));
    } catch (const ameco::Error& error) {
        result.code = error.code();
        result.error = error.what();
    } catch (const std::bad_alloc&) {
        result.code = ExitCode::memory;
        result.error = "not enough memory for the picture: make it smaller";
    } catch (const std::exception& error) {
        result.code = ExitCode::internal;
        result.error = std::string("internal error: ") + error.what();
    }
}
