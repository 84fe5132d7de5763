#include "layoutbox/plan/offline/text_passes.h"

#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/passes/absent.h"
#include "layoutbox/plan/passes/agents.h"
#include "layoutbox/plan/passes/alternatives.h"
#include "layoutbox/plan/passes/bans.h"
#include "layoutbox/plan/passes/bare_corners.h"
#include "layoutbox/plan/passes/bare_starts.h"
#include "layoutbox/plan/passes/built_ins.h"
#include "layoutbox/plan/passes/clusters.h"
#include "layoutbox/plan/passes/corrections.h"
#include "layoutbox/plan/passes/courtesy.h"
#include "layoutbox/plan/passes/each_after.h"
#include "layoutbox/plan/passes/examples.h"
#include "layoutbox/plan/passes/for_each.h"
#include "layoutbox/plan/passes/forward_counts.h"
#include "layoutbox/plan/passes/halves.h"
#include "layoutbox/plan/passes/inserts.h"
#include "layoutbox/plan/passes/inventory.h"
#include "layoutbox/plan/passes/labels.h"
#include "layoutbox/plan/passes/likewise.h"
#include "layoutbox/plan/passes/modals.h"
#include "layoutbox/plan/passes/owners.h"
#include "layoutbox/plan/passes/purposes.h"
#include "layoutbox/plan/passes/relatives.h"
#include "layoutbox/plan/passes/requests.h"
#include "layoutbox/plan/passes/runs.h"
#include "layoutbox/plan/passes/said_counts.h"
#include "layoutbox/plan/passes/second_roles.h"
#include "layoutbox/plan/passes/shelf_subjects.h"
#include "layoutbox/plan/passes/side_shares.h"
#include "layoutbox/plan/passes/side_subjects.h"
#include "layoutbox/plan/passes/terse_lists.h"
#include "layoutbox/plan/passes/their_own.h"
#include "layoutbox/plan/passes/uses.h"
#include "layoutbox/plan/passes/wall_lists.h"
#include "layoutbox/plan/passes/wants.h"
#include "layoutbox/plan/passes/wordings.h"
#include "layoutbox/plan/passes/written_links.h"
#include "layoutbox/plan/room/coordinates.h"
#include "layoutbox/plan/room/looks_behind.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/room/slopes.h"

namespace layoutbox::offline {
namespace {

// A pass that needs no lexicon.
template <void (*run)(Document&)>
constexpr auto kWithout = [](const Lexicon&, Document& document) { run(document); };

constexpr WordPass kWordPasses[] = {
    {"looks behind", put_looks_before, "A bedroom with a bed. Window full height on the left wall.",
     "A bedroom with a bed. Full height window on the left wall."},
    {"second roles", read_second_roles, "A flat with a bed that is also the sofa.", "A flat with a sofa bed."},
    {"coordinates", read_coordinates, "A hall with a lamp, its middle at x = 2 m and y = 1 m.", "A hall with a lamp at (2, 1)."},
    {"owners", read_owners, "Her bed is on the left wall, his is on the right wall.",
     "Her bed is on the left wall, his bed is on the right wall."},
    {"runs", part_runs, "A bedroom with a bed desk wardrobe.", "A bedroom with a bed, a desk and a wardrobe."},
    {"examples", read_examples, "On the table are three objects: a bowl, a cup and a vase.", "On the table are a bowl, a cup and a vase."},
    {"likewise", read_likewise, "A workshop. A lathe stands against the wall, and so does a drill press.",
     "A workshop. A lathe stands against the wall, and a drill press stands against the wall."},
    {"agents", read_agents, "A bedroom. The bed is flanked by a table and by a chest.",
     "A bedroom. The bed is flanked by a table and flanked by a chest."},
    {"wall lists", complete_wall_lists, "Bookcases on the left and right walls.", "Bookcases on the left wall and the right wall."},
    {"halves", read_halves, "A room with a bed and a desk. The left half is for the desk.",
     "A room with a bed and a desk. The desk is in the left half."},
    {"bare corners", complete_bare_corners, "A bedroom. Desk back right.", "A bedroom. A desk in the back right corner."},
    {"bare starts", complete_bare_starts, "A shop. Behind counter shelves, above sink mirror.",
     "A shop. Behind the counter some shelves, above the sink a mirror."},
    {"written links", read_written_links, "A study. A desk and a chest stand side by side; the former has a lamp on it.",
     "A study. A desk and a chest stand side by side. The desk has a lamp on it."},
    {"terse lists", read_terse_lists, "A clinic. Table center, a plant, desk should face the door.",
     "A clinic. A table in the center, a plant. The desk faces the door."},
    {"seats said", read_seats_said, "A dining room with a table that seats six.", "A dining room with a table for six."},
    {"labels", read_labels, "A bedroom with a bed for under 200 dollars.", "A bedroom with a bed."},
    {"corrected counts", read_corrected_counts, "A bedroom with one nightstand, make that two.", "A bedroom with two nightstands."},
    {"alternatives", read_alternatives, "A bedroom with a bed and a desk or a table.", "A bedroom with a bed and a desk."},
    {"side shares", read_side_shares, "A table with eight chairs: three on each long side and one at each end.",
     "A table with three chairs on each long side and one at each end."},
    {"said counts", read_said_counts, "An office with desks (qty 4).", "An office with four desks."},
    {"courtesies", read_courtesies, "A bedroom with a bed, and if you could also put in a desk.", "A bedroom with a bed and a desk."},
    {"wants", read_wants, "A study. I need to write at a desk.", "A study. A desk."},
    {"requests", read_requests, "I was hoping to have a bed in the corner.", "A bed in the corner."},
    {"each after", read_each_after, "A hall with four tables with two chairs each, arranged in two rows.",
     "A hall with four tables arranged in two rows, each with two chairs."},
    {"bans", read_bans, "A bedroom with a bed and a desk. Nothing in front of the window.",
     "A bedroom with a bed and a desk. Keep the window free."},
    {"modals", read_modals, "A bathroom. A cart shall carry four towels.", "A bathroom. A cart carries four towels."},
    {"uses", read_uses, "A bed, and somewhere to put my clothes.", "A bed and a wardrobe."},
    {"wordings", read_wordings, "A bedroom with a bed shoved up to the left wall.", "A bedroom with a bed against the left wall."},
    {"slopes", read_slopes, "A bedroom whose ceiling slopes down on the left side, with a bed.",
     "A bedroom with a sloped ceiling on the left and a bed."},
    {"relatives", part_relatives, "The desk, on which a lamp stands, is in the corner.",
     "The desk is in the corner. On the desk is a lamp."},
    {"side subjects", turn_side_subjects, "The long side of the bed is against the left wall.",
     "The bed is with its long side against the left wall."},
    {"shelf subjects", turn_shelf_subjects, "A rack. The rack's middle shelf holds a loaf.",
     "A rack. On the middle shelf of the rack is a loaf."},
};

constexpr PhrasePass kPhrasePasses[] = {
    {"corrected places", kWithout<settle_corrected_places>, "Put the desk in the middle. No wait, put it under the window.",
     "Put the desk under the window."},
    {"opening sizes", kWithout<settle_opening_sizes>, "A bedroom with a bed. The door is 1 m wide.",
     "A bedroom with a bed and a 1 m wide door."},
    {"door swings", kWithout<settle_door_swings>, "A bathroom with a toilet. The door swings outwards.",
     "A bathroom with a toilet. The door opens outwards."},
    {"shared openings", share_out_openings, "A hall with a bench and two doors, one on the left wall and one on the back wall.",
     "A hall with a bench, a door on the left wall and a door on the back wall."},
    {"opening walls", settle_opening_walls, "A bedroom with a bed. The entrance is on the left.",
     "A bedroom with a bed and a door on the left wall."},
    {"opening ends", settle_opening_ends, "A 6 x 3 m bedroom with a bed and the entrance on the narrow side.",
     "A 6 x 3 m bedroom with a bed and a door in the short wall."},
    {"whose coordinates", settle_coordinates, "A bedroom with a bed. At (2, 1) stands a lamp.",
     "A bedroom with a bed and a lamp at (2, 1)."},
    {"finishes", settle_finishes, "A bedroom with a bed and exposed brick on the back wall.",
     "A bedroom with a bed and a back wall of exposed brick."},
    {"absent", settle_absent, "A bedroom with a bed. The old desk has been taken away.", "A bedroom with a bed."},
    {"clusters", settle_clusters, "An office with six desks in groups of two.", "An office with six desks in pairs."},
    {"inserts", kWithout<settle_inserts>, "Behind the chair, humming, is a cabinet.", "Behind the chair is a cabinet."},
    {"bunks", settle_bunks, "A dormitory with 8 beds as bunks.", "A dormitory with four bunk beds."},
    {"for each", settle_for_each, "A room for two girls: a bed and a desk for each.", "A room with two single beds and two desks."},
    {"their own", settle_their_own, "An office for four programmers. Their desks are against the walls.",
     "An office with four desks. The desks are against the walls."},
    {"purposes", settle_purposes, "A bedroom for a teenager with a bed and a desk.", "A bedroom with a bed and a desk."},
    {"room senses", settle_room_senses, "A gym with a treadmill and mats.", "A gym with a treadmill and exercise mats."},
    {"word senses", settle_word_senses, "A bedroom with a bed on bare boards.", "A bedroom with a bed and a wooden floor."},
    {"toys", settle_toys, "A living room with a rug. A truck is on the rug.", "A living room with a rug. A toy car is on the rug."},
    {"company", settle_company, "An office with a desk with a PC and two monitors on it.",
     "An office with a desk with a computer tower and two monitors on it."},
    {"worktops", kWithout<settle_worktops>, "A kitchen with a sink, white base cabinets, oak worktop.",
     "A kitchen with a sink and white base cabinets."},
    {"glosses", kWithout<settle_glosses>, "A dining room with a trinchador (sideboard).", "A dining room with a sideboard."},
    {"namesakes", kWithout<settle_namesakes>, "A living room with a sofa and a fireplace with a marble mantel.",
     "A living room with a sofa and a fireplace."},
    {"inventory", kWithout<settle_inventory>, "Items: desk, lamp. Layout: lamp on desk.", "A desk with a lamp on it."},
    {"floor carpets", kWithout<settle_floor_carpets>, "A bedroom with a bed. Gray carpet, white walls.",
     "A bedroom with a bed. Gray carpet floor, white walls."},
    {"part looks", kWithout<settle_part_looks>, "A bedroom with a chair with a red seat.", "A bedroom with a red chair."},
    {"grid counts", kWithout<settle_grid_counts>, "A classroom with desks in four rows of three.",
     "A classroom with 12 desks in four rows of three."},
    {"forward counts", kWithout<settle_forward_counts>, "Each desk has a lamp. There are two desks.",
     "There are two desks. Each desk has a lamp."},
    {"counts of each", settle_counts_of_each, "A kitchen with knives, forks and spoons on the table, two of each.",
     "A kitchen with two knives, two forks and two spoons on the table."},
    {"forward wholes", settle_forward_wholes, "Both sofas have cushions. There are two sofas.",
     "There are two sofas. Both sofas have cushions."},
    {"named again", kWithout<settle_named_again>, "A shop with a counter with a brass balance and a jar next to the balance.",
     "A shop with a counter with a brass balance and a jar next to it."},
    {"forward names", kWithout<settle_forward_names>, "A bedroom. Leave space round the bed. A single bed is in the corner.",
     "A bedroom. A single bed is in the corner. Leave space round the bed."},
    {"filling counts", settle_filling_counts, "A table littered with bottles.", "A table with eight bottles on it."},
};

}  // namespace

std::span<const WordPass> word_passes() { return kWordPasses; }
std::span<const PhrasePass> phrase_passes() { return kPhrasePasses; }

}  // namespace layoutbox::offline
