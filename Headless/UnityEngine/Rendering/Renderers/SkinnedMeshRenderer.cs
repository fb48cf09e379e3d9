using System;
using System.Collections.Generic;
using System.Linq;
using Headless.Engine;

namespace UnityEngine;

public class SkinnedMeshRenderer : Renderer
{
    private readonly Dictionary<int, float> shapeWeights = [];
    private Mesh? mesh;
    private Mesh? drawn;
    private Matrix4x4[] drawnBones = [];
    private float[] drawnWeights = [];
    private Mesh? drawnOf;

    public Mesh? sharedMesh
    {
        get => mesh != null ? mesh : null;
        set => mesh = value;
    }

    public Transform[] bones { get; set; } = [];
    public Transform? rootBone { get; set; }
    public SkinQuality quality { get; set; } = SkinQuality.Auto;
    public bool updateWhenOffscreen { get; set; }
    public bool forceMatrixRecalculationPerRender { get; set; }
    public bool skinnedMotionVectors { get; set; } = true;

    internal override Mesh? MeshOfBounds => sharedMesh;

    internal override Matrix4x4 BoundsToWorld => (rootBone != null ? rootBone : transform).localToWorldMatrix;

    /// <summary>The skin as it is now; made anew only when a bone, a shape or the mesh changed.</summary>
    internal override Mesh? MeshToDraw
    {
        get
        {
            if (sharedMesh is null)
            {
                return null;
            }

            Matrix4x4[] matrices = BoneMatrices(transform.worldToLocalMatrix);
            float[] weights = [.. Enumerable.Range(0, mesh!.blendShapeCount).Select(GetBlendShapeWeight)];
            if (drawn == null || !ReferenceEquals(drawnOf, mesh) || !matrices.AsSpan().SequenceEqual(drawnBones) || !weights.AsSpan().SequenceEqual(drawnWeights))
            {
                drawn = drawn != null ? drawn : new Mesh { name = mesh.name, hideFlags = HideFlags.HideAndDontSave };
                (drawnOf, drawnBones, drawnWeights) = (mesh, matrices, weights);
                Bake(drawn, Matrix4x4.identity, matrices);
            }

            return drawn;
        }
    }

    public float GetBlendShapeWeight(int index) => shapeWeights.GetValueOrDefault(index);

    public void SetBlendShapeWeight(int index, float value) => shapeWeights[index] = value;

    public void BakeMesh(Mesh mesh) => BakeMesh(mesh, false);

    public void BakeMesh(Mesh mesh, bool useScale)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (sharedMesh is null)
        {
            mesh.Clear();
            return;
        }

        Matrix4x4 toTransform = useScale ? transform.worldToLocalMatrix : Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one).inverse;
        Bake(mesh, toTransform * transform.localToWorldMatrix, BoneMatrices(toTransform));
    }

    internal override void OnRemoved()
    {
        base.OnRemoved();
        if (drawn != null)
        {
            DestroyImmediate(drawn);
        }

        drawn = null;
    }

    private Matrix4x4[] BoneMatrices(Matrix4x4 worldToLocal)
    {
        IReadOnlyList<Matrix4x4> poses = mesh!.Bindposes;
        var matrices = new Matrix4x4[Math.Min(bones.Length, poses.Count)];
        for (int i = 0; i < matrices.Length; i++)
        {
            matrices[i] = (bones[i] != null ? worldToLocal * bones[i].localToWorldMatrix : Matrix4x4.identity) * poses[i];
        }

        return matrices;
    }

    // unskinned: where vertices go that no bone moves.
    private void Bake(Mesh target, Matrix4x4 unskinned, Matrix4x4[] matrices)
    {
        Vector3[] vertices = mesh!.vertices;
        Vector3[] normals = mesh.normals;
        for (int shape = 0; shape < mesh.blendShapeCount; shape++)
        {
            mesh.BlendShapes[shape].AddTo(GetBlendShapeWeight(shape), vertices, normals);
        }

        IReadOnlyList<BoneWeight> weights = mesh.BoneWeights;
        bool isSkinned = matrices.Length > 0 && weights.Count == vertices.Length;
        for (int i = 0; i < vertices.Length; i++)
        {
            Matrix4x4 matrix = isSkinned ? Mix(weights[i], matrices) : unskinned;
            vertices[i] = matrix.MultiplyPoint3x4(vertices[i]);
            if (i < normals.Length)
            {
                normals[i] = matrix.MultiplyVector(normals[i]).normalized;
            }
        }

        target.CopyFrom(mesh);
        target.vertices = vertices;
        if (normals.Length > 0)
        {
            target.normals = normals;
        }

        target.RecalculateBounds();
    }

    private static Matrix4x4 Mix(in BoneWeight weight, Matrix4x4[] matrices)
    {
        Matrix4x4 mixed = default;
        Add(ref mixed, weight.weight0, weight.boneIndex0, matrices);
        Add(ref mixed, weight.weight1, weight.boneIndex1, matrices);
        Add(ref mixed, weight.weight2, weight.boneIndex2, matrices);
        Add(ref mixed, weight.weight3, weight.boneIndex3, matrices);
        return mixed;
    }

    private static void Add(ref Matrix4x4 sum, float weight, int bone, Matrix4x4[] matrices)
    {
        if (weight == 0f || (uint)bone >= (uint)matrices.Length)
        {
            return;
        }

        for (int i = 0; i < 16; i++)
        {
            sum[i] += weight * matrices[bone][i];
        }
    }
}
