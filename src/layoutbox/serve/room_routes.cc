// Rooms that are kept.
#include <nlohmann/json.hpp>

#include "layoutbox/serve/call_parts.h"
#include "layoutbox/serve/http.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {
namespace {

constexpr const char* kRoom = R"(/api/rooms/([0-9a-f]{16}))";

JsonText text_of_room(const RoomRecord& room) {
  JsonText text;
  text.add("id", room.id).add("name", room.name).add("created", room.created).add("prompt", room.prompt);
  return text;
}

void list_rooms(const Site& site, httplib::Response& response) {
  const auto rooms = site.store.rooms();
  if (!rooms) return put_error(response, rooms.error());
  std::vector<std::string> list;
  for (const RoomRecord& room : *rooms) list.push_back(text_of_room(room).text());
  put(response, JsonText().add_written("rooms", list).answer());
}

void keep_room(Site& site, const httplib::Request& request, httplib::Response& response) {
  const auto body = site.read_body("keepRoom", request, response);
  if (!body) return;
  const auto layout = layout_of(*body);
  if (!layout) return put_error(response, layout.error());
  const RoomRecord room{new_id(), body->at("name").get<std::string>(), body->value("prompt", ""), time_text(), body->at("layout").dump()};
  const Status kept = site.store.put_room(room);
  if (!kept) return put_error(response, kept.error());
  put(response, text_of_room(room).answer(201));
}

void open_room(const Site& site, const std::string& id, httplib::Response& response) {
  const auto room = site.store.room(id);
  if (!room) return put_error(response, room.error());
  if (!*room) return put_nothing_there(response);
  put(response, text_of_room(**room).add_written("layout", (*room)->layout).answer());
}

void forget_room(Site& site, const std::string& id, httplib::Response& response) {
  const auto gone = site.store.remove_room(id);
  if (!gone) return put_error(response, gone.error());
  if (!*gone) return put_nothing_there(response);
  response.status = 204;
}

}  // namespace

void add_room_routes(httplib::Server& server, Site& site) {
  server.Get("/api/rooms", [&site](const httplib::Request&, httplib::Response& response) { list_rooms(site, response); });
  server.Post("/api/rooms", [&site](const httplib::Request& request, httplib::Response& response) { keep_room(site, request, response); });
  server.Get(kRoom,
             [&site](const httplib::Request& request, httplib::Response& response) { open_room(site, request.matches[1], response); });
  server.Delete(kRoom,
                [&site](const httplib::Request& request, httplib::Response& response) { forget_room(site, request.matches[1], response); });
}

}  // namespace layoutbox::serve
