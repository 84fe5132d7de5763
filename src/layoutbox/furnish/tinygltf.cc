// The one place where tinygltf itself is compiled; by itself, as its header has the code only where it is seen first.
#define TINYGLTF_IMPLEMENTATION
#include "layoutbox/furnish/tinygltf_quietly.h"
