#include "layoutbox/judge/entries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "layoutbox/judge/vocabulary.h"

namespace layoutbox::scoring {
namespace {

constexpr std::size_t kMostGroups = 20'000;  // choices tried for one relation
constexpr std::size_t kMostInWords = 4;

struct AnchorTrial {
  std::string anchor;
  std::vector<std::size_t> targets;
  Scored scored;
};

// All ways to take `count` of `pool`, in its order.
std::vector<std::vector<std::size_t>> choices(const std::vector<std::size_t>& pool, std::size_t count) {
  std::vector<std::vector<std::size_t>> all;
  if (count > pool.size()) return all;
  std::vector<std::size_t> pick(count);
  for (std::size_t i = 0; i < count; ++i) pick[i] = i;
  while (all.size() < kMostGroups) {
    std::vector<std::size_t> chosen;
    for (const std::size_t i : pick) chosen.push_back(pool[i]);
    all.push_back(std::move(chosen));
    std::size_t at = count;
    while (at > 0 && pick[at - 1] == pool.size() - (count - at) - 1) --at;
    if (at == 0) break;
    ++pick[at - 1];
    for (std::size_t i = at; i < count; ++i) pick[i] = pick[i - 1] + 1;
  }
  return all;
}

std::string in_words(std::vector<AnchorTrial> tried, const MeasuredRoom& room) {
  std::stable_sort(tried.begin(), tried.end(), [](const AnchorTrial& a, const AnchorTrial& b) { return a.scored.score > b.scored.score; });
  std::string text;
  for (std::size_t i = 0; i < std::min(tried.size(), kMostInWords); ++i) {
    std::vector<std::string> names;
    for (const std::size_t target : tried[i].targets) names.push_back(room.blocks[target].body->id());
    text += fmt::format("{}{} to {}: {} -> {:.2f}", i ? " | " : "", fmt::join(names, "+"), tried[i].anchor, tried[i].scored.text,
                        tried[i].scored.score);
  }
  if (tried.size() > kMostInWords) text += fmt::format(" | and {} more", tried.size() - kMostInWords);
  return text;
}

// Judges the entries of one annotation in one room.
class EntryJudge {
 public:
  EntryJudge(const Annotation& annotation, const MeasuredRoom& room)
      : room_(room), rooms_(annotation.rooms()), found_(match_objects(annotation.categories(), room.view.layout, room.view.catalog)) {}

  Verdict judge(const Entry& entry) {
    switch (entry.kind) {
      case EntryKind::kObjects: return judge_objects(entry);
      case EntryKind::kRoom: return judge_room(entry);
      default: return judge_count(entry);
    }
  }

 private:
  const std::vector<std::size_t>& found(const std::string& category) const {
    static const std::vector<std::size_t> none;
    const auto place = found_.find(category);
    return place == found_.end() ? none : place->second;
  }

  Verdict judge_count(const Entry& entry) const {
    std::vector<std::string> names;
    for (const std::size_t i : found(entry.targets[0])) names.push_back(room_.blocks[i].body->id());
    return {entry.kind, entry.raw, meets(entry.quantifier, static_cast<int>(names.size()), entry.count),
            fmt::format("found {}: {}", names.size(), names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")))};
  }

  Verdict judge_objects(const Entry& entry) {
    const std::string_view check = check_for(entry.word, "objects");
    if (check.empty()) return {entry.kind, entry.raw, false, fmt::format("no check stands for \"{}\"", entry.word)};
    std::map<std::string, std::size_t> need;
    ++need[entry.anchor];
    for (const std::string& target : entry.targets) ++need[target];
    std::vector<std::string> lacking;
    for (const auto& [category, count] : need) {
      if (found(category).size() < count) lacking.push_back(fmt::format("{} ({} of {})", category, found(category).size(), count));
    }
    if (!lacking.empty()) return {entry.kind, entry.raw, false, fmt::format("not there: {}", fmt::join(lacking, ", "))};
    const std::vector<AnchorTrial> tried = candidates(entry, check);
    int good = 0;
    std::set<std::vector<std::size_t>> groups;
    std::set<std::string> anchors;
    for (const AnchorTrial& candidate : tried) {
      if (candidate.scored.score <= kHolds) continue;
      ++good;
      groups.insert(candidate.targets);
      anchors.insert(candidate.anchor);
    }
    // Pairs or different targets may be what was counted; of a group the anchors, or its members ("4 chairs surround" as eq,4).
    std::vector<int> counts{good, static_cast<int>(groups.size())};
    if (entry.targets.size() > 1) {
      const int whole = static_cast<int>(anchors.size());
      counts = {whole, whole > 0 && entry.count == static_cast<int>(entry.targets.size()) ? entry.count : whole};
    }
    const bool holds = std::any_of(counts.begin(), counts.end(), [&](int count) { return meets(entry.quantifier, count, entry.count); });
    return {entry.kind, entry.raw, holds, fmt::format("holds {} times: {}", counts[0], in_words(tried, room_))};
  }

  // Every choice of one anchor and the entry's targets, with its score.
  std::vector<AnchorTrial> candidates(const Entry& entry, std::string_view check) {
    std::vector<std::pair<std::string, std::size_t>> wanted;  // category, how many; in the entry's order
    for (const std::string& target : entry.targets) {
      const auto at = std::find_if(wanted.begin(), wanted.end(), [&](const auto& item) { return item.first == target; });
      if (at == wanted.end()) {
        wanted.emplace_back(target, 1);
      } else {
        ++at->second;
      }
    }
    const bool ring = entry.targets.size() >= 3 && is_ring_word(entry.word);
    const bool both_ways =
        is_symmetric(check) && std::any_of(wanted.begin(), wanted.end(), [&](const auto& item) { return item.first == entry.anchor; });
    std::vector<AnchorTrial> result;
    for (const std::size_t anchor : found(entry.anchor)) {
      std::vector<std::vector<std::size_t>> groups{{}};
      for (const auto& [category, count] : wanted) {
        std::vector<std::size_t> pool = found(category);
        pool.erase(std::remove(pool.begin(), pool.end(), anchor), pool.end());
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& group : groups) {
          for (const auto& part : choices(pool, count)) {
            if (longer.size() >= kMostGroups) break;
            longer.push_back(group);
            longer.back().insert(longer.back().end(), part.begin(), part.end());
          }
        }
        groups = std::move(longer);
      }
      const std::string& anchor_id = room_.blocks[anchor].body->id();
      for (std::vector<std::size_t>& group : groups) {
        if (both_ways && tried_the_other_way(result, anchor, anchor_id, group)) continue;
        result.push_back({anchor_id, group, ring ? score_ring(blocks(group), room_.blocks[anchor]) : score_group(check, group, anchor)});
        if (result.size() >= kMostGroups) return result;
      }
    }
    return result;
  }

  bool tried_the_other_way(const std::vector<AnchorTrial>& tried, std::size_t anchor, const std::string&,
                           const std::vector<std::size_t>& group) const {
    return std::any_of(tried.begin(), tried.end(), [&](const AnchorTrial& other) {
      const bool has_its_anchor =
          std::any_of(group.begin(), group.end(), [&](std::size_t i) { return room_.blocks[i].body->id() == other.anchor; });
      return has_its_anchor && std::find(other.targets.begin(), other.targets.end(), anchor) != other.targets.end();
    });
  }

  std::vector<const Block*> blocks(const std::vector<std::size_t>& group) const {
    std::vector<const Block*> list;
    for (const std::size_t i : group) list.push_back(&room_.blocks[i]);
    return list;
  }

  Scored score_group(std::string_view check, const std::vector<std::size_t>& group, std::size_t anchor) {
    Scored worst{2, {}, {}};
    for (const std::size_t target : group) {
      const auto [place, is_new] = pairs_.try_emplace({std::string(check), target, anchor});
      if (is_new) place->second = score_objects(check, room_.blocks[target], room_.blocks[anchor], room_);
      if (place->second.score < worst.score) worst = place->second;
    }
    return worst;
  }

  Verdict judge_room(const Entry& entry) const {
    const std::vector<std::size_t>& boxes = found(entry.targets[0]);
    if (boxes.empty()) {
      const bool known = room_.blocks.empty() || score_room(entry.word, entry.element, room_.blocks[0], room_).has_value();
      return {entry.kind, entry.raw, false,
              known ? "not there: " + entry.targets[0] : fmt::format("no check stands for \"{} {}\"", entry.word, entry.element)};
    }
    const Phrase type = phrase_of(room_.view.layout.room.type);
    if (rooms_.contains(entry.element) && rooms_.size() > 1 && !ends_in(type, phrase_of(entry.element))) {
      return {entry.kind, entry.raw, false, fmt::format("the room is \"{}\", not \"{}\"", room_.view.layout.room.type, entry.element)};
    }
    std::vector<AnchorTrial> tried;
    int held = 0;
    for (const std::size_t i : boxes) {
      std::optional<Scored> scored = score_room(entry.word, entry.element, room_.blocks[i], room_);
      if (!scored) return {entry.kind, entry.raw, false, fmt::format("no check stands for \"{} {}\"", entry.word, entry.element)};
      held += scored->score > kHolds;
      tried.push_back({scored->place, {i}, *scored});
    }
    return {entry.kind, entry.raw, meets(entry.quantifier, held, entry.count),
            fmt::format("holds {} times: {}", held, in_words(tried, room_))};
  }

  const MeasuredRoom& room_;
  std::set<std::string> rooms_;
  Matches found_;
  std::map<std::tuple<std::string, std::size_t, std::size_t>, Scored> pairs_;
};

}  // namespace

Matches match_objects(const std::vector<std::string>& categories, const Layout& layout, const Catalog& catalog) {
  NounMatcher matcher(catalog);
  Matches matches;
  for (const std::string& category : categories) matches[category];
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    const PlacedObject& object = layout.objects[i];
    const std::string* best = nullptr;
    std::tuple<int, int, int> best_rank;
    for (const std::string& category : categories) {
      const int by_category = matcher.strength(category, object.category);
      const int strength = std::max(by_category, matcher.strength(category, object.name));
      if (strength < 2) continue;
      const std::tuple rank{matcher.narrowness(category), strength, by_category};
      if (best && rank <= best_rank) continue;
      best = &category;
      best_rank = rank;
    }
    if (best) {
      matches[*best].push_back(i);
    } else {
      left.push_back(i);
    }
  }
  // A bare head noun ("table" for dining_table) is taken only where nothing fits the category better.
  std::vector<std::string> bare;
  for (const std::string& category : categories) {
    if (matches[category].empty()) bare.push_back(category);
  }
  for (const std::size_t i : left) {
    const PlacedObject& object = layout.objects[i];
    const std::string* best = nullptr;
    for (const std::string& category : bare) {
      if (std::max(matcher.strength(category, object.category), matcher.strength(category, object.name)) != 1) continue;
      if (!best || std::tuple(matches[category].size(), category) < std::tuple(matches[*best].size(), *best)) best = &category;
    }
    if (best) matches[*best].push_back(i);
  }
  return matches;
}

std::vector<Verdict> judge_annotation(const Annotation& annotation, const MeasuredRoom& room) {
  EntryJudge judge(annotation, room);
  std::vector<Verdict> verdicts;
  for (const Entry& entry : annotation.entries) verdicts.push_back(judge.judge(entry));
  return verdicts;
}

}  // namespace layoutbox::scoring
