#include "layoutbox/export/cairo_canvas.h"

#include <dlfcn.h>

#include <cmath>
#include <cstdlib>

#include "layoutbox/base/units.h"

namespace layoutbox {
namespace {

// Cairo's C interface as far as it is used; it has been stable since 1.10 (2010). The handles are never looked into.
struct CairoContext;
struct CairoSurface;
struct CairoTextExtents {
  double x_bearing, y_bearing, width, height, x_advance, y_advance;
};
using CairoWrite = int (*)(void* closure, const unsigned char* data, unsigned length);

constexpr int kFormatRgb24 = 1, kFontNormal = 0, kLineRound = 1, kMetadataTitle = 0;
constexpr double kMmPerInch = 25.4, kPointsPerInch = 72;
constexpr double kMostPixels = 30000;  // a side; Cairo's limit is 32767

struct CairoLibrary {
  const char* (*version_string)();
  CairoSurface* (*image_surface_create)(int format, int width, int height);
  CairoSurface* (*pdf_surface_create_for_stream)(CairoWrite write, void* closure, double width, double height);
  void (*pdf_surface_set_metadata)(CairoSurface* surface, int which, const char* text);
  int (*surface_write_to_png_stream)(CairoSurface* surface, CairoWrite write, void* closure);
  void (*surface_finish)(CairoSurface* surface);
  void (*surface_destroy)(CairoSurface* surface);
  int (*surface_status)(CairoSurface* surface);
  CairoContext* (*create)(CairoSurface* surface);
  void (*destroy)(CairoContext* context);
  int (*status)(CairoContext* context);
  void (*scale)(CairoContext* context, double x, double y);
  void (*save)(CairoContext* context);
  void (*restore)(CairoContext* context);
  void (*translate)(CairoContext* context, double x, double y);
  void (*rotate)(CairoContext* context, double angle);
  void (*set_source_rgba)(CairoContext* context, double r, double g, double b, double a);
  void (*paint)(CairoContext* context);
  void (*new_path)(CairoContext* context);
  void (*move_to)(CairoContext* context, double x, double y);
  void (*line_to)(CairoContext* context, double x, double y);
  void (*close_path)(CairoContext* context);
  void (*arc)(CairoContext* context, double x, double y, double radius, double from, double to);
  void (*fill_preserve)(CairoContext* context);
  void (*fill)(CairoContext* context);
  void (*stroke)(CairoContext* context);
  void (*stroke_preserve)(CairoContext* context);
  void (*set_line_width)(CairoContext* context, double width);
  void (*set_line_join)(CairoContext* context, int join);
  void (*set_line_cap)(CairoContext* context, int cap);
  void (*set_dash)(CairoContext* context, const double* dashes, int count, double offset);
  void (*select_font_face)(CairoContext* context, const char* family, int slant, int weight);
  void (*set_font_size)(CairoContext* context, double size);
  void (*text_extents)(CairoContext* context, const char* text, CairoTextExtents* extents);
  void (*show_text)(CairoContext* context, const char* text);
  void (*text_path)(CairoContext* context, const char* text);
};

constexpr const char* kHint = "install it: apt-get install libcairo2; or export the floor plan as svg";

template <class Function>
bool find(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  return function != nullptr;
}

Result<CairoLibrary> open_library() {
  void* handle = dlopen("libcairo.so.2", RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* reason = dlerror();
    return fail(ErrorCode::kIo, std::string("the library Cairo, which draws PDF and PNG, cannot be loaded: ") + (reason ? reason : ""),
                "libcairo.so.2", kHint);
  }
  CairoLibrary c{};
  const bool all =
      find(handle, "cairo_version_string", c.version_string) && find(handle, "cairo_image_surface_create", c.image_surface_create) &&
      find(handle, "cairo_pdf_surface_create_for_stream", c.pdf_surface_create_for_stream) &&
      find(handle, "cairo_pdf_surface_set_metadata", c.pdf_surface_set_metadata) &&
      find(handle, "cairo_surface_write_to_png_stream", c.surface_write_to_png_stream) &&
      find(handle, "cairo_surface_finish", c.surface_finish) && find(handle, "cairo_surface_destroy", c.surface_destroy) &&
      find(handle, "cairo_surface_status", c.surface_status) && find(handle, "cairo_create", c.create) &&
      find(handle, "cairo_destroy", c.destroy) && find(handle, "cairo_status", c.status) && find(handle, "cairo_scale", c.scale) &&
      find(handle, "cairo_save", c.save) && find(handle, "cairo_restore", c.restore) && find(handle, "cairo_translate", c.translate) &&
      find(handle, "cairo_rotate", c.rotate) && find(handle, "cairo_set_source_rgba", c.set_source_rgba) &&
      find(handle, "cairo_paint", c.paint) && find(handle, "cairo_new_path", c.new_path) && find(handle, "cairo_move_to", c.move_to) &&
      find(handle, "cairo_line_to", c.line_to) && find(handle, "cairo_close_path", c.close_path) && find(handle, "cairo_arc", c.arc) &&
      find(handle, "cairo_fill_preserve", c.fill_preserve) && find(handle, "cairo_fill", c.fill) &&
      find(handle, "cairo_stroke", c.stroke) && find(handle, "cairo_stroke_preserve", c.stroke_preserve) &&
      find(handle, "cairo_set_line_width", c.set_line_width) && find(handle, "cairo_set_line_join", c.set_line_join) &&
      find(handle, "cairo_set_line_cap", c.set_line_cap) && find(handle, "cairo_set_dash", c.set_dash) &&
      find(handle, "cairo_select_font_face", c.select_font_face) && find(handle, "cairo_set_font_size", c.set_font_size) &&
      find(handle, "cairo_text_extents", c.text_extents) && find(handle, "cairo_show_text", c.show_text) &&
      find(handle, "cairo_text_path", c.text_path);
  if (!all) return fail(ErrorCode::kIo, "the library Cairo is too old: 1.16 or later is needed", "libcairo.so.2", kHint);
  return c;
}

Result<const CairoLibrary*> library() {
  static const Result<CairoLibrary> opened = open_library();
  if (!opened) return Failure(opened.error());
  return &*opened;
}

// Called by Cairo, which is C: nothing may be thrown through it.
int append(void* closure, const unsigned char* data, unsigned length) noexcept {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return 0;
}

struct Rgb {
  double r = 0, g = 0, b = 0;
};

// "#rgb" or "#rrggbb"; black for anything else.
Rgb rgb_of(std::string_view color) {
  const std::size_t digits = color.size() == 4 ? 1 : color.size() == 7 ? 2 : 0;
  if (digits == 0 || color.front() != '#') return {};
  const auto part = [&](std::size_t i) {
    std::string hex(color.substr(1 + i * digits, digits));
    if (digits == 1) hex += hex;
    return static_cast<double>(std::strtol(hex.c_str(), nullptr, 16)) / 255;
  };
  return {part(0), part(1), part(2)};
}

}  // namespace

struct CairoCanvas::State {
  const CairoLibrary* cairo = nullptr;
  PageFormat format = PageFormat::kPdf;
  std::string bytes;
  CairoSurface* surface = nullptr;
  CairoContext* context = nullptr;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context != nullptr) cairo->destroy(context);
    if (surface != nullptr) cairo->surface_destroy(surface);
  }
};

CairoCanvas::CairoCanvas(std::unique_ptr<State> state) : state_(std::move(state)) {}
CairoCanvas::~CairoCanvas() = default;

Result<std::unique_ptr<CairoCanvas>> CairoCanvas::make(PageFormat format, double width, double height, double dots_per_inch,
                                                       std::string_view title) {
  auto state = std::make_unique<State>();
  LAYOUTBOX_ASSIGN(state->cairo, library());
  const CairoLibrary& cairo = *state->cairo;
  state->format = format;
  const double per_mm = (format == PageFormat::kPdf ? kPointsPerInch : dots_per_inch) / kMmPerInch;
  if (format == PageFormat::kPdf) {
    state->surface = cairo.pdf_surface_create_for_stream(append, &state->bytes, width * per_mm, height * per_mm);
    cairo.pdf_surface_set_metadata(state->surface, kMetadataTitle, std::string(title).c_str());
  } else {
    if (std::max(width, height) * per_mm > kMostPixels)
      return fail(ErrorCode::kTooLarge, "a side of the picture has more than 30000 pixels");
    state->surface = cairo.image_surface_create(kFormatRgb24, static_cast<int>(std::lround(width * per_mm)),
                                                static_cast<int>(std::lround(height * per_mm)));
  }
  state->context = cairo.create(state->surface);
  cairo.scale(state->context, per_mm, per_mm);
  cairo.set_source_rgba(state->context, 1, 1, 1, 1);
  cairo.paint(state->context);
  cairo.set_line_join(state->context, kLineRound);
  cairo.set_line_cap(state->context, kLineRound);
  cairo.select_font_face(state->context, "Helvetica", kFontNormal, kFontNormal);
  if (cairo.status(state->context) != 0) return fail(ErrorCode::kIo, "Cairo cannot make a page of that size");
  return std::unique_ptr<CairoCanvas>(new CairoCanvas(std::move(state)));
}

void CairoCanvas::path(const std::vector<PaperPoint>& points, bool closed) {
  const CairoLibrary& cairo = *state_->cairo;
  cairo.new_path(state_->context);
  for (std::size_t i = 0; i < points.size(); ++i) (i == 0 ? cairo.move_to : cairo.line_to)(state_->context, points[i].x, points[i].y);
  if (closed) cairo.close_path(state_->context);
}

void CairoCanvas::paint(const DrawStyle& style) {
  const CairoLibrary& cairo = *state_->cairo;
  if (style.fill != "none") {
    const Rgb color = rgb_of(style.fill);
    cairo.set_source_rgba(state_->context, color.r, color.g, color.b, 1);
    cairo.fill_preserve(state_->context);
  }
  if (style.stroke != "none") {
    std::vector<double> dashes;
    for (const char* at = style.dash.data(); at != nullptr && at < style.dash.data() + style.dash.size();) {
      char* end = nullptr;
      const double dash = std::strtod(at, &end);
      if (end == at) break;
      dashes.push_back(dash);
      at = end;
    }
    const Rgb color = rgb_of(style.stroke);
    cairo.set_source_rgba(state_->context, color.r, color.g, color.b, 1);
    cairo.set_dash(state_->context, dashes.data(), static_cast<int>(dashes.size()), 0);
    cairo.set_line_width(state_->context, style.width);
    cairo.stroke_preserve(state_->context);
  }
  cairo.new_path(state_->context);
}

void CairoCanvas::polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  path(points, true);
  paint(style);
}

void CairoCanvas::polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  path(points, false);
  paint(style);
}

void CairoCanvas::circle(PaperPoint center, double radius, const DrawStyle& style) {
  state_->cairo->new_path(state_->context);
  state_->cairo->arc(state_->context, center.x, center.y, radius, 0, 2 * kPi);
  paint(style);
}

void CairoCanvas::text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) {
  const CairoLibrary& cairo = *state_->cairo;
  CairoContext* context = state_->context;
  const std::string text = printable(words);
  cairo.save(context);
  cairo.translate(context, at.x, at.y);
  cairo.rotate(context, radians_from_degrees(degrees));
  cairo.set_font_size(context, size);
  CairoTextExtents extents{};
  cairo.text_extents(context, text.c_str(), &extents);
  if (extents.x_advance > 0) cairo.scale(context, text_width(text, size) / extents.x_advance, 1);
  const double x = anchor == TextAnchor::kStart ? 0 : anchor == TextAnchor::kMiddle ? -extents.x_advance / 2 : -extents.x_advance;
  const Rgb ink = rgb_of(color);
  cairo.new_path(context);
  cairo.move_to(context, x, 0);
  cairo.text_path(context, text.c_str());
  cairo.set_dash(context, nullptr, 0, 0);
  cairo.set_line_width(context, 0.6);
  cairo.set_source_rgba(context, 1, 1, 1, 0.7);
  cairo.stroke(context);
  cairo.move_to(context, x, 0);
  cairo.set_source_rgba(context, ink.r, ink.g, ink.b, 1);
  cairo.show_text(context, text.c_str());  // text in a PDF, not outlines: it can be searched
  cairo.restore(context);
  cairo.new_path(context);
}

Result<std::string> CairoCanvas::finish() {
  const CairoLibrary& cairo = *state_->cairo;
  int status = cairo.status(state_->context);
  if (state_->format == PageFormat::kPng && status == 0) {
    status = cairo.surface_write_to_png_stream(state_->surface, append, &state_->bytes);
  }
  cairo.surface_finish(state_->surface);
  if (status == 0) status = cairo.surface_status(state_->surface);
  if (status != 0) return fail(ErrorCode::kIo, "Cairo could not draw the floor plan (its status " + std::to_string(status) + ")");
  return std::move(state_->bytes);
}

Result<std::string> describe_cairo() {
  LAYOUTBOX_ASSIGN(const CairoLibrary* cairo, library());
  return std::string("libcairo.so.2 ") + cairo->version_string();
}

}  // namespace layoutbox
