#include "layoutbox/plan/relations/amounts.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/relations/mention_links.h"
#include "layoutbox/plan/relations/seat_builder.h"

namespace layoutbox::offline {
namespace {

constexpr int kUnsaid = 2;  // what a plural was read as
constexpr int kSeveral = 3, kLots = 6;
constexpr int kVagueLots = 4;        // "lots of", "many", as the word lists have them
constexpr Mm kSmall = 300;           // across
constexpr std::int64_t kLevels = 4;  // of a shelf
constexpr std::int64_t kRoomy = 3;   // so much of a carrier's top is free of them

class Amounts {
 public:
  Amounts(const Lexicon& lexicon, Document& document)
      : lexicon_(lexicon), document_(document), builder_(lexicon, document), links_(document) {}

  void run() {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) settle(static_cast<int>(m));
  }

 private:
  // Small things, of which three look like some.
  static bool is_small(const CatalogEntry& entry) {
    const Size& size = entry.size.usual;
    if (entry.is(Trait::kLamp) || entry.is(Trait::kScreen) || entry.is(Trait::kInTwos)) return false;
    return entry.mount == Mount::kSurface && std::max(size.width, size.depth) <= kSmall;
  }

  // The one thing that carries them; null: none, or several share them out.
  const NounPhrase* carrier_of(int m) const {
    const NounPhrase* carrier = nullptr;
    for (const int host : links_.hosts_of(m)) {
      const Mention& mention = document_.mentions[static_cast<std::size_t>(host)];
      if (mention.noun.kind != NounKind::kObject || mention.items.size() != 1 || mention.distributes) return nullptr;
      const bool great = mention.noun.entry != nullptr && mention.noun.entry->mount != Mount::kSurface;
      if (great && carrier == nullptr) carrier = &mention.noun;
    }
    return carrier;
  }

  static bool takes(const NounPhrase& carrier, const CatalogEntry& thing, int count) {
    const Size &top = carrier.entry->size.usual, &one = thing.size.usual;
    const auto area = [](const Size& size) { return std::int64_t{size.width} * size.depth; };
    const std::int64_t levels = carrier.entry->is(Trait::kShelving) ? kLevels : 1;
    return levels * area(top) >= kRoomy * count * area(one);
  }

  void settle(int m) {
    const Mention& mention = builder_.mention(m);
    const NounPhrase& noun = mention.noun;
    const bool unsaid = noun.count == 0 && noun.plural && static_cast<int>(mention.items.size()) == kUnsaid;
    const bool lots = noun.vague && noun.count == kVagueLots && static_cast<int>(mention.items.size()) == kVagueLots;
    const bool some = noun.vague && lexicon_.is(document_.tokens[noun.first], WordClass::kVague) && noun.count == kUnsaid && noun.plural &&
                      static_cast<int>(mention.items.size()) == kUnsaid;
    if (!mention.introduces || noun.kind != NounKind::kObject || noun.entry == nullptr || !(unsaid || lots || some)) return;
    if (!is_small(*noun.entry)) return;
    const int wanted = lots ? kLots : kSeveral;
    const NounPhrase* const carrier = carrier_of(m);
    if (carrier != nullptr && takes(*carrier, *noun.entry, wanted)) builder_.grow(m, wanted);
  }

  const Lexicon& lexicon_;
  Document& document_;
  SeatBuilder builder_;
  MentionLinks links_;
};

}  // namespace

void settle_amounts(const Lexicon& lexicon, Document& document) { Amounts(lexicon, document).run(); }

}  // namespace layoutbox::offline
