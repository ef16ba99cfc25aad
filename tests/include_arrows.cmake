# Which folder may include from which: one row per folder, which may include its own files and those of the folders after the colon. An include
# that is not in the table fails with the name of the row. The table has no cycle, so that each folder depends only on those below it.
# Called with -DSOURCE_DIR=<source tree>.
cmake_minimum_required(VERSION 3.25)
set(arrows
  "base:"
  "base/csv:"
  "base/json: base"
  "gl: base"
  "gl/context: base gl"
  "gl/timing: gl"
  "sim/accuracy: sim/elements sim/material sim/mesh sim/model sim/reference"
  "sim/bare_mesh: base sim/elements sim/grab sim/material sim/mesh sim/model sim/reference sim/surface"
  "sim/coarse: shaders/shared sim/material sim/mesh sim/model"
  "sim/contact: base sim/contact/tissue sim/model sim/surface sim/tool"
  "sim/contact/passing: sim/contact sim/contact/tissue sim/model sim/tool"
  "sim/contact/tissue: sim/elements sim/mesh sim/model sim/surface sim/tool"
  "sim/elements: sim/mesh"
  "sim/fit: base sim/fit/measured sim/fit/simulated sim/grab sim/material sim/model sim/reference sim/scene"
  "sim/fit/gpu: gl sim/fit/simulated sim/simulation"
  "sim/fit/measured: base base/csv sim/contact sim/mesh sim/model sim/reference sim/surface"
  "sim/fit/simulated: sim/contact sim/integrators sim/model sim/reference sim/reference/tangent sim/scene"
  "sim/gpu: base gl sim/coarse sim/contact sim/gpu/acceleration sim/gpu/contact sim/gpu/integrators sim/gpu/methods sim/gpu/passes sim/gpu/readback sim/model sim/reference"
  "sim/gpu/acceleration: gl sim/gpu/passes sim/scene/settings"
  "sim/gpu/contact: base gl sim/coarse sim/contact sim/contact/tissue sim/elements sim/gpu/passes sim/model sim/tool"
  "sim/gpu/integrators: gl sim/gpu/passes"
  "sim/gpu/methods: gl sim/coarse sim/gpu/acceleration sim/gpu/passes sim/ordering sim/scene/settings"
  "sim/gpu/passes: base gl gl/timing shaders/shared sim/coarse sim/material sim/mesh sim/model sim/ordering sim/scene/settings"
  "sim/gpu/readback: gl shaders/shared sim/gpu/contact sim/gpu/passes sim/model sim/surface"
  "sim/gpu/self_test: base gl sim/gpu sim/gpu/integrators sim/gpu/passes sim/mesh sim/model sim/reference"
  "sim/grab: base sim/contact sim/mesh sim/model sim/scene sim/surface sim/tool sim/visual"
  "sim/material:"
  "sim/mesh: base"
  "sim/mesh/io: base sim/mesh"
  "sim/mesh/io/fem: base sim/mesh sim/mesh/io"
  "sim/mesh/io/gmsh: base sim/mesh/io"
  "sim/mesh/io/surface: base sim/mesh sim/mesh/io"
  "sim/mesh/io/vtk: base sim/mesh sim/mesh/io"
  "sim/model: base base/csv sim/elements sim/material sim/mesh sim/mesh/io sim/scene sim/scene/settings sim/surface sim/tool"
  "sim/ordering: sim/mesh sim/model"
  "sim/output: base base/json sim/accuracy sim/contact sim/contact/tissue sim/fit/measured sim/mesh sim/mesh/io sim/mesh/io/fem sim/mesh/io/vtk sim/model sim/scene sim/scene/tools sim/simulation sim/visual"
  "sim/integrators:"
  "sim/reference: base sim/contact sim/contact/passing sim/elements sim/integrators sim/material sim/model sim/ordering sim/reference/factor sim/scene/settings sim/tool"
  "sim/reference/factor:"
  "sim/reference/tangent: sim/integrators sim/model sim/reference"
  "sim/replay: base base/json sim/grab sim/model sim/scene"
  "sim/scene: base base/json sim/material sim/scene/settings sim/scene/tools sim/surface"
  "sim/scene/settings: base sim/integrators sim/material"
  "sim/scene/tools: base base/json"
  "sim/simulation: base sim/accuracy sim/contact sim/contact/tissue sim/gpu sim/gpu/passes sim/grab sim/model sim/reference sim/replay sim/scene sim/tool"
  "sim/simulation/errors: base sim/accuracy sim/grab sim/simulation"
  "sim/surface: base sim/elements sim/mesh sim/mesh/io"
  "sim/tool: base sim/scene/tools sim/surface"
  "sim/visual: base sim/mesh sim/model sim/scene/tools sim/tool"
  "render: gl render/passes render/target render/view"
  "include/fascia:"
  "api: base gl gl/context include/fascia sim/accuracy sim/bare_mesh sim/grab sim/material sim/mesh sim/mesh/io sim/model sim/output sim/scene sim/scene/settings sim/simulation"
  "examples: include/fascia"
  "python: include/fascia"
  "render/context: base gl gl/context"
  "render/passes: base gl render/target render/view"
  "render/target: base gl"
  "render/view: base shaders/shared"
  "app: base app/cli app/commands app/session"
  "app/bench: base base/csv gl gl/timing sim/bare_mesh sim/gpu sim/mesh sim/mesh/io sim/model sim/output sim/reference sim/replay sim/simulation render/target app/charts app/session app/system"
  "app/bench/accuracy: base sim/accuracy sim/mesh sim/model sim/reference sim/scene/settings sim/simulation app/bench app/ui app/verify"
  "app/bench/window: base base/csv app/bench app/system"
  "app/bench/figures: sim/gpu sim/grab render/target render/view app/bench app/charts app/system app/ui"
  "app/bench/fill: base sim/accuracy sim/bare_mesh sim/elements sim/grab sim/mesh sim/model sim/output sim/reference sim/scene sim/simulation sim/surface app/bench"
  "app/check: base base/json render app/cli app/golden app/headless app/system"
  "app/cli: base base/json sim/material sim/mesh/io sim/scene sim/scene/settings app/golden"
  "app/commands: base gl/context sim/accuracy sim/bare_mesh sim/contact/tissue sim/fit sim/fit/gpu sim/fit/simulated sim/gpu/self_test sim/material sim/mesh sim/mesh/io sim/model sim/ordering sim/output sim/reference sim/scene sim/simulation sim/simulation/errors sim/surface sim/tool render app/bench app/bench/accuracy app/bench/fill app/bench/window app/charts app/check app/cli app/fit app/golden app/headless app/overlay app/refine app/session app/stress app/system app/verify app/video app/window"
  "app/charts: base"
  "app/compare: base gl/timing sim/material app/overlay app/panels app/session app/state app/ui"
  "app/dialogs: base gl sim/mesh/io render/target app/session app/state app/system app/ui"
  "app/fit: base sim/fit sim/material sim/scene app/charts app/check app/system"
  "app/golden: base base/json sim/model sim/output sim/reference render/target"
  "app/headless: base gl shaders/shared sim/output sim/replay sim/scene sim/simulation render render/view app/cli app/compare app/golden app/overlay app/panels app/session app/video"
  "app/kernels: base sim/scene app/system"
  "app/overlay: base sim/grab sim/scene/settings sim/tool render/passes render/view app/charts app/panels app/session app/ui"
  "app/panels: base gl sim/fit sim/material sim/replay render/view app/session app/state app/system app/ui"
  "app/refine: base gl sim/accuracy sim/model sim/output sim/reference sim/scene sim/simulation sim/simulation/errors sim/surface"
  "app/session: base base/json gl sim/bare_mesh sim/gpu/readback sim/grab sim/material sim/mesh sim/mesh/io sim/model sim/output sim/replay sim/scene sim/scene/settings sim/simulation sim/simulation/errors sim/visual render render/context render/target render/view app/cli app/system app/ui"
  "app/state: shaders/shared sim/contact sim/fit sim/gpu/readback sim/grab sim/material sim/mesh sim/model sim/output sim/scene sim/scene/tools sim/simulation app/session app/ui app/video"
  "app/stress: base sim/bare_mesh sim/contact/tissue sim/grab sim/material sim/mesh sim/mesh/io sim/model sim/replay sim/simulation app/bench app/cli app/system"
  "app/system: base"
  "app/ui: sim/output"
  "app/verify: base sim/accuracy sim/elements sim/grab sim/mesh sim/model sim/reference sim/scene sim/simulation sim/simulation/errors app/bench app/check"
  "app/video: base sim/output sim/replay sim/scene render/target app/cli app/system"
  "app/window: base gl gl/timing sim/fit sim/grab sim/output sim/scene sim/simulation sim/visual render app/cli app/compare app/dialogs app/fit app/overlay app/panels app/session app/state app/system app/ui app/video app/window/brush app/window/parts"
  "app/window/brush: sim/mesh sim/visual app/session app/state"
  "app/window/parts: base gl sim/contact sim/contact/tissue sim/grab sim/replay sim/scene sim/simulation sim/tool sim/visual render/target render/view app/kernels app/overlay app/panels app/session app/state app/ui"
)

set(rooms)
foreach(row IN LISTS arrows)
  string(REGEX MATCH "^[^:]+" room "${row}")
  string(REGEX REPLACE "^[^:]+: ?" "" allowed "${row}")
  string(REPLACE " " ";" allowed "${allowed}")
  list(APPEND rooms ${room})
  set(allowed_${room} ${allowed})
endforeach()

file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/base/*.h ${SOURCE_DIR}/base/*.cpp ${SOURCE_DIR}/gl/*.h ${SOURCE_DIR}/gl/*.cpp
     ${SOURCE_DIR}/sim/*.h ${SOURCE_DIR}/sim/*.cpp ${SOURCE_DIR}/render/*.h ${SOURCE_DIR}/render/*.cpp ${SOURCE_DIR}/app/*.h ${SOURCE_DIR}/app/*.cpp
     ${SOURCE_DIR}/include/*.h ${SOURCE_DIR}/api/*.h ${SOURCE_DIR}/api/*.cpp ${SOURCE_DIR}/examples/*.cpp ${SOURCE_DIR}/python/*.h ${SOURCE_DIR}/python/*.cpp)
set(used)
set(count 0)
foreach(source IN LISTS sources)
  cmake_path(GET source PARENT_PATH room)
  if(NOT room IN_LIST rooms)
    message(SEND_ERROR "${source}: its folder has no row in tests/include_arrows.cmake")
    continue()
  endif()
  math(EXPR files_${room} "0${files_${room}} + 1")
  file(STRINGS ${SOURCE_DIR}/${source} includes REGEX "^[ \t]*#[ \t]*include[ \t]+\"")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE ".*\"([^\"]*)\".*" "\\1" target "${line}")
    cmake_path(GET target PARENT_PATH from)
    if(from STREQUAL fascia)  # in the form used by programs that link the library
      set(from include/fascia)
    endif()
    math(EXPR count "${count} + 1")
    if(from STREQUAL room)
      continue()
    endif()
    if(NOT from IN_LIST allowed_${room})
      message(SEND_ERROR "${source}: includes ${target}; the row \"${room}:\" of tests/include_arrows.cmake does not allow \"${from}\"")
    endif()
    list(APPEND used "${room}>${from}")
  endforeach()
endforeach()
list(REMOVE_DUPLICATES used)

foreach(room IN LISTS rooms)
  if(NOT files_${room})
    message(SEND_ERROR "${room}: has a row in tests/include_arrows.cmake and no sources")
  elseif(files_${room} GREATER 25)
    message(SEND_ERROR "${room}: ${files_${room}} files; expected at most 25 in a folder")
  endif()
  foreach(from IN LISTS allowed_${room})
    if(NOT "${room}>${from}" IN_LIST used)
      message(SEND_ERROR "the row \"${room}:\" of tests/include_arrows.cmake allows \"${from}\", which nothing there includes")
    endif()
  endforeach()
endforeach()

# Removes folders without remaining dependencies one after another; the rest forms a cycle.
set(left ${rooms})
set(before)
while(NOT "${left}" STREQUAL "${before}")
  set(before ${left})
  foreach(room IN LISTS before)
    set(lowest TRUE)
    foreach(from IN LISTS allowed_${room})
      if(from IN_LIST left)
        set(lowest FALSE)
      endif()
    endforeach()
    if(lowest)
      list(REMOVE_ITEM left ${room})
    endif()
  endforeach()
endwhile()
if(left)
  message(SEND_ERROR "tests/include_arrows.cmake has a circle among ${left}")
endif()
list(LENGTH rooms rooms_count)
message(STATUS "${rooms_count} folders, ${count} includes, no circle")
