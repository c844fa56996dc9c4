# graspdb_private_headers(NAME LIBRARIES ...): the headers beside a folder's sources must compile alone,
# too. Like the public ones they are compiled by the target all_verify_interface_header_sets only.
function(graspdb_private_headers name)
  file(GLOB headers CONFIGURE_DEPENDS *.h)
  if(headers)
    add_library(graspdb_${name}_private_headers INTERFACE)
    target_sources(graspdb_${name}_private_headers INTERFACE FILE_SET HEADERS
                   BASE_DIRS ${CMAKE_CURRENT_SOURCE_DIR} FILES ${headers})
    target_link_libraries(graspdb_${name}_private_headers INTERFACE ${ARGN})
  endif()
endfunction()

# One folder is one target. graspdb_library(NAME SOURCES ... HEADERS ... PUBLIC ... PRIVATE ...) makes
# graspdb::NAME of the folder that calls it. Its public headers are include/graspdb/FOLDER/*.h, so that
# an #include says which room it enters; each of them must compile alone.
add_library(graspdb_warnings INTERFACE)
target_compile_options(graspdb_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers
  $<$<BOOL:${GRASPDB_DEVELOPER}>:-Werror>)

# Rows must not depend on how a compiler fuses multiplications and additions.
add_compile_options(-ffp-contract=off)
if(GRASPDB_SANITIZE OR GRASPDB_FUZZ)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(GRASPDB_FUZZ)
  # Everything reports its branches; only the fuzzers themselves link libFuzzer's main().
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

function(graspdb_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set(headers ${ARG_HEADERS})
  list(TRANSFORM headers PREPEND "include/graspdb/${folder}/")
  add_library(graspdb_${name} STATIC ${ARG_SOURCES})
  add_library(graspdb::${name} ALIAS graspdb_${name})
  target_sources(graspdb_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_link_libraries(graspdb_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE}
                        $<BUILD_INTERFACE:graspdb_warnings>)
  graspdb_private_headers(${name} graspdb_${name} ${ARG_PRIVATE} graspdb_warnings)
endfunction()
