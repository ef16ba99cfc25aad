# One executable per test folder or GPU need. fascia_test(name SOURCES... LIBS libs... LABELS labels...)
function(fascia_test name)
  cmake_parse_arguments(T "" "" "SOURCES;LIBS;LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${T_SOURCES})
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE test_support ${T_LIBS})
  target_precompile_headers(${name} REUSE_FROM test_support)
  add_test(NAME ${name} COMMAND ${name})
  # Small meshes and pictures: llvmpipe's worker threads cost more than they bring, four times as much on a busy machine.
  set_tests_properties(${name} PROPERTIES LABELS "${T_LABELS}" TIMEOUT 900 ENVIRONMENT LP_NUM_THREADS=0)
endfunction()

set(T ${PROJECT_SOURCE_DIR}/tests)
fascia_test(test_mesh SOURCES ${T}/sim/test_*mesh*.cpp ${T}/sim/test_surface.cpp LIBS sim_core)
fascia_test(test_scene SOURCES ${T}/sim/test_scene*.cpp ${T}/sim/test_settings.cpp ${T}/sim/test_material.cpp
            ${T}/sim/test_model*.cpp ${T}/sim/test_coarse*.cpp LIBS sim_core nlohmann_json::nlohmann_json)
fascia_test(test_fuzz SOURCES ${T}/fuzz/fuzz.cpp ${T}/fuzz/fuzz_*.cpp ${T}/fuzz/test_fuzz.cpp LIBS sim_core LABELS fuzz)
fascia_test(test_reference SOURCES ${T}/sim/reference/test_*.cpp LIBS sim_core)
fascia_test(test_gl SOURCES ${T}/render/gl/test_*.cpp ${T}/render/test_context*.cpp LIBS render)
fascia_test(test_render SOURCES ${T}/render/test_render*.cpp ${T}/render/test_camera.cpp ${T}/render/test_image.cpp
            ${T}/render/test_framebuffer.cpp
            LIBS render)
fascia_test(test_solver SOURCES ${T}/sim/gpu/*.cpp LIBS sim render)
fascia_test(test_app SOURCES ${T}/app/test_*.cpp ${T}/app/window_fixture.cpp LIBS app nlohmann_json::nlohmann_json)
if(TARGET test_app)
  add_dependencies(test_app fascia)
endif()
add_test(NAME include_directions COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
         -P ${T}/include_directions.cmake)
