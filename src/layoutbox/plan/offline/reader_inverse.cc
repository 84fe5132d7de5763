// Phrases that name the reference first: "flanked by …", "on which …".
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

// Those of a list that no relation of their own places; `last` is always of them.
std::vector<int> DocumentReader::unplaced(const std::vector<int>& all, int last, int host) const {
  std::vector<int> free;
  for (const int mention : all) {
    const bool placed = std::any_of(document_.links.begin() + static_cast<std::ptrdiff_t>(sentence_links_), document_.links.end(),
                                    [&](const Link& l) { return l.kind == Link::Kind::kRelation && contains(l.targets, mention); });
    const bool fits = host < 0 || (!is_seat(lexicon_.catalog(), noun_of(mention)) && !is_table(lexicon_.catalog(), noun_of(mention)));
    if (mention == last || (!placed && fits)) free.push_back(mention);
  }
  return free;
}

// "a desk, on which a computer sits": a clause of its own whose place comes first.
bool DocumentReader::read_relative_place(std::size_t k) {
  const std::size_t n = next(k);
  if (!is(n, ChunkKind::kNoun) || chain_.empty()) return false;
  const std::string& word = document_.tokens[chunk(n).last - 1].text;
  if ((chunk(n).noun.kind != NounKind::kPronoun && !chunk(n).noun.subset) || (word != "which" && word != "whom")) return false;
  int host = -1;
  for (std::size_t c = chain_.size(); c-- > 0 && host < 0;) {
    if (is_thing(chain_[c])) host = chain_[c];
  }
  const PhraseSenses direct = with_direction(*chunk(k).phrase.senses, Direction::kDirect);
  if (host < 0 || direct.empty()) return false;
  const int outer = roots_.size() > clause_start_ ? roots_.back() : -1;
  begin_clause();
  outer_root_ = outer;
  if (chunk(n).noun.determiner == Determiner::kEach) {  // "above each of which"
    Mention each = mention_at(host);
    each.introduces = false;
    each.distributes = true;
    document_.mentions.push_back(std::move(each));
    host = static_cast<int>(document_.mentions.size()) - 1;
  }
  Link link;
  link.senses = direct;
  link.references = {host};
  link.each = chunk(k).phrase.each;
  link.first = chunk(k).first;
  link.last = chunk(n).last;
  fronted_.push_back(add_link(std::move(link)));
  mark(n, WordReading::Use::kUsed, "reference");
  passed_over_ = n;
  return true;
}

void DocumentReader::read_inverse(std::size_t k, PhraseSenses senses) {
  Link link;
  link.senses = std::move(senses);
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  link.each = chunk(k).phrase.each;
  const bool at_start = roots_.size() == clause_start_ && chain_.empty();
  std::vector<int> hosts;
  if (!at_start) {
    int host = chain_.empty() ? -1 : chain_.back();
    const bool apart = joiner_ != Joiner::kNone || is(previous(k), ChunkKind::kVerb);
    if (apart && !chain_.empty()) host = chain_.front();
    // "a chandelier over a table, flanked by two sofas": sofas stand by the table.
    if (const std::size_t n = next(k); apart && is(n, ChunkKind::kNoun) && chunk(n).noun.kind == NounKind::kObject) {
      for (const int mention : chain_) {
        if (!is_thing(mention) || !may_refer(lexicon_.catalog(), link.senses, chunk(n).noun, noun_of(mention))) continue;
        host = mention;
        break;
      }
    }
    if (is_finite(document_.tokens[chunk(k).first].text) && roots_.size() > clause_start_) host = roots_.back();
    if (host >= 0 && !is_thing(host)) {
      for (const int mention : chain_) {
        if (is_thing(mention)) host = mention;
      }
    }
    if (relative_host_ >= 0) host = relative_host_;
    if (host >= 0) hosts = {host};
    if (host >= 0 && contains(subject_, host)) hosts = subject_;
    relative_host_ = -1;
  }
  for (const int host : hosts) {
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      if (roots_[r] == host) root_modified_[r] = true;
    }
  }
  link.references = hosts;
  const int index = add_link(std::move(link));
  if (at_start) fronted_.push_back(index);
  frames_.push_back({index, hosts, false, false});
  expects_content_ = true;
  joiner_ = Joiner::kNone;
}

// "a desk with a chair at the back": behind the desk, not at the back of the room.
bool DocumentReader::lies_at_end_of_host(Link& link) {
  if (!says(link.senses, RelationType::kInRegion) || chain_.empty() || joiner_ != Joiner::kNone || frames_.empty() || frames_.back().room ||
      frames_.back().hosts.size() != 1 || !is_content(chain_.back()) || !is_thing(chain_.back()))
    return false;
  const auto region = std::find_if(link.senses.begin(), link.senses.end(), [](const PhraseSense& s) { return !s.region.empty(); });
  const int host = frames_.back().hosts.front();
  if (region == link.senses.end() || !is_thing(host) || mount_of(noun_of(chain_.back())) != Mount::kFloor) return false;
  if (region->region != "back" && region->region != "front") return false;
  link.senses = {{region->region == "back" ? RelationType::kBehind : RelationType::kInFrontOf, Direction::kDirect, {}, {}, {}}};
  link.targets = {chain_.back()};
  link.references = {host};
  add_link(std::move(link));
  return true;
}

}  // namespace layoutbox::offline
