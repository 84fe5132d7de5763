// The studio's page.
#include <fmt/format.h>

#include "layoutbox/serve/http.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {

void add_page_routes(httplib::Server& server, Site& site) {
  server.Get("/", [&site](const httplib::Request& request, httplib::Response& response) {
    if (site.gives_token(request)) {
      response.set_header("Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", kTokenCookie, site.guard.token));
      return response.set_redirect("/");
    }
    put(response, site.page.start());
  });
  server.Get(R"(/([a-z0-9-]{1,64}\.[a-z0-9]{1,8}))", [&site](const httplib::Request& request, httplib::Response& response) {
    const auto file = site.page.file(request.matches[1].str());
    if (!file) return put_nothing_there(response);
    put(response, *file);
  });
}

}  // namespace layoutbox::serve
