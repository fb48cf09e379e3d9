using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Rendering;

/// <summary>Skinned meshes as Unity documents them: bones, bind poses, blend shapes, and BakeMesh with and without the transform's scale.</summary>
public sealed class SkinnedMeshTests : SceneFixture
{
    private static readonly Vector3[] Corners = [new(-1f, 0f, 0f), new(0f, 2f, 0f), new(1f, 0f, 0f)];

    private static SkinnedMeshRenderer Make(out Transform[] bones)
    {
        var holder = new GameObject("Skin");
        holder.transform.position = new Vector3(3f, 0f, 0f);
        holder.transform.localScale = new Vector3(1f, 2f, 1f);
        bones = [new GameObject("A").transform, new GameObject("B").transform];
        foreach (Transform bone in bones)
        {
            bone.SetParent(holder.transform, false);
        }

        var mesh = new Mesh { vertices = Corners, normals = [Vector3.back, Vector3.back, Vector3.back], triangles = [0, 1, 2] };
        mesh.boneWeights =
        [
            new BoneWeight { boneIndex0 = 0, weight0 = 1f },
            new BoneWeight { boneIndex0 = 0, weight0 = 0.25f, boneIndex1 = 1, weight1 = 0.75f },
            new BoneWeight { boneIndex0 = 1, weight0 = 1f },
        ];
        mesh.bindposes = [.. bones.Select(b => b.worldToLocalMatrix * holder.transform.localToWorldMatrix)];
        mesh.AddBlendShapeFrame("Tall", 100f, [Vector3.zero, Vector3.up, Vector3.zero], null!, null!);
        SkinnedMeshRenderer renderer = holder.AddComponent<SkinnedMeshRenderer>();
        (renderer.sharedMesh, renderer.bones) = (mesh, bones);
        return renderer;
    }

    private static Vector3[] Baked(SkinnedMeshRenderer renderer, bool useScale)
    {
        var mesh = new Mesh();
        renderer.BakeMesh(mesh, useScale);
        Assert.That(mesh.triangles, Is.EqualTo(new[] { 0, 1, 2 }));
        return mesh.vertices;
    }

    [Test]
    public void CornersGoWithTheirBonesByWeight()
    {
        SkinnedMeshRenderer renderer = Make(out Transform[] bones);
        Assert.That(Baked(renderer, true), Is.EqualTo(Corners));
        bones[1].localPosition = new Vector3(0f, 0f, 4f);
        Assert.That(Baked(renderer, true), Is.EqualTo(new[] { Corners[0], new Vector3(0f, 2f, 3f), new Vector3(1f, 0f, 4f) }));
        Assert.That(Baked(renderer, false), Is.EqualTo(new[] { Corners[0], new Vector3(0f, 4f, 3f), new Vector3(1f, 0f, 4f) }), "with the transform's scale in it");
    }

    [Test]
    public void BlendShapesComeBeforeBones()
    {
        SkinnedMeshRenderer renderer = Make(out Transform[] bones);
        renderer.SetBlendShapeWeight(renderer.sharedMesh!.GetBlendShapeIndex("Tall"), 50f);
        bones[0].localRotation = bones[1].localRotation = Quaternion.Euler(0f, 0f, 180f);
        Vector3 top = Baked(renderer, true)[1];
        Assert.That((top - new Vector3(0f, -2.5f, 0f)).magnitude, Is.LessThan(1e-5f));
    }

    [Test]
    public void ItIsDrawnWhereItsBonesAre()
    {
        SkinnedMeshRenderer renderer = Make(out Transform[] bones);
        bones[0].localPosition = bones[1].localPosition = new Vector3(0f, 0f, 2f);
        Mesh drawn = renderer.MeshToDraw!;
        Assert.That(drawn.vertices[0], Is.EqualTo(new Vector3(-1f, 0f, 2f)));
        Assert.That(renderer.MeshToDraw, Is.SameAs(drawn));
        bones[0].localPosition = Vector3.zero;
        Assert.That(renderer.MeshToDraw!.vertices[0], Is.EqualTo(Corners[0]));
        Assert.That(renderer.sharedMesh!.vertices, Is.EqualTo(Corners), "the mesh stays as it is");
    }
}
