#ifndef SPHFLUID_FACE_IMAGES
#define SPHFLUID_FACE_IMAGES

// The liquid's mirror images in the faces of the domain, which push and are counted as the liquid is: before a mirror the arrangement of
// the neighbours is as whole as inside, and what the correction does there conserves energy as it does inside. Images in edges and corners
// are mirrored more than once. The image of a neighbour is farther than the neighbour, r'^2 = r^2 + 4 sum z_i z_j over the faces that
// mirror it, so that the list has them all. Triangles are no mirrors: they add what they add without the correction, and near them nothing
// is corrected.
#include "../../DomainFaces.hlsl"
#include "../../Cells/Wendland.hlsl"

struct FaceImages
{
    float3 Low;  // from the particle to the faces, m
    float3 High;
    uint Faces;  // within R: bits 0 to 2 those of least x, y, z, bits 3 to 5 the others
};

struct FaceImage
{
    float3 Separation; // from it
    float DistanceSquared;
    float3 Mirror;     // -1 along each axis that is mirrored, else 1
};

FaceImages ImagesAt(float3 position)
{
    FaceImages images;
    images.Low = max(position - _WallsLow, 0.0);
    images.High = max(_WallsHigh - position, 0.0);
    const bool3 low = images.Low * _InverseSupport < 1.0;
    const bool3 high = images.High * _InverseSupport < 1.0;
    images.Faces = (low.x ? 1u : 0u) | (low.y ? 2u : 0u) | (low.z ? 4u : 0u) | (high.x ? 8u : 0u) | (high.y ? 16u : 0u) |
        (high.z ? 32u : 0u);
    return images;
}

bool3 MaskOf(uint axes)
{
    return bool3((axes & 1u) != 0u, (axes & 2u) != 0u, (axes & 4u) != 0u);
}

// Runs through every set of faces but the empty one.
#define FOR_EACH_IMAGE(images, set) for (uint set = (images).Faces; set != 0u; set = (set - 1u) & (images).Faces)

// The image of what is d away, in a set of faces. Of two that look at each other there is none.
FaceImage ImageOf(FaceImages images, uint set, float3 d, float distanceSquared)
{
    const bool3 isLow = MaskOf(set);
    const bool3 isHigh = MaskOf(set >> 3u);
    const bool3 isMirrored = MaskOf(set | set >> 3u);
    const float3 own = isLow ? images.Low : isHigh ? images.High : 0.0;
    const float3 others = isLow ? max(images.Low - d, 0.0) : isHigh ? max(images.High + d, 0.0) : 0.0;
    const float3 apart = isLow ? own + others : -(own + others);
    FaceImage image;
    image.Separation = isMirrored ? apart : d;
    image.Mirror = isMirrored ? -1.0 : 1.0;
    image.DistanceSquared = (set & set >> 3u) != 0u ? 1.0 / (_InverseSupport * _InverseSupport)
        : distanceSquared + 4.0 * dot(own, others);
    return image;
}

#endif
