// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The window: menus, docks, and what is connected to what. It computes nothing.
#pragma once

#include "gui/jobs/job_runner.h"
#include "gui/model/document.h"
#include "gui/model/inspection.h"
#include "gui/model/predictor.h"
#include "gui/session.h"

#include <QMainWindow>

#include <optional>

class QActionGroup;
class QLabel;
class QMenu;
class QScrollArea;

namespace ameco::gui {

class ChartPanel;
class CoarsenPanel;
class CommandPanel;
class CompareView;
class ConvergencePanel;
class HierarchyPanel;
class InspectorPanel;
class LogPanel;
class PatchModel;
class PatchPanel;
class ViewController;
class ViewPanel;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] JobRunner& jobs() { return jobs_; }
    [[nodiscard]] CompareView& views() { return *views_; }
    [[nodiscard]] ViewController& viewController() { return *controller_; }
    [[nodiscard]] PatchModel& patches() { return *patches_; }
    [[nodiscard]] CoarsenPanel& coarsenPanel() { return *coarsen_; }
    [[nodiscard]] ViewPanel& viewPanel() { return *view_panel_; }
    [[nodiscard]] InspectorPanel& inspectorPanel() { return *inspector_; }
    [[nodiscard]] ChartPanel& aspectRatioPanel() { return *aspect_ratios_; }
    [[nodiscard]] ChartPanel& qualityPanel() { return *qualities_; }
    [[nodiscard]] ConvergencePanel& convergencePanel() { return *convergence_; }
    [[nodiscard]] LogPanel& logPanel() { return *log_; }
    [[nodiscard]] CommandPanel& commandPanel() { return *command_; }
    [[nodiscard]] HierarchyPanel& hierarchyPanel() { return *hierarchy_; }
    [[nodiscard]] PatchPanel& patchPanel() { return *patch_panel_; }

public slots:
    /// Opens a mesh, a hierarchy's folder or a session; what is open stays until it has been read.
    void openPath(const QString& path);
    void saveSessionTo(const QString& path);
    /// \param factor  pixels per pixel of the views: 1, 2, 4
    void saveScreenshot(const QString& path, int factor, bool transparent);
    void setViewCount(int count);
    void setDark(bool dark);
    void raisePanel(QWidget& panel); ///< brings the dock that holds it to the front

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window.cpp
    void makePanels();
    void makeDocks();
    QDockWidget* addDock(const QString& title, const QString& name, QWidget* content,
                         Qt::DockWidgetArea area);
    void makeStatusBar();
    void connectJobs();
    void connectDocument();
    void connectPanels();
    void connectCharts();
    void tell(Severity severity, const QString& text);
    void endJob(JobEnd end, const QString& reason);
    void showCurrent();
    void showCharts();
    void showCommand();
    void predict();
    void inspectPicked();
    void goToNode(int level_id, int node);
    void selectClasses(const std::set<int>& chart_classes);
    void changeScene(const SceneOptions& options);
    void prepareRemovedAt();
    void run();

    // main_window_menus.cpp
    void makeMenus();
    void makeFileMenu();
    void makeViewMenu();
    void addCameraActions(QMenu& menu);
    void addLookActions(QMenu& menu);
    void makeLevelMenu();
    void makeHelpMenu();
    QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& shortcut,
                       std::function<void()> action);
    void chooseMesh();
    void chooseHierarchy();
    void chooseSession();
    void chooseFolderForLevels();
    void chooseMeshFile();
    void chooseScreenshot(int factor, bool transparent);
    void checkViewCount(); ///< in the menu
    void stepLevel(int step);
    void remember(const QString& path);
    void fillRecent();

    // main_window_session.cpp
    void openSession(const QString& path);
    [[nodiscard]] Session currentSession() const;
    void restore(const Session& session);

    JobRunner jobs_;
    JobRunner inspections_;
    Document document_;
    Predictor predictor_;
    PatchModel* patches_ = nullptr;

    CompareView* views_ = nullptr;
    ViewController* controller_ = nullptr;
    HierarchyPanel* hierarchy_ = nullptr;
    PatchPanel* patch_panel_ = nullptr;
    CoarsenPanel* coarsen_ = nullptr;
    ViewPanel* view_panel_ = nullptr;
    InspectorPanel* inspector_ = nullptr;
    ChartPanel* aspect_ratios_ = nullptr;
    ChartPanel* qualities_ = nullptr;
    ChartPanel* lengths_ = nullptr;
    ConvergencePanel* convergence_ = nullptr;
    LogPanel* log_ = nullptr;
    CommandPanel* command_ = nullptr;
    QLabel* status_ = nullptr;
    QMenu* recent_ = nullptr;
    QMenu* panels_menu_ = nullptr;
    QActionGroup* view_counts_ = nullptr;
    QAction* dark_action_ = nullptr;
    std::vector<QAction*> needs_case_;

    std::optional<Session> session_; ///< being opened
    QString session_path_;           ///< of the session that is open
    QString opening_;                ///< path that is being opened
    bool removed_at_known_ = false;
};

} // namespace ameco::gui
