using System.Numerics;
using Headless.Importers;
using Headless.Importers.Models;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class ObjFileTests
{
    private const string Quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    private static MeshGeometry Import(string text, ModelSettings? settings = null)
    {
        ObjFile file = ObjFile.Parse(text, "t.obj");
        return ObjGeometryBuilder.Build(file, file.Groups[0], settings ?? new ModelSettings());
    }

    [Test]
    public void XIsNegatedAndTheWindingFlipped()
    {
        MeshGeometry mesh = Import("v 1 2 3\nv 4 2 3\nv 1 5 3\nf 1 2 3\n");
        Assert.That(mesh.SubMeshes[0].Select(i => mesh.Vertices[i]), Is.EqualTo(new[] { new Vector3(-1, 2, 3), new Vector3(-1, 5, 3), new Vector3(-4, 2, 3) }));
        Assert.That(mesh.Normals, Is.All.EqualTo(Vector3.UnitZ));
    }

    [Test]
    public void QuadsAreTriangulatedAndVerticesWelded()
    {
        MeshGeometry mesh = Import(Quad + "f 1 2 3 4\n");
        Assert.That(mesh.Vertices, Has.Count.EqualTo(4));
        Assert.That(mesh.SubMeshes[0], Has.Count.EqualTo(6));
    }

    [Test]
    public void WeldingCanBeOff() =>
        Assert.That(Import(Quad + "f 1 2 3 4\n", new ModelSettings { WeldVertices = false }).Vertices, Has.Count.EqualTo(6));

    [Test]
    public void NormalsOfTheFileAreMirrored()
    {
        MeshGeometry mesh = Import("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n");
        Assert.That(mesh.Normals, Is.All.EqualTo(new Vector3(-0.6f, 0, 0.8f)));
    }

    [Test]
    public void TheSmoothingAngleDecidesBetweenSmoothAndHardEdges()
    {
        const string fold = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -1\nf 1 3 2\nf 1 2 4\n";
        Assert.That(Import(fold, new ModelSettings { SmoothingAngle = 60 }).Vertices, Has.Count.EqualTo(6));
        Assert.That(Import(fold, new ModelSettings { SmoothingAngle = 120 }).Vertices, Has.Count.EqualTo(4));
    }

    [Test]
    public void NormalsCanBeLeftOut() =>
        Assert.That(Import(Quad + "f 1 2 3 4\n", new ModelSettings { Normals = ModelNormals.None }).Normals, Is.Empty);

    [Test]
    public void IndicesCountFromTheEndWhenNegative()
    {
        MeshGeometry mesh = Import("v 9 9 9\n" + Quad + "vt 0 0\nvt 1 0\nvt 1 1\nf -4/-3 -3/-2 -2/-1\n");
        Assert.That(mesh.Vertices, Has.Count.EqualTo(3));
        Assert.That(mesh.TextureCoordinates, Is.EqualTo(new[] { new Vector2(0, 0), new Vector2(1, 1), new Vector2(1, 0) }));
    }

    // tinyobjloader's catmark_torus_creases0.obj and trimesh's cubevt.obj are written so.
    [Test]
    public void FacesMayNameWhatComesBehindThem()
    {
        const string face = "f 1/1/1 2/2/1 3/3/1\n", places = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", coordinates = "vt 0 0\nvt 1 0\nvt 0 1\n", normal = "vn 0.6 0 0.8\n";
        MeshGeometry usual = Import(places + coordinates + normal + face), normalsLast = Import(places + coordinates + face + normal), facesFirst = Import(face + normal + coordinates + places);
        foreach (MeshGeometry mesh in (MeshGeometry[])[normalsLast, facesFirst])
        {
            Assert.That(mesh.Vertices, Is.EqualTo(usual.Vertices));
            Assert.That(mesh.Normals, Is.EqualTo(usual.Normals).And.All.EqualTo(new Vector3(-0.6f, 0, 0.8f)));
            Assert.That(mesh.TextureCoordinates, Is.EqualTo(usual.TextureCoordinates));
            Assert.That(mesh.SubMeshes[0], Is.EqualTo(usual.SubMeshes[0]));
        }
    }

    [Test]
    public void GroupsNameMeshesAndObjectsDoNot()
    {
        Assert.That(ObjFile.Parse("o Cube\n" + Quad + "f 1 2 3\n", "t.obj").Groups.Select(g => g.Name), Is.EqualTo(new[] { "default" }));
        Assert.That(ObjFile.Parse(Quad + "g left\nf 1 2 3\ng right\nf 1 3 4\ng left\nf 2 3 4\n", "t.obj").Groups.Select(g => (g.Name, g.Faces.Count)),
            Is.EqualTo(new[] { ("left", 2), ("right", 1) }));
    }

    [Test]
    public void MaterialsMakeSubmeshes() =>
        Assert.That(Import(Quad + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl a\nf 2 3 4\n").SubMeshes.Select(s => s.Count), Is.EqualTo(new[] { 6, 3 }));

    [Test]
    public void ScaleIsApplied() =>
        Assert.That(Import(Quad + "f 1 2 3 4\n", new ModelSettings { Scale = 2 }).Vertices.Max(v => v.Y), Is.EqualTo(2));

    [TestCase("v 0 0 0\nf 1 2 3\n", "t.obj:2: vertex index 2 is outside the 1 of the file.")]
    [TestCase("f 1 -1 2\nv 0 0 0\nv 1 0 0\n", "t.obj:1: vertex index -1 is outside the 0 read so far.")]
    [TestCase(Quad + "f 1 2 0\n", "t.obj:5: vertex index 0 is outside the 4 read so far.")]
    [TestCase(Quad + "f 1/2 2/2 3/2\nvt 0 0\n", "t.obj:5: texture coordinate index 2 is outside the 1 of the file.")]
    [TestCase(Quad + "f 1//1 2//1 3//2147483647\nvn 0 0 1\n", "t.obj:5: normal index 2147483647 is outside the 1 of the file.")]
    [TestCase("v 0 0\n", "t.obj:1: 'v' needs a finite number as its component 3, found ''.")]
    [TestCase("v 0 0 nan\n", "t.obj:1: 'v' needs a finite number as its component 3, found 'nan'.")]
    [TestCase(Quad + "f 1 2\n", "t.obj:5: a face needs at least 3 corners, found 2.")]
    [TestCase(Quad + "f 1 2 x\n", "t.obj:5: 'x' is not a vertex index.")]
    public void BadLinesAreNamed(string text, string message) =>
        Assert.That(() => ObjFile.Parse(text, "t.obj"), Throws.TypeOf<ImportException>().With.Message.StartsWith(message + " ").And.Message.Contains("export the model again"));
}
