// The paper's second way to a picture: the model writes blender.py from the text, the layout and the program's own script.
#pragma once

#include <functional>
#include <string>

#include "layoutbox/chat/chat_client.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

struct ScriptByModel {
  chat::ChatOptions chat;
  std::string prompt;  // what the room was asked for by; may be empty
  std::uint64_t seed = 1;
  int max_attempts = 5;                             // answers; a script that fails goes back with its error. REQUIRES: > 0
  bool unsafe_scripts = false;                      // see sandbox::Job::without_walls
  std::function<void(const std::string&)> on_note;  // told of each failure, and of the fallback; may be empty
};

// For GenerateOptions::draw. Its script runs in the sandbox alone and takes the place of blender.py; it draws scene.png, through its own
// camera, and no other view. Where no script of the model's works, the program's own is run and blender.py stays.
// Errors: those of run_blender; of asking the model only kInterrupted (all else ends in the program's own script).
DrawPictures draw_by_model(ScriptByModel options);

}  // namespace layoutbox
