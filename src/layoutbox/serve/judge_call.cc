// What rooms are judged by.
#include "layoutbox/judge/judge.h"

#include <utility>

#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {

Result<Answer> judge_call(const Json& request, const Surroundings& around) {
  RoomFile room{request.value("name", ""), "layout", {}, {}};
  LAYOUTBOX_ASSIGN(room.layout, layout_of(request));
  Asked asked;
  if (request.contains("scene")) {
    LAYOUTBOX_ASSIGN(asked.scene, scene_of_request(request));
  }
  return Answer{200, "application/json", judgement_json({judge_room(std::move(room), asked, around.catalog)})};
}

}  // namespace layoutbox::serve
