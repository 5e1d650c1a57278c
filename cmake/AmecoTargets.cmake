# Compiler settings shared by all of our targets, as interface targets, and the one-line test registration.

add_library(ameco_settings INTERFACE)
target_compile_features(ameco_settings INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
target_compile_options(ameco_settings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wformat=2
    # The same bytes from every compiler: no fused multiply-add behind our back.
    -ffp-contract=off
    # GCC 12 sees overlapping copies in std::string's operator+ where there are none (its bug 105329).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${AMECO_WARNINGS_AS_ERRORS}>:-Werror>)
if(AMECO_SANITIZE)
    target_compile_options(ameco_settings INTERFACE -fsanitize=${AMECO_SANITIZE} -fno-omit-frame-pointer
        -fno-sanitize-recover=all)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # What GCC inserts for the sanitizers makes it see uninitialised members in std::function.
        target_compile_options(ameco_settings INTERFACE -Wno-maybe-uninitialized)
    endif()
    target_link_options(ameco_settings INTERFACE -fsanitize=${AMECO_SANITIZE})
endif()

# What nearly every test reads, compiled once: half of what a test takes to build. Tests that use Qt's
# Gui have other macros, with which it cannot be used.
function(ameco_add_test_headers)
    # Qt's test library gives every test its own folders as macros (for QFINDTESTDATA), which would
    # make the headers differ.
    set_property(TARGET Qt6::Test PROPERTY INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
    file(CONFIGURE OUTPUT test_headers.cpp CONTENT "// Holds nothing: CMake wants a file to compile the headers for.\n")
    add_library(ameco_test_headers OBJECT "${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp")
    target_link_libraries(ameco_test_headers PRIVATE ameco_core ameco_settings Qt6::Test)
    target_precompile_headers(ameco_test_headers PRIVATE <QtTest> <Eigen/Dense>)
endfunction()

# ameco_add_test(<name> LABELS <label>...): builds <name>.cpp of the current folder as a Qt Test
# executable; its CTest name is the path under tests/, e.g. core/metric/edge_length_test.
# WINDOW: it opens windows, on a screen of its own; skipped by name where xvfb-run is missing.
find_program(AMECO_XVFB_RUN xvfb-run)
function(ameco_add_test name)
    cmake_parse_arguments(ARG "WINDOW" "TIMEOUT" "LABELS;LIBRARIES" ${ARGN})
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}/tests" "${CMAKE_CURRENT_SOURCE_DIR}")
    string(REPLACE "/" "_" prefix "${folder}")
    set(target "${prefix}_${name}")
    add_executable(${target} ${name}.cpp)
    # Without the compiler's predefined macros, moc sees no C++20 in the standard headers, whose
    # concepts Qt 6.4's moc cannot parse.
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_COMPILER_PREDEFINES OFF)
    target_compile_definitions(${target} PRIVATE
        AMECO_SHARED_DIR="${AMECO_SHARED_DIR}"
        AMECO_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        AMECO_PROGRAM="$<TARGET_FILE:ameco>")
    target_link_libraries(${target} PRIVATE ameco_core ameco_settings Qt6::Test ${ARG_LIBRARIES})
    add_dependencies(${target} ameco)
    if(NOT folder MATCHES "^gui" AND NOT "Qt6::Gui" IN_LIST ARG_LIBRARIES)
        target_precompile_headers(${target} REUSE_FROM ameco_test_headers)
        # Without it ccache keeps nothing that uses them.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
    if(ARG_WINDOW AND AMECO_XVFB_RUN)
        add_test(NAME ${folder}/${name} COMMAND "${AMECO_XVFB_RUN}" -a -s "-screen 0 1600x1200x24"
            $<TARGET_FILE:${target}>)
        set_property(TEST ${folder}/${name} PROPERTY ENVIRONMENT
            QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1)
    elseif(ARG_WINDOW)
        add_test(NAME ${folder}/${name} COMMAND "${CMAKE_COMMAND}" -E echo
            "SKIP: xvfb-run is missing (Debian: xvfb xauth)")
        set_property(TEST ${folder}/${name} PROPERTY SKIP_REGULAR_EXPRESSION "SKIP: xvfb-run")
    else()
        add_test(NAME ${folder}/${name} COMMAND ${target})
    endif()
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    set_tests_properties(${folder}/${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
