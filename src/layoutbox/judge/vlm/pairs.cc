#include "layoutbox/judge/vlm/pairs.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/vlm/asking.h"

namespace layoutbox::vlm {
namespace {

constexpr std::string_view kPairSchema = R"({"type": "object", "properties": {
  "better": {"type": "string", "enum": ["first", "second", "neither"], "description": "the better room"},
  "reason": {"type": "string", "maxLength": 400, "description": "one sentence, or empty"}},
  "required": ["better", "reason"], "additionalProperties": false})";
constexpr std::string_view kPairTask =
    "You compare pictures of two furnished rooms. Better is the room that is as was asked and in which nothing is wrong: "
    "nothing in another thing or a wall, nothing in the air, nothing turned away from its use.";

Result<Choice> choose(const Contestant& first, const Contestant& second, const std::string& wanted, chat::ChatClient& client,
                      const JudgeOptions& options) {
  Asking asking{kPairTask,
                fmt::format("The first room: {}. Then the second room: {}.{} Which is better?", views_of(first.pictures),
                            views_of(second.pictures), wanted.empty() ? "" : " What was asked for: " + wanted),
                {},
                {"choose", "The better room", std::string(kPairSchema), true}};
  for (const Contestant* room : {&first, &second}) {
    for (const Picture& picture : room->pictures) asking.pictures.push_back(&picture);
  }
  LAYOUTBOX_ASSIGN(const chat::Response response, client.ask(request_for(std::move(asking), options)));
  const std::string said = member_text(document_of(response), "better");
  return said == "first" ? Choice::kFirst : said == "second" ? Choice::kSecond : Choice::kNeither;
}

std::string_view said_as(Choice choice) { return choice == Choice::kFirst ? "first" : choice == Choice::kSecond ? "second" : "neither"; }

std::string share_text(const std::optional<Estimate>& share) {
  return share ? fmt::format("{:6.3f}  [{:.3f}, {:.3f}]", share->value, share->low, share->high) : "   n/a";
}

std::string lines_for(const std::string& about, const std::vector<Comparison>& comparisons) {
  const PairFigures figures = figures_of_pairs(comparisons);
  return fmt::format("{:20} {:4} comparisons   the better room {}   the same both ways round {}\n", about, figures.comparisons,
                     share_text(figures.right), share_text(figures.steady));
}

nlohmann::ordered_json share_json(const std::optional<Estimate>& share) {
  if (!share) return nullptr;
  return {{"value", share->value}, {"low", share->low}, {"high", share->high}};
}

std::map<std::string, std::vector<Comparison>> by_fault(const std::vector<Comparison>& comparisons) {
  std::map<std::string, std::vector<Comparison>> groups;
  for (const Comparison& one : comparisons) {
    if (!one.fault.empty()) groups[one.fault].push_back(one);
  }
  return groups;
}

}  // namespace

std::string Comparison::winner() const {
  if (first == Choice::kFirst && swapped == Choice::kSecond) return a;
  if (first == Choice::kSecond && swapped == Choice::kFirst) return b;
  return {};
}

bool Comparison::contradicts() const { return first == swapped && first != Choice::kNeither; }

Result<Comparison> compare(const Contestant& a, const Contestant& b, const std::string& wanted, chat::ChatClient& client,
                           const JudgeOptions& options) {
  Comparison result{a.name, b.name, {}, Choice::kNeither, Choice::kNeither, std::nullopt};
  if (a.faults != b.faults) result.truth = a.faults < b.faults;
  LAYOUTBOX_ASSIGN(result.first, choose(a, b, wanted, client, options));
  LAYOUTBOX_ASSIGN(result.swapped, choose(b, a, wanted, client, options));
  return result;
}

PairFigures figures_of_pairs(const std::vector<Comparison>& comparisons) {
  PairFigures figures;
  int steady = 0, chosen = 0, firsts = 0, known = 0, right = 0;
  for (const Comparison& one : comparisons) {
    ++figures.comparisons;
    steady += !one.winner().empty() || (one.first == Choice::kNeither && one.swapped == Choice::kNeither);
    for (const Choice choice : {one.first, one.swapped}) {
      chosen += choice != Choice::kNeither;
      firsts += choice == Choice::kFirst;
    }
    if (!one.truth) continue;
    ++known;
    right += one.winner() == (*one.truth ? one.a : one.b);
  }
  figures.steady = share_of(steady, figures.comparisons);
  figures.prefers_first = share_of(firsts, chosen);
  figures.right = share_of(right, known);
  return figures;
}

std::string pairs_text(const std::vector<Comparison>& comparisons) {
  std::string text = lines_for("all", comparisons);
  for (const auto& [fault, group] : by_fault(comparisons)) text += lines_for(fault, group);
  return text + "answers that prefer the first picture " + share_text(figures_of_pairs(comparisons).prefers_first);
}

std::string pairs_json(const std::vector<Comparison>& comparisons, const std::string& judge) {
  using Json = nlohmann::ordered_json;
  const auto figures_json = [](const std::vector<Comparison>& group) {
    const PairFigures figures = figures_of_pairs(group);
    return Json{{"comparisons", figures.comparisons},
                {"right", share_json(figures.right)},
                {"steady", share_json(figures.steady)},
                {"prefersFirst", share_json(figures.prefers_first)}};
  };
  Json faults = Json::object(), list = Json::array();
  for (const auto& [fault, group] : by_fault(comparisons)) faults[fault] = figures_json(group);
  for (const Comparison& one : comparisons) {
    Json item{{"a", one.a}, {"b", one.b}};
    if (!one.fault.empty()) item["fault"] = one.fault;
    item["said"] = {said_as(one.first), said_as(one.swapped)};
    item["winner"] = one.winner().empty() ? Json(nullptr) : Json(one.winner());
    item["better"] = !one.truth ? Json(nullptr) : Json(*one.truth ? one.a : one.b);
    list.push_back(std::move(item));
  }
  const Json document{
      {"format", "layoutbox/pairs@1"}, {"judge", judge}, {"figures", figures_json(comparisons)}, {"faults", faults}, {"comparisons", list}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox::vlm
