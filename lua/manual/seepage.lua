return {
  name = "seepage", title = "Seepage: flow of water through joints",
  { "model:seepage", "Water flows through the joint between two bodies, or through a fissure of given length, by the "
    .. "cubic law. The aperture of a joint is the given one plus the gap of its faces, and its pressure acts on both "
    .. "faces. Nodes of the same name connect joints. m:process lets the water flow. Returns the name.",
    also = "cubic law, fissure flow, hydraulic aperture, uplift, pore pressure, squeeze film", keys = [[
upper         body?              a body at the joint; in space rigid, and the joint one rectangle
lower         body?              the other body
heel          point?             a point at the end that is "from"; without it the left end
length        number m?          of a fissure, instead of bodies  <above 0>
width         number m = 1       of a fissure, out of the plane  <above 0>
elevation     number m = 0       of a fissure, or {number, number} at both ends
stiffness     number Pa/m = 0    of the walls of a fissure, which opens by pressure; 0: rigid walls  <at least 0>
aperture      number m           without load, or {number, number} at both ends  <above 0>
divisions     number = 32        number of cells  <at least 1>
from          text?              node at the first end
to            text?              node at the second end
filled        flag = true        water fills it at the start; false: it is dry
density       number kg/m3 = 1000      of the water  <above 0>
viscosity     number Pa s = 1e-3       of the water  <above 0>
bulk_modulus  number Pa = 2.2e9        of the water  <above 0>
crack_aperture  number m?        of a closed crack of its bodies at the joint; without it as the joint  <above 0>
name          text?              name in readings]], gives = "string",
    example = 'm:seepage { name = "fissure", length = 2, aperture = 2e-4, from = "lake", to = "drain" }' },
  { "model:seepage_head", "The head at a node of seepage: a course of elevations of a free surface, or the level of a "
    .. "water of m:water. A node without a head is closed, or a junction. A later call replaces the head.",
    also = "boundary head, reservoir, drain", keys = [[
node   text      a node of m:seepage
head   course?   head [m]: a number, or { {time, value}, ..., period = seconds }
water  text?     instead of head: name of a water, whose level is the head]],
    example = 'm:seepage { name = "fissure", length = 2, aperture = 2e-4, from = "lake", to = "drain" }\n'
      .. 'm:seepage_head { node = "lake", head = 3 }' },
  { "model:seepage_motion", "Whether water flows through joints in m:run and m:shake too. Without this call, and in "
    .. "implicit steps between bodies and with local_damping, pressures are held there. The explicit step is shortened "
    .. "to resolve the stiffness of the enclosed water, its bulk modulus over the aperture. The water has no inertia.",
    also = "squeeze film, hydrodynamic uplift, undrained", keys = [[
flows  flag = true  water flows during stages of motion; false: pressures are held]],
    example = 'm:seepage { name = "fissure", length = 2, aperture = 2e-4, from = "lake", to = "drain" }\n'
      .. 'm:seepage_motion { flows = true }' },
  { "model:seepage_state", "State of a joint. Lists by cell: head [m], pressure [Pa], aperture [m] and fill [1]. "
    .. "Numbers: volume of water [m3], wet_length and length [m], inflow and outflow [m3/s], head_from and head_to "
    .. "[m]. Between bodies also force [N] and moment about the origin [N m] on the upper one. Without a name: "
    .. "clock, volume, cells, and nodes by name, each with head, elevation, inflow into its joints, and the volume "
    .. "supplied.",
    args = "name  text?  name of a joint", gives = "table",
    example = 'm:seepage { name = "fissure", length = 2, aperture = 2e-4, from = "lake", to = "drain" }\n'
      .. 'print(m:seepage_state("fissure").volume)' },
}
