// The models of scripts, in the plane and in space. No Lua here.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "bindings/model/simulated_model.hpp"
#include "edit/split.hpp"
#include "model/builder/builder.hpp"
#include "model/builder/extend.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith::script {

template <int D>
struct BridgeBookOf;  // bridge_book.hpp

/// Default kind of bodies in the plane.
struct BodyForm {
  BodyKind kind = BodyKind::rigid;
  std::array<int, 2> divisions{1, 1};
};

/// A model that a builder makes.
template <int D>
class BuiltModel : public SimulatedModel<D> {
 public:
  using Builder = std::conditional_t<D == 2, ModelBuilder, SolidModelBuilder>;
  using Spec = std::conditional_t<D == 2, BodySpec, SolidSpec>;
  using Form = std::conditional_t<D == 2, BodyForm, SpaceForm>;
  using SimulatedModel<D>::SimulatedModel;

  Builder builder;
  Form body_form;                           ///< default kind of bodies
  bool says_body = false;                   ///< body_form was given, and is not the default
  std::shared_ptr<BridgeBookOf<D>> bridge;  ///< types of bearings, supports and spans; empty before the first

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
    return this->built() ? standing_faults() : builder.faults();
  }
  [[nodiscard]] const Spec& spec(int body) const { return builder.bodies()[static_cast<std::size_t>(body)]; }
  [[nodiscard]] int first_part(int body) const override;
  [[nodiscard]] int heir_of(int body) const override;
  /// The part of a cracked body that holds its point at `at` at the start [m]; the body itself if it is whole.
  [[nodiscard]] int part_with(int body, const Vec<D>& at) const;

 protected:
  [[nodiscard]] Model<D> built_model() override { return built_unjudged(builder); }
  [[nodiscard]] std::vector<std::string> standing_faults() const override {
    if (builder.judge_standing) return {};
    const auto* const run = this->if_built();
    return trilith::standing_faults(run->model(), run->state(), floating_bodies(builder.bodies()));
  }
  void judge_standing() override { builder.judge_standing = true; }
  [[nodiscard]] double overlap_allowed() const override { return builder.overlap_allowed; }
  [[nodiscard]] Model<D> extended_model(const Model<D>& model, const State<D>& state) override {
    return builder.extended(model, state);
  }
  void forget_beyond(const Model<D>& model) override {
    builder.shorten(model.bodies.size(), model.bearings.size(), model.seats.size());
  }
  [[nodiscard]] Model<D> lone_body(int body) const override;
  [[nodiscard]] std::vector<CrackingBody<D>> cracking_bodies(const Model<D>& model) const override {
    return builder.cracking(model);
  }
  [[nodiscard]] Model<D> cracked_model(const Model<D>& model, std::span<const Crack<D>> cracks) override {
    return with_cracks(builder, model, this->if_built()->cracking().bodies, cracks);
  }
};
extern template class BuiltModel<2>;
extern template class BuiltModel<3>;

class PlaneModel final : public BuiltModel<2> {
 public:
  using BuiltModel::BuiltModel;
  /// Moment of inertia of a body about its centroid [kg m2], before and after building.
  [[nodiscard]] double inertia_of(int body);
};

class SpaceModel final : public BuiltModel<3> {
 public:
  using BuiltModel::BuiltModel;
};

}  // namespace trilith::script
