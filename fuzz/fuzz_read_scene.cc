// Any bytes as a scene file: read, written, read again, normalised. Nothing may crash, and what was written must be readable.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace layoutbox;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<SceneGraph> scene = read_scene(text);
  if (!scene) return 0;
  if (!read_scene(write_scene(*scene))) std::abort();
  (void)normalize_scene(*scene, Catalog::builtin());
  return 0;
}
