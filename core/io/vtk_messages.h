// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What VTK would print, caught. Includes VTK's headers: for the vtk_*.cpp files only.
#pragma once

#include <string>

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace ameco::vtk {

/// Field array of our files: bytes of text, a line of number and name for each patch.
inline constexpr const char* patch_names_array = "patch_names";

/// Keeps the first error that VTK reports, and shows none.
class MessageCatcher : public vtkOutputWindow {
public:
    static MessageCatcher* New();
    // clang-format off: the macro ends in a function body, behind which a semicolon is an error
    vtkTypeMacro(MessageCatcher, vtkOutputWindow)
        // clang-format on

        void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override {
        if (error_.empty()) {
            error_ = text;
        }
    }
    /// The first error in one line, without the place in VTK's sources; empty if there was none.
    [[nodiscard]] std::string error() const;

private:
    std::string error_;
};

/// Catches messages while it lives.
class Silence {
public:
    Silence();
    ~Silence();
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;
    [[nodiscard]] std::string error() const { return catcher_->error(); }

private:
    vtkSmartPointer<vtkOutputWindow> before_;
    vtkLogger::Verbosity verbosity_;
    vtkSmartPointer<MessageCatcher> catcher_;
};

} // namespace ameco::vtk
