#include "model/io/fingerprint.hpp"

#include "base/hash.hpp"
#include "field/field.hpp"

namespace trilith {
namespace {

void add(Hash& hash, double v) {
  hash.add(v);
}
void add(Hash& hash, int v) {
  hash.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(v)));
}
void add(Hash& hash, bool v) {
  hash.add(std::uint64_t{v});
}
void add(Hash& hash, std::uint8_t v) {
  hash.add(std::uint64_t{v});
}
void add(Hash& hash, Support v) {
  hash.add(static_cast<std::uint64_t>(v));
}
void add(Hash& hash, const std::string& v) {
  hash.add(std::string_view(v));
}
void add(Hash& hash, const Vec2& v) {
  hash.add(v.x()), hash.add(v.y());
}
void add(Hash& hash, const Vec3& v) {
  hash.add(v.x()), hash.add(v.y()), hash.add(v.z());
}
void add(Hash& hash, const UnitQuaternion& v) {
  hash.add(v.w), hash.add(v.x), hash.add(v.y), hash.add(v.z);
}

// Declared before the arrays that contain them.
void add(Hash& hash, const ContactLaw& law);
void add(Hash& hash, const DirectionLaw& law);
void add(Hash& hash, const Body& b);
template <int D>
void add(Hash& hash, const Bearing<D>& b);
void add(Hash& hash, const ConvexSolid& s);
template <int D>
void add(Hash& hash, const Seat<D>& s);
void add(Hash& hash, const Solid& s);
void add(Hash& hash, const Element& e);
void add(Hash& hash, const Beam& b);
void add(Hash& hash, const Member& m);
void add(Hash& hash, const FibreSection& s);
void add(Hash& hash, const FibreBeamRow& r);
void add(Hash& hash, const FibreSection3& s);
void add(Hash& hash, const FibreBeamRow3& r);
void add(Hash& hash, const HingeLaw& l);
void add(Hash& hash, const Drive& d);
template <class T>
requires requires {
  T::members();
}
void add(Hash& hash, const T& row);
template <int D>
void add(Hash& hash, const PushRow<D>& r);
template <int D>
void add(Hash& hash, const Push<D>& p);

/// The length counts too, so that elements cannot move from one array to the next.
template <class T, std::size_t N>
void add(Hash& hash, const std::array<T, N>& values) {
  for (const T& v : values) add(hash, v);
}
template <class T>
void add(Hash& hash, const std::vector<T>& values) {
  hash.add(static_cast<std::uint64_t>(values.size()));
  for (const T& v : values) add(hash, v);
}

template <Declared T>
void add_law(Hash& hash, const T& law) {
  hash.add(T::name);
  [[maybe_unused]] std::size_t place = 0;
  for (const Parameter<T>& p : T::parameters()) {
    if constexpr (requires { T::always_in_fingerprint; })
      if (place++ >= T::always_in_fingerprint && law.*(p.member) == p.preset) continue;
    hash.add(law.*(p.member));
  }
}

void add(Hash& hash, const ContactLaw& law) {
  std::visit([&](const auto& l) { add_law(hash, l); }, law);
}

void add(Hash& hash, const DirectionLaw& law) {
  std::visit(
      [&](const auto& l) {
        using L = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<L, std::monostate>) {
          hash.add(std::string_view("free"));
        } else {
          add_law(hash, l);
          if constexpr (TabulatedLaw<L>) add(hash, l.displacement), add(hash, l.force);
        }
      },
      law);
}

void add(Hash& hash, const Body& b) {
  add(hash, b.name), hash.add(name_of(b.kind)), add(hash, b.material), add(hash, b.groups);
  for (const int v : {b.first_node, b.nodes, b.first_skin, b.skins, b.outline, b.first_piece, b.pieces, b.surface})
    add(hash, v);
}

template <int D>
void add(Hash& hash, const Attachment<D>& t) {
  add(hash, t.nodes), hash.add(static_cast<std::uint64_t>(t.turns));
  add(hash, t.node), add(hash, t.turn), add(hash, t.weight), add(hash, t.arm);
}

void add(Hash& hash, const ConvexSolid& s) {
  add(hash, s.shape.corners), add(hash, s.shape.faces.corner), add(hash, s.shape.faces.start), add(hash, s.surface);
  if (s.is_sphere()) add(hash, s.radius);
}

template <int D>
void add(Hash& hash, const Bearing<D>& b) {
  add(hash, b.name);
  for (const int v : {b.body_a, b.body_b, b.piece_a, b.piece_b, b.contact_after, b.becomes_bearing}) add(hash, v);
  add(hash, b.end_a), add(hash, b.end_b), add(hash, b.rest);
  add(hash, b.angle), add(hash, b.rest_angle);
  add(hash, b.law), add(hash, b.limit);
  add(hash, b.replaces_contact), add(hash, b.starts_waiting);
  if (b.next_counts_from_here()) add(hash, b.next_from_here);
  if constexpr (D == 3) add(hash, b.horizontal), add(hash, b.horizontal_limit);
}

template <int D>
void add(Hash& hash, const Seat<D>& s) {
  add(hash, s.name), add(hash, s.body), add(hash, s.support);
  add(hash, s.end), add(hash, s.edge), add(hash, s.inward);
}

void add(Hash& hash, const Solid& s) {
  std::visit([&](const auto& l) { add_law(hash, l); }, s.law);
  hash.add(static_cast<std::uint64_t>(s.plane)), hash.add(static_cast<std::uint64_t>(s.form));
  add(hash, s.strain_limit);
}

void add(Hash& hash, const Element& e) {
  add(hash, e.node);
  for (const int v : {e.body, e.nodes, e.solid, e.first_number, e.first_point}) add(hash, v);
  add(hash, e.thickness);
}

void add(Hash& hash, const Beam& b) {
  add(hash, b.body), add(hash, b.node), add(hash, b.arm);
  add(hash, b.length), add(hash, b.angle), add(hash, b.damping);
  add(hash, b.stiffness.axial), add(hash, b.stiffness.bend), add(hash, b.stiffness.bow);
  hash.add(static_cast<std::uint64_t>(b.yield)), add(hash, b.yield_row), add(hash, b.first_memory);
  if (b.band >= 0) add(hash, b.band), add(hash, b.first_branch);
  if (b.inertia >= 0) hash.add(std::string_view("consistent"));
}

void add(Hash& hash, const FibrePart& p) {
  std::visit([&](const auto& l) { add_law(hash, l); }, p.law);
  add(hash, p.first), add(hash, p.count);
}

void add(Hash& hash, const FibreSection& s) {
  for (const Fibre& f : s.fibres) add(hash, f.area), add(hash, f.height);
  for (const FibrePart& p : s.parts) add(hash, p);
}

void add(Hash& hash, const FibreSection3& s) {
  for (const Fibre3& f : s.fibres) add(hash, f.area), add(hash, f.up), add(hash, f.across);
  for (const FibrePart& p : s.parts) add(hash, p);
}

void add(Hash& hash, const FibreBeam& b) {
  add(hash, b.length), add(hash, b.bow), add(hash, b.shear), add(hash, b.slant), add(hash, b.stations);
  for (const FibreStation& s : b.station) add(hash, s.weight), add(hash, s.curvature);
}

void add(Hash& hash, const FibreBeamRow& r) {
  add(hash, r.section), add(hash, r.beam);
}

void add(Hash& hash, const FibreBeamRow3& r) {
  add(hash, r.section), add(hash, r.beam.torsion);
  for (const FibreBeam& plane : r.beam.plane) add(hash, plane);
}

void add(Hash& hash, const HingeLaw& l) {
  add_law(hash, l), add(hash, l.force), add(hash, l.share);
  if (l.removes) hash.add(std::string_view("removes"));
}

void add(Hash& hash, const BeamYields& y) {
  add(hash, y.sections), add(hash, y.fibre_beams), add(hash, y.hinge_laws), add(hash, y.hinged_beams);
}

void add(Hash& hash, const Member& m) {
  add(hash, m.name), add(hash, m.body), add(hash, m.first_beam), add(hash, m.beams);
  for (const std::string& joint : m.joint) add(hash, joint);
}

void add(Hash& hash, const Beam3& b) {
  add(hash, b.body), add(hash, b.node), add(hash, b.axes), add(hash, b.length), add(hash, b.damping);
  add(hash, b.stiffness.axial), add(hash, b.stiffness.torsion);
  for (const BeamStiffness& k : b.stiffness.bend) add(hash, k.bend), add(hash, k.bow);
  if (b.yield != BeamYield::never) add(hash, b.yield_row), add(hash, b.first_memory);
  if (b.yield == BeamYield::at_hinges) hash.add(std::string_view("hinges"));
  if (b.band >= 0) add(hash, b.band), add(hash, b.first_branch);
  if (b.inertia >= 0) hash.add(std::string_view("consistent"));
  for (const Vec3& arm : b.arm)
    if (arm != Vec3(0, 0, 0)) hash.add(std::string_view("arm")), add(hash, arm);
}

void add(Hash& hash, const GroundMotion& m) {
  add(hash, m.step()), add(hash, m.start_time());
  add(hash, m.start().velocity), add(hash, m.start().displacement);
  hash.add(static_cast<std::uint64_t>(m.samples().size()));
  for (const MotionAt& sample : m.samples()) hash.add(sample.acceleration);
}

void add(Hash& hash, const Drive& d) {
  add(hash, d.node), add(hash, d.dof), add(hash, d.origin), add(hash, d.start);
  add(hash, *d.motion);
}

void add(Hash& hash, const LoadCurve& c) {
  add(hash, c.time), add(hash, c.share), add(hash, c.smooth);
}

template <class T>
requires requires {
  T::members();
}
void add(Hash& hash, const T& row) {
  std::apply([&](const auto... member) { (add(hash, row.*member), ...); }, T::members());
}

template <int D>
void add(Hash& hash, const PushRow<D>& r) {
  add(hash, r.node), add(hash, r.turn), add(hash, r.place), add(hash, r.weight);
}

template <int D>
void add(Hash& hash, const Push<D>& p) {
  add(hash, p.name), add(hash, p.rows), add(hash, p.direction), add(hash, p.origin), add(hash, p.start);
  add(hash, *p.motion);
}

template <int D>
std::uint64_t structure_of(const Model<D>& m) {
  Hash hash;
  add(hash, m.thickness);
  add(hash, m.mass), add(hash, m.inertia);
  add(hash, m.start_position), add(hash, m.start_rotation), add(hash, m.start_velocity), add(hash, m.start_spin);
  add(hash, m.bodies), add(hash, m.skin_place), add(hash, m.skin_node), add(hash, m.skin_turn);
  add(hash, m.piece_body), add(hash, m.piece_first), add(hash, m.corner_skin), add(hash, m.edge_is_face);
  add(hash, m.edge_corner);
  add(hash, m.solids), add(hash, m.elements), add(hash, m.element_number), add(hash, m.beams), add(hash, m.members);
  if (m.beam_memory > 0) add(hash, m.yields);
  for (const DampingBranches& b : m.bands) add_law(hash, b.band);
  std::vector<int> law_of = m.law_of;
  for (int& law : law_of) law = std::max(law, -1);  // a missing statement does not change the model
  add(hash, m.laws), add(hash, m.law_names), add(hash, m.surfaces), add(hash, law_of);
  add(hash, m.bearings), add(hash, m.seats);
  if constexpr (D == 3) add(hash, m.piece_solid);
  for (const Beam3& beam : m.beams_3d) add(hash, beam);
  if (!m.yields_3d.fibre_beams.empty()) add(hash, m.yields_3d.sections), add(hash, m.yields_3d.fibre_beams);
  if (!m.yields_3d.hinged_beams.empty()) add(hash, m.yields_3d.hinge_laws), add(hash, m.yields_3d.hinged_beams);
  return hash.value();
}

/// The plain kinds and the displacement controls, then the other kinds of which there are any.
template <int D>
void add_loads(Hash& hash, const Model<D>& m) {
  std::size_t place = 0;
  m.loads.for_each_kind([&](const auto& loads) {
    if (place++ < plain_load_kinds) add(hash, loads);
  });
  add(hash, m.pushes);
  place = 0;
  m.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if (place++ < plain_load_kinds || loads.empty()) return;
    hash.add(L::kind);
    add(hash, loads);
  });
}

template <int D>
std::uint64_t conditions_of(const Model<D>& m) {
  Hash hash;
  add(hash, m.gravity.field);
  add(hash, m.bounds.low), add(hash, m.bounds.high);
  add(hash, m.gravity.tilt_rate);
  for (const double v : {m.gravity.tilt_start, m.gravity.tilt_end, m.gravity.grow_start, m.gravity.grow_end,
                         m.mass_damping, m.impact_speed, m.apart_time, m.still_speed, m.still_time})
    add(hash, v);
  add(hash, m.support), add(hash, m.load), add(hash, m.drives), add(hash, m.drive_of);
  if (m.loaded()) add_loads(hash, m);
  for (const auto& field : m.fields) hash.add(field->digest());
  return hash.value();
}

}  // namespace

template <int D>
Fingerprint model_fingerprint(const Model<D>& model) {
  return {structure_of(model), conditions_of(model)};
}

template <int D>
Fingerprint model_fingerprint(Model<D> model, const State<D>& state) {
  for (std::size_t b = 0; b < state.left.size(); ++b) {
    if (state.left[b] == 0) continue;
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
      model.support[n].fill(Support::fixed), model.drive_of[n].fill(-1);
  }
  return model_fingerprint(model);
}

template Fingerprint model_fingerprint(const Model<2>&);
template Fingerprint model_fingerprint(const Model<3>&);
template Fingerprint model_fingerprint(Model<2>, const State<2>&);
template Fingerprint model_fingerprint(Model<3>, const State<3>&);

}  // namespace trilith
