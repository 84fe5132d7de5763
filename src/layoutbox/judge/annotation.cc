#include "layoutbox/judge/annotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "layoutbox/catalog/csv.h"
#include "layoutbox/judge/vocabulary.h"

namespace layoutbox::scoring {
namespace {

constexpr std::array<std::string_view, 5> kQuantifiers{"eq", "ge", "gt", "le", "lt"};

std::string trimmed_part(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(trimmed_part(text.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

// "chair:2" names one of several chairs; which one does not matter.
std::string category_of(const std::string& name) { return name.substr(0, name.find(':')); }

std::optional<int> number_of(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string_view name_of(EntryKind kind) {
  constexpr std::array<std::string_view, 3> kNames{"CNT", "OOR", "OAR"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool meets(Quantifier quantifier, int found, int wanted) {
  switch (quantifier) {
    case Quantifier::kAtLeast: return found >= wanted;
    case Quantifier::kMore: return found > wanted;
    case Quantifier::kAtMost: return found <= wanted;
    case Quantifier::kLess: return found < wanted;
    default: return found == wanted;
  }
}

std::vector<std::string> Annotation::categories() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    if (entry.kind != EntryKind::kCount) continue;
    if (std::find(names.begin(), names.end(), entry.targets[0]) == names.end()) names.push_back(entry.targets[0]);
  }
  return names;
}

std::set<std::string> Annotation::rooms() const {
  std::set<std::string> names;
  for (const Entry& entry : entries) {
    if (entry.kind == EntryKind::kRoom && !is_part_of_room(entry.element)) names.insert(entry.element);
  }
  return names;
}

Result<Entry> parse_entry(std::string_view raw, EntryKind kind) {
  const std::vector<std::string> parts = parts_of(raw, ',');
  const auto broken = [&](std::string_view why) {
    return fail(ErrorCode::kParse, fmt::format("the entry \"{}\" cannot be read: {}", trimmed_part(raw), why), {},
                "write eq,2,chair or eq,1,near,0,bed,lamp or eq,1,against,bed,wall");
  };
  const auto quantifier = std::find(kQuantifiers.begin(), kQuantifiers.end(), parts[0]);
  if (quantifier == kQuantifiers.end()) return broken("it does not begin with eq, ge, gt, le or lt");
  const std::optional<int> count = parts.size() > 1 ? number_of(parts[1]) : std::nullopt;
  if (!count) return broken("its second part is no number");
  Entry entry{trimmed_part(raw), kind, static_cast<Quantifier>(quantifier - kQuantifiers.begin()), *count, {}, {}, {}, {}};
  if (kind == EntryKind::kCount) {
    if (parts.size() != 3) return broken("a count has three parts");
    entry.targets = {parts[2]};
    return entry;
  }
  if (kind == EntryKind::kRoom) {
    if (parts.size() != 5) return broken("a relation to the room has five parts");
    entry.word = parts[2];
    entry.targets = {category_of(parts[3])};
    entry.element = parts[4];
    std::transform(entry.element.begin(), entry.element.end(), entry.element.begin(), [](unsigned char c) { return std::tolower(c); });
    return entry;
  }
  if (parts.size() < 6) return broken("a relation between objects has six parts or more");
  const std::optional<int> index = number_of(parts[3]);
  if (!index) return broken("its fourth part is no number");
  for (std::size_t i = 4; i < parts.size(); ++i) entry.targets.push_back(category_of(parts[i]));
  entry.word = parts[2];
  // An index outside the list means the first object, as in SceneEval.
  const auto at = *index >= 0 && *index < static_cast<int>(entry.targets.size()) ? *index : 0;
  entry.anchor = entry.targets[static_cast<std::size_t>(at)];
  entry.targets.erase(entry.targets.begin() + at);
  return entry;
}

Result<std::vector<Annotation>> read_annotations(std::string_view csv) {
  LAYOUTBOX_ASSIGN(const std::vector<CsvRow> rows, read_csv(csv));
  if (rows.empty()) return fail(ErrorCode::kEmpty, "the table of annotations is empty");
  const std::vector<std::string>& header = rows.front().fields;
  const auto column = [&](std::string_view name) { return std::find(header.begin(), header.end(), name) - header.begin(); };
  constexpr std::array<std::pair<std::string_view, EntryKind>, 3> kLists{
      {{"ObjCount", EntryKind::kCount}, {"OORel", EntryKind::kObjects}, {"OARel", EntryKind::kRoom}}};
  for (const std::string_view name : {"ID", "Description", "ObjCount", "OORel", "OARel"}) {
    if (column(name) == static_cast<std::ptrdiff_t>(header.size())) {
      return fail(ErrorCode::kSchema, fmt::format("the table of annotations has no column {}", name), {},
                  "it needs the columns ID, Description, ObjCount, OORel and OARel");
    }
  }
  std::vector<Annotation> annotations;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto field = [&](std::string_view name) -> const std::string& { return rows[i].fields[static_cast<std::size_t>(column(name))]; };
    Annotation annotation{trimmed_part(field("ID")), trimmed_part(field("Description")), {}};
    for (const auto& [name, kind] : kLists) {
      for (const std::string& raw : parts_of(field(name), ';')) {
        if (raw.empty()) continue;
        auto entry = parse_entry(raw, kind);
        if (!entry) {
          entry.error().pointer = fmt::format("line {}", rows[i].line);
          return Failure(std::move(entry).error());
        }
        annotation.entries.push_back(*std::move(entry));
      }
    }
    annotations.push_back(std::move(annotation));
  }
  return annotations;
}

}  // namespace layoutbox::scoring
