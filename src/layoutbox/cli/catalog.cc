#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "layoutbox/cli/commands.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string range_text(Mm least, Mm usual, Mm greatest) {
  if (least == greatest) return fmt::format("{:.2f} m", m_from_mm(usual));
  return fmt::format("{:.2f}–{:.2f} m, usually {:.2f} m", m_from_mm(least), m_from_mm(greatest), m_from_mm(usual));
}

std::string describe(const CatalogEntry& entry) {
  const SizeRange& size = entry.size;
  std::string text = fmt::format("{} ({})\n", entry.name, entry.id);
  if (!entry.synonyms.empty()) text += fmt::format("  also        {}\n", fmt::join(entry.synonyms, ", "));
  if (!entry.kind_of.empty()) text += fmt::format("  a kind of   {}\n", entry.kind_of);
  text += fmt::format("  width       {}\n", range_text(size.least.width, size.usual.width, size.greatest.width));
  text += fmt::format("  depth       {}\n", range_text(size.least.depth, size.usual.depth, size.greatest.depth));
  text += fmt::format("  height      {}\n", range_text(size.least.height, size.usual.height, size.greatest.height));
  for (const SizeVariant& variant : entry.variants) text += fmt::format("  sizes for   {}\n", fmt::join(variant.words, ", "));
  text += fmt::format("  mount       {}\n", name_of(entry.mount));
  std::vector<std::string_view> sides;
  for (const Side side : entry.used_sides) sides.push_back(name_of(side));
  if (!sides.empty()) text += fmt::format("  used from   {}\n", fmt::join(sides, ", "));
  if (!entry.stands_on.empty()) text += fmt::format("  stands on   {}\n", fmt::join(entry.stands_on, ", "));
  if (!entry.rooms.empty()) text += fmt::format("  usual in    {}\n", fmt::join(entry.rooms, ", "));
  text += fmt::format("  shape       {}\n", entry.shape.family);
  if (!entry.source.empty()) text += fmt::format("  source      {}\n", entry.source);
  text.pop_back();
  return text;
}

Json size_json(const Size& size) { return {{"w", m_from_mm(size.width)}, {"d", m_from_mm(size.depth)}, {"h", m_from_mm(size.height)}}; }

Json entry_json(const CatalogEntry& entry) {
  return {{"id", entry.id},
          {"name", entry.name},
          {"synonyms", entry.synonyms},
          {"kindOf", entry.kind_of},
          {"least", size_json(entry.size.least)},
          {"usual", size_json(entry.size.usual)},
          {"greatest", size_json(entry.size.greatest)},
          {"mount", name_of(entry.mount)},
          {"shape", entry.shape.family}};
}

int list_all(const Catalog& catalog, const Console& console) {
  std::string text;
  Json json = Json::array();
  for (const CatalogEntry& entry : catalog.entries()) {
    text += fmt::format("{:<24} {}\n", entry.id, fmt::join(entry.synonyms, ", "));
    json.push_back(entry_json(entry));
  }
  text += fmt::format("{} kinds", catalog.entries().size());
  console.result(text, json.dump());
  return kDone;
}

int run_catalog(const std::string& word, const Console& console) {
  const Catalog& catalog = Catalog::builtin();
  if (word.empty()) return list_all(catalog, console);
  const CatalogEntry* entry = catalog.find_by_words(word);
  if (!entry) {
    return console.fail({ErrorCode::kUsage, fmt::format("the catalogue knows no '{}'", word), {}, "layoutbox catalog lists all kinds", {}});
  }
  console.result(describe(*entry), entry_json(*entry).dump());
  return kDone;
}

}  // namespace

void add_catalog(CLI::App& app, Context& context) {
  auto word = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("catalog", "What is known about a piece of furniture, and under which words");
  command->add_option("word", *word, "A kind of furniture (default: list all)");
  command->callback([word, &context] { context.status = run_catalog(*word, context.console); });
}

}  // namespace layoutbox::cli
