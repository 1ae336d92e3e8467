local rest = "true, or { speed = [m/s], ratio = , hold = [s], from = [s] }"
local until_keys = [[

until_true       function?  end where f(model), asked after each step, is true
until_collapse   flag = false  end as something comes down: true, or { drop = [m], bodies = how many }]]
local drive = [[
body      bodies   what is moved
x         motion?  along x
y         motion?  along y
z         motion?  along z, in space
rotation  motion?  about the centroid, in the plane
turn_x    motion?  about the axis of the world along x through the centroid, in space
turn_y    motion?  ... along y
turn_z    motion?  ... along z
motions   list?    instead: { { body = , x = , y = , rotation = }, ... }]]
local in_space = { z = true, turn_x = true, turn_y = true, turn_z = true } -- of drive

return {
  name = "stages", title = "Stages: what runs, and what changes between and within them",
  { "model:run", "A stage of motion. Where the model pauses, the stage that pauses goes on up to that time.", keys = [[
duration    number s?     how long
to          number s?     or until this time
name        text = "run"  what results call it
damping     number = 0    share of the unbalanced force that brakes each body
dt          number s?     fixed step; found by itself where left out. Of implicit ones the longest (5 ms)
safety      number = 0.5  share of the longest stable step, at most 0.9; where accuracy is given 0.8
mass_scaling  table?  { step = [s], most = 30, bodies = }: longer steps by mass that deformation alone feels
integrator       text = "explicit"   or "implicit": long steps by Newton's method; or "auto": these where they pay
alpha            number = -0.05      implicit, HHT: from -1/3 to 0, which damps nothing (Newmark)
spectral_radius  number?             implicit, instead: generalised alpha, 0 to 1
tolerance        number = 1e-8       implicit: force left over, as a share of the largest
accuracy         number?             share of energies a step may miss, 0: any; implicit 1e-3; explicit: of blows, 0.02
watch       flag = true   speeds and energies that nothing gave end it as diverged
until_rest  rest?         end at rest: ]] .. rest .. until_keys, gives = "report" },
  { "model:consolidate", "To rest under dead load, with a damping of its own.", keys = [[
duration  number s = 60           at most
ratio     number = 1e-5           unbalanced force over the largest one at rest
speed     number m/s?             fastest point at rest
hold      number s?               for how long
damping   number = 0.8            share of the unbalanced force that brakes each body
grow      number s = 0.5          gravity comes on over this time
fresh     flag = false            mortar is fresh: joints are bonded as they stand at the end
or_go_on  flag = false            where rest is not reached, or not in place: a note, and the verdict stays sound
within    number = 0.25           a body that rests farther than this share of its size from where it was is unstable
integrator  text = "explicit"     or "static": found by Newton's method, in no time, without damping or steps
shares     integer = 1            static: weight and loads come on in so many shares
tolerance  number = 1e-8          static: force left over, as a share of the largest
name      text = "consolidation"  what results call it
dt        number s?               fixed step
safety    number = 0.5            share of the longest stable step, at most 0.9
mass_scaling  table?  { step = [s], most = 30, bodies = }: longer steps by mass that deformation alone feels
watch     flag = true             speeds and energies that nothing gave end it as diverged]] .. until_keys,
    gives = "report" },
  { "model:shake", "Bodies follow ground motions.", keys = drive .. [[

duration  number s?       how long; to the end of the motions where left out
still     rest?           end at rest after the motions: ]] .. rest .. [[

name      text = "shake"  what results call it
dt        number s?       fixed step
safety    number = 0.5    share of the longest stable step, at most 0.9; where accuracy is given 0.8
mass_scaling  table?  { step = [s], most = 30, bodies = }: longer steps by mass that deformation alone feels
integrator       text = "explicit"   or "implicit": long steps by Newton's method; or "auto": these where they pay
alpha            number = -0.05      implicit, HHT: from -1/3 to 0, which damps nothing (Newmark)
spectral_radius  number?             implicit, instead: generalised alpha, 0 to 1
tolerance        number = 1e-8       implicit: force left over, as a share of the largest
accuracy         number?             share of energies a step may miss, 0: any; implicit 1e-3; explicit: of blows, 0.02
watch     flag = true     speeds and energies that nothing gave end it as diverged]] .. until_keys,
    beside = in_space, gives = "report" },
  { "model:drive", "A body follows a motion from now on.", keys = drive, beside = in_space },
  { "model:fix", "Holds bodies, in some directions or all.", args = [[
bodies      bodies  a body, set, name, group or list of these
directions  text = all  of x, y and r, as in "xy"; in space of x, y, z and r, which is every turn]] },
  { "model:free", "Lets bodies go, in some directions or all.", args = [[
bodies      bodies  a body, set, name, group or list of these
directions  text = all  of x, y and r, as in "xy"; in space of x, y, z and r, which is every turn]] },
  { "model:tilt", "Gravity turns from now on.", keys = [[
rate     number rad/s    counter-clockwise; 0 stops it
by       number rad?     where it stops
towards  number rad = 0  in space: the azimuth it turns towards, counted from x to y]], beside = { towards = true } },
  { "model:bounds", "What leaves them is an event, stands still from then on and touches nothing. Sides that are not "
    .. "given are 10 times the extent of all bodies at the start away from them, at least 100 m.", keys = [[
left    number m?  least x
right   number m?  greatest x
front   number m?  least y, in space
back    number m?  greatest y, in space
bottom  number m?  least y, in space z
top     number m?  greatest y, in space z]], beside = { front = true, back = true } },
  { "model:stop", "Ends the running stage at the next step border." },
}
