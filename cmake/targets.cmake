# What all of our own code is compiled with, and nobody else's. Rows must not depend on how a compiler
# fuses multiplications and additions.
add_library(graspdb_flags INTERFACE)
target_compile_options(graspdb_flags INTERFACE
  -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers
  $<$<BOOL:${GRASPDB_DEVELOPER}>:-Werror>
  # In large units GCC collects its garbage from 1 GB on: an eighth of a build's time for a quarter
  # more memory. (File by file clang-tidy reads the flags, and does not know this one.)
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:--param=ggc-min-heapsize=1000000>)

if(GRASPDB_SANITIZE OR GRASPDB_FUZZ)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(GRASPDB_FUZZ)
  # Everything reports its branches; only the fuzzers themselves link libFuzzer's main().
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

# One folder is one target. graspdb_library(NAME SOURCES ... HEADERS ... PUBLIC ... PRIVATE ...) makes
# graspdb::NAME of the folder that calls it. Its public headers are include/graspdb/FOLDER/*.h, so that
# an #include says which room it enters; each of them must compile alone.
function(graspdb_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set(headers ${ARG_HEADERS})
  list(TRANSFORM headers PREPEND "include/graspdb/${folder}/")
  # Of it only headers are used: who links an installed graspdb need not have it.
  foreach(libraries ARG_PUBLIC ARG_PRIVATE)
    list(TRANSFORM ${libraries} REPLACE "^nlohmann_json::.+$" "$<BUILD_INTERFACE:\\0>")
  endforeach()
  add_library(graspdb_${name} STATIC ${ARG_SOURCES})
  target_sources(graspdb_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_compile_features(graspdb_${name} PUBLIC cxx_std_20)
  target_link_libraries(graspdb_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE}
                        $<BUILD_INTERFACE:graspdb_flags>)
  graspdb_private_headers(${name} graspdb_${name} ${ARG_PRIVATE} graspdb_flags)
  graspdb_export(${name})
endfunction()

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

# graspdb_NAME becomes graspdb::NAME, here and for those who find_package() an installation.
function(graspdb_export name)
  add_library(graspdb::${name} ALIAS graspdb_${name})
  set_target_properties(graspdb_${name} PROPERTIES EXPORT_NAME ${name})
  if(GRASPDB_INSTALL)
    install(TARGETS graspdb_${name} EXPORT graspdb-${graspdb_component}
            ARCHIVE COMPONENT development FILE_SET HEADERS COMPONENT development)
  endif()
endfunction()
