// What an edit works on, and one step of it: a pure function of the scene, the guide and the step. No step solves anything.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "layoutbox/edit/edit.h"

namespace layoutbox {

// A thing that is put exactly somewhere.
struct EditPin {
  std::string id;
  std::array<double, 3> from{}, way{};
  double rotation = 0;
  bool loose = false;     // a shorter way will do
  bool may_move = false;  // turned on the spot, or else beside it
};

struct EditState {
  SceneGraph scene;
  Layout guide;  // where things are, or are to be as nearly as can be
  std::vector<EditPin> pins;
  std::vector<std::string> freed;   // ids that need not stay near their place in the guide
  std::vector<std::string> locked;  // … that stay exactly there
  std::set<std::string> softened;   // ids of relations that were asked for earlier and are wishes now
  std::vector<Relation> dropped;    // … that the edit takes back
};

// What is there before the first step: what was given up earlier is a wish.
EditState begin_edit(const Layout& before);

// The state after `step`. `before`: the layout that the edit began with. Errors: kGeometry, kReference, as edit_layout() says.
Result<EditState> apply_edit_step(EditState state, const EditStep& step, const Layout& before, const Catalog& catalog);

// The state after the last step: what stood on things that went is gone too, with the relations of all that is gone; new relations have
// ids that no other has.
Result<EditState> finish_edit(EditState state, const Layout& before, const Catalog& catalog);

}  // namespace layoutbox
