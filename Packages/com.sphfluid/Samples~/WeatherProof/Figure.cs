using System;
using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// A figure in a raincoat and a hat that sways: a skinned mesh, made when the scene begins, and the bones of its spine.
    /// </summary>
    [RequireComponent(typeof(SkinnedMeshRenderer))]
    public sealed class Figure : MonoBehaviour
    {
        private const int Sides = 28;

        // Radius and height of the outline from the feet to the tip of the hat [m].
        private static readonly Vector2[] Outline =
        {
            new Vector2(0f, 0f), new Vector2(0.12f, 0f), new Vector2(0.15f, 0.02f), new Vector2(0.14f, 0.12f), new Vector2(0.12f, 0.24f),
            new Vector2(0.105f, 0.34f),
            new Vector2(0.11f, 0.42f), new Vector2(0.12f, 0.48f), new Vector2(0.105f, 0.54f), new Vector2(0.06f, 0.575f),
            new Vector2(0.05f, 0.6f), new Vector2(0.075f, 0.63f),
            new Vector2(0.085f, 0.67f), new Vector2(0.17f, 0.655f), new Vector2(0.215f, 0.64f), new Vector2(0.22f, 0.65f),
            new Vector2(0.17f, 0.68f), new Vector2(0.09f, 0.705f),
            new Vector2(0.085f, 0.75f), new Vector2(0.06f, 0.79f), new Vector2(0f, 0.8f),
        };

        private static readonly float[] Joints = { 0f, 0.2f, 0.4f, 0.6f }; // heights of the bones, m

        [SerializeField, Min(0f), Tooltip("Swings to and fro a second [1/s].")]
        private float frequency = 0.6f;

        [SerializeField, Range(0f, 30f), Tooltip("How far each bone turns [degrees].")]
        private float swing = 7f;

        private Transform[] bones;
        private Mesh mesh;
        private float time;

        private void Awake()
        {
            bones = new Transform[Joints.Length];
            for (int i = 0; i < bones.Length; i++)
            {
                bones[i] = new GameObject("Bone " + i).transform;
                bones[i].SetParent(i == 0 ? transform : bones[i - 1], false);
                bones[i].localPosition = (i == 0 ? Joints[0] : Joints[i] - Joints[i - 1]) * Vector3.up;
            }
            mesh = MakeMesh();
            mesh.bindposes = Array.ConvertAll(bones, b => b.worldToLocalMatrix * transform.localToWorldMatrix);
            var skin = GetComponent<SkinnedMeshRenderer>();
            skin.sharedMesh = mesh;
            skin.bones = bones;
            skin.rootBone = transform;
            skin.localBounds = new Bounds(0.4f * Vector3.up, 1.6f * Vector3.one);
        }

        private void Update()
        {
            time += Time.deltaTime;
            float gentle = Mathf.SmoothStep(0f, 1f, time);
            for (int i = 1; i < bones.Length; i++)
            {
                float phase = 2f * Mathf.PI * frequency * time - 0.7f * i;
                bones[i].localRotation = Quaternion.Euler(0.6f * gentle * swing * Mathf.Sin(2f * phase), gentle * swing * Mathf.Sin(phase),
                    gentle * swing * Mathf.Sin(phase));
            }
        }

        private void OnDestroy() => Destroy(mesh);

        // Closed: a ring of corners for each point of the outline, and one corner at each end.
        private static Mesh MakeMesh()
        {
            int rings = Outline.Length - 2;
            var vertices = new Vector3[Sides * rings + 2];
            var weights = new BoneWeight[vertices.Length];
            for (int ring = 0; ring < rings; ring++)
                for (int side = 0; side < Sides; side++)
                {
                    float angle = 2f * Mathf.PI * side / Sides;
                    Vector2 point = Outline[ring + 1];
                    vertices[ring * Sides + side] = new Vector3(point.x * Mathf.Cos(angle), point.y, point.x * Mathf.Sin(angle));
                }
            int feet = Sides * rings, tip = feet + 1;
            vertices[feet] = Outline[0].y * Vector3.up;
            vertices[tip] = Outline[rings + 1].y * Vector3.up;
            for (int i = 0; i < vertices.Length; i++) weights[i] = WeightAt(vertices[i].y);

            var triangles = new int[6 * Sides * rings];
            int at = 0;
            void Add(int a, int b, int c)
            {
                triangles[at++] = a;
                triangles[at++] = b;
                triangles[at++] = c;
            }
            for (int side = 0; side < Sides; side++)
            {
                int next = (side + 1) % Sides, top = (rings - 1) * Sides;
                Add(feet, side, next);
                Add(tip, top + next, top + side);
                for (int ring = 0; ring < rings - 1; ring++)
                {
                    int a = ring * Sides + side, b = ring * Sides + next;
                    Add(a, a + Sides, b);
                    Add(b, a + Sides, b + Sides);
                }
            }
            var made = new Mesh { name = "Figure", vertices = vertices, triangles = triangles, boneWeights = weights };
            made.RecalculateNormals();
            made.RecalculateBounds();
            return made;
        }

        // Between the bones below and above a height.
        private static BoneWeight WeightAt(float height)
        {
            int below = Joints.Length - 1;
            while (below > 0 && Joints[below] > height) below--;
            int above = Mathf.Min(below + 1, Joints.Length - 1);
            float share = above == below ? 0f : Mathf.SmoothStep(0f, 1f, (height - Joints[below]) / (Joints[above] - Joints[below]));
            return new BoneWeight { boneIndex0 = below, weight0 = 1f - share, boneIndex1 = above, weight1 = share };
        }
    }
}
