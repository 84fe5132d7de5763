// CP-SAT's models and answers as bytes (protocol buffers written and read by protozero; field numbers as of OR-Tools 9.15).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::placement {

// A Boolean variable, or its negation as −index − 1.
using CpLiteral = std::int32_t;
inline CpLiteral cp_not(CpLiteral literal) { return -literal - 1; }

struct CpTerm {
  std::int32_t variable = 0;
  std::int64_t coefficient = 1;
};

class CpModel {
 public:
  std::int32_t add_variable(std::int64_t low, std::int64_t high);
  std::int32_t add_boolean() { return add_variable(0, 1); }
  // low ≤ Σ terms ≤ high, where all literals of `when` are true.
  void add_linear(std::span<const CpTerm> terms, std::int64_t low, std::int64_t high, std::span<const CpLiteral> when = {});
  void add_or(std::span<const CpLiteral> literals, std::span<const CpLiteral> when = {});
  void add_exactly_one(std::span<const CpLiteral> literals);
  // target = a · b.
  void add_product(std::int32_t target, std::int32_t a, std::int32_t b);
  void minimize(std::span<const CpTerm> terms);
  void hint(std::int32_t variable, std::int64_t value);
  void assume(CpLiteral literal) { assumptions_.push_back(literal); }
  void clear_assumptions() { assumptions_.clear(); }
  std::string bytes() const;
  std::size_t variable_count() const { return variables_; }

 private:
  void add_constraint(std::uint32_t field, const std::string& body, std::span<const CpLiteral> when);

  std::string body_;  // variables and constraints, serialised as they come
  std::size_t variables_ = 0;
  std::vector<CpTerm> objective_;
  std::vector<std::int32_t> hint_variables_;
  std::vector<std::int64_t> hint_values_;
  std::vector<CpLiteral> assumptions_;
};

struct CpParameters {
  std::uint64_t seed = 1;
  double deterministic_time = 1;  // CP-SAT's own units, about a second each
  bool first_solution = true;
  bool presolve = false;
  bool inclusions = false;  // presolve looks for linear constraints within others: slow, and it seldom brings a layout
};
std::string write_parameters(const CpParameters& parameters);

enum class CpStatus { kUnknown = 0, kModelInvalid = 1, kFeasible = 2, kInfeasible = 3, kOptimal = 4 };

struct CpAnswer {
  CpStatus status = CpStatus::kUnknown;
  std::vector<std::int64_t> values;
  std::vector<CpLiteral> core;  // assumptions that clash
  double deterministic_time = 0;
};

// Errors: kInternal: bytes that are no answer, an unknown status, or a solution of another length than the model.
Result<CpAnswer> read_answer(std::string_view bytes, std::size_t variables);

}  // namespace layoutbox::placement
