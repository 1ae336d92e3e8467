#include "view/frames.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/space.hpp"
#include "results/file/field_names.hpp"

namespace trilith::view {
namespace {

struct Quanta {
  double length = 1, angle = 1, force = 1, bearing_force = 1, bearing_displacement = 1, stress = 1, plastic = 1,
         member_force = 1, temperature = 1;
};

/// A row of positions of `dim` numbers; z is 0 in the plane.
Vec3 row_at(const results::Header& header, const std::vector<double>& places, int row) {
  const double* at = places.data() + static_cast<std::size_t>(header.dim) * static_cast<std::size_t>(row);
  return {at[0], at[1], header.dim == 3 ? at[2] : 0};
}

/// `radius`: radius of the sphere about each vertex; empty without spheres.
double reach(const results::Header& header, const results::BodyRow& body, const std::vector<double>& radius) {
  double out = 0;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
    out = std::max(
        out, row_at(header, header.vertices, v).norm() + (radius.empty() ? 0.0 : radius[static_cast<std::size_t>(v)]));
  // Outline points that are nodes have no distance from them, so the size follows from the start.
  const Vec3 first = row_at(header, header.node_position, body.first_node);
  for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
    out = std::max(out, (row_at(header, header.node_position, n) - first).norm());
  return out;
}

/// Fine enough for the smallest free body and, at its far end, for the longest one.
Quanta body_quanta(const results::Header& header) {
  double smallest = 0, largest = 0;
  const std::vector<double> radius = header.vertex_radius();
  for (const results::BodyRow& body : header.bodies) {
    const double size = reach(header, body, radius);
    largest = std::max(largest, size);
    if (body.support.starts_with("free") && size > 0) smallest = smallest > 0 ? std::min(smallest, size) : size;
  }
  if (largest <= 0) largest = 1;
  if (smallest <= 0) smallest = largest;
  const double length = smallest / 2000;
  Quanta out;
  out.length = length;
  out.angle = std::clamp(length / largest, 1e-6, 1e-3);
  if (header.dim == 3) out.angle /= 2;  // a quaternion contains half angles
  return out;
}

double share_of(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Determined by the usual value; the rare large ones cost an additional byte.
double usual_quantum(std::vector<double> sizes, double share, double parts) {
  std::erase_if(sizes, [](double s) { return !(s > 0); });
  const double usual = share_of(sizes, share);
  return usual > 0 ? usual / parts : 1;
}

std::size_t stride_for(double size, double most) {
  return size > most ? static_cast<std::size_t>(std::ceil(size / most)) : 1;
}

class Gatherer {
 public:
  Gatherer(const results::Header& header, const Quanta& quanta) {
    const std::size_t nodes = header.node_count(), bearings = header.bearings.size();
    const auto dim = static_cast<std::size_t>(header.dim);
    time_ = {"time", 1, 1e-6, {}};
    stage_ = {"stage", 1, 1, {}};
    position_ = {"position", dim * nodes, quanta.length, {}};
    rotation_ = {"rotation", static_cast<std::size_t>(results::rotation_width(header.dim)) * nodes, quanta.angle, {}};
    stress_ = {"stress", 3 * header.element_count(), quanta.stress, {}};
    plastic_ = {"plastic", header.element_count(), quanta.plastic, {}};
    state_ = {"bearing_state", bearings, 1, {}};
    force_ = {"bearing_force", dim * bearings, quanta.bearing_force, {}};
    displacement_ = {"bearing_displacement", dim * bearings, quanta.bearing_displacement, {}};
    contact_frame_ = {"contact_frame", 1, 1, {}};
    contact_first_ = {"contact_first", 1, 1, {0}};
    place_ = {"contact_place", dim, quanta.length, {}};
    push_ = {"contact_force", dim, quanta.force, {}};
    pair_ = {"contact_pair", 3, 1, {}};
    take_fields(header, quanta);
  }

  void add(const results::Frame& frame, bool with_contacts) {
    time_.values.push_back(quantised(frame.time, time_.quantum));
    stage_.values.push_back(frame.stage);
    append(position_, frame.position);
    append(rotation_, frame.rotation);
    append(stress_, frame.stress);
    append(plastic_, frame.plastic);
    for (const auto& [block, field] : recorded_) append(fields_[block], frame.fields[field]);
    for (const results::BearingState s : frame.bearing_state) state_.values.push_back(static_cast<std::int32_t>(s));
    append(force_, frame.bearing_force);
    append(displacement_, frame.bearing_displacement);
    if (!with_contacts) return;
    contact_frame_.values.push_back(static_cast<std::int32_t>(time_.values.size()) - 1);
    for (const results::ContactForce& c : frame.contacts) add(c);
    contact_first_.values.push_back(static_cast<std::int32_t>(pair_.rows()));
  }

  std::vector<ViewBlock> take() {
    std::vector<ViewBlock> out;
    for (ViewBlock* block : {&time_, &stage_, &position_, &rotation_, &stress_, &plastic_, &state_, &force_,
                             &displacement_, &contact_frame_, &contact_first_, &place_, &push_, &pair_})
      if (block->columns > 0) out.push_back(std::move(*block));
    for (ViewBlock& block : fields_) out.push_back(std::move(block));
    return out;
  }

 private:
  /// Forces and states of the members of frames, and the temperatures of nodes.
  void take_fields(const results::Header& header, const Quanta& quanta) {
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
      const results::Field& field = header.fields[i];
      const bool heat = field.name == results::node_temperature, force = field.name == "member_force";
      if (!heat && !force && field.name != "member_state") continue;
      recorded_.emplace_back(fields_.size(), i);
      fields_.push_back({heat ? "temperature" : field.name,
                         field.rows * static_cast<std::size_t>(field.width),
                         heat    ? quanta.temperature
                         : force ? quanta.member_force
                                 : 1,
                         {}});
    }
  }

  static void append(ViewBlock& block, const std::vector<double>& values) {
    for (const double v : values) block.values.push_back(quantised(v, block.quantum));
  }

  void add(const results::ContactForce& c) {
    for (std::size_t k = 0; k < place_.columns; ++k) place_.values.push_back(quantised(c.point[k], place_.quantum));
    for (std::size_t k = 0; k < push_.columns; ++k) push_.values.push_back(quantised(c.force[k], push_.quantum));
    pair_.values.insert(pair_.values.end(), {c.body_a, c.body_b, static_cast<std::int32_t>(c.state)});
  }

  ViewBlock time_, stage_, position_, rotation_, stress_, plastic_, state_, force_, displacement_, contact_frame_,
      contact_first_, place_, push_, pair_;
  std::vector<ViewBlock> fields_;
  std::vector<std::pair<std::size_t, std::size_t>> recorded_;  // block in fields_, and field of the frames
};

void note_sizes(const std::vector<double>& values, std::vector<double>& sizes) {
  for (const double v : values) sizes.push_back(std::abs(v));
}

/// Index of a field of the frames; their number if there is none.
std::size_t field_index(const results::Header& header, std::string_view name) {
  const auto at =
      std::find_if(header.fields.begin(), header.fields.end(), [&](const results::Field& f) { return f.name == name; });
  return static_cast<std::size_t>(at - header.fields.begin());
}

/// A share of the range of the temperatures, so that heat of friction is seen as well as a season.
double temperature_quantum(const std::vector<double>& temperatures) {
  if (temperatures.empty()) return 1;
  const auto [low, high] = std::minmax_element(temperatures.begin(), temperatures.end());
  return *high > *low ? std::max(1e-6, (*high - *low) / 2000) : 0.01;
}

/// Quanta of forces and bearings from about 50 frames; returns the mean number of contact forces per frame.
double survey(const results::ResultsReader& reader, Quanta& quanta) {
  std::vector<double> forces, bearing_forces, displacements, stresses, plastic, member_forces;
  std::vector<double> temperatures;
  const std::size_t of_members = field_index(reader.header(), "member_force"),
                    of_nodes = field_index(reader.header(), results::node_temperature);
  std::size_t contacts = 0, looked = 0;
  const std::size_t count = reader.frame_count(), step = std::max<std::size_t>(1, count / 50);
  for (std::size_t i = 0; i < count; i += step, ++looked) {
    const results::Frame frame = reader.frame(i);
    contacts += frame.contacts.size();
    for (const results::ContactForce& c : frame.contacts)
      forces.push_back(std::hypot(c.force[0], c.force[1], c.force[2]));
    note_sizes(frame.bearing_force, bearing_forces);
    note_sizes(frame.bearing_displacement, displacements);
    note_sizes(frame.stress, stresses);
    note_sizes(frame.plastic, plastic);
    if (of_members < frame.fields.size()) note_sizes(frame.fields[of_members], member_forces);
    if (of_nodes < frame.fields.size())
      for (const double t : frame.fields[of_nodes])
        if (t > results::no_temperature) temperatures.push_back(t);
  }
  quanta.force = usual_quantum(std::move(forces), 0.9, 1000);
  quanta.bearing_force = usual_quantum(std::move(bearing_forces), 0.9, 5000);
  quanta.bearing_displacement = usual_quantum(std::move(displacements), 0.9, 5000);
  quanta.stress = usual_quantum(std::move(stresses), 0.9, 500);
  quanta.member_force = usual_quantum(std::move(member_forces), 0.9, 5000);
  quanta.temperature = temperature_quantum(temperatures);
  quanta.plastic = usual_quantum(std::move(plastic), 0.9, 500);
  return looked > 0 ? static_cast<double>(contacts) / static_cast<double>(looked) : 0;
}

}  // namespace

ViewFrames view_frames(const results::ResultsReader& reader, const ViewLimits& limits, const ViewProgress& progress) {
  ViewFrames out;
  const std::size_t count = reader.frame_count();
  if (count == 0) return out;
  const results::Header& header = reader.header();
  Quanta quanta = body_quanta(header);
  const double contacts = survey(reader, quanta);
  const auto frames = static_cast<double>(count);
  // Stress and plastic strain of an element need the space of 4/3 nodes.
  const double nodes = static_cast<double>(header.node_count()) + 4.0 / 3 * static_cast<double>(header.element_count());
  out.frame_stride = stride_for(frames * nodes, limits.node_frames);
  out.contact_stride = stride_for(frames * contacts / static_cast<double>(out.frame_stride), limits.contact_rows);
  Gatherer gatherer(header, quanta);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % out.frame_stride != 0 && i + 1 != count) continue;
    const results::Frame frame = reader.frame(i);
    gatherer.add(frame, kept++ % out.contact_stride == 0 || i + 1 == count);
    for (const results::ContactForce& c : frame.contacts)
      if (c.state == results::ContactState::bonded) out.bonded.insert(std::minmax(c.body_a, c.body_b));
    if (progress) progress(static_cast<double>(i + 1) / frames);
  }
  out.blocks = gatherer.take();
  return out;
}

}  // namespace trilith::view
