using System.Collections.Generic;
using System;
using Headless.Engine;

namespace UnityEngine;

public sealed partial class Mesh
{
    private readonly List<BlendShape> shapes = [];
    private BoneWeight[] weights = [];
    private Matrix4x4[] poses = [];

    public int bindposeCount => poses.Length;
    public int blendShapeCount => shapes.Count;

    public BoneWeight[] boneWeights
    {
        get => [.. weights];
        set
        {
            if (value.Length != 0 && value.Length != vertexCount)
            {
                Debug.LogError("Mesh.boneWeights is out of bounds. The supplied array needs to be the same size as the Mesh.vertices array.");
                return;
            }

            weights = [.. value];
        }
    }

    public Matrix4x4[] bindposes
    {
        get => [.. poses];
        set => poses = [.. value];
    }

    internal IReadOnlyList<BoneWeight> BoneWeights => weights;
    internal IReadOnlyList<Matrix4x4> Bindposes => poses;
    internal IReadOnlyList<BlendShape> BlendShapes => shapes;

    public void GetBoneWeights(List<BoneWeight> boneWeights) => Fill(boneWeights, weights);

    public void GetBindposes(List<Matrix4x4> bindposes) => Fill(bindposes, poses);

    public void AddBlendShapeFrame(string shapeName, float frameWeight, Vector3[] deltaVertices, Vector3[] deltaNormals, Vector3[] deltaTangents)
    {
        if (deltaVertices.Length != vertexCount)
        {
            throw new ArgumentException($"Mesh '{name}' has {vertexCount} vertices, but {deltaVertices.Length} offsets were given.", nameof(deltaVertices));
        }

        int index = GetBlendShapeIndex(shapeName);
        BlendShape shape = index < 0 ? new BlendShape(shapeName) : shapes[index];
        if (shape.Frames.Count > 0 && frameWeight <= shape.Frames[^1].Weight)
        {
            throw new ArgumentException("Frames of a blend shape are added in rising order of their weights.", nameof(frameWeight));
        }

        shape.Add(new BlendShape.Frame(frameWeight, [.. deltaVertices], deltaNormals is null ? null : [.. deltaNormals], deltaTangents is null ? null : [.. deltaTangents]));
        if (index < 0)
        {
            shapes.Add(shape);
        }
    }

    public void ClearBlendShapes() => shapes.Clear();

    public int GetBlendShapeIndex(string blendShapeName) => shapes.FindIndex(s => s.Name == blendShapeName);

    public string GetBlendShapeName(int shapeIndex) => shapes[shapeIndex].Name;

    public int GetBlendShapeFrameCount(int shapeIndex) => shapes[shapeIndex].Frames.Count;

    public float GetBlendShapeFrameWeight(int shapeIndex, int frameIndex) => shapes[shapeIndex].Frames[frameIndex].Weight;

    public void GetBlendShapeFrameVertices(int shapeIndex, int frameIndex, Vector3[] deltaVertices, Vector3[] deltaNormals, Vector3[] deltaTangents)
    {
        BlendShape.Frame frame = shapes[shapeIndex].Frames[frameIndex];
        frame.Vertices.CopyTo(deltaVertices, 0);
        if (deltaNormals is not null)
        {
            frame.Normals?.CopyTo(deltaNormals, 0);
        }

        if (deltaTangents is not null)
        {
            frame.Tangents?.CopyTo(deltaTangents, 0);
        }
    }

    /// <summary>Becomes another mesh's vertices and triangles, without its bones and shapes.</summary>
    internal void CopyFrom(Mesh other)
    {
        store.CopyFrom(other.store);
        (format, indices, meshBounds) = (other.format, [.. other.indices], other.meshBounds);
        subMeshes.Clear();
        subMeshes.AddRange(other.subMeshes);
        Changed();
    }

    private void ClearSkin()
    {
        shapes.Clear();
        (weights, poses) = ([], []);
    }

    private void CopySkin(Mesh from)
    {
        shapes.AddRange(from.shapes);
        (weights, poses) = (from.weights, from.poses);
    }
}
