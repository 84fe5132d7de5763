// The meshes of a script as one block of text: binary, compressed, base64.
#pragma once

#include <array>
#include <map>
#include <string>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

// Base64, in lines of 120 characters.
std::string base64_lines(std::string_view bytes);

using Size3f = std::array<double, 3>;

class MeshBlock {
 public:
  // The number of this mesh in the block; equal meshes share one.
  int add(const Mesh& mesh);

  // zlib and base64, in lines of 120 characters.
  std::string text() const;

 private:
  std::string bytes_;
  std::map<std::string, int> numbers_;
};

// Width, depth and height of a node's parts in its own frame, in metres.
Size3f bounds_of(const Node& node);

}  // namespace layoutbox
