// The second level of the tree. Instances have eight texels (host/render/geometry.h): three rows of world-to-object, grid
// origin and root node, grid scale and first primitive id of their object's tree, three rows of object-to-world. A walk goes
// on in an instance's tree with the ray in the object's space; an entry on the stack that holds no node, kSentinel, marks
// where it began. Everything here is compiled out of scenes with one level.
layout(constant_id = kSpecInstances) const uint kInstances = 0u;
DATA_TEXELS(kBindInstances, instance_texels);

const uint kNoNode = 0xffffffffu;    // a walk that is over
const uint kLeaveNode = 0xfffffffeu; // what the sentinel gives as a node
bool is_node(uint node) { return int(node) >= 0; }

vec4 instance_row(uint instance, uint row) { return uintBitsToFloat(FETCH(instance_texels, instance * 8u + row)); }

// Where a lane's walk is, and its ray there.
struct Place {
  Ray ray;         // t_max: the reach, in units of this space
  RayFrame frame;
  GridRay grid;
  float scale;     // length here of a unit of the world
  uint instance;   // slot of the instance; kNoNode: the world
  uint first_id;   // added to the ids of primitives
};

Place world_place(Ray ray, TreeConstants tree, bool inside_bounds) {
  Place p;
  p.ray = ray;
  p.frame = ray_frame(ray.direction);
  vec3 error = inside_bounds && kInstances == 0u ? vec3(0.0) : (abs(ray.origin) + abs(tree.grid_origin.xyz)) * 4.5e-7;
  p.grid = to_grid(ray, tree.grid_origin.xyz, tree.grid_scale.xyz, error, kInstances != 0u);
  p.scale = 1.0;
  p.instance = kNoNode;
  p.first_id = 0u;
  return p;
}

// The ray in an instance's object. `root` receives the first node of its tree.
Place enter_instance(Ray world, uint instance, out uint root) {
  vec4 r0 = instance_row(instance, 0u), r1 = instance_row(instance, 1u), r2 = instance_row(instance, 2u);
  uvec4 g0 = FETCH(instance_texels, instance * 8u + 3u);
  uvec4 g1 = FETCH(instance_texels, instance * 8u + 4u);
  vec4 o = vec4(world.origin, 1.0);
  vec3 d = vec3(dot(r0.xyz, world.direction), dot(r1.xyz, world.direction), dot(r2.xyz, world.direction));
  // The world's own shapes: nothing may be rounded, so that they are met as they would be with one level.
  bool own = (g0.w & kWorldInstance) != 0u;
  Place p;
  p.scale = own ? 1.0 : sqrt(dot(d, d));
  p.ray.origin = own ? world.origin : vec3(dot(r0, o), dot(r1, o), dot(r2, o));
  p.ray.direction = own ? world.direction : d / p.scale;
  p.ray.t_max = world.t_max * p.scale;
  p.ray.skip = world.skip;
#ifdef RAYS_TO_LIGHTS
  p.ray.light = world.light;
  p.ray.more_lights = world.more_lights;
#endif
  p.frame = ray_frame(p.ray.direction);
  vec4 a = abs(o);
  vec3 error = (vec3(dot(abs(r0), a), dot(abs(r1), a), dot(abs(r2), a)) + abs(uintBitsToFloat(g0.xyz))) * 6.0e-7;
  p.grid = to_grid(p.ray, uintBitsToFloat(g0.xyz), uintBitsToFloat(g1.xyz), error, true);
  p.instance = instance;
  p.first_id = g1.w;
  root = g0.w & ~kWorldInstance;
  return p;
}

#define CHOOSE(field) p.field = take ? q.field : p.field;
Place choose(bool take, Place q, Place p) {
  CHOOSE(ray.origin) CHOOSE(ray.direction) CHOOSE(ray.t_max) CHOOSE(frame.u) CHOOSE(frame.v) CHOOSE(grid.origin) CHOOSE(grid.inverse)
  CHOOSE(grid.stretch) CHOOSE(grid.slack) CHOOSE(scale) CHOOSE(instance) CHOOSE(first_id)
  return p;
}
#undef CHOOSE

// A walk's way through the levels.
struct Levels {
  uint first;       // instances first + bit that wait to be entered
  uint mask;
  uint world_node;  // where the world's walk goes on after them
};

// What the nodes gave as primitives are instances in the world's tree.
void take_instances(inout Levels levels, Place place, uint first, inout uint mask) {
  bool found = place.instance == kNoNode && mask != 0u;
  levels.first = found ? first : levels.first;
  levels.mask = found ? mask : levels.mask;
  mask = found ? 0u : mask;
}

// Between rounds: from the world into the next instance that waits, from an instance into the next or back. Returns whether
// the sentinel is to be pushed. `world`: the ray with its present reach; `tested`: no primitive waits.
bool switch_level(inout Levels levels, inout Place place, inout uint node, Ray world, TreeConstants tree, bool tested) {
  bool in_world = place.instance == kNoNode;
  bool arrived = in_world && levels.mask != 0u;
  bool finished = !in_world && node == kLeaveNode && tested;
  levels.world_node = arrived ? node : levels.world_node;
  bool enter = (arrived || finished) && levels.mask != 0u;
  uint instance = levels.first + uint(findLSB(enter ? levels.mask : 1u));
  uint root;
  Place inside = enter_instance(world, enter ? instance : 0u, root);
  place = choose(enter, inside, place);
  place = choose(finished && !enter, world_place(world, tree, false), place);
  node = enter ? root : (finished ? levels.world_node : node);
  levels.mask = enter ? levels.mask & (levels.mask - 1u) : levels.mask;
  return enter;
}
