// Private to results/: the columns of every table, each named once. `a` is an archive of table_columns.hpp.
#pragma once

#include "model/seal_row.hpp"
#include "results/file/results.hpp"
#include "results/reading/table_columns.hpp"

namespace trilith::results {

/// A note made during the run.
struct NoteRow {
  double time = 0;
  std::string text;
};

/// A contact force with its frame.
struct ContactRow {
  std::int32_t frame = 0;
  ContactForce contact;
};

/// Number of committed rows of each growing table. Written last at each flush.
struct Committed {
  std::int64_t frames = 0, contacts = 0, histories = 0, events = 0, energy = 0, stages = 0, notes = 0, modes = 0;
  std::int64_t motions = 0, motion_samples = 0;
};

template <class A>
void describe(A& a, typename A::template Of<Committed>& row) {
  a.number("frames", row.frames, "1", "rows of every data set in /frames but contacts");
  a.number("contacts", row.contacts, "1", "rows of /frames/contacts");
  a.number("histories", row.histories, "1", "rows of every data set in /histories");
  a.number("events", row.events, "1", "rows of /events");
  a.number("energy", row.energy, "1", "rows of every data set in /energy");
  a.number("stages", row.stages, "1", "rows of /stages");
  a.number("notes", row.notes, "1", "rows of /provenance/notes");
  a.number("modes", row.modes, "1", "rows of every data set in /modes");
  a.number("motions", row.motions, "1", "rows of /motions/list");
  a.number("motion_samples", row.motion_samples, "1", "rows of /motions/acceleration");
}

template <class A>
void describe(A& a, typename A::template Of<ParameterRow>& row) {
  a.text("name", row.name, 1, "name in the script");
  a.text("value", row.value, 1, "value in this run");
  a.text("unit", row.unit, 1, "unit");
  a.text("default", row.fallback, 1, "declared default");
  a.text("text", row.text, 1, "description");
}

template <class A>
void describe(A& a, typename A::template Of<BodyRow>& row) {
  a.text("name", row.name, 1, "name");
  a.text("kind", row.kind, 1, "kind of body");
  a.text("material", row.material, 1, "material");
  a.text("groups", row.groups, 1, "groups, separated by blanks");
  a.text("support", row.support, 1, "free, fixed or moved");
  a.number("first_node", row.first_node, "1", "first of its nodes");
  a.number("node_count", row.node_count, "1", "number of its nodes");
  a.number("first_vertex", row.first_vertex, "1", "first of its outline points");
  a.number("vertex_count", row.vertex_count, "1", "number of its outline points");
  if (a.dim != 3) return;
  a.number("first_face", row.first_face, "1", "first of its faces");
  a.number("face_count", row.face_count, "1", "number of its faces");
}

template <class A>
void describe(A& a, typename A::template Of<LawRow>& row) {
  a.text("name", row.name, 1, "name");
  a.text("role", row.role, 1, "material, contact or section");
  a.text("first", row.first, 1, "contact: material or group on one side; section: members");
  a.text("second", row.second, 1, "contact: material or group on the other side");
  a.text("text", row.text, 1, "parameters with units");
}

template <class A>
void describe(A& a, typename A::template Of<BearingRow>& row) {
  a.text("name", row.name, 1, "name");
  a.number("body_a", row.body_a, "1", "row of /model/bodies");
  a.number("body_b", row.body_b, "1", "row of /model/bodies");
  a.vector("point_a_", row.point_a, "m", "point on body a, in its axes");
  a.vector("point_b_", row.point_b, "m", "point on body b, in its axes");
  a.text("law", row.law, 1, "law with parameters");
}

template <class A>
void describe(A& a, typename A::template Of<JointRow>& row) {
  a.number("body_a", row.body_a, "1", "row of /model/bodies");
  a.number("body_b", row.body_b, "1", "row of /model/bodies");
  a.number("storey", row.storey, "1", "storey, 0: none");
  a.number("bonded", row.bonded, "1", "1: with a bond at the start");
  a.vector("end_0_", row.end_0, "m", "one end at the start, world axes");
  a.vector("end_1_", row.end_1, "m", "the other end at the start, world axes");
  if (a.dim != 3) return;
  a.number("area", row.area, "m^2", "area that the faces share");
}

template <class A>
void describe(A& a, typename A::template Of<MemberRow>& row) {
  a.text("name", row.name, 1, "name");
  a.text("from", row.from, 1, "joint at its start");
  a.text("to", row.to, 1, "joint at its end");
  a.text("yields", row.yields, 1, "elastic, hinges or fibres");
  a.number("body", row.body, "1", "row of /model/bodies");
  a.number("first_beam", row.first_beam, "1", "first of its rows of /model/beams");
  a.number("beam_count", row.beam_count, "1", "number of its beams");
  a.number("yield_rotation_from", row.yield_rotation[0], "rad", "chord rotation at yield of the hinge at its start");
  a.number("yield_rotation_to", row.yield_rotation[1], "rad", "chord rotation at yield of the hinge at its end");
}

template <class A>
void describe(A& a, typename A::template Of<BeamRow>& row) {
  a.number("member", row.member, "1", "row of /model/members");
  a.number("node_a", row.node_a, "1", "node that carries its start");
  a.number("node_b", row.node_b, "1", "node that carries its end");
  a.vector("arm_a_", row.arm_a, "m", "from node a to its start, in the axes of the node");
  a.vector("arm_b_", row.arm_b, "m", "from node b to its end, in the axes of the node");
  a.vector("up_", row.up, "1", "to the top of its section, in the axes of node a");
  a.number("length", row.length, "m", "initial length");
}

template <class A>
void describe(A& a, typename A::template Of<Figure>& row, const char* name, const char* unit, const char* value) {
  a.text(name, row.name, 24, "meaning of the figure; empty if unused");
  a.text(unit, row.unit, 8, "its unit");
  a.number(value, row.value, "", "the figure, in the unit next to it");
}

template <class A>
void describe(A& a, typename A::template Of<EventRow>& row) {
  a.number("id", row.id, "1", "number of the event");
  a.number("time", row.time, "s", "time");
  a.number("step", row.step, "1", "steps done");
  a.number("stage", row.stage, "1", "row of /stages");
  a.text("type", row.type, 32, "type");
  a.number("body_a", row.body_a, "1", "row of /model/bodies, -1: none");
  a.number("body_b", row.body_b, "1", "row of /model/bodies, -1: none");
  a.number("bearing", row.bearing, "1", "row of /model/bearings, -1: none");
  a.text("body_a_name", row.body_a_name, 1, "its name");
  a.text("body_b_name", row.body_b_name, 1, "its name");
  a.text("bearing_name", row.bearing_name, 1, "its name");
  a.code("has_place", row.has_place, "1 where x, y are the place of the event");
  a.vector("", row.place, "m", "place, world axes");
  describe<A>(a, row.first, "figure_1", "unit_1", "value_1");
  describe<A>(a, row.second, "figure_2", "unit_2", "value_2");
  a.number("cause", row.cause, "1", "id of the event that led to this one, -1: none");
  a.text("text", row.text, 160, "in words");
}

template <class A>
void describe(A& a, typename A::template Of<StageRow>& row) {
  a.text("name", row.name, 64, "name");
  a.text("kind", row.kind, 32, "kind");
  a.number("begin", row.begin, "s", "time of its beginning");
  a.number("end", row.end, "s", "time of its end; its start while it runs");
  a.code("ended", row.ended, "1 if it has ended");
  a.text("why", row.why, 160, "reason for its end");
}

template <class A>
void describe(A& a, typename A::template Of<ModeRow>& row) {
  a.number("analysis", row.analysis, "1", "equal for modes of one analysis");
  a.number("number", row.number, "1", "by rising frequency, from 1");
  a.number("time", row.time, "s", "time of the analysis");
  a.number("frequency", row.frequency, "Hz", "natural frequency; 0 where it does not oscillate");
  a.number("damping", row.damping, "1", "ratio to critical damping");
  a.vector("mass_", row.mass, "kg", "effective mass along each axis");
}

template <class A>
void describe(A& a, typename A::template Of<MotionRow>& row) {
  a.number("body", row.body, "1", "row of /model/bodies");
  a.number("node", row.node, "1", "node of the body that follows it; the others keep their distance");
  a.text("direction", row.direction, 8, "along which it moves the body: x, y, z or rotation");
  a.number("begin", row.begin, "s", "time of the run at which its clock is 0");
  a.number("origin", row.origin, "m", "coordinate of the node along that direction when the displacement is 0");
  a.number("step", row.step, "s", "between samples");
  a.number("start_time", row.start_time, "s", "of the first sample, on its clock");
  a.number("start_velocity", row.start_velocity, "m/s", "at the first sample");
  a.number("start_displacement", row.start_displacement, "m", "at the first sample");
  a.number("first_sample", row.first_sample, "1", "first of its rows in /motions/acceleration");
  a.number("sample_count", row.sample_count, "1", "how many");
  a.text("record", row.record, 120, "file it was read from");
  a.text("title", row.title, 120, "event and station");
  a.text("text", row.text, 240, "record and the operations on it");
}

template <class A>
void describe(A& a, typename A::template Of<SealRow>& row) {
  a.text("check", row.check, 40, "name of the check");
  a.text("state", row.state, 10, "passed, failed, or not made: there was nothing to check");
  a.number("value", row.value, "", "the worst of the run, in the unit of the column unit");
  a.number("limit", row.limit, "", "it may be at most this; 0: no limit");
  a.text("unit", row.unit, 8, "unit of value and limit");
  a.text("text", row.text, 120, "in a few words");
  a.number("valid_until", row.valid_until, "s", "of a failed check: the run is reliable until then");
}

template <class A>
void describe(A& a, typename A::template Of<NoteRow>& row) {
  a.number("time", row.time, "s", "time");
  a.text("text", row.text, 240, "note or warning");
}

template <class A>
void describe(A& a, typename A::template Of<ContactRow>& row) {
  a.number("frame", row.frame, "1", "row of /frames/time");
  a.vector("", row.contact.point, "m", "point of the resultant, world axes");
  a.vector("f", row.contact.force, "N", "force on body a, world axes; the force on body b is opposite");
  a.number("body_a", row.contact.body_a, "1", "row of /model/bodies");
  a.number("body_b", row.contact.body_b, "1", "row of /model/bodies");
  a.code("state", row.contact.state, "0 bonded, 1 sticking, 2 sliding");
  if (a.dim != 3) return;
  a.number("area", row.contact.area, "m^2", "area over which it acts");
  a.vector("n", row.contact.normal, "1", "unit normal from body a to body b, world axes; 0 where unknown");
}

/// The type of a table of `Row`, wide enough for every row of `rows`.
template <class Row>
TableType table_type(const std::vector<Row>& rows, int dim) {
  ColumnCollector columns(dim);
  describe<ColumnCollector>(columns, Row{});
  for (const Row& row : rows) {
    columns.start_row();
    describe<ColumnCollector>(columns, row);
  }
  return std::move(columns).finish();
}

/// Writes `row` to `out`, which holds type.size bytes.
template <class Row>
void pack(const TableType& type, int dim, const Row& row, std::byte* out) {
  Packer packer(type, dim, out);
  describe<Packer>(packer, row);
}

/// The row stored at `in`.
template <class Row>
Row unpack(const TableType& type, int dim, const std::byte* in) {
  Row row{};
  Unpacker unpacker(type, dim, in);
  describe<Unpacker>(unpacker, row);
  return row;
}

}  // namespace trilith::results
