// Having and verbs: whose things they are, and who is the subject.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

void DocumentReader::read_have(std::size_t k) {
  if (skipping_ && is_finite(document_.tokens[chunk(k).first].text) && is(previous(k), ChunkKind::kNoun)) skipping_ = false;
  // "the lobby welcomes guests with a desk"
  if (skipping_ && document_.tokens[chunk(k).first].text == "with" && !roots_.empty() && noun_of(roots_.back()).kind == NounKind::kRoom &&
      is(previous(k), ChunkKind::kNoun) && new_thing_at(next(k)) && chunk(next(k)).noun.entry != nullptr)
    skipping_ = false;
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  skipping_ = false;
  mark(k, WordReading::Use::kUsed, "has");
  const std::string& word = document_.tokens[chunk(k).first].text;
  Link link;
  link.kind = Link::Kind::kHave;
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  const bool plain = word == "with" || word == "featuring" || word == "features" || word == "feature" || word == "including" ||
                     word == "includes" || word == "include" || word == "has" || word == "have" || word == "having";
  link.holding = !plain;
  link.weak = plain;
  const bool after_comma = joiner_ == Joiner::kComma || joiner_ == Joiner::kCommaAnd;
  joiner_ = Joiner::kNone;
  // "Flank the bed with two nightstands": the verb says how.
  if (word == "with" && arranging_link_ >= 0 && link_at(arranging_link_).references.size() == 1) {
    const std::vector<int> hosts = link_at(arranging_link_).references;
    frames_.push_back({arranging_link_, hosts, false, false});
    chain_ = hosts;
    arranging_link_ = -1;
    expects_content_ = true;
    return;
  }
  // The host: what stands right before; after a comma or a verb the clause's own thing.
  int host = chain_.empty() ? -1 : chain_.back();
  for (std::size_t c = chain_.size(); c-- > 0 && host >= 0 && !is_thing(host) && noun_of(host).kind == NounKind::kPart;) host = chain_[c];
  if (host >= 0 && is_thing(host) && !mention_at(host).introduces && is_thing(chain_.front()) && noun_of(host).kind == NounKind::kObject)
    host = chain_.front();
  if ((after_comma || is(previous(k), ChunkKind::kVerb)) && !chain_.empty()) host = chain_.front();
  if (is_finite(word) && roots_.size() > clause_start_) host = roots_.back();
  if (is_finite(word) && host >= 0 &&
      (noun_of(host).kind == NounKind::kWall || noun_of(host).kind == NounKind::kFloor || noun_of(host).kind == NounKind::kWindow)) {
    // "An office with white walls has a desk": the office has.
    for (const int root : roots_) {
      if (noun_of(root).kind == NounKind::kRoom) host = root;
    }
  }
  if (relative_host_ >= 0) host = relative_host_;
  relative_host_ = -1;
  if (host < 0 && !roots_.empty() && roots_.size() > clause_start_) host = roots_.back();
  link.after_comma = after_comma;
  const auto kind = host >= 0 ? noun_of(host).kind : NounKind::kRoom;
  if (host >= 0 && is_thing(host) && kind != NounKind::kAbstract) {
    link.references = joined_with(host, !plain);
    const std::vector<int> hosts = link.references;
    const int index = add_link(std::move(link));
    frames_.push_back({index, hosts, false, after_comma});
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      if (contains(hosts, roots_[r])) root_modified_[r] = true;
    }
  } else if (kind == NounKind::kWall || kind == NounKind::kCorner || kind == NounKind::kCenter || kind == NounKind::kCeiling ||
             kind == NounKind::kFloor) {
    link.kind = Link::Kind::kRelation;
    link.weak = false;
    link.senses = {{RelationType::kOn, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnCeiling, Direction::kDirect, {}, {}, {}}};
    link.references = {host};
    const int index = add_link(std::move(link));
    frames_.push_back({index, {host}, false, false});
  } else if (kind == NounKind::kAbstract && !frames_.empty() && !frames_.back().room && frames_.back().link >= 0) {
    // "a desk with a setup of …": what the setup has, the desk has.
  } else {
    // A room, an area, a window: what it has is a list of things.
    frames_.push_back({-1, {}, true, false});
    if (kind == NounKind::kRoom || kind == NounKind::kOutsideRoom || kind == NounKind::kAbstract) in_room_list_ = true;
    clause_start_ = roots_.size();
    chain_.clear();
    subject_.clear();
    imperative_ = false;
  }
  expects_content_ = true;
}

void DocumentReader::read_verb(std::size_t k) {
  // "two chairs for the owners stand …"
  const bool plural_stands = !roots_.empty() && is_thing(roots_.back()) && noun_of(roots_.back()).is_plural() && !chunk(k).passive &&
                             chunk(k).kind == ChunkKind::kVerb && is(next(k), ChunkKind::kRelation) && subject_.empty();
  if (skipping_ && (is_finite(document_.tokens[chunk(k).first].text) || plural_stands) && is(previous(k), ChunkKind::kNoun))
    skipping_ = false;
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  mark(k, WordReading::Use::kUsed, "placing");
  if (relative_host_ >= 0) {
    subject_ = {relative_host_};
    chain_ = {relative_host_};
    after_verb_ = true;
    if (chunk(k).hang) hang(subject_, k);
    relative_host_ = -1;
    joiner_ = Joiner::kNone;
    return;
  }
  if (document_.tokens[chunk(k).last - 1].text.starts_with("center")) centering_ = true;
  if (outer_root_ >= 0 && joiner_ == Joiner::kComma) {
    // "the desk, on which a computer sits, is …": the desk is.
    const int outer = outer_root_;
    outer_root_ = -1;
    begin_clause();
    roots_.push_back(outer);
    root_joiners_.push_back(Joiner::kNone);
    root_modified_.push_back(false);
  }
  const bool has_root = roots_.size() > clause_start_;
  if (!has_root || (joiner_ != Joiner::kNone && !chunk(k).passive && is(next(k), ChunkKind::kNoun))) {
    if (fronted_.empty() || has_root) {
      // A command: "Place the bed …", "…, and hang the lamp …".
      if (has_root) begin_clause();
      imperative_ = !chunk(k).passive;
      subject_.clear();
    }
    hang_ = chunk(k).hang;
    after_verb_ = false;
    joiner_ = Joiner::kNone;
    return;
  }
  // The subject: a plural verb takes all that "and" joined, a singular one the last.
  const std::string& word = document_.tokens[chunk(k).first].text;
  const bool plural_verb = word == "are" || word == "were" || word == "have" || (!word.ends_with("s") && word != "is" && word != "was");
  std::vector<int> subject{roots_.back()};
  if (plural_verb && !noun_of(roots_.back()).is_plural()) {
    for (std::size_t r = roots_.size() - 1; r > clause_start_ && root_joiners_[r] != Joiner::kNone; --r) {
      if (in_room_list_ && root_joiners_[r] != Joiner::kAnd) break;
      subject.insert(subject.begin(), roots_[r - 1]);
    }
  } else if (plural_verb && !in_room_list_) {
    for (std::size_t r = roots_.size() - 1; r > clause_start_ && root_joiners_[r] == Joiner::kAnd && !root_modified_[r - 1]; --r)
      subject.insert(subject.begin(), roots_[r - 1]);
  }
  subject.erase(std::remove_if(subject.begin(), subject.end(), [&](int m) { return subject.size() > 1 && !is_thing(m); }), subject.end());
  if (subject.empty()) subject = {roots_.back()};
  subject_ = subject;
  // "a table where puzzles lie": on the table.
  const std::size_t after = next(k);
  if (where_host_ >= 0 && is_thing(where_host_) && is_thing(subject_.front()) &&
      (is(after, ChunkKind::kStop) || is(after, ChunkKind::kComma))) {
    Link link;
    link.kind = Link::Kind::kHave;
    link.holding = true;
    link.targets = subject_;
    link.references = {where_host_};
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
  }
  chain_ = {subject_.front()};
  after_verb_ = true;
  imperative_ = false;
  frames_.clear();
  if (chunk(k).hang && is_thing(subject_.front())) hang(subject_, k);
  joiner_ = Joiner::kNone;
}

}  // namespace layoutbox::offline
