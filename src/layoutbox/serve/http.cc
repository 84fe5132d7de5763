#include "layoutbox/serve/http.h"

#include "layoutbox/scene/json_text.h"

namespace layoutbox::serve {
namespace {

int status_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::kParse: return 400;
    case ErrorCode::kSchema: return 400;
    case ErrorCode::kTooLarge: return error.pointer.empty() ? 413 : 400;  // the whole body, or a member of it
    case ErrorCode::kInterrupted: return 503;
    case ErrorCode::kNoBlender:
    case ErrorCode::kNoSolver:
    case ErrorCode::kIo:
    case ErrorCode::kNetwork: return 503;
    default: return 422;
  }
}

}  // namespace

Answer error_answer(int status, const Error& error) { return {status, "application/json", write_error(error)}; }
Answer error_answer(const Error& error) { return error_answer(status_of(error), error); }

void put(httplib::Response& response, const Answer& answer) {
  response.status = answer.status;
  response.set_content(answer.body, answer.type.c_str());
}

void put_error(httplib::Response& response, int status, const Error& error) { put(response, error_answer(status, error)); }

void put_error(httplib::Response& response, const Error& error) { put(response, error_answer(error)); }

void put_nothing_there(httplib::Response& response) {
  put_error(response, 404, {ErrorCode::kReference, "there is no such thing", {}, "GET /api/openapi.json lists what there is", {}});
}

void set_headers(httplib::Response& response) {
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Content-Security-Policy",
                      "default-src 'self'; img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self' blob: data:; "
                      "object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'");
}

}  // namespace layoutbox::serve
