// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/vtk_messages.h"

#include <algorithm>

namespace ameco::vtk {

vtkStandardNewMacro(MessageCatcher);

std::string MessageCatcher::error() const {
    // "ERROR: In file.cxx, line 3\nvtkXMLReader (0x1234): what happened\n\n"
    std::string text = error_;
    const std::size_t object = text.find("): ");
    text.erase(0, object == std::string::npos ? 0 : object + 3);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t last = text.find_last_not_of(' ');
    return text.substr(0, last == std::string::npos ? 0 : last + 1);
}

Silence::Silence()
    : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()),
      catcher_(vtkSmartPointer<MessageCatcher>::New()) {
    vtkOutputWindow::SetInstance(catcher_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // which prints beside the window
}

Silence::~Silence() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
}

} // namespace ameco::vtk
