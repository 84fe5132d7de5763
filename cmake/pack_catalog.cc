// Run when the program is built: pack_catalog OUTPUT catalog/*.json. Checks the catalogue's data against its schema and itself, prints
// every fault, and packs it for Catalog::builtin().
#include <fmt/format.h>

#include <cstdio>

#include "layoutbox/base/files.h"
#include "layoutbox/catalog/pack.h"

namespace {

using namespace layoutbox;

int print(std::string_view file, const Error& error) {
  for (const Error& detail : error.details) print(file, detail);
  if (error.details.empty())
    fmt::print(stderr, "{}: {} {}{}\n", file, error.message, error.pointer, error.hint.empty() ? "" : " (" + error.hint + ")");
  return 1;
}

}  // namespace

int main(int count, char** arguments) {
  CatalogData data;
  int faults = 0;
  for (int i = 2; i < count; ++i) {
    const auto text = read_file(arguments[i]);
    if (!text) return print(arguments[i], text.error());
    if (const Status status = read_checked_catalog_data(*text, data); !status) faults += print(arguments[i], status.error());
  }
  for (const Error& error : check_catalog_data(data)) faults += print("catalog", error);
  if (faults > 0 || count < 2) return 1;
  inherit_from_kinds(data);
  const Status written = write_file(arguments[1], pack_catalog(data, index_of(data.entries, data.rooms)));
  return written ? 0 : print(arguments[1], written.error());
}
