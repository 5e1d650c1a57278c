// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/main_window.h"

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "gui/model/patch_model.h"
#include "gui/panels/chart_panel.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/command_panel.h"
#include "gui/panels/convergence_panel.h"
#include "gui/panels/hierarchy_panel.h"
#include "gui/panels/inspector_panel.h"
#include "gui/panels/level_charts.h"
#include "gui/panels/log_panel.h"
#include "gui/panels/patch_panel.h"
#include "gui/panels/view_panel.h"
#include "gui/theme.h"
#include "gui/view/compare_view.h"
#include "gui/view_controller.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QScrollArea>
#include <QStatusBar>
#include <QTableView>

namespace ameco::gui {
namespace {

/// A panel that may be higher than its dock.
QScrollArea* scrolling(QWidget* content) {
    auto* const area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(content->minimumSizeHint().width() + 18);
    return area;
}

} // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), document_(jobs_) {
    setWindowTitle(QStringLiteral("ameco"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    makePanels();
    makeDocks();
    makeStatusBar();
    makeMenus();
    connectJobs();
    connectDocument();
    connectPanels();
    resize(1440, 900);
    if (!views_->hasOpenGL()) {
        tell(Severity::warning, tr("no OpenGL 3.2 here: meshes are not drawn; tables, histograms "
                                   "and runs work"));
    }
    showCurrent();
}

MainWindow::~MainWindow() {
    // What still runs must find the document; signals must not find half a window.
    jobs_.disconnect(this);
    document_.disconnect(this);
    predictor_.disconnect(this);
}

void MainWindow::makePanels() {
    patches_ = new PatchModel(document_, this);
    views_ = new CompareView;
    setCentralWidget(views_);
    controller_ = new ViewController(document_, *views_, this);
    hierarchy_ = new HierarchyPanel(document_);
    patch_panel_ = new PatchPanel(*patches_);
    coarsen_ = new CoarsenPanel;
    view_panel_ = new ViewPanel;
    inspector_ = new InspectorPanel;
    aspect_ratios_ = new ChartPanel(QStringLiteral("aspect-ratios"));
    qualities_ = new ChartPanel(QStringLiteral("quality"));
    lengths_ = new ChartPanel(QStringLiteral("edge-lengths"));
    qualities_->chart().setSelectable(false);
    lengths_->chart().setSelectable(false);
    convergence_ = new ConvergencePanel(document_);
    log_ = new LogPanel;
    command_ = new CommandPanel;
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    auto* const levels = addDock(tr("Levels"), "levels", hierarchy_, Qt::LeftDockWidgetArea);
    auto* const patches = addDock(tr("Patches"), "patches", patch_panel_, Qt::LeftDockWidgetArea);
    auto* const coarsen =
        addDock(tr("Coarsen"), "coarsen", scrolling(coarsen_), Qt::RightDockWidgetArea);
    auto* const view = addDock(tr("View"), "view", scrolling(view_panel_), Qt::RightDockWidgetArea);
    auto* const node = addDock(tr("Node"), "node", inspector_, Qt::RightDockWidgetArea);
    tabifyDockWidget(coarsen, view);
    tabifyDockWidget(view, node);
    coarsen->raise();
    auto* const ratios =
        addDock(tr("Aspect ratios"), "aspect-ratios", aspect_ratios_, Qt::BottomDockWidgetArea);
    auto* const log = addDock(tr("Log"), "log", log_, Qt::BottomDockWidgetArea);
    auto* const quality = addDock(tr("Quality"), "quality", qualities_, Qt::BottomDockWidgetArea);
    auto* const lengths =
        addDock(tr("Edge lengths"), "edge-lengths", lengths_, Qt::BottomDockWidgetArea);
    auto* const convergence =
        addDock(tr("Convergence"), "convergence", convergence_, Qt::BottomDockWidgetArea);
    auto* const command = addDock(tr("Command"), "command", command_, Qt::BottomDockWidgetArea);
    tabifyDockWidget(ratios, quality);
    tabifyDockWidget(quality, lengths);
    tabifyDockWidget(lengths, convergence);
    ratios->raise();
    tabifyDockWidget(log, command);
    log->raise();
    for (QDockWidget* const dock :
         {coarsen, view, node, ratios, quality, lengths, convergence, log, command}) {
        dock->setTitleBarWidget(new QWidget(dock)); // the tab says it already
    }
    resizeDocks({levels, coarsen}, {330, 330}, Qt::Horizontal);
    resizeDocks({levels, patches}, {300, 260}, Qt::Vertical);
    resizeDocks({ratios, log}, {700, 400}, Qt::Horizontal);
    resizeDocks({ratios}, {250}, Qt::Vertical);
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content,
                                 Qt::DockWidgetArea area) {
    auto* const dock = new QDockWidget(title);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::raisePanel(QWidget& panel) {
    for (QWidget* w = &panel; w != nullptr; w = w->parentWidget()) {
        if (auto* const dock = qobject_cast<QDockWidget*>(w)) {
            dock->show();
            dock->raise();
            return;
        }
    }
}

void MainWindow::makeStatusBar() {
    status_ = new QLabel;
    statusBar()->addPermanentWidget(status_);
}

void MainWindow::tell(Severity severity, const QString& text) {
    log_->add(severity, text);
    statusBar()->showMessage(text, severity == Severity::error ? 0 : 8000);
    if (severity == Severity::error) {
        raisePanel(*log_);
    }
}

void MainWindow::connectJobs() {
    connect(&jobs_, &JobRunner::started, this, [this](const QString& title) {
        coarsen_->showStart(title);
        log_->add(Severity::info, title);
        statusBar()->showMessage(title + QStringLiteral("…"));
    });
    connect(&jobs_, &JobRunner::progressed, this, [this](double fraction, const QString& step) {
        coarsen_->showProgress(fraction, step);
        statusBar()->showMessage(
            QStringLiteral("%1: %2 (%3 %)").arg(jobs_.title(), step).arg(qRound(100 * fraction)));
    });
    connect(&jobs_, &JobRunner::said, this, &MainWindow::tell);
    connect(&jobs_, &JobRunner::ended, this, &MainWindow::endJob);
    connect(&inspections_, &JobRunner::ended, this, [this](JobEnd end, const QString& reason) {
        if (end == JobEnd::failed) {
            tell(Severity::warning, reason);
        }
    });
}

void MainWindow::endJob(JobEnd end, const QString& reason) {
    coarsen_->showEnd();
    controller_->dropSketch();
    switch (end) {
    case JobEnd::failed:
        session_.reset();
        tell(Severity::error, reason);
        break;
    case JobEnd::cancelled:
        session_.reset();
        tell(Severity::info, tr("%1: cancelled; what was finished is kept").arg(jobs_.title()));
        break;
    case JobEnd::done:
        statusBar()->showMessage(tr("%1: done").arg(jobs_.title()), 8000);
    }
    prepareRemovedAt();
}

void MainWindow::connectDocument() {
    connect(&document_, &Document::opened, this, [this] {
        removed_at_known_ = false;
        setWindowTitle(QFileInfo(QString::fromStdString(document_.file().path)).fileName() +
                       QStringLiteral(" — ameco"));
        remember(opening_);
        const SceneData& scene = *document_.levels().front().scene;
        view_panel_->setBounds(scene.focus_low, scene.focus_high);
        coarsen_->setFrozenPatches(patches_->frozenPatches());
        const LevelStatistics& s = document_.levels().front().statistics;
        tell(Severity::info,
             tr("%1: %2 nodes, %3 %4, %5")
                 .arg(QFileInfo(QString::fromStdString(document_.file().path)).fileName(),
                      QString::fromStdString(count_text(s.nodes)),
                      QString::fromStdString(count_text(s.elements)),
                      document_.file().dimension == 3 ? tr("tets") : tr("triangles"),
                      QString::fromStdString(document_.file().format)));
        if (session_) {
            restore(*session_);
            session_.reset();
        }
    });
    const auto changed = [this] {
        removed_at_known_ = false;
        showCharts();
        showCommand();
    };
    connect(&document_, &Document::levelAdded, this, changed);
    connect(&document_, &Document::levelRemoved, this, changed);
    connect(&document_, &Document::closed, this,
            [this] { setWindowTitle(QStringLiteral("ameco")); });
    connect(&document_, &Document::currentChanged, this, &MainWindow::showCurrent);
    connect(&document_, &Document::levelAdded, this, [this](int id) {
        const LevelStatistics& s = document_.level(id)->statistics;
        tell(Severity::info, tr("level %1: %2 nodes, ratio %3")
                                 .arg(s.level)
                                 .arg(QString::fromStdString(count_text(s.nodes)),
                                      QString::fromStdString(ratio_text(s.ratio))));
    });
    connect(&document_, &Document::exported, this,
            [this](const QString& path) { tell(Severity::info, tr("written: %1").arg(path)); });
    connect(&predictor_, &Predictor::changed, this, [this] {
        coarsen_->setPrediction(predictor_.prediction());
        showCharts();
    });
}

void MainWindow::connectPanels() {
    connect(coarsen_, &CoarsenPanel::optionsChanged, this, &MainWindow::predict);
    connect(coarsen_, &CoarsenPanel::runRequested, this, &MainWindow::run);
    connect(coarsen_, &CoarsenPanel::cancelRequested, &jobs_, &JobRunner::cancel);
    connect(coarsen_, &CoarsenPanel::threadsChanged, this, [this](int threads) {
        set_thread_count(threads);
        showCommand();
    });
    connect(patches_, &PatchModel::frozenChanged, this,
            [this] { coarsen_->setFrozenPatches(patches_->frozenPatches()); });
    connect(patches_, &PatchModel::hiddenChanged, this, [this] {
        SceneOptions options = controller_->options();
        options.hidden_patches = patches_->hidden();
        changeScene(options);
    });
    connect(patch_panel_, &PatchPanel::selectionChanged, this, &MainWindow::showCharts);
    connect(view_panel_, &ViewPanel::optionsChanged, this, &MainWindow::changeScene);
    connect(view_panel_, &ViewPanel::lensAtPickRequested, this, [this] {
        const auto& picked = controller_->picked();
        if (picked && picked->pick) {
            SceneOptions options = controller_->options();
            options.lens.enabled = true;
            options.lens.origin = picked->pick->position;
            options.lens.normal = picked->pick->normal;
            changeScene(options);
        }
    });
    connect(view_panel_, &ViewPanel::meansSideBySideRequested, controller_,
            &ViewController::setMeansSideBySide);
    connect(controller_, &ViewController::shownLevelsChanged, this, [this] {
        view_panel_->setMeansSideBySide(controller_->areMeansSideBySide());
        checkViewCount();
    });
    connect(controller_, &ViewController::optionsChanged, view_panel_, &ViewPanel::setOptions);
    connect(controller_, &ViewController::nodePicked, this, &MainWindow::inspectPicked);
    connect(views_, &CompareView::rendered, this, [this](int view) {
        if (view == controller_->activeView()) {
            view_panel_->setShownRange(views_->view(view).scene().shown_range());
        }
    });
    connect(views_, &CompareView::filesDropped, this, [this](const QStringList& files) {
        if (!files.isEmpty()) {
            openPath(files.front());
        }
    });
    connect(inspector_, &InspectorPanel::nodeRequested, this, [this](int node) {
        if (document_.current() != nullptr) {
            goToNode(document_.current()->id, node);
        }
    });
    connect(inspector_, &InspectorPanel::placeRequested, this, &MainWindow::goToNode);
    connectCharts();
}

void MainWindow::connectCharts() {
    connect(&aspect_ratios_->chart(), &ChartWidget::selectionChanged, this,
            &MainWindow::selectClasses);
    for (ChartPanel* const panel :
         std::initializer_list<ChartPanel*>{aspect_ratios_, qualities_, lengths_, convergence_}) {
        connect(panel, &ChartPanel::exported, this,
                [this](const QString& path) { tell(Severity::info, tr("written: %1").arg(path)); });
        connect(panel, &ChartPanel::failed, this,
                [this](const QString& reason) { tell(Severity::error, reason); });
    }
    connect(&convergence_->jobs(), &JobRunner::said, this, &MainWindow::tell);
    connect(&convergence_->jobs(), &JobRunner::ended, this,
            [this](JobEnd end, const QString& reason) {
                if (end == JobEnd::failed) {
                    tell(Severity::error, reason);
                }
            });
}

void MainWindow::openPath(const QString& path) {
    opening_ = QFileInfo(path).absoluteFilePath();
    if (path.endsWith(QStringLiteral(".ameco"))) {
        openSession(path);
    } else {
        session_.reset();
        session_path_.clear();
        document_.open(opening_);
    }
}

void MainWindow::showCurrent() {
    const CaseLevel* const current = document_.current();
    coarsen_->setLevel(current);
    coarsen_->setPrediction(std::nullopt);
    inspector_->setNodeCount(current != nullptr ? current->statistics.nodes : 0);
    for (QAction* const action : needs_case_) {
        action->setEnabled(current != nullptr);
    }
    status_->setText(
        current != nullptr
            ? tr("level %1: %2 nodes, %3 elements  ")
                  .arg(current->number)
                  .arg(QString::fromStdString(count_text(current->statistics.nodes)),
                       QString::fromStdString(count_text(current->statistics.elements)))
            : tr("no mesh is open  "));
    predict();
    showCharts();
    showCommand();
}

void MainWindow::predict() {
    predictor_.request(document_.current(), coarsen_->options(),
                       document_.isOpen() ? document_.levels().front().statistics.classes.max : 1);
}

void MainWindow::showCharts() {
    const Branch branch = document_.currentBranch();
    std::vector<double> selection;
    const std::set<int> patches = patch_panel_->selectedPatches();
    const CaseLevel* const current = document_.current();
    if (current != nullptr && !patches.empty() && current->statistics.elements > 0) {
        selection = count_nodes(*current, nodes_of_patches(*current, patches));
    }
    Chart chart = aspect_ratio_chart(branch, predictor_.prediction(),
                                     current != nullptr ? current->number : 0, selection,
                                     tr("selected patches"));
    if (const auto& shown = inspector_->inspection()) {
        const auto& classes =
            branch.empty() ? AspectRatioClasses{} : branch.front()->statistics.classes;
        if (!classes.counts.empty()) {
            const int count = static_cast<int>(classes.counts.size());
            chart.marked =
                mirrored({static_cast<int>(classes.class_of(shown->aspect_ratio))}, count);
        }
    }
    aspect_ratios_->setChart(chart);
    qualities_->setChart(quality_chart(branch));
    lengths_->setChart(length_chart(branch));
}

void MainWindow::showCommand() {
    const Branch branch = document_.currentBranch();
    command_->setCommand(
        document_.commandLine(branch.empty() ? -1 : branch.back()->id, coarsen_->threads()));
}

void MainWindow::selectClasses(const std::set<int>& chart_classes) {
    const int count = aspect_ratios_->chart().chart().classCount();
    controller_->highlightClasses(mirrored(chart_classes, count));
    statusBar()->showMessage(
        chart_classes.empty()
            ? QString()
            : tr("%1 nodes selected")
                  .arg(QString::fromStdString(
                      count_text(static_cast<std::int64_t>(controller_->highlightedCount())))));
}

void MainWindow::inspectPicked() {
    const auto& picked = controller_->picked();
    const CaseLevel* const level = picked ? document_.level(picked->level_id) : nullptr;
    view_panel_->setPickKnown(picked && picked->pick);
    if (level == nullptr || level->statistics.elements == 0) {
        inspections_.cancel();
        inspector_->clear();
        showCharts();
        return;
    }
    std::vector<InspectorPanel::Elsewhere> elsewhere;
    for (const CaseLevel* other : document_.currentBranch()) {
        if (other->id != level->id) {
            elsewhere.push_back(
                {other->id, other->number, document_.sameNode(level->id, picked->node, other->id)});
        }
    }
    inspections_.start(tr("Inspecting"),
                       [this, level = *level, node = picked->node, elsewhere,
                        element = picked->pick ? picked->pick->element : ElementId(),
                        target = coarsen_->options().coarsen.target](JobContext& job) {
                           const Inspection inspection = inspect(level, node, target, element);
                           job.post([this, inspection, elsewhere] {
                               inspector_->setInspection(inspection, elsewhere);
                               showCharts();
                           });
                       });
}

void MainWindow::goToNode(int level_id, int node) {
    const CaseLevel* const level = document_.level(level_id);
    if (level != nullptr && node >= 0 && node < level->statistics.nodes) {
        document_.setCurrent(level_id);
        controller_->pick({level_id, NodeId(node), std::nullopt});
        controller_->lookAtPicked();
    }
}

void MainWindow::changeScene(const SceneOptions& options) {
    controller_->setOptions(options);
    view_panel_->setOptions(options);
    patches_->setHidden(options.hidden_patches);
    prepareRemovedAt();
}

void MainWindow::prepareRemovedAt() {
    if (controller_->options().colour == ColourBy::removed_at && !removed_at_known_ &&
        document_.isOpen() && !jobs_.isRunning()) {
        removed_at_known_ = true;
        document_.prepareRemovedAt();
    }
}

void MainWindow::run() {
    if (document_.current() != nullptr) {
        document_.coarsen(document_.current()->id, coarsen_->options());
    }
}

void MainWindow::setDark(bool dark) {
    apply_theme(*static_cast<QApplication*>(QApplication::instance()), dark);
    dark_action_->setChecked(dark);
    SceneOptions options = controller_->options();
    options.dark = dark;
    changeScene(options);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    jobs_.cancel();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) {
        event->acceptProposedAction();
        openPath(urls.front().toLocalFile());
    }
}

} // namespace ameco::gui
