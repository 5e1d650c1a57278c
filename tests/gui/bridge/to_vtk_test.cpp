// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/bridge/to_vtk.h"

#include <QTest>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

using namespace ameco;
using namespace ameco::gui;

namespace {

std::vector<vtkIdType> corners(vtkCellArray* cells, vtkIdType cell) {
    vtkNew<vtkIdList> ids;
    cells->GetCellAtId(cell, ids);
    return {ids->begin(), ids->end()};
}

} // namespace

class ToVtkTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_triangles_and_quadrilaterals_apart();
    void makes_lines_and_vertices();
    void keeps_the_order_of_numbers();
    void takes_nothing_for_nothing();
};

void ToVtkTest::keeps_triangles_and_quadrilaterals_apart() {
    const std::vector<std::array<std::int32_t, 4>> polygons{
        {0, 1, 2, -1}, {3, 2, 1, 0}, {4, 3, 0, -1}};
    const auto cells = to_vtk(polygons);
    QCOMPARE(cells->GetNumberOfCells(), vtkIdType(3));
    QCOMPARE(corners(cells, 0), (std::vector<vtkIdType>{0, 1, 2}));
    QCOMPARE(corners(cells, 1), (std::vector<vtkIdType>{3, 2, 1, 0}));
    QCOMPARE(corners(cells, 2), (std::vector<vtkIdType>{4, 3, 0}));
}

void ToVtkTest::makes_lines_and_vertices() {
    const std::vector<std::array<std::int32_t, 2>> lines{{5, 1}, {1, 2}};
    const auto cells = to_vtk(lines);
    QCOMPARE(cells->GetNumberOfCells(), vtkIdType(2));
    QCOMPARE(corners(cells, 0), (std::vector<vtkIdType>{5, 1}));
    const auto points = vertices(3);
    QCOMPARE(points->GetNumberOfCells(), vtkIdType(3));
    QCOMPARE(corners(points, 2), (std::vector<vtkIdType>{2}));
}

void ToVtkTest::keeps_the_order_of_numbers() {
    const auto points = to_vtk_points({{1, 2, 3}, {-4, 5e-9, 6}});
    QCOMPARE(points->GetNumberOfPoints(), vtkIdType(2));
    QCOMPARE(points->GetPoint(1)[0], -4.0);
    QCOMPARE(static_cast<float>(points->GetPoint(1)[1]), 5e-9F);
    const auto colours = to_vtk(std::vector<Rgba>{{1, 2, 3, 4}, {5, 6, 7, 8}});
    QCOMPARE(colours->GetNumberOfComponents(), 4);
    QCOMPARE(colours->GetTypedComponent(1, 2), static_cast<unsigned char>(7));
    QCOMPARE(to_vtk(std::vector<float>{1, 2.5F})->GetValue(1), 2.5F);
}

void ToVtkTest::takes_nothing_for_nothing() {
    QCOMPARE(to_vtk(std::vector<std::array<std::int32_t, 4>>())->GetNumberOfCells(), vtkIdType(0));
    QCOMPARE(to_vtk(std::vector<Rgb>())->GetNumberOfTuples(), vtkIdType(0));
    QCOMPARE(vertices(0)->GetNumberOfCells(), vtkIdType(0));
}

QTEST_APPLESS_MAIN(ToVtkTest)
#include "to_vtk_test.moc"
