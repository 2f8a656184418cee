#include "tests/support/ray_world.hpp"

namespace hs::tests {

RayWorld::RayWorld(const std::vector<glm::vec4>& corners)
    : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners.size()
    ));
    auto* const indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), corners.size() / 3
    ));
    for (unsigned i = 0; i < corners.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            positions[3 * i + static_cast<unsigned>(k)] = corners[i][k];
        }
        indices[i] = i;
    }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_);
}

RayWorld::~RayWorld() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

int RayWorld::first_hit(const glm::vec3& origin, const glm::vec3& direction, float near, float far)
    const {
    RTCRayHit query{};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tnear = near;
    query.ray.tfar = far;
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : static_cast<int>(query.hit.primID);
}

} // namespace hs::tests
