// Which of two rooms is better, asked both ways round: who only likes the first picture contradicts himself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/judge/vlm/vlm_judge.h"

namespace layoutbox::vlm {

struct Contestant {
  std::string name;
  std::vector<Picture> pictures;
  int faults = 0;  // as geometry counts them: required checks that fail
};

enum class Choice { kFirst, kSecond, kNeither };

struct Comparison {
  std::string a, b;           // names
  std::string fault;          // where b is a with a fault planted: its kind
  Choice first, swapped;      // what was said of (a, b), and of (b, a)
  std::optional<bool> truth;  // a is better, by geometry; empty where that does not tell
  // a, b, or neither of them: empty where the two answers contradict one another or prefer none.
  std::string winner() const;
  bool contradicts() const;  // it was the place that was preferred
};

// Errors: those of ChatClient::ask.
Result<Comparison> compare(const Contestant& a, const Contestant& b, const std::string& wanted, chat::ChatClient& client,
                           const JudgeOptions& options);

struct PairFigures {
  int comparisons = 0;
  std::optional<Estimate> steady;         // both ways round the same
  std::optional<Estimate> prefers_first;  // of all answers that prefer one
  std::optional<Estimate> right;          // of comparisons where geometry tells: the winner is the better one
};
PairFigures figures_of_pairs(const std::vector<Comparison>& comparisons);

// By kind of fault where some were planted.
std::string pairs_text(const std::vector<Comparison>& comparisons);
std::string pairs_json(const std::vector<Comparison>& comparisons, const std::string& judge);  // layoutbox/pairs@1

}  // namespace layoutbox::vlm
