#include "layoutbox/solve/model/formula.h"

namespace layoutbox::placement {
namespace {

void add_term(Linear& form, const Term& term) {
  for (Term& known : form.terms) {
    if (known.item != term.item || known.quantity != term.quantity) continue;
    known.coefficient += term.coefficient;
    if (known.coefficient == 0) {
      known = form.terms.back();
      form.terms.pop_back();
    }
    return;
  }
  if (term.coefficient != 0) form.terms.push_back(term);
}

Linear single(ItemId item, int quantity) {
  Linear form;
  form.terms.push_back({1, item, static_cast<std::int16_t>(quantity)});
  return form;
}

}  // namespace

Linear operator+(Linear a, const Linear& b) {
  for (const Term& term : b.terms) add_term(a, term);
  a.constant += b.constant;
  return a;
}

Linear operator-(Linear a, const Linear& b) {
  for (Term term : b.terms) {
    term.coefficient = -term.coefficient;
    add_term(a, term);
  }
  a.constant -= b.constant;
  return a;
}

Linear operator*(std::int32_t factor, Linear a) {
  if (factor == 0) return {};
  for (Term& term : a.terms) term.coefficient *= factor;
  a.constant *= factor;
  return a;
}

Linear lo(ItemId item, int axis) { return single(item, kPositionX + axis); }
Linear extent(ItemId item, int axis) { return single(item, kExtentX + axis); }
Linear hi(ItemId item, int axis) { return lo(item, axis) + extent(item, axis); }
Linear mid2(ItemId item, int axis) { return 2 * lo(item, axis) + extent(item, axis); }
Linear constant_of(ItemId item, int quantity) { return single(item, quantity); }
Linear reach(ItemId item, Direction towards) { return towards.sign > 0 ? hi(item, towards.axis) : -1 * lo(item, towards.axis); }

Case& Case::require_small(const Linear& form, Mm tolerance) {
  require(Linear(tolerance) - form);
  return require(form + Linear(tolerance));
}

}  // namespace layoutbox::placement
