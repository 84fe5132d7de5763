// Questions in a model's words, as in the paper: it writes them from the scene's JSON.
#pragma once

#include <vector>

#include "layoutbox/judge/vlm/vlm_judge.h"

namespace layoutbox::vlm {

// Each question's text is written anew by the model, which is shown the scene and what the question is about; what it asks, and so its
// truth, stays. One that the model leaves out keeps our words. Errors: those of ChatClient::ask.
Status write_questions(std::vector<RoomQuestion>& questions, const std::string& scene, chat::ChatClient& client,
                       const JudgeOptions& options);

// The same of what was asked of a room.
Status write_questions(RoomAnswers& room, const Layout& layout, chat::ChatClient& client, const JudgeOptions& options);

}  // namespace layoutbox::vlm
