// Any readable layout gets a report, the same one each time.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "layoutbox/scene/scene_json.h"
#include "layoutbox/verify/verify.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace layoutbox;
  const Result<Layout> layout = read_layout({reinterpret_cast<const char*>(data), size});
  if (!layout || layout->objects.size() > 40 || layout->relations.size() > 80) return 0;
  const std::string report = write_report(verify(*layout, Catalog::builtin()));
  if (report.empty() || report != write_report(verify(*layout, Catalog::builtin()))) std::abort();
  return 0;
}
