// What a vision model is shown of rooms, and by which way it gets there.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/cli/judge_questions.h"
#include "layoutbox/publish/publish.h"

namespace layoutbox::cli {

// A picture from a file: `given`, else scene.png in the folder of the room's file, if it is there. Errors: kIo, kTooLarge; kParse where it
// is neither PNG nor JPEG.
Result<std::optional<RoomPicture>> picture_of_room(const std::string& room_file, const std::string& given);

class Showing {
 public:
  // REQUIRES: what is given outlives it. Errors: those of publish::Settings and make_publisher.
  static Result<Showing> make(const QuestionFlags& flags, const std::map<std::string, RoomPicture>& pictures, const Console& console);

  // `own`: the room's own picture may be taken, which is none of a room that was changed.
  Result<std::vector<vlm::Picture>> of(const std::string& name, const Layout& layout, bool own) const;

 private:
  Showing(const QuestionFlags& flags, const std::map<std::string, RoomPicture>& pictures, const Console& console)
      : flags_(&flags), pictures_(&pictures), console_(&console) {}

  const QuestionFlags* flags_;
  const std::map<std::string, RoomPicture>* pictures_;
  const Console* console_;
  std::unique_ptr<publish::Publisher> publisher_;
};

}  // namespace layoutbox::cli
