// Where to publish and with which credentials: the environment, else a file that nobody else can read.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::publish {

class Settings {
 public:
  // The file is LAYOUTBOX_CREDENTIALS, else layoutbox/credentials in the user's configuration folder: lines NAME=value. Variables of the
  // environment come before it. Errors: kIo where it is there and others may read it, or it cannot be read.
  static Result<Settings> of_user();
  explicit Settings(std::map<std::string, std::string> file = {}) : file_(std::move(file)) {}

  // Of the first of the names that is set; empty where none is.
  std::string get(std::initializer_list<std::string_view> names) const;
  // The same of a value that must never be shown: without_secrets() takes it out of any text.
  std::string secret(std::initializer_list<std::string_view> names);
  // As secret(). Error kUsage, which names the variable, where it is not set.
  Result<std::string> need(std::string_view name, bool is_secret);
  void hide(std::string value);

  std::string without_secrets(std::string text) const;

 private:
  std::map<std::string, std::string> file_;
  std::vector<std::string> secrets_;
};

}  // namespace layoutbox::publish
