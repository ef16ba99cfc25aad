// The library used by read_obj, compiled here so that libFuzzer instruments its branches and the sanitizers its memory
// accesses.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
