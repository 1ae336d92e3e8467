local report = [[
name         text      name of the stage
ending       text      time, rest, unstable, stopped, not at rest, diverged, all left or not converged
rests        flag      true where the stage ended at rest
collapsed    flag      true where until_collapse ended the stage
reason       text      reason, where the stage did not end as requested
steps        integer   number of time steps
begun        number s  time at the start
ended        number s  time at the end
shortest_dt  number s  shortest time step
longest_dt   number s  longest time step
speed        number m/s  largest speed of a point at the end
ratio        number    out-of-balance ratio: unbalanced force over the largest force
threads      integer   threads of a step at the end
thread_gain  number    speed-up by these threads; 0 if not measured
mass_scaling  table?  bodies, share of added mass, most of a body, before (its step, s), energy and kinetic (J)]]

return {
  name = "tables", title = "Results of calls: reports, events, energy terms and other tables",
  tables = {
    report = report,
    ["pushover report"] = report .. [[

curve                 table      capacity curve: lists t [s], displacement [m], force [N] and drift [m]
peak_force            number N   largest force of all steps; a point of the curve
displacement_at_peak  number m   displacement at the peak force
drift_at_peak         number m   drift at the peak force
force                 number N   force at the end
displacement          number m   displacement at the end
drift                 number m   drift at the end
limit                 text       limit that ended the stage: "displacement", "drift", "drop", "until", "samples", ...
carried_at_peak       number N   part of the peak force that the structure carries statically; below 0 while it swings
quasi_static          flag       false where inertia and damping exceed 2 % of the peak force
limits                list?      control "arc": limit points of the path, { force = , displacement = , highest = }
happened              list?      control "arc": sentences on yielding and failures along the path]],
    bilinear = [[
code                   text      "eurocode8" or "ntc2018"
yield_force            number N  force of the horizontal branch
yield_displacement     number m  displacement at the corner
stiffness              number N/m  of the elastic branch
ultimate_displacement  number m  where the force has fallen by the drop; else the end of the curve
reached_drop           flag      false where the curve ends before the drop
ductility              number    ultimate_displacement over yield_displacement
peak_force             number N  largest force of the curve
displacement_at_peak   number m  its displacement
energy                 number J  area of the curve up to the ultimate displacement
damage_limitation      number m  EN 1998-3: the yield displacement
significant_damage     number m  EN 1998-3: 3/4 of the ultimate displacement
near_collapse          number m  EN 1998-3: the ultimate displacement
period                 number s?  of the oscillator; with mass
target                 number m?  displacement under the spectrum, EN 1998-1 annex B.5; with mass and spectrum
demand_to_capacity     number?   target over ultimate_displacement]],
    energy = [[
kinetic           number J  kinetic energy
gravity           number J  potential energy of the weight, from the start
contact_elastic   number J  elastic energy of contacts
bearing_elastic   number J  elastic energy of bearings
strain            number J  elastic energy of deformable bodies
contact_damping   number J  dissipated by contact damping
contact_friction  number J  dissipated by friction
contact_fracture  number J  dissipated by breaking bonds and by crushing of mortar
bearing_damping   number J  dissipated by the dashpots of bearings
bearing_inner     number J  dissipated by yielding or sliding of bearings (hysteresis)
bearing_failure   number J  dissipated by failing bearings
plastic           number J  dissipated by plastic strain of deformable bodies
element_damping   number J  dissipated by damping of deformable bodies
mass_damping      number J  dissipated by mass-proportional damping
rest_damping      number J  dissipated by the damping of consolidation
support           number J  work of moving supports (input)
load              number J  work of loads (input)
left_bounds       number J  energy of bodies that left the bounds
numerical         number J  dissipated by the numerical damping of implicit steps
added             number J  energy of bodies and bearings that were added, and of changed laws (input)
removed           number J  energy of bodies and bearings that were removed
water             number J  work of the pressure and the drag of water (input)
heat              number J  elastic energy that changes of temperature put into bodies (input)
residual          number J  error of the energy balance]],
    event = [[
type        text      type, such as "bearing.failed"
severity    text      "routine", "notice", "change", "damage", "failure", "loss" or "invalid"
time        number s  time
id          integer   number, increasing from 0
cause       integer?  id of the event that caused this one
step        integer   number of the time step
value       number    value; its meaning is value_name
value_name  text      meaning of the value
x           number m  place
y           number m  place
z           number m?  place, in space
mode        text?     for a joint or a crack: "tension", "shear" or "compression"
plane       integer?  for a crack: number of its plane
parts       list?     for a crack: the two bodies into which the body cracked
text        text      the event as a sentence
bodies      list      bodies of the event
body        body?     the first of the bodies
bearing     bearing?  bearing of the event
seat        seat?     seat of the event]],
    findings = "text  text  the whole text",
    part = [[
name     text    name
outline  points  corners in order
groups   names   groups of the part]],
  },
}
