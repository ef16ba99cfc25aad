# Every source file has a test of its name: base/text.cpp is tested by tests/base/test_text.cpp or test_text_lines.cpp, unless there is a
# base/text_lines.cpp, whose test that is. A test of several sources names those of other names in lines "// Covers: tetgen, base/text" behind its
# first comment, by their names in its own folder or with their folder: sources whose main function cannot be broken without a failure of the test.
# The table below has the others, with the reason. Called with -DSOURCE_DIR=<source tree>.
cmake_minimum_required(VERSION 3.25)
set(without_test
  "app/main: the program itself, which every test of tests/app/commands runs"
  "app/commands/view: opens the window, as every test of tests/app/window does"
  "app/commands/soak: runs for hours"
  "app/bench/device: measures the device, there is no other measure of it to compare with"
  "app/bench/speed: runs for minutes, its table of times is tests/app/bench/test_speed_table.cpp's"
  "app/bench/skip: runs for minutes, tests/sim/gpu/test_solver_cost.cpp counts what is off"
  "app/dialogs/dialog: widgets of a window, tests/app/window/test_window_dialogs.cpp types and clicks in them"
  "app/dialogs/file_dialogs: as dialog"
  "app/dialogs/folder_browser: as dialog"
  "app/dialogs/save_dialog: as dialog"
  "app/panels/*: tests/app/panels looks at all panels at once"
  "app/ui/icons: strokes in a panel, as app/panels"
  "app/ui/log_plot: draws in a panel, as app/panels"
  "app/ui/style: colors and sizes of the panels, as app/panels"
  "app/ui/widgets: rows of the panels, as app/panels"
  "app/ui/window_input: input of a window, tests/app/window/test_window_typing.cpp types and clicks"
  "app/video/capture: films a window, tests/app/window/test_window_video.cpp measures its videos"
  "app/window/*: tests/app/window looks at the window from outside"
)

set(folders base gl sim render app api python)
set(patterns)
foreach(folder IN LISTS folders)
  list(APPEND patterns ${SOURCE_DIR}/${folder}/*.cpp)
endforeach()
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${patterns})
list(TRANSFORM sources REPLACE "\\.cpp$" "")
file(GLOB_RECURSE tests RELATIVE ${SOURCE_DIR}/tests ${SOURCE_DIR}/tests/test_*.cpp ${SOURCE_DIR}/tests/test_*.py)
list(REMOVE_DUPLICATES sources)

set(tested)   # by a test of its name
set(covered)  # named by a test
foreach(test IN LISTS tests)
  cmake_path(GET test PARENT_PATH folder)
  cmake_path(GET test STEM name)
  string(REGEX REPLACE "^test_" "" name ${name})
  while(NOT "${folder}/${name}" IN_LIST sources AND name MATCHES "_")
    string(REGEX REPLACE "_[^_]*$" "" name ${name})
  endwhile()
  list(APPEND tested ${folder}/${name})
  file(STRINGS ${SOURCE_DIR}/tests/${test} lines REGEX "^(//|#) Covers: ")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^(//|#) Covers: *" "" names "${line}")
    string(REGEX REPLACE ", *" ";" names "${names}")
    foreach(source IN LISTS names)
      if(NOT source MATCHES "/")
        set(source ${folder}/${source})
      endif()
      if(NOT source IN_LIST sources)
        message(SEND_ERROR "tests/${test}: covers ${source}, which is no source")
      endif()
      list(APPEND covered ${source})
    endforeach()
  endforeach()
endforeach()

set(rows)
foreach(row IN LISTS without_test)
  string(REGEX MATCH "^[^:]+" name "${row}")
  if(NOT row MATCHES "^[^:]+: .")
    message(SEND_ERROR "the row \"${row}\" of tests/test_names.cmake has no reason")
  endif()
  list(APPEND rows ${name})
endforeach()

set(own_count 0)
set(covered_count 0)
set(used)
foreach(source IN LISTS sources)
  if(source IN_LIST tested)
    math(EXPR own_count "${own_count} + 1")
    continue()
  elseif(source IN_LIST covered)
    math(EXPR covered_count "${covered_count} + 1")
    continue()
  endif()
  set(row)
  if(source IN_LIST rows)
    set(row ${source})
  endif()
  foreach(pattern IN LISTS rows)
    string(REGEX REPLACE "\\*$" "" begin "${pattern}")
    string(FIND "${source}" "${begin}" place)
    if(pattern MATCHES "\\*$" AND place EQUAL 0)
      set(row ${pattern})
    endif()
  endforeach()
  if(row)
    list(APPEND used ${row})
  else()
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET source FILENAME name)
    message(SEND_ERROR "${source}.cpp: expected tests/${folder}/test_${name}.cpp, or a line \"// Covers: ${name}\" of a test in tests/${folder}")
  endif()
endforeach()

foreach(row IN LISTS rows)
  if(row IN_LIST used)
    continue()
  elseif(row IN_LIST sources)
    message(SEND_ERROR "the row \"${row}\" of tests/test_names.cmake is not needed any more: there is a test of it")
  else()
    message(SEND_ERROR "the row \"${row}\" of tests/test_names.cmake has no source without a test")
  endif()
endforeach()
list(LENGTH sources count)
list(LENGTH rows rows_count)
message(STATUS "${count} sources: ${own_count} with a test of their name, ${covered_count} covered by another one; ${rows_count} rows of others")
