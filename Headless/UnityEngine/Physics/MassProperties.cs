using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Centre of mass and moments of inertia that Unity works out for a body: its colliders are filled evenly with its mass.</summary>
readonly record struct MassProperties(Vector3 Center, Vector3 Moments, Quaternion Axes)
{
    public static MassProperties Of(Rigidbody body)
    {
        var sum = new MassSum();
        foreach (Collider collider in body.gameObject.GetComponentsInChildren<Collider>())
            if (collider.enabled && !collider.isTrigger && ReferenceEquals(collider.attachedRigidbody, body)) Add(ref sum, collider, body);
        return sum.Volume <= 0.0 ? new MassProperties(Vector3.zero, Vector3.one, Quaternion.identity) : sum.Spread(body.mass);
    }

    static void Add(ref MassSum sum, Collider collider, Rigidbody body)
    {
        Transform own = body.transform;
        Quaternion back = Quaternion.Inverse(own.rotation);
        Transform at = collider.transform;
        var scale = new Vector3(Mathf.Abs(at.lossyScale.x), Mathf.Abs(at.lossyScale.y), Mathf.Abs(at.lossyScale.z));
        Vector3 Place(Vector3 local) => back * (at.TransformPoint(local) - own.position);
        Quaternion turn = back * at.rotation;
        switch (collider)
        {
            case BoxCollider box:
                Vector3 size = Vector3.Scale(box.size, scale);
                sum.Add(size.x * size.y * size.z, Place(box.center), turn,
                    new Vector3(size.y * size.y + size.z * size.z, size.z * size.z + size.x * size.x, size.x * size.x + size.y * size.y) / 12f);
                break;
            case SphereCollider sphere:
                float r = sphere.radius * Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z));
                sum.Add(4f / 3f * Mathf.PI * r * r * r, Place(sphere.center), turn, 0.4f * r * r * Vector3.one);
                break;
            case CapsuleCollider capsule:
                AddCapsule(ref sum, capsule, scale, Place(capsule.center), turn);
                break;
            case MeshCollider { sharedMesh: not null } mesh:
                AddMesh(ref sum, mesh.sharedMesh, Place);
                break;
        }
    }

    // A cylinder and two half balls, whose centres of mass are 3/8 r from their flat sides.
    static void AddCapsule(ref MassSum sum, CapsuleCollider capsule, Vector3 scale, Vector3 center, Quaternion turn)
    {
        int axis = capsule.direction;
        float r = capsule.radius * Mathf.Max(scale[(axis + 1) % 3], scale[(axis + 2) % 3]);
        float length = Mathf.Max(0f, capsule.height * scale[axis] - 2f * r);
        float cylinder = Mathf.PI * r * r * length, ball = 4f / 3f * Mathf.PI * r * r * r;
        float along = (cylinder * 0.5f + ball * 0.4f) * r * r;
        float across = cylinder * (r * r / 4f + length * length / 12f) + ball * (0.4f * r * r + 0.375f * length * r + 0.25f * length * length);
        Vector3 moments = across / (cylinder + ball) * Vector3.one;
        moments[axis] = along / (cylinder + ball);
        sum.Add(cylinder + ball, center, turn, moments);
    }

    // Tetrahedra from the origin over the triangles, with signs (B. Mirtich 1996).
    static void AddMesh(ref MassSum sum, Mesh mesh, Func<Vector3, Vector3> place)
    {
        Vector3[] vertices = Array.ConvertAll(mesh.vertices, v => place(v));
        int[] triangles = mesh.triangles;
        for (int i = 0; i + 2 < triangles.Length; i += 3) sum.AddTetrahedron(vertices[triangles[i]], vertices[triangles[i + 1]], vertices[triangles[i + 2]]);
    }
}
