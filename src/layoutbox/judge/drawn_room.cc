#include "layoutbox/judge/drawn_room.h"

#include <cmath>
#include <utility>

#include "layoutbox/base/units.h"

namespace layoutbox {

std::vector<DrawnObject> drawn_objects(const Model& model) {
  std::vector<DrawnObject> drawn;
  for (const Node& node : model.nodes) {
    if (node.kind != NodeKind::kObject) continue;
    const double turn = radians_from_degrees(double{node.rotation_deg}), cs = std::cos(turn), sn = std::sin(turn);
    const auto in_room = [&](const Vec3f& p) {
      const double x = double{p[0]}, y = double{p[1]};
      return Point3{double{node.position[0]} + x * cs - y * sn, double{node.position[1]} + x * sn + y * cs,
                    double{node.position[2]} + double{p[2]}};
    };
    DrawnObject object{node.id, {}};
    for (const Part& part : node.parts) {
      const Mesh& mesh = part.mesh;
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        object.triangles.push_back({in_room(mesh.positions[mesh.indices[i]]), in_room(mesh.positions[mesh.indices[i + 1]]),
                                    in_room(mesh.positions[mesh.indices[i + 2]])});
      }
    }
    drawn.push_back(std::move(object));
  }
  return drawn;
}

Report verify_with_furniture(const Layout& layout, const Model& model, const Catalog& catalog, const VerifyOptions& options) {
  Report report = verify(layout, catalog, options);
  verify_drawn(layout, catalog, drawn_objects(model), options, report);
  return report;
}

}  // namespace layoutbox
