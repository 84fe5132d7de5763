// Answers as HTTP has them: status, type, headers, the error object.
#pragma once

#include <httplib.h>

#include <string>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

Answer error_answer(int status, const Error& error);
Answer error_answer(const Error& error);  // with the status that its code stands for

void put(httplib::Response& response, const Answer& answer);
void put_error(httplib::Response& response, int status, const Error& error);
void put_error(httplib::Response& response, const Error& error);
void put_nothing_there(httplib::Response& response);  // 404

// Of every answer: nothing is read as something else, framed, or told to others.
void set_headers(httplib::Response& response);

}  // namespace layoutbox::serve
