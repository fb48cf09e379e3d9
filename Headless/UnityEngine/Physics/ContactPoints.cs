using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Points of a collider, with a radius about each, that its body touches others with.</summary>
static class ContactPoints
{
    public static IEnumerable<(Vector3 point, float radius)> Of(Collider collider)
    {
        Transform at = collider.transform;
        var scale = new Vector3(Mathf.Abs(at.lossyScale.x), Mathf.Abs(at.lossyScale.y), Mathf.Abs(at.lossyScale.z));
        switch (collider)
        {
            case BoxCollider box:
                for (int corner = 0; corner < 8; corner++)
                {
                    var sign = new Vector3((corner & 1) - 0.5f, (corner >> 1 & 1) - 0.5f, (corner >> 2 & 1) - 0.5f);
                    yield return (at.TransformPoint(box.center + Vector3.Scale(sign, box.size)), 0f);
                }
                break;
            case SphereCollider sphere:
                yield return (at.TransformPoint(sphere.center), sphere.radius * Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z)));
                break;
            case CapsuleCollider capsule:
                float radius = capsule.radius * Mathf.Max(scale[(capsule.direction + 1) % 3], scale[(capsule.direction + 2) % 3]);
                Vector3 half = Vector3.zero;
                half[capsule.direction] = Mathf.Max(0f, 0.5f * capsule.height * scale[capsule.direction] - radius);
                yield return (at.TransformPoint(capsule.center) + at.rotation * half, radius);
                yield return (at.TransformPoint(capsule.center) - at.rotation * half, radius);
                break;
            case MeshCollider { sharedMesh: not null } mesh:
                foreach (Vector3 vertex in mesh.sharedMesh.vertices) yield return (at.TransformPoint(vertex), 0f);
                break;
        }
    }
}
