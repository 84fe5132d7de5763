#include "layoutbox/solve/cp_sat/wire.h"

#include <fmt/format.h>

#include <limits>
#include <protozero/pbf_reader.hpp>
#include <protozero/pbf_writer.hpp>

namespace layoutbox::placement {
namespace {

namespace field {
// CpModelProto
constexpr std::uint32_t kVariables = 2, kConstraints = 3, kObjective = 4, kHint = 6, kAssumptions = 7;
// IntegerVariableProto
constexpr std::uint32_t kVariableDomain = 2;
// ConstraintProto
constexpr std::uint32_t kEnforcement = 2, kBoolOr = 3, kProduct = 11, kLinear = 12, kExactlyOne = 29;
// LinearConstraintProto, BoolArgumentProto
constexpr std::uint32_t kVars = 1, kCoefficients = 2, kDomain = 3, kLiterals = 1;
// LinearArgumentProto, LinearExpressionProto
constexpr std::uint32_t kTarget = 1, kExpressions = 2, kExpressionVars = 1, kExpressionCoefficients = 2;
// CpObjectiveProto, PartialVariableAssignment
constexpr std::uint32_t kObjectiveVars = 1, kObjectiveCoefficients = 4, kHintVars = 1, kHintValues = 2;
// SatParameters
constexpr std::uint32_t kSeed = 31, kDeterministicTime = 67, kPresolve = 86, kLinearization = 90, kFirstSolution = 98, kProbing = 110,
                        kSymmetry = 183, kInclusionWork = 201, kWorkers = 206;
// CpSolverResponse
constexpr std::uint32_t kStatus = 1, kSolution = 2, kDeterministicUsed = 17, kCore = 23;
}  // namespace field

// Negative bounds that mean "none" stay clear of overflow inside CP-SAT.
constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max() / 4;

}  // namespace

std::int32_t CpModel::add_variable(std::int64_t low, std::int64_t high) {
  std::string variable;
  protozero::pbf_writer writer(variable);
  const std::int64_t domain[2] = {low, high};
  writer.add_packed_int64(field::kVariableDomain, std::begin(domain), std::end(domain));
  protozero::pbf_writer(body_).add_message(field::kVariables, variable);
  return static_cast<std::int32_t>(variables_++);
}

void CpModel::add_constraint(std::uint32_t kind, const std::string& body, std::span<const CpLiteral> when) {
  std::string constraint;
  protozero::pbf_writer writer(constraint);
  if (!when.empty()) writer.add_packed_int32(field::kEnforcement, when.begin(), when.end());
  writer.add_message(kind, body);
  protozero::pbf_writer(body_).add_message(field::kConstraints, constraint);
}

void CpModel::add_linear(std::span<const CpTerm> terms, std::int64_t low, std::int64_t high, std::span<const CpLiteral> when) {
  std::string body;
  protozero::pbf_writer writer(body);
  std::vector<std::int32_t> variables;
  std::vector<std::int64_t> coefficients;
  for (const CpTerm& term : terms) {
    variables.push_back(term.variable);
    coefficients.push_back(term.coefficient);
  }
  const std::int64_t domain[2] = {std::max(low, -kNone), std::min(high, kNone)};
  writer.add_packed_int32(field::kVars, variables.begin(), variables.end());
  writer.add_packed_int64(field::kCoefficients, coefficients.begin(), coefficients.end());
  writer.add_packed_int64(field::kDomain, std::begin(domain), std::end(domain));
  add_constraint(field::kLinear, body, when);
}

void CpModel::add_or(std::span<const CpLiteral> literals, std::span<const CpLiteral> when) {
  std::string body;
  protozero::pbf_writer(body).add_packed_int32(field::kLiterals, literals.begin(), literals.end());
  add_constraint(field::kBoolOr, body, when);
}

void CpModel::add_exactly_one(std::span<const CpLiteral> literals) {
  std::string body;
  protozero::pbf_writer(body).add_packed_int32(field::kLiterals, literals.begin(), literals.end());
  add_constraint(field::kExactlyOne, body, {});
}

void CpModel::add_product(std::int32_t target, std::int32_t a, std::int32_t b) {
  const auto expression = [](std::int32_t variable) {
    std::string bytes;
    protozero::pbf_writer writer(bytes);
    const std::int64_t one = 1;
    writer.add_packed_int32(field::kExpressionVars, &variable, &variable + 1);
    writer.add_packed_int64(field::kExpressionCoefficients, &one, &one + 1);
    return bytes;
  };
  std::string body;
  protozero::pbf_writer writer(body);
  writer.add_message(field::kTarget, expression(target));
  for (const std::int32_t factor : {a, b}) writer.add_message(field::kExpressions, expression(factor));
  add_constraint(field::kProduct, body, {});
}

void CpModel::minimize(std::span<const CpTerm> terms) { objective_.assign(terms.begin(), terms.end()); }

void CpModel::hint(std::int32_t variable, std::int64_t value) {
  hint_variables_.push_back(variable);
  hint_values_.push_back(value);
}

std::string CpModel::bytes() const {
  std::string all = body_;
  protozero::pbf_writer writer(all);
  if (!objective_.empty()) {
    std::vector<std::int32_t> variables;
    std::vector<std::int64_t> coefficients;
    for (const CpTerm& term : objective_) {
      variables.push_back(term.variable);
      coefficients.push_back(term.coefficient);
    }
    protozero::pbf_writer objective(writer, field::kObjective);
    objective.add_packed_int32(field::kObjectiveVars, variables.begin(), variables.end());
    objective.add_packed_int64(field::kObjectiveCoefficients, coefficients.begin(), coefficients.end());
  }
  if (!hint_variables_.empty()) {
    protozero::pbf_writer hint(writer, field::kHint);
    hint.add_packed_int32(field::kHintVars, hint_variables_.begin(), hint_variables_.end());
    hint.add_packed_int64(field::kHintValues, hint_values_.begin(), hint_values_.end());
  }
  if (!assumptions_.empty()) writer.add_packed_int32(field::kAssumptions, assumptions_.begin(), assumptions_.end());
  return all;
}

std::string write_parameters(const CpParameters& parameters) {
  std::string bytes;
  protozero::pbf_writer writer(bytes);
  writer.add_int32(field::kSeed, static_cast<std::int32_t>(parameters.seed & 0x7fffffff));
  writer.add_double(field::kDeterministicTime, parameters.deterministic_time);
  writer.add_int32(field::kWorkers, 1);
  writer.add_bool(field::kPresolve, parameters.presolve);
  writer.add_int32(field::kLinearization, 0);
  writer.add_int32(field::kProbing, 0);
  writer.add_int32(field::kSymmetry, 0);
  if (!parameters.inclusions) writer.add_int64(field::kInclusionWork, 0);
  writer.add_bool(field::kFirstSolution, parameters.first_solution);
  return bytes;
}

Result<CpAnswer> read_answer(std::string_view bytes, std::size_t variables) {
  CpAnswer answer;
  try {
    protozero::pbf_reader reader(bytes.data(), bytes.size());
    while (reader.next()) {
      switch (reader.tag()) {
        case field::kStatus: {
          const int status = reader.get_enum();
          if (status < 0 || status > 4)
            return fail(ErrorCode::kInternal, fmt::format("CP-SAT answered with the unknown status {}", status));
          answer.status = static_cast<CpStatus>(status);
          break;
        }
        case field::kSolution:
          for (const std::int64_t value : reader.get_packed_int64()) answer.values.push_back(value);
          break;
        case field::kCore:
          for (const std::int32_t literal : reader.get_packed_int32()) answer.core.push_back(literal);
          break;
        case field::kDeterministicUsed: answer.deterministic_time = reader.get_double(); break;
        default: reader.skip();
      }
    }
  } catch (const protozero::exception& error) {
    return fail(ErrorCode::kInternal, fmt::format("CP-SAT's answer cannot be read: {}", error.what()));
  }
  if (answer.status == CpStatus::kModelInvalid) return fail(ErrorCode::kInternal, "CP-SAT called the model invalid");
  const bool solved = answer.status == CpStatus::kFeasible || answer.status == CpStatus::kOptimal;
  if (solved && answer.values.size() != variables) {
    return fail(ErrorCode::kInternal, fmt::format("CP-SAT's solution has {} values for {} variables", answer.values.size(), variables));
  }
  return answer;
}

}  // namespace layoutbox::placement
