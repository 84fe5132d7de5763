// A page drawn by Cairo into a PDF or a PNG. Cairo (libcairo.so.2) is loaded when the first page is drawn, so that the program starts
// without it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/export/canvas.h"

namespace layoutbox {

enum class PageFormat { kPdf, kPng };

class CairoCanvas final : public Canvas {
 public:
  // A page of that many millimetres; `dots_per_inch` is for PNG. Errors: kIo (no Cairo, with what to install; a page too large).
  static Result<std::unique_ptr<CairoCanvas>> make(PageFormat format, double width, double height, double dots_per_inch,
                                                   std::string_view title);
  ~CairoCanvas() override;

  void polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void circle(PaperPoint center, double radius, const DrawStyle& style) override;
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) override;
  void open_group(std::string_view, std::string_view) override {}
  void close_group() override {}

  // The file. Errors: kIo when Cairo ran out of memory or the like.
  Result<std::string> finish();

 private:
  struct State;
  explicit CairoCanvas(std::unique_ptr<State> state);
  void path(const std::vector<PaperPoint>& points, bool closed);
  void paint(const DrawStyle& style);
  std::unique_ptr<State> state_;
};

// Is Cairo there? Its version, or the reason why not.
Result<std::string> describe_cairo();

}  // namespace layoutbox
