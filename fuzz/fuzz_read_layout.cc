// Any bytes as a layout file: read, written, read again to the same bytes.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "layoutbox/scene/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace layoutbox;
  const Result<Layout> layout = read_layout({reinterpret_cast<const char*>(data), size});
  if (!layout) return 0;
  const std::string text = write_layout(*layout);
  const Result<Layout> again = read_layout(text);
  if (!again || write_layout(*again) != text) std::abort();
  return 0;
}
