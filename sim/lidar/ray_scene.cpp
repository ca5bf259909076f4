#include "sim/lidar/ray_scene.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <embree3/rtcore.h>

#include "core/parallel_for.h"

namespace citrine::sim {
namespace {

constexpr int kPacket = 8;
constexpr int kPacketsAPart = 256;    ///< that a thread takes at once
constexpr int kDirections = 14;       ///< of the test for solid
constexpr int kEnclosedAtLeast = 12;  ///< of them
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What a ray of the test for solid has passed through.
struct Crossings : RTCIntersectContext {
  const std::vector<std::uint8_t>* half_space = nullptr;
  int winding = 0;
  bool under_plane = false;
};

/// Counts every surface on the way, and lets the ray go on.
void CountCrossing(const RTCFilterFunctionNArguments* args) {
  auto& crossings = *static_cast<Crossings*>(args->context);
  const unsigned n = args->N;
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] != -1) continue;
    args->valid[i] = 0;
    const float along = RTCRayN_dir_x(args->ray, n, i) * RTCHitN_Ng_x(args->hit, n, i) +
                        RTCRayN_dir_y(args->ray, n, i) * RTCHitN_Ng_y(args->hit, n, i) +
                        RTCRayN_dir_z(args->ray, n, i) * RTCHitN_Ng_z(args->hit, n, i);
    if ((*crossings.half_space)[RTCHitN_primID(args->hit, n, i)])
      crossings.under_plane |= along > 0;
    else
      crossings.winding += along > 0 ? 1 : -1;
  }
}

/// Directions spread evenly over the sphere (Fibonacci), none of them along an axis.
const std::array<Eigen::Vector3f, kDirections>& SolidDirections() {
  static const auto directions = [] {
    std::array<Eigen::Vector3f, kDirections> all;
    for (int i = 0; i < kDirections; ++i) {
      const double z = 1 - 2 * (i + 0.5) / kDirections, r = std::sqrt(1 - z * z),
                   angle = 0.37 + 2.399963229728653 * i;
      // The order is mixed so that opposite directions come early, and free points are settled after three
      // rays.
      all[(i * 5) % kDirections] = Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>();
    }
    return all;
  }();
  return directions;
}

Eigen::Vector3f ClosestOnTriangle(const Eigen::Vector3f& p, const Eigen::Vector3f& a,
                                  const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  // Regions of the plane around a triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
  const Eigen::Vector3f ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Eigen::Vector3f bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Eigen::Vector3f cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

bool NearestTriangle(RTCPointQueryFunctionArguments* args) {
  const TriMesh& mesh = *static_cast<const TriMesh*>(args->userPtr);
  const auto& triangle = mesh.triangles[args->primID];
  const Eigen::Vector3f p(args->query->x, args->query->y, args->query->z);
  const float distance = (p - ClosestOnTriangle(p, mesh.vertices_W[triangle[0]], mesh.vertices_W[triangle[1]],
                                                mesh.vertices_W[triangle[2]]))
                             .norm();
  if (distance >= args->query->radius) return false;
  args->query->radius = distance;
  return true;
}

/// Casts those of the packets of RayScene::Cast from `begin` to `end`.
void CastPackets(RTCScene scene, const Eigen::Vector3f& origin_W, std::span<const Eigen::Vector3f> directions,
                 float range_max_m, std::span<float> ranges_m, int begin, int end) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int at = begin; at < end; ++at) {
    const std::size_t first = static_cast<std::size_t>(at) * kPacket;
    const int count = static_cast<int>(std::min<std::size_t>(kPacket, directions.size() - first));
    alignas(32) int valid[kPacket];
    alignas(32) RTCRayHit8 packet;
    for (int i = 0; i < kPacket; ++i) {
      valid[i] = i < count ? -1 : 0;
      const Eigen::Vector3f& d = directions[first + std::min(i, count - 1)];
      packet.ray.org_x[i] = origin_W.x(), packet.ray.org_y[i] = origin_W.y(),
      packet.ray.org_z[i] = origin_W.z();
      packet.ray.dir_x[i] = d.x(), packet.ray.dir_y[i] = d.y(), packet.ray.dir_z[i] = d.z();
      packet.ray.tnear[i] = 0, packet.ray.tfar[i] = range_max_m;
      packet.ray.time[i] = 0, packet.ray.mask[i] = ~0u, packet.ray.id[i] = 0, packet.ray.flags[i] = 0;
      packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, scene, &context, &packet);
    for (int i = 0; i < count; ++i)
      ranges_m[first + i] = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kInfinity : packet.ray.tfar[i];
  }
}

}  // namespace

struct RayScene::Impl {
  TriMesh mesh;
  std::uint64_t world_hash = 0;
  std::vector<std::uint8_t> half_space;  ///< one a triangle
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const World& world) : impl_(std::make_unique<Impl>()) {
  impl_->mesh = world.mesh;
  impl_->world_hash = world.hash;
  const TriMesh& mesh = impl_->mesh;
  impl_->half_space.assign(mesh.triangles.size(), 0);
  for (const Part& part : world.parts)
    std::fill_n(impl_->half_space.begin() + part.first_triangle, part.num_triangles, part.half_space);

  impl_->device = rtcNewDevice("threads=1,isa=avx2");
  if (!impl_->device) throw std::runtime_error("Embree cannot be started; it needs a processor with AVX2");
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                            RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices_W.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
  for (const Eigen::Vector3f& v : mesh.vertices_W) vertices = std::copy_n(v.data(), 3, vertices);
  for (const auto& triangle : mesh.triangles) indices = std::copy_n(triangle.begin(), 3, indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}

RayScene::~RayScene() = default;
std::uint64_t RayScene::world_hash() const { return impl_->world_hash; }

void RayScene::Cast(const Eigen::Vector3f& origin_W, std::span<const Eigen::Vector3f> directions,
                    float range_max_m, std::span<float> ranges_m) const {
  const int packets = static_cast<int>((directions.size() + kPacket - 1) / kPacket);
  ParallelFor(packets, packets / kPacketsAPart, [&](int begin, int end) {
    CastPackets(impl_->scene, origin_W, directions, range_max_m, ranges_m, begin, end);
  });
}

RayScene::Hit RayScene::CastOne(const Eigen::Vector3f& origin_W, const Eigen::Vector3f& direction,
                                float range_max_m) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{{origin_W.x(), origin_W.y(), origin_W.z(), 0, direction.x(), direction.y(), direction.z(),
                   0, range_max_m, ~0u, 0, 0},
                  {0, 0, 0, 0, 0, 0, RTC_INVALID_GEOMETRY_ID, {RTC_INVALID_GEOMETRY_ID}}};
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.ray.tfar, static_cast<int>(query.hit.primID),
          Eigen::Vector3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).normalized()};
}

bool RayScene::Occluded(const Eigen::Vector3f& from_W, const Eigen::Vector3f& target_W) const {
  std::uint8_t free = 0;
  Unoccluded({&from_W, 1}, {&target_W, 1}, {&free, 1});
  return !free;
}

void RayScene::Unoccluded(std::span<const Eigen::Vector3f> from_W, std::span<const Eigen::Vector3f> target_W,
                          std::span<std::uint8_t> free) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t first = 0; first < from_W.size(); first += kPacket) {
    const int count = static_cast<int>(std::min<std::size_t>(kPacket, from_W.size() - first));
    alignas(32) int valid[kPacket];
    alignas(32) RTCRay8 packet;
    for (int i = 0; i < kPacket; ++i) {
      const std::size_t ray = first + std::min(i, count - 1);
      const Eigen::Vector3f &o = from_W[ray], d = target_W[ray] - o;
      const float length = d.norm(), reach = length - static_cast<float>(kOcclusionTolerance_m);
      valid[i] = i < count && reach > 0 ? -1 : 0;
      packet.org_x[i] = o.x(), packet.org_y[i] = o.y(), packet.org_z[i] = o.z();
      packet.dir_x[i] = d.x(), packet.dir_y[i] = d.y(), packet.dir_z[i] = d.z();
      packet.tnear[i] = 0, packet.tfar[i] = length > 0 ? reach / length : 0;
      packet.time[i] = 0, packet.mask[i] = ~0u, packet.id[i] = 0, packet.flags[i] = 0;
    }
    rtcOccluded8(valid, impl_->scene, &context, &packet);
    for (int i = 0; i < count; ++i) free[first + i] = packet.tfar[i] >= 0 || !valid[i];
  }
}

double RayScene::Distance(const Eigen::Vector3d& p_W, double limit_m) const {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const Eigen::Vector3f p = p_W.cast<float>();
  alignas(16) RTCPointQuery query{p.x(), p.y(), p.z(), 0, static_cast<float>(limit_m)};
  rtcPointQuery(impl_->scene, &query, &context, NearestTriangle, &impl_->mesh);
  return std::min<double>(query.radius, limit_m);
}

bool RayScene::Solid(const Eigen::Vector3d& p_W) const {
  const Eigen::Vector3f p = p_W.cast<float>();
  int open = 0;
  for (const Eigen::Vector3f& d : SolidDirections()) {
    Crossings crossings;
    rtcInitIntersectContext(&crossings);
    crossings.filter = CountCrossing;
    crossings.half_space = &impl_->half_space;
    RTCRayHit query{{p.x(), p.y(), p.z(), 0, d.x(), d.y(), d.z(), 0, kInfinity, ~0u, 0, 0},
                    {0, 0, 0, 0, 0, 0, RTC_INVALID_GEOMETRY_ID, {RTC_INVALID_GEOMETRY_ID}}};
    rtcIntersect1(impl_->scene, &crossings, &query);
    if (crossings.under_plane) return true;
    if (crossings.winding == 0 && ++open > kDirections - kEnclosedAtLeast) return false;
  }
  return true;
}

}  // namespace citrine::sim
