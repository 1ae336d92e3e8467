// List of the functions and methods that each file of bindings adds to the module table.
#pragma once

#include "bindings/core/handles.hpp"

namespace trilith::script {

Host& host(lua_State* L);

// Each function adds its functions to the table on top of the stack.
void open_units(lua_State* L);         ///< units, params
void open_math(lua_State* L);          ///< math.sin, math.exp, ...
void open_laws(lua_State* L);          ///< frictional, bonded, linear, ...
void open_sections(lua_State* L);      ///< rectangle_section, i_section, ...
void open_yields(lua_State* L);        ///< fibre_section, kent_park, end_hinge, ...
void open_motions(lua_State* L);       ///< motion
void open_build(lua_State* L);         ///< build.block, build.arch, ...
void open_study(lua_State* L);         ///< study
void open_core(lua_State* L);          ///< for the library only: model, wake, fail, ...
void open_declarations(lua_State* L);  ///< for the library only: declarations of kinds and laws

// Methods of a model, file by file.
std::span<const Method> parts_methods();     ///< material, contact, body, add, pier, span, ...
std::span<const Method> bearing_methods();   ///< bearing, seat
std::span<const Method> bridge_methods();    ///< bearing_type, span
std::span<const Method> frame_methods();     ///< beam, frame
std::span<const Method> stage_methods();     ///< run, consolidate, shake, drive, tilt, stop
std::span<const Method> load_methods();      ///< point_load
std::span<const Method> pressure_methods();  ///< pressure
std::span<const Method> water_methods();     ///< water, set_level, uplift, drag, added_mass, water_state
std::span<const Method> heat_methods();  ///< heat, heat_exchange, heat_contact, set_temperature, temperature, process
std::span<const Method> release_methods();   ///< fix, free, set_load, release
std::span<const Method> pushover_methods();  ///< pushover
std::span<const Method> finding_methods();   ///< joints, thrust_line
std::span<const Method> modes_methods();     ///< modes
std::span<const Method> debug_methods();     ///< step, rewind, checkpoints
std::span<const Method> change_methods();    ///< change
std::span<const Method> reading_methods();   ///< bodies, contacts, history, results, explain_dt

/// body:forces and body:hinges, of beams and frames.
int push_member_forces(lua_State* L);
int push_member_hinges(lua_State* L);
int push_member_fibres(lua_State* L);

/// Highest number of a storey ("storey 3") among the groups of the present bodies.
int storey_count(const ScriptModel& model);
/// Properties of the whole model: base shear, drift, damage, openings; InputError if the model cannot be built.
std::span<const Property<ModelBox>> finding_properties();
/// Properties of the model: force and displacement of its pushes.
std::span<const Property<ModelBox>> pushover_properties();

/// Properties of the model: worst.
std::span<const Property<ModelBox>> debug_properties();
/// For the library: pause, resume, compare, laws of a model.
void open_debug(lua_State* L);
void open_compare(lua_State* L);
void open_change(lua_State* L);
void open_modes(lua_State* L);
void open_bridge(lua_State* L);  ///< for the library: bearing types, and bearings at the ends of spans
void open_lint(lua_State* L);    ///< for the library: faults, plausibility notes, damping of contacts, plausible ranges

/// Pushes an event as the table for handlers. `model_index`: index of the model's userdata.
void push_event(lua_State* L, int model_index, const Event& event);

/// Adds a note on a change of `model`: reported at once while a stage runs, otherwise with the others at the start of a
/// stage.
void tell_note(lua_State* L, ScriptModel& model, const std::string& text);

/// Name of a contact law in `model`: `name`, its own name, the name of a law with equal numbers, or a new one; adds the
/// law to the builder. Throws InputError if another law has that name.
std::string require_law(ScriptModel& model, const ContactLawValue& law, const std::string& name);

}  // namespace trilith::script
