// The library behind read_obj, compiled here so that libFuzzer sees its branches and the sanitizers its memory.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
