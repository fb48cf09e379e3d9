using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Skinned meshes as walls: found by a Fluid Collider, placed where they are drawn, followed as their bones move.</summary>
    public sealed class SkinnedWallsTests
    {
        private readonly List<Object> made = new List<Object>();
        private readonly List<WallSpec> skins = new List<WallSpec>();
        private CollisionScene scene;

        [SetUp]
        public void SetUp() => scene = new CollisionScene();

        [TearDown]
        public void TearDown()
        {
            scene.Dispose();
            foreach (Object item in made) Object.DestroyImmediate(item);
            made.Clear();
            skins.Clear();
        }

        private T Made<T>(T item) where T : Object
        {
            made.Add(item);
            return item;
        }

        // A cube whose upper corners go with one bone and whose lower ones with another.
        private SkinnedMeshRenderer Skin(out Transform upper)
        {
            GameObject holder = Made(new GameObject("figure"));
            Transform Bone(string name, float y)
            {
                var bone = new GameObject(name).transform;
                bone.SetParent(holder.transform, false);
                bone.localPosition = y * Vector3.up;
                return bone;
            }
            Transform[] bones = { Bone("lower", -0.5f), Bone("upper", 0.5f) };
            Mesh mesh = Made(TestMeshes.Cube());
            mesh.boneWeights = mesh.vertices.Select(v => new BoneWeight { boneIndex0 = v.y > 0f ? 1 : 0, weight0 = 1f }).ToArray();
            mesh.bindposes = bones.Select(b => b.worldToLocalMatrix * holder.transform.localToWorldMatrix).ToArray();
            SkinnedMeshRenderer renderer = holder.AddComponent<SkinnedMeshRenderer>();
            renderer.sharedMesh = mesh;
            renderer.bones = bones;
            renderer.localBounds = new Bounds(Vector3.zero, 3f * Vector3.one);
            FluidCollider settings = holder.AddComponent<FluidCollider>();
            settings.SkinnedMeshes = true;
            skins.Add(((IFluidPart<WallSpec>)settings).Spec);
            upper = bones[1];
            return renderer;
        }

        private bool Gather(int layers = ~0) => scene.Gather(new CollisionQuery
        {
            Scene = Physics.defaultPhysicsScene,
            Position = new Vector3(0f, 0f, 1f),
            Rotation = Quaternion.Euler(0f, 90f, 0f),
            DomainSize = 6f * Vector3.one,
            Spacing = 0.1f,
            Layers = layers,
            Walls = skins,
        });

        [Test]
        public void CornersAreWhereTheSkinIsDrawn()
        {
            SkinnedMeshRenderer renderer = Skin(out Transform upper);
            renderer.transform.localScale = new Vector3(1f, 2f, 0.5f);
            renderer.transform.position = new Vector3(0.2f, 0f, 0.9f);
            upper.localPosition += new Vector3(0.3f, 0.1f, 0f);
            Assert.That(Gather(), Is.True);
            FluidObstacle solid = scene.Solids.Single(s => s.Source == renderer);
            Vector3[] rest = renderer.sharedMesh.vertices;
            Matrix4x4 toSimulation = DomainSpace.FromWorld(new Vector3(0f, 0f, 1f), Quaternion.Euler(0f, 90f, 0f)) *
                renderer.transform.localToWorldMatrix;
            for (int i = 0; i < rest.Length; i++)
            {
                Vector3 expected = rest[i].y > 0f ? rest[i] + new Vector3(0.3f, 0.1f, 0f) : rest[i];
                Assert.That((solid.Mesh.Vertices[i] - toSimulation.MultiplyPoint3x4(expected)).magnitude, Is.LessThan(2e-6f),
                    $"corner {i}");
            }
            Assert.That(solid.Mesh.IsClosed, Is.True);
        }

        [Test]
        public void ASkinThatRestsIsNoChangeAndOneThatMovesDeforms()
        {
            SkinnedMeshRenderer renderer = Skin(out Transform upper);
            Gather();
            var motion = new BodyMotion(scene.Solids.Single(s => s.Source == renderer));
            Assert.That(Gather(), Is.False);
            for (int frame = 1; frame < 5; frame++)
            {
                upper.localPosition += 0.05f * Vector3.right;
                motion.Arrive();
                Assert.That(Gather(), Is.True);
                FluidObstacle solid = scene.Solids.Single(s => s.Source == renderer);
                Assert.That(motion.MoveTo(solid), Is.EqualTo(frame == 1 ? BodyFollowing.CellsOutgrown : BodyFollowing.Followed));
                Assert.That(motion.Deformation.Longest, Is.EqualTo(0.05f).Within(1e-5f));
            }
        }

        [Test]
        public void OnlySkinsThatAreAskedForAreWalls()
        {
            SkinnedMeshRenderer renderer = Skin(out _);
            bool IsWall(int layers = ~0)
            {
                Gather(layers);
                return scene.Solids.Any(s => s.Source == renderer);
            }
            Assert.That(IsWall(), Is.True);
            Assert.That(IsWall(~1), Is.False, "of another layer");
            renderer.enabled = false;
            Assert.That(IsWall(), Is.False, "not drawn");
            renderer.enabled = true;
            renderer.transform.position = 20f * Vector3.right;
            Assert.That(IsWall(), Is.False, "far off");
            renderer.transform.position = Vector3.zero;
            var settings = renderer.GetComponent<FluidCollider>();
            settings.enabled = false;
            Assert.That(IsWall(), Is.False, "the component is off");
            settings.enabled = true;
            settings.SkinnedMeshes = false;
            skins[0] = ((IFluidPart<WallSpec>)settings).Spec;
            Assert.That(IsWall(), Is.False, "not asked for");
        }

        [Test]
        public void ASkinOfTooManyVerticesIsNamed()
        {
            SkinnedMeshRenderer renderer = Skin(out _);
            renderer.sharedMesh = Made(new Mesh { name = "detailed", vertices = new Vector3[SkinnedWalls.MostVertices + 1] });
            Gather();
            Assert.That(scene.Solids.Any(s => s.Source == renderer), Is.False);
            FluidMessage message = scene.Messages.Single(m => m.Context == renderer);
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.TooManyTriangles));
            Assert.That(message.Text, Does.Contain("'detailed'").And.Contain("20001 vertices"));
            Assert.That(message.Cure, Does.Contain("Capsule"));
        }
    }
}
