#include "layoutbox/plan/llm/draft.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/chat/endpoint.h"
#include "layoutbox/plan/llm/functions.h"
#include "layoutbox/plan/llm/loose_json.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

Reading faulty(ErrorCode code, std::string message, std::string hint = {}) {
  Reading reading;
  reading.faults.push_back({code, std::move(message), {}, std::move(hint), {}});
  return reading;
}

bool looks_like_scene(const json& document) {
  for (const char* key : {"furniture", "objects", "room", "scene", "arguments", "parameters"}) {
    if (document.contains(key)) return true;
  }
  return false;
}

// A list of changes: {"patch": […]}, or the list itself.
const json* patch_in(const json& document) {
  const auto found = document.find("patch");
  return found != document.end() && found->is_array() ? &*found : nullptr;
}

// Either the document, or what is wrong.
struct Chosen {
  json document;
  std::vector<Error> faults;
};

Chosen wrong(ErrorCode code, std::string message, std::string hint = {}) {
  return {{}, {{code, std::move(message), {}, std::move(hint), {}}}};
}

Chosen apply_patch(const json& patch, std::string_view previous, Notes& notes) {
  if (previous.empty())
    return wrong(ErrorCode::kReference, "there is no scene yet that could be changed", "call create_scene with the whole scene");
  try {
    json document = json::parse(previous).patch(patch);
    notes.push_back({"mended", counted(patch.size(), "change") + " to the scene before taken over", {}});
    return {std::move(document), {}};
  } catch (const json::exception& error) {
    return wrong(ErrorCode::kReference, fmt::format("the changes do not fit the scene: {}", chat::one_line(error.what(), 160)),
                 "paths refer to the scene as it was sent, or call create_scene with the whole scene");
  }
}

Chosen document_from(std::string_view text, std::string_view previous, Notes& notes) {
  Result<json> parsed = parse_loose_json(text, notes);
  if (!parsed) {
    // A bare list of changes.
    const json list = json::parse(text, nullptr, false);
    if (list.is_array() && !list.empty() && list[0].is_object() && list[0].contains("op")) return apply_patch(list, previous, notes);
    return wrong(ErrorCode::kParse, fmt::format("what was handed over is no JSON object: {}", parsed.error().message),
                 "answer with the function call alone; JSON without comments and without words around it");
  }
  json document = std::move(*parsed);
  if (const json* patch = patch_in(document); patch != nullptr && !document.contains("furniture"))
    return apply_patch(*patch, previous, notes);
  return {std::move(document), {}};
}

bool has_json(const chat::Response& answer) { return !answer.calls.empty() || answer.content.find('{') != std::string::npos; }

Chosen choose(const chat::Response& answer, std::string_view previous, Notes& notes) {
  if (answer.calls.empty()) {
    if (answer.content.find_first_not_of(" \t\r\n") == std::string::npos) {
      return wrong(ErrorCode::kEmpty, "the answer is empty", "call create_scene");
    }
    if (!has_json(answer)) {
      return wrong(ErrorCode::kParse, "the answer is prose, not a scene", "call create_scene, nothing else");
    }
    return document_from(answer.content, previous, notes);
  }
  const chat::Call* call = nullptr;
  for (const chat::Call& one : answer.calls) {
    if (call == nullptr && (one.name == kCreateScene || one.name == kPatchScene)) call = &one;
  }
  if (answer.calls.size() > 1) notes.push_back({"mended", fmt::format("of {} function calls the first is taken", answer.calls.size()), {}});
  if (call != nullptr) return document_from(call->arguments, previous, notes);
  Chosen chosen = document_from(answer.calls[0].arguments, previous, notes);
  const std::string name = chat::one_line(answer.calls[0].name, 40);
  if (!chosen.faults.empty() || !looks_like_scene(chosen.document)) {
    return wrong(ErrorCode::kReference, fmt::format("there is no function \"{}\"", name), "call create_scene");
  }
  notes.push_back({"mended", fmt::format("the function was called \"{}\" instead of {}", name, kCreateScene), {}});
  return chosen;
}

std::size_t size_of_list(const json& document, const char* name) {
  const auto list = document.find(name);
  return list != document.end() && list->is_array() ? list->size() : 0;
}

// Of an answer that was cut off; empty where fewer than `things` are whole, and where it cannot be told how many are enough (0).
std::optional<json> what_is_whole(const chat::Response& answer, std::size_t things, Notes& notes) {
  if (things == 0) return std::nullopt;
  Result<json> document = parse_cut_json(answer.calls.empty() ? answer.content : answer.calls[0].arguments);
  if (!document) return std::nullopt;
  json scene = *document;
  Notes unused;
  mend_form(scene, unused);
  const std::size_t whole = size_of_list(scene, "furniture");
  if (whole < things) return std::nullopt;
  notes.push_back({"mended",
                   fmt::format("the answer was cut off; {} and {} in it were whole and are kept", counted(whole, "thing"),
                               counted(size_of_list(scene, "constraints"), "relation")),
                   {}});
  return std::move(*document);
}

// The pointer's list and index: "/constraints/3/targets/0" → constraints, 3.
bool leave_out(json& document, const std::string& pointer, Notes& notes, const std::string& why) {
  const std::vector<std::string> steps = [&] {
    std::vector<std::string> parts;
    for (std::size_t begin = 1; begin <= pointer.size() && begin > 0;) {
      const std::size_t end = std::min(pointer.find('/', begin), pointer.size());
      parts.push_back(pointer.substr(begin, end - begin));
      begin = end + 1;
    }
    return parts;
  }();
  if (steps.empty() || pointer.empty()) return false;
  try {
    // A relation or an opening as a whole; of an object what is wrong in it, or all of it where that is its id or category.
    const bool in_object = steps[0] == "furniture" && steps.size() > 2 && steps[2] != "id" && steps[2] != "category";
    std::size_t depth = steps.size();
    if (steps[0] == "constraints" || steps[0] == "materials") depth = std::min<std::size_t>(2, depth);
    if (steps[0] == "furniture") depth = std::min<std::size_t>(in_object ? 3 : 2, depth);
    if (steps[0] == "room") depth = std::min<std::size_t>(steps.size() > 2 && steps[1] == "openings" ? 3 : 2, depth);
    if (steps[0] == "room" && depth == 1) return false;
    json* parent = &document;
    for (std::size_t i = 0; i + 1 < depth; ++i) parent = parent->is_array() ? &parent->at(std::stoul(steps[i])) : &parent->at(steps[i]);
    if (parent->is_array()) {
      parent->erase(std::stoul(steps[depth - 1]));
    } else if (parent->erase(steps[depth - 1]) == 0) {
      return false;
    }
  } catch (const std::exception&) {
    return false;
  }
  notes.push_back({"left-out", fmt::format("left out, because {}", why), pointer});
  return true;
}

std::vector<Error> single_errors(const Error& error) { return error.details.empty() ? std::vector<Error>{error} : error.details; }

// The last error first, so that the places of the others stay right; one relation may have several.
bool leave_out_all(json& document, const std::vector<Error>& errors, Notes& notes) {
  bool any = false;
  std::set<std::string> done;
  for (auto it = errors.rbegin(); it != errors.rend(); ++it) {
    const std::size_t second = it->pointer.find('/', 1);
    const std::size_t third = second == std::string::npos ? second : it->pointer.find('/', second + 1);
    const std::string item = it->pointer.starts_with("/constraints/") ? it->pointer.substr(0, third) : it->pointer;
    if (!done.insert(item).second) continue;
    any = leave_out(document, it->pointer, notes, it->message) || any;
  }
  return any;
}

}  // namespace

Reading read_document(std::string text, const Catalog& catalog, Notes notes, Leniency leniency) {
  json document = json::parse(text, nullptr, false);
  if (!document.is_object()) return faulty(ErrorCode::kParse, "the scene is no JSON object");
  mend_scene(document, catalog, notes);
  if (!document.contains("furniture") || !document["furniture"].is_array() || document["furniture"].empty()) {
    return faulty(ErrorCode::kEmpty, "the scene has no furniture", "list every thing that the description names in \"furniture\"");
  }
  for (int round = 0;; ++round) {
    std::string written = document.dump(-1, ' ', false, json::error_handler_t::replace);
    Result<SceneGraph> scene = read_scene(written);
    if (scene) {
      scene->notes.insert(scene->notes.begin(), notes.begin(), notes.end());
      return {Draft{std::move(written), std::move(*scene)}, {}};
    }
    if (leniency == Leniency::kNormal || round == 20 || !leave_out_all(document, single_errors(scene.error()), notes)) {
      return {std::nullopt, single_errors(scene.error())};
    }
    if (document["furniture"].empty()) return faulty(ErrorCode::kEmpty, "nothing of the furniture can be used");
  }
}

Result<Reading> read_draft(const chat::Response& answer, const Catalog& catalog, const Known& known, Leniency leniency) {
  if (!answer.refusal.empty()) {
    return fail(ErrorCode::kNotFound, fmt::format("the model refuses: {}", chat::one_line(answer.refusal, 200)), {},
                "put it in other words");
  }
  if (answer.finish_reason == "content_filter") {
    return fail(ErrorCode::kNotFound, "the server's content filter held the answer back", {}, "put it in other words");
  }
  Notes notes;
  Chosen chosen = choose(answer, known.previous, notes);
  if (!chosen.faults.empty()) {
    const bool salvage = leniency == Leniency::kSalvage;
    if (auto whole = what_is_whole(answer, salvage ? 1 : known.named, notes)) chosen = {std::move(*whole), {}};
  }
  if (!chosen.faults.empty()) {
    if (answer.finish_reason == "length" && has_json(answer)) {
      return faulty(ErrorCode::kTooLarge, fmt::format("the answer was cut off after {} tokens", answer.usage.response_tokens),
                    "write shorter: no blanks, null for what is not said, only relations that are stated");
    }
    return Reading{std::nullopt, std::move(chosen.faults)};
  }
  return read_document(chosen.document.dump(-1, ' ', false, json::error_handler_t::replace), catalog, std::move(notes), leniency);
}

bool same_document(std::string_view a, std::string_view b) { return json::parse(a, nullptr, false) == json::parse(b, nullptr, false); }

}  // namespace layoutbox::llm
