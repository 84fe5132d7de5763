#include "other_models.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <limits>
#include <protozero/pbf_writer.hpp>
#include <utility>
#include <vector>

#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/cp_sat/wire.h"

namespace layoutbox::bench {
namespace {

using namespace placement;

constexpr Mm kCell = 10;
constexpr std::int64_t kUnbounded = std::numeric_limits<std::int64_t>::max() / 4;

// Defaults but for one worker (the figures are for one core) and the limit.
std::string default_parameters(double limit) {
  std::string bytes;
  protozero::pbf_writer writer(bytes);
  writer.add_double(36, limit);
  writer.add_int32(206, 1);
  return bytes;
}

// Where the middle of a box at a wall is, on the axis across the wall; in cells.
std::pair<int, Mm> wall_middle(const PlainRoom& room, const PlainBox& box) {
  switch (box.wall) {
    case 0: return {1, box.depth / 2 / kCell};
    case 1: return {0, (room.width - box.width / 2) / kCell};
    case 2: return {1, (room.depth - box.depth / 2) / kCell};
    default: return {0, box.width / 2 / kCell};
  }
}

Outcome solve_paper(const PlainRoom& room, bool whole_boxes, double limit) {
  const auto library = CpSatLibrary::get();
  if (!library) return {false, 0, library.error().message};
  const double start = cpu_seconds();
  CpModel model;
  const Mm half = 2 * kCell;
  std::vector<std::array<std::int32_t, 2>> middle;
  for (const PlainBox& box : room.boxes) {
    const Mm w = whole_boxes ? box.width / half : 0, d = whole_boxes ? box.depth / half : 0;
    middle.push_back({model.add_variable(w, room.width / kCell - w), model.add_variable(d, room.depth / kCell - d)});
  }
  for (std::size_t i = 0; i < room.boxes.size(); ++i) {
    const PlainBox& box = room.boxes[i];
    if (box.wall >= 0) {
      const auto [axis, at] = wall_middle(room, box);
      model.add_linear(std::array{CpTerm{middle[i][static_cast<std::size_t>(axis)], 1}}, at, at);
    }
    if (box.align >= 0) {
      const auto axis = static_cast<std::size_t>(box.axis);
      model.add_linear(std::array{CpTerm{middle[i][axis], 1}, CpTerm{middle[static_cast<std::size_t>(box.align)][axis], -1}}, 0, 0);
    }
    for (std::size_t j = i + 1; j < room.boxes.size(); ++j) {
      const Mm apart[2] = {(box.width + room.boxes[j].width) / half, (box.depth + room.boxes[j].depth) / half};
      std::vector<CpLiteral> sides;
      for (const std::size_t axis : {0, 1}) {
        for (const int sign : {1, -1}) {
          sides.push_back(model.add_boolean());
          const std::array terms{CpTerm{middle[j][axis], sign}, CpTerm{middle[i][axis], -sign}};
          model.add_linear(terms, apart[axis], kUnbounded, std::array{sides.back()});
        }
      }
      model.add_or(sides);
    }
  }
  const auto answer = read_answer((*library)->solve(model.bytes(), default_parameters(limit), nullptr, limit + 1), model.variable_count());
  Outcome out{false, cpu_seconds() - start, answer ? "" : answer.error().message};
  out.found = answer && (answer->status == CpStatus::kFeasible || answer->status == CpStatus::kOptimal);
  return out;
}

// The C interface of HiGHS, from the library beside OR-Tools'.
struct Highs {
  void* (*create)() = nullptr;
  void (*destroy)(void*) = nullptr;
  int (*run)(void*) = nullptr;
  int (*pass_mip)(void*, int, int, int, int, int, double, const double*, const double*, const double*, const double*, const double*,
                  const int*, const int*, const double*, const int*) = nullptr;
  int (*set_bool)(void*, const char*, int) = nullptr;
  int (*set_int)(void*, const char*, int) = nullptr;
  int (*set_double)(void*, const char*, double) = nullptr;
  int (*get_int_info)(const void*, const char*, int*) = nullptr;

  static const Highs* get() {
    static const Highs highs = open();
    return highs.run != nullptr ? &highs : nullptr;
  }

 private:
  static Highs open() {
    Highs h;
    const auto library = CpSatLibrary::get();
    if (!library) return h;
    void* handle = dlopen((std::filesystem::path((*library)->path()).parent_path() / "libhighs.so.1").c_str(), RTLD_NOW);
    if (handle == nullptr) return h;
    const auto find = [&](const char* name, auto& function) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(dlsym(handle, name));  // NOLINT
      return function != nullptr;
    };
    const bool all = find("Highs_create", h.create) && find("Highs_destroy", h.destroy) && find("Highs_passMip", h.pass_mip) &&
                     find("Highs_setBoolOptionValue", h.set_bool) && find("Highs_setIntOptionValue", h.set_int) &&
                     find("Highs_setDoubleOptionValue", h.set_double) && find("Highs_getIntInfoValue", h.get_int_info) &&
                     find("Highs_run", h.run);
    if (!all) h.run = nullptr;
    return h;
  }
};

// Columns and rows as HiGHS wants them, row by row.
struct Programme {
  std::vector<double> low, high, row_low, row_high, values;
  std::vector<int> starts, columns, integral;

  int column(double from, double to) {
    low.push_back(from), high.push_back(to), integral.push_back(1);
    return static_cast<int>(low.size()) - 1;
  }
  void row(std::initializer_list<std::pair<int, double>> terms, double from, double to) {
    starts.push_back(static_cast<int>(columns.size()));
    for (const auto& [c, value] : terms) columns.push_back(c), values.push_back(value);
    row_low.push_back(from), row_high.push_back(to);
  }
};

Outcome solve_big_m(const PlainRoom& room, double limit) {
  const Highs* highs = Highs::get();
  if (highs == nullptr) return {false, 0, "HiGHS is not beside OR-Tools"};
  const double start = cpu_seconds();
  constexpr double kMuch = 1e30;
  Programme p;
  std::vector<std::array<int, 2>> middle;
  for (const PlainBox& b : room.boxes) {
    middle.push_back(
        {p.column(b.width / 20.0, (room.width - b.width / 2.0) / kCell), p.column(b.depth / 20.0, (room.depth - b.depth / 2.0) / kCell)});
  }
  for (std::size_t i = 0; i < room.boxes.size(); ++i) {
    const PlainBox& box = room.boxes[i];
    if (box.wall >= 0) {
      const auto [axis, at] = wall_middle(room, box);
      p.row({{middle[i][static_cast<std::size_t>(axis)], 1}}, at, at);
    }
    if (box.align >= 0) {
      const auto axis = static_cast<std::size_t>(box.axis);
      p.row({{middle[i][axis], 1}, {middle[static_cast<std::size_t>(box.align)][axis], -1}}, 0, 0);
    }
    for (std::size_t j = i + 1; j < room.boxes.size(); ++j) {
      const double apart[2] = {(box.width + room.boxes[j].width) / 20.0, (box.depth + room.boxes[j].depth) / 20.0};
      const double much[2] = {2.0 * room.width / kCell, 2.0 * room.depth / kCell};
      int side[4];
      for (int k = 0; k < 4; ++k) {
        const auto axis = static_cast<std::size_t>(k / 2);
        const double sign = k % 2 == 0 ? 1 : -1;
        side[k] = p.column(0, 1);
        p.row({{middle[j][axis], sign}, {middle[i][axis], -sign}, {side[k], -much[axis]}}, apart[axis] - much[axis], kMuch);
      }
      p.row({{side[0], 1}, {side[1], 1}, {side[2], 1}, {side[3], 1}}, 1, 4);
    }
  }
  void* model = highs->create();
  highs->set_bool(model, "output_flag", 0);
  highs->set_int(model, "threads", 1);
  highs->set_double(model, "time_limit", limit);
  const std::vector<double> cost(p.low.size(), 0);
  constexpr int kRowWise = 2, kMinimize = 1;
  highs->pass_mip(model, static_cast<int>(p.low.size()), static_cast<int>(p.row_low.size()), static_cast<int>(p.values.size()), kRowWise,
                  kMinimize, 0, cost.data(), p.low.data(), p.high.data(), p.row_low.data(), p.row_high.data(), p.starts.data(),
                  p.columns.data(), p.values.data(), p.integral.data());
  highs->run(model);
  int status = 0;
  highs->get_int_info(model, "primal_solution_status", &status);
  highs->destroy(model);
  constexpr int kFeasiblePoint = 2;
  return {status == kFeasiblePoint, cpu_seconds() - start, ""};
}

}  // namespace

Outcome solve_otherwise(OtherModel model, const PlainRoom& room, double limit) {
  if (model == OtherModel::kBigM) return solve_big_m(room, limit);
  return solve_paper(room, model == OtherModel::kPaperBoxes, limit);
}

}  // namespace layoutbox::bench
