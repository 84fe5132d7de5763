#include "layoutbox/scene/quirks.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/axes.h"

namespace layoutbox {
namespace {

using nlohmann::json;

bool is_own(const json& scene) { return scene.contains("format"); }

class SceneRewriter {
 public:
  SceneRewriter(double metres_per_unit, const Axes& axes, std::vector<Note>& notes)
      : factor_(metres_per_unit), axes_(axes), notes_(notes) {}

  void room(json& room, const std::string& at) {
    if (!room.is_object()) return;
    if (const auto dims = room.find("dims"); dims != room.end()) dimensions(*dims, at + "/dims");
    scale_member(room, "height");
    if (const auto area = room.find("area"); area != room.end() && area->is_number()) *area = area->get<double>() * factor_ * factor_;
    if (const auto polygon = room.find("polygon"); polygon != room.end() && polygon->is_array()) {
      for (json& corner : *polygon) scale_all(corner);
    }
    each(room, "walls", at, [&](json& wall, const std::string& where) { this->wall(wall, where); });
    each(room, "openings", at, [&](json& opening, const std::string& where) { this->opening(opening, where); });
  }

  void furniture(json& scene) {
    each(scene, "furniture", "", [&](json& object, const std::string& at) { this->object(object, at); });
  }

  void constraints(json& scene) {
    each(scene, "constraints", "", [&](json& relation, const std::string& at) { this->relation(relation, at); });
  }

  void materials(json& scene) {
    each(scene, "materials", "", [&](json& material, const std::string& at) { this->material(material, at); });
  }

 private:
  template <class Function>
  static void each(json& parent, const char* key, const std::string& at, Function function) {
    const auto list = parent.find(key);
    if (list == parent.end() || !list->is_array()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
      if ((*list)[i].is_object()) function((*list)[i], fmt::format("{}/{}/{}", at, key, i));
    }
  }

  void note(std::string code, std::string message, std::string pointer) {
    notes_.push_back({std::move(code), std::move(message), std::move(pointer)});
  }

  void scale(json& value) const {
    if (value.is_number() && factor_ != 1) value = value.get<double>() * factor_;
  }
  void scale_member(json& object, const char* key) const {
    if (const auto found = object.find(key); found != object.end()) scale(*found);
  }
  void scale_all(json& list) const {
    if (!list.is_array()) return;
    for (json& value : list) scale(value);
  }

  // [x, y, z] of the file → metres in our frame.
  void place(json& value) const {
    scale_all(value);
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, [](const json& v) { return v.is_number(); })) return;
    if (axes_.is_usual()) return;
    const auto p = axes_.room_from_file({value[0].get<double>(), value[1].get<double>(), value[2].get<double>()});
    value = {p[0], p[1], p[2]};
  }

  // w, d, h by any of their names; a list of three too.
  void dimensions(json& dims, const std::string& at) {
    if (dims.is_array() && dims.size() == 3) {
      dims = {{"w", dims[0]}, {"d", dims[1]}, {"h", dims[2]}};
      note("converted", "the list is read as width, depth, height", at);
    }
    if (!dims.is_object()) return;
    bool renamed = rename_member(dims, "width", "w");
    renamed |= rename_member(dims, "depth", "d");
    renamed |= rename_member(dims, "height", "h");
    // A length is the depth where the width is named, else the width.
    for (const char* length : {"l", "length"})
      renamed |= dims.contains("w") ? rename_member(dims, length, "d") : rename_member(dims, length, "w");
    if (renamed) note("converted", "sizes under other names are read as w, d, h", at);
    for (const char* key : {"w", "d", "h"}) scale_member(dims, key);
    if (const auto source = dims.find("source"); source != dims.end() && source->is_string()) {
      if (const auto known = size_source_from_name(source->get<std::string>())) *source = name_of(*known);
    }
  }

  void mesh(json& owner, const std::string& at) {
    const auto found = owner.find("mesh");
    if (found == owner.end() || !found->is_object()) return;
    if (!found->empty()) note("ignored", "only the name of a file is read as a mesh", at + "/mesh");
    owner.erase(found);
  }

  void wall(json& wall, const std::string& at) {
    for (const char* key : {"start", "end"}) {
      const auto found = wall.find(key);
      if (found == wall.end()) continue;
      if (found->is_array() && found->size() == 2) {
        scale_all(*found);
        found->push_back(0);
      } else {
        place(*found);
      }
    }
    scale_member(wall, "thickness");
    mesh(wall, at);
  }

  void opening(json& opening, const std::string& at) {
    bool renamed = rename_member(opening, "wall", "wallId");
    renamed |= rename_member(opening, "width", "w");
    renamed |= rename_member(opening, "height", "h");
    renamed |= rename_member(opening, "sillHeight", "sill");
    if (renamed) note("converted", "members under other names are read as wallId, w, h, sill", at);
    for (const char* key : {"offset", "w", "h", "sill", "sillDepth"}) scale_member(opening, key);
    if (const auto type = opening.find("type"); type != opening.end() && type->is_string()) {
      if (const auto known = opening_type_from_name(type->get<std::string>())) *type = name_of(*known);
    }
  }

  void object(json& object, const std::string& at) {
    if (const auto dims = object.find("dims"); dims != object.end()) dimensions(*dims, at + "/dims");
    if (const auto range = object.find("dimsRange"); range != object.end() && range->is_object()) {
      for (json& side : *range) scale_all(side);
    }
    if (const auto xform = object.find("xform"); xform != object.end() && xform->is_object()) transform(*xform, at + "/xform");
    if (const auto spaces = object.find("spaces"); spaces != object.end() && spaces->is_array()) {
      for (json& space : *spaces) {
        if (!space.is_object()) continue;
        for (const char* key : {"min", "max"}) {
          if (const auto corner = space.find(key); corner != space.end()) scale_all(*corner);
        }
      }
    }
    if (const auto mount = object.find("mount"); mount != object.end() && mount->is_string()) {
      if (const auto known = mount_from_name(mount->get<std::string>())) *mount = name_of(*known);
    }
    mesh(object, at);
  }

  void transform(json& xform, const std::string& at) {
    bool renamed = rename_member(xform, "position", "pos");
    renamed |= rename_member(xform, "rotation", "rot");
    if (renamed) note("converted", "members under other names are read as pos, rot", at);
    if (const auto pos = xform.find("pos"); pos != xform.end()) {
      if (pos->is_array() && pos->size() == 2 && axes_.is_usual()) pos->push_back(0);
      place(*pos);
    }
    if (const auto rot = xform.find("rot"); rot != xform.end()) rotation(*rot, at + "/rot");
    if (const auto size = xform.find("scale"); size != xform.end()) {
      if (size->is_number())
        *size = {*size, *size, *size};
      else if (!axes_.is_usual() && size->is_array() && size->size() == 3)
        *size = axes_.scale_from_file(*size);
    }
  }

  void rotation(json& value, const std::string& at) {
    if (value.is_number()) value = axes_.is_usual() ? json{0, 0, value} : json{0, 0, value.get<double>() * axes_.turn_sign()};
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, [](const json& v) { return v.is_number(); })) return;
    const std::size_t up = axes_.up_index();
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != up && value[i].get<double>() != 0) note("ignored", "furniture stands upright: only the turn about the vertical is read", at);
    }
    if (!axes_.is_usual() && up != 2)
      value = {0, 0, value[up].get<double>() * axes_.turn_sign()};
    else
      value = {0, 0, value[2].get<double>() * axes_.turn_sign()};
  }

  void relation(json& relation, const std::string& at) {
    if (const auto type = relation.find("type"); type != relation.end() && type->is_string()) {
      for (const RelationRow& row : relation_table()) {
        const std::string written = type->get<std::string>();
        if (written == row.name || !same_name(written, row.name)) continue;
        *type = row.name;
        note("converted", fmt::format("the relation \"{}\" is read as \"{}\"", written, row.name), at + "/type");
      }
    }
    if (rename_member(relation, "target", "targets")) note("converted", "\"target\" is read as \"targets\"", at);
    if (const auto targets = relation.find("targets"); targets != relation.end() && targets->is_string())
      *targets = json::array({*targets});
    for (const char* key : {"axis", "alignAxis"}) {
      const auto axis = relation.find(key);
      if (axis == relation.end() || !axis->is_string()) continue;
      std::string text = axis->get<std::string>();
      if (!text.empty() && (text.back() == '+' || text.back() == '-')) text.pop_back();
      if (const auto known = axis_from_name(text)) *axis = name_of(axes_.room_axis(*known));
    }
    if (const auto side = relation.find("side"); side != relation.end() && side->is_string()) {
      if (const auto known = side_from_name(side->get<std::string>())) *side = name_of(*known);
    }
    settle_edge_and_region(relation, at, notes_);
    for (const char* key : {"distance", "min", "max", "gap", "depth", "width", "height"}) scale_member(relation, key);
  }

  void material(json& material, const std::string& at) {
    if (const auto color = material.find("color"); color != material.end()) {
      if (color->is_array() && color->size() == 4) color->erase(3);
      const bool bytes =
          color->is_array() && color->size() == 3 &&
          std::ranges::all_of(*color, [](const json& v) { return v.is_number() && v.get<double>() >= 0 && v.get<double>() <= 255; }) &&
          std::ranges::any_of(*color, [](const json& v) { return v.get<double>() > 1; });
      if (bytes) {
        for (json& part : *color) part = part.get<double>() / 255;
        note("converted", "the color is read as 0 to 255", at + "/color");
      }
    }
    if (const auto scale = material.find("scaleUV"); scale != material.end() && scale->is_number()) *scale = {*scale, *scale};
    if (const auto texture = material.find("tex"); texture != material.end() && texture->is_object() && texture->empty())
      material.erase(texture);
  }

  double factor_;
  const Axes& axes_;
  std::vector<Note>& notes_;
};

// "+x", "X", "-Z" → X+, X+, Z-; anything else stays for the schema to name.
json axis_direction(const json& written) {
  if (!written.is_string()) return written;
  std::string letter, sign = "+";
  for (const char c : written.get_ref<const std::string&>()) {
    if (c == '+' || c == '-')
      sign = c;
    else
      letter += c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  }
  return letter == "X" || letter == "Y" || letter == "Z" ? json(letter + sign) : written;
}

std::string text_member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

Status bring_into_form(json& scene, std::string_view units, std::vector<Note>& notes) {
  drop_nulls(scene);
  if (!scene.is_object()) return {};
  std::string unit(units);
  Axes axes;
  Status status;
  if (const auto metadata = scene.find("metadata"); metadata != scene.end() && metadata->is_object()) {
    if (unit.empty()) unit = text_member(*metadata, "units");
    if (metres_per_unit(unit)) (*metadata)["units"] = "m";
    if (const auto written = metadata->find("axes"); written != metadata->end() && written->is_object()) {
      for (json& direction : *written) direction = axis_direction(direction);
    }
    if (!axes.read(*metadata, notes)) {
      status = fail(ErrorCode::kSchema, "right, forward and up name one axis twice, which makes no frame", "/metadata/axes",
                    "name x, y and z once each, or leave axes out: x right, y forward, z up");
    }
  }
  const double factor = metres_per_unit(unit).value_or(1);
  if (factor != 1) notes.push_back({"converted", fmt::format("lengths in {} are converted to metres", unit), "/metadata/units"});
  SceneRewriter rewriter(factor, axes, notes);
  if (const auto room = scene.find("room"); room != scene.end()) rewriter.room(*room, "/room");
  rewriter.furniture(scene);
  rewriter.constraints(scene);
  rewriter.materials(scene);
  if (!is_own(scene)) axes.move_into_room(scene, notes);
  return status;
}

void bring_room_into_form(json& room, std::string_view units, std::vector<Note>& notes) {
  drop_nulls(room);
  const Axes axes;
  SceneRewriter(metres_per_unit(units).value_or(1), axes, notes).room(room, "");
}

}  // namespace layoutbox
