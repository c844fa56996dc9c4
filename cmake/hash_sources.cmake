# Writes OUT, a C++ file with the hash of the files in LIST (one path a line, in the order of the
# list) and of TEXT:  cmake -DLIST=... -DTEXT=... -DOUT=... -P hash_sources.cmake
file(STRINGS ${LIST} files)
set(all "${TEXT}")
foreach(file IN LISTS files)
  file(SHA256 ${file} hash)
  get_filename_component(name ${file} NAME)
  string(APPEND all "\n${name} ${hash}")
endforeach()
string(SHA256 hash "${all}")
file(WRITE ${OUT} "// Written by cmake/hash_sources.cmake.
namespace graspdb {
extern const char* const kRowCodeHash;
const char* const kRowCodeHash = \"${hash}\";
}  // namespace graspdb
")
