# One executable per test folder or GPU need. fascia_test(name SOURCES... LIBS libs... LABELS labels... FILTER tests...)
function(fascia_test name)
  cmake_parse_arguments(T "" "" "SOURCES;LIBS;LABELS;FILTER" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${T_SOURCES})
  if(NOT sources)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY FASCIA_TEST_SOURCES ${sources})
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE test_support ${T_LIBS})
  target_precompile_headers(${name} REUSE_FROM test_support)
  add_test(NAME ${name} COMMAND ${name} ${T_FILTER})
  set_tests_properties(${name} PROPERTIES LABELS "${T_LABELS}" TIMEOUT ${FASCIA_TEST_TIMEOUT} ENVIRONMENT "${FASCIA_TEST_ENVIRONMENT}")
endfunction()

# Against hangs; code under sanitizers is many times slower.
set(FASCIA_TEST_TIMEOUT 1200)
if(FASCIA_SANITIZE)
  set(FASCIA_TEST_TIMEOUT 12000)
endif()
# The same renderer on every machine, whatever graphics card it has. Small meshes and pictures: llvmpipe's worker threads cost more
# than they bring, four times as much on a busy machine.
set(FASCIA_TEST_ENVIRONMENT LP_NUM_THREADS=0 LIBGL_ALWAYS_SOFTWARE=1)
if(FASCIA_SANITIZE)
  list(APPEND FASCIA_TEST_ENVIRONMENT LSAN_OPTIONS=print_suppressions=0)  # tests compare what programs print
endif()
set(mesa_egl /usr/share/glvnd/egl_vendor.d/50_mesa.json)
if(EXISTS ${mesa_egl})
  list(APPEND FASCIA_TEST_ENVIRONMENT __EGL_VENDOR_LIBRARY_FILENAMES=${mesa_egl})
endif()

set(T ${PROJECT_SOURCE_DIR}/tests)
fascia_test(test_mesh SOURCES ${T}/sim/test_*mesh*.cpp ${T}/sim/test_surface.cpp LIBS sim_core)
fascia_test(test_scene SOURCES ${T}/sim/test_scene*.cpp ${T}/sim/test_settings.cpp ${T}/sim/test_rest.cpp ${T}/sim/test_material.cpp
            ${T}/sim/test_model*.cpp ${T}/sim/test_coarse*.cpp ${T}/sim/test_tet_pairing.cpp LIBS sim_core nlohmann_json::nlohmann_json)
fascia_test(test_fuzz SOURCES ${T}/fuzz/fuzz.cpp ${T}/fuzz/fuzz_*.cpp ${T}/fuzz/test_fuzz.cpp ${T}/fuzz/watched_new.cpp LIBS sim_core LABELS fuzz)
fascia_test(test_reference SOURCES ${T}/sim/reference/test_*.cpp LIBS sim_core)
fascia_test(test_gl SOURCES ${T}/render/gl/test_*.cpp ${T}/render/test_context*.cpp LIBS render)
fascia_test(test_render SOURCES ${T}/render/test_render*.cpp ${T}/render/test_camera.cpp ${T}/render/test_image.cpp
            ${T}/render/test_framebuffer.cpp
            LIBS render)
fascia_test(test_solver SOURCES ${T}/sim/gpu/*.cpp LIBS sim render FILTER "~[slow]")
fascia_test(test_app SOURCES ${T}/app/test_*.cpp ${T}/app/window_fixture.cpp LIBS app nlohmann_json::nlohmann_json PkgConfig::IMGUI)

# A test that no program has would never fail.
file(GLOB_RECURSE written CONFIGURE_DEPENDS ${T}/test_*.cpp)
get_property(built GLOBAL PROPERTY FASCIA_TEST_SOURCES)
list(REMOVE_ITEM written ${built})
if(written)
  message(FATAL_ERROR "no test program has ${written}: expected it among the SOURCES in tests/tests.cmake")
endif()

# The work groups of fused passes wait for each other: with more threads than most machines of CI have cores. And vectors of four, as
# llvmpipe has them on processors without AVX2.
set(threads_environment ${FASCIA_TEST_ENVIRONMENT})
list(TRANSFORM threads_environment REPLACE "^LP_NUM_THREADS=0$" "LP_NUM_THREADS=3")
foreach(name test_gl test_solver)
  if(TARGET ${name})
    add_test(NAME ${name}_threads COMMAND ${name} "[threads]")
    add_test(NAME ${name}_narrow COMMAND ${name} "[threads]")
    set_tests_properties(${name}_threads PROPERTIES TIMEOUT ${FASCIA_TEST_TIMEOUT} ENVIRONMENT "${threads_environment}")
    set_tests_properties(${name}_narrow PROPERTIES TIMEOUT ${FASCIA_TEST_TIMEOUT}
                         ENVIRONMENT "${threads_environment};LP_NATIVE_VECTOR_WIDTH=128")
  endif()
endforeach()
# Not among those that run without an argument: scripts/test.sh -L slow.
if(TARGET test_solver)
  add_test(NAME test_solver_slow COMMAND test_solver "[slow]")
  set_tests_properties(test_solver_slow PROPERTIES LABELS slow TIMEOUT 12000 ENVIRONMENT "${FASCIA_TEST_ENVIRONMENT}")
endif()
if(TARGET test_app)
  add_dependencies(test_app fascia)
endif()
if(TARGET fascia)
  add_test(NAME stress COMMAND fascia stress --quick --context osmesa --only "/two_level + subspace" --out ${CMAKE_BINARY_DIR}/stress)
  set_tests_properties(stress PROPERTIES LABELS stress TIMEOUT ${FASCIA_TEST_TIMEOUT} ENVIRONMENT "${FASCIA_TEST_ENVIRONMENT}")
endif()
if(TARGET fascia)
  add_test(NAME tutorial COMMAND ${PROJECT_SOURCE_DIR}/scripts/tutorial.sh ${CMAKE_BINARY_DIR}/tutorial)
  set_tests_properties(tutorial PROPERTIES TIMEOUT ${FASCIA_TEST_TIMEOUT} ENVIRONMENT "${FASCIA_TEST_ENVIRONMENT};FASCIA=$<TARGET_FILE:fascia>")
endif()
add_test(NAME include_directions COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
         -P ${T}/include_directions.cmake)
