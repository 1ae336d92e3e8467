// A plane model in scripts. No Lua here.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bindings/model/simulated_model.hpp"
#include "model/builder/builder.hpp"
#include "model/builder/extend.hpp"

namespace trilith::script {

template <int D>
struct BridgeBookOf;  // bridge_book.hpp

/// Default kind of bodies.
struct BodyForm {
  BodyKind kind = BodyKind::rigid;
  std::array<int, 2> divisions{1, 1};
};

class PlaneModel final : public SimulatedModel<2> {
 public:
  using SimulatedModel::SimulatedModel;

  ModelBuilder builder;
  BodyForm body_form;
  bool says_body = false;                   ///< body_form was given, and is not the default
  std::shared_ptr<BridgeBookOf<2>> bridge;  ///< supports and spans; empty before the first

  void add_material(const Material& material) override { builder.add_material(material); }
  void add_law(const std::string& law_name, const ContactLaw& law) override { builder.add_law(law_name, law); }
  void set_contact(const std::string& a, const std::string& b, const std::string& law) override {
    builder.set_contact(a, b, law);
  }
  [[nodiscard]] std::vector<std::string> law_names() const override { return builder.law_names(); }
  [[nodiscard]] int body_count() const override { return static_cast<int>(builder.bodies().size()); }
  [[nodiscard]] const std::string& body_name(int body) const override { return spec(body).name; }
  [[nodiscard]] const std::string& material_of(int body) const override { return spec(body).material; }
  [[nodiscard]] const std::vector<std::string>& groups_of(int body) const override { return spec(body).groups; }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return builder.notes(); }
  void add_note(const std::string& line) override { builder.note(line); }
  [[nodiscard]] std::vector<std::string> faults() const override {
    return built() ? standing_faults() : builder.faults();
  }
  /// Moment of inertia of a body about its centroid [kg m2], before and after building.
  [[nodiscard]] double inertia_of(int body);
  [[nodiscard]] const BodySpec& spec(int body) const { return builder.bodies()[static_cast<std::size_t>(body)]; }

 protected:
  [[nodiscard]] Model<2> built_model() override { return built_unjudged(builder); }
  [[nodiscard]] std::vector<std::string> standing_faults() const override {
    if (builder.judge_standing) return {};
    return trilith::standing_faults(if_built()->model(), if_built()->state(), floating_bodies(builder.bodies()));
  }
  void judge_standing() override { builder.judge_standing = true; }
  [[nodiscard]] double overlap_allowed() const override { return builder.overlap_allowed; }
  [[nodiscard]] Model<2> extended_model(const Model<2>& model, const State<2>& state) override {
    return builder.extended(model, state);
  }
  void forget_beyond(const Model<2>& model) override {
    builder.shorten(model.bodies.size(), model.bearings.size(), model.seats.size());
  }
  [[nodiscard]] Model<2> lone_body(int body) const override;
};

}  // namespace trilith::script
