// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/bridge/headless_gl.h"

#include "core/base/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

#include <string>

namespace ameco::gui {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw Error(ExitCode::not_built,
                "pictures need OpenGL, and this machine has none that works without a screen (" +
                    what + "): install a driver, e.g. Debian's libegl1 and libgl1-mesa-dri");
}

EGLDisplay display_without_screen() {
    const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display == nullptr) {
        fail("EGL has no platforms");
    }
    return get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

} // namespace

struct HeadlessGL::Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Context() {
        display = display_without_screen();
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
            fail("no surfaceless EGL display");
        }
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  2,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
            eglChooseConfig(display, wanted, &config, 1, &count) == EGL_FALSE || count == 0) {
            eglTerminate(display);
            fail("EGL knows no OpenGL");
        }
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
        if (context == EGL_NO_CONTEXT || !make_current()) {
            eglTerminate(display);
            fail("no context of OpenGL 3.2");
        }
    }
    ~Context() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        eglTerminate(display);
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] bool make_current() const {
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }
    static void on_make_current(vtkObject*, unsigned long, void* self, void*) {
        (void)static_cast<Context*>(self)->make_current();
    }
    static void on_is_current(vtkObject*, unsigned long, void* self, void* answer) {
        *static_cast<bool*>(answer) =
            eglGetCurrentContext() == static_cast<Context*>(self)->context;
    }
};

HeadlessGL::HeadlessGL(int width, int height)
    : context_(std::make_unique<Context>()),
      window_(vtkSmartPointer<GenericWindow>::Take(GenericWindow::New())) {
    window_->drawOffSide();
    vtkNew<vtkCallbackCommand> make_current;
    make_current->SetClientData(context_.get());
    make_current->SetCallback(&Context::on_make_current);
    window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, make_current);
    vtkNew<vtkCallbackCommand> is_current;
    is_current->SetClientData(context_.get());
    is_current->SetCallback(&Context::on_is_current);
    window_->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
    window_->start();
    window_->SetSize(width, height);
}

HeadlessGL::~HeadlessGL() {
    window_->Finalize();
    window_->RemoveAllObservers();
}

} // namespace ameco::gui
