#if SPHFLUID_VEHICLES
using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Wheel Colliders as walls: found by a Fluid Collider or a script, where their wheels are, followed as they roll.</summary>
    public sealed class WheelDiscsTests
    {
        private const float Spacing = 0.05f;

        private readonly List<WallSpec> walls = new List<WallSpec>();
        private GameObject car;
        private WheelCollider wheel;
        private FluidCollider settings;
        private CollisionScene scene;

        [SetUp]
        public void SetUp()
        {
            scene = new CollisionScene();
            car = new GameObject("Car") { hideFlags = HideFlags.HideAndDontSave };
            car.AddComponent<Rigidbody>().isKinematic = true;
            settings = car.AddComponent<FluidCollider>();
            settings.WheelColliders = true;
            var holder = new GameObject("Front Left") { hideFlags = HideFlags.HideAndDontSave };
            holder.transform.SetParent(car.transform, false);
            wheel = holder.AddComponent<WheelCollider>();
            wheel.radius = 0.3f;
            wheel.suspensionDistance = 0.1f;
        }

        [TearDown]
        public void TearDown()
        {
            scene.Dispose();
            walls.Clear();
            Object.DestroyImmediate(car);
        }

        private bool Gather(int layers = ~0)
        {
            walls.Clear();
            if (settings.isActiveAndEnabled) walls.Add(((IFluidPart<WallSpec>)settings).Spec);
            return scene.Gather(new CollisionQuery
            {
                Scene = Physics.defaultPhysicsScene,
                Rotation = Quaternion.Euler(0f, 90f, 0f),
                DomainSize = 2f * Vector3.one,
                Spacing = Spacing,
                Layers = layers,
                Walls = walls,
            });
        }

        private FluidObstacle Found() => scene.Solids.SingleOrDefault(s => s.Source == wheel);

        [TestCase(0f, 0.195f)]
        [TestCase(0.1f, 0.1f)]
        public void ItIsACylinderAboutTheAxleOfItsWheel(float width, float expected)
        {
            settings.WheelWidth = width;
            wheel.center = new Vector3(0.1f, 0.05f, 0f);
            wheel.steerAngle = 25f;
            wheel.transform.SetPositionAndRotation(new Vector3(0.1f, 0.2f, -0.1f), Quaternion.Euler(20f, 30f, 10f));
            Assert.That(Gather(), Is.True);
            TriangleMesh mesh = Found().Mesh;
            wheel.GetWorldPose(out Vector3 position, out Quaternion rotation);
            Matrix4x4 toWheel = (DomainSpace.FromWorld(Vector3.zero, Quaternion.Euler(0f, 90f, 0f)) *
                Matrix4x4.TRS(position, rotation, Vector3.one)).inverse;
            Vector3[] corners = mesh.Vertices.Select(v => toWheel.MultiplyPoint3x4(v)).ToArray();
            float Radius(Vector3 p) => new Vector2(p.y, p.z).magnitude;
            Assert.That(corners.Max(c => Math.Abs(Math.Abs(c.x) - 0.5f * expected)), Is.LessThan(1e-5f));
            Assert.That(corners.Where(c => Radius(c) > 1e-4f).Max(c => Math.Abs(Radius(c) - 0.3f)), Is.LessThan(1e-5f));
            Assert.That(mesh.IsClosed, Is.True);
            Assert.That(TestMeshes.Volume(mesh), Is.EqualTo(Math.PI * 0.09 * expected).Within(2).Percent);
        }

        [Test]
        public void WithoutARigidbodyItIsAtTheCollidersCentre()
        {
            Object.DestroyImmediate(car.GetComponent<Rigidbody>());
            wheel.center = new Vector3(0.1f, 0.2f, 0f);
            Gather();
            Assert.That((Found().Mesh.Bounds.center - new Vector3(0f, 0.2f, 0.1f)).magnitude, Is.LessThan(0.005f),
                "in a domain that is turned by 90°");
        }

        [Test]
        public void OnlyWheelsThatAreAskedForAreWalls()
        {
            bool IsWall(int layers = ~0)
            {
                Gather(layers);
                return Found() != null;
            }
            Assert.That(IsWall(), Is.True);
            Assert.That(IsWall(~1), Is.False, "of another layer");
            wheel.enabled = false;
            Assert.That(IsWall(), Is.False, "off");
            wheel.enabled = true;
            car.transform.position = 20f * Vector3.right;
            Assert.That(IsWall(), Is.False, "far off");
            car.transform.position = Vector3.zero;
            Assert.That(IsWall(), Is.True);
            settings.WheelColliders = false;
            Gather();
            Assert.That(scene.Solids.Count(s => s.Source == wheel), Is.LessThanOrEqualTo(1), "what the overlap query reports");
        }

        [Test]
        public void AWheelThatRestsIsNoChangeAndOneThatRollsIsFollowed()
        {
            Gather();
            var motion = new BodyMotion(Found());
            Assert.That(Gather(), Is.False);
            for (int frame = 1; frame < 5; frame++)
            {
                car.transform.position += 0.1f * Vector3.forward;
                wheel.transform.rotation = Quaternion.Euler(19f * frame, 0f, 0f); // 0.1 m of the rim
                motion.Arrive();
                Assert.That(Gather(), Is.True);
                Assert.That(motion.MoveTo(Found()), Is.EqualTo(BodyFollowing.Followed));
                Assert.That((motion.IsStretched, motion.Deformation != null), Is.EqualTo((false, false)));
            }
            wheel.radius = 0.35f;
            Gather();
            Assert.That(motion.MoveTo(Found()), Is.EqualTo(BodyFollowing.Reshaped));
        }

        [Test]
        public void AWheelWithoutSizeIsNamed()
        {
            car.transform.localScale = new Vector3(1f, 0f, 1f);
            Gather();
            Assert.That(Found(), Is.Null);
            FluidMessage message = scene.Messages.Single();
            Assert.That(message.ToString(), Does.Contain("'Front Left'").And.Contain("WheelCollider").And.Contain("size"));
        }

        // A drop on top of a wheel that turns two and a half times a second is thrown the way its top goes, and none of it is inside.
        [Test]
        public void AWheelThatTurnsThrowsLiquidAndLetsNoneIn()
        {
            GpuTest.Require();
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                FluidRuleInput input = FluidRuleInput.Water;
                input.DomainSize = 2f * Vector3.one;
                input.Spacing = Spacing;
                input.LiquidHeight = 1f;
                input.LiquidDepth = 0.4f;
                FluidSolverSettings solverSettings = FluidRules.Derive(input);
                FluidParticle[] drop = ParticleSets.Lattice(new Vector3Int(4, 6, 4), Spacing, 0f, 1);
                wheel.suspensionDistance = 0f;
                wheel.GetWorldPose(out Vector3 hub, out _);
                for (int i = 0; i < drop.Length; i++) drop[i].Position += hub + (0.3f + 4f * Spacing) * Vector3.up;
                using (var solver = new FluidSolver(solverSettings, shaders, drop))
                using (var obstacles = new FluidObstacles(solver.Settings))
                {
                    obstacles.Add(wheel, 1f);
                    obstacles.Update(Matrix4x4.identity);
                    solver.SetObstacles(obstacles);
                    int perFrame = Mathf.CeilToInt(1f / 60f / solverSettings.TimeStep);
                    for (int frame = 1; frame <= 24; frame++)
                    {
                        wheel.transform.rotation = Quaternion.Euler(15f * frame, 0f, 0f);
                        obstacles.Update(Matrix4x4.identity);
                        GpuTest.Run(cmd => solver.RecordSteps(cmd, perFrame));
                    }
                    Assert.That(obstacles.Jumps, Is.Zero);
                    GpuTest.Run(cmd => solver.RecordNeighbourSetup(cmd));
                    FluidParticle[] liquid = GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
                    bool Inside(Vector3 p) => Math.Abs(p.x - hub.x) < 0.0975f &&
                        new Vector2(p.y - hub.y, p.z - hub.z).magnitude < 0.3f - 0.1f * Spacing;
                    Assert.That(liquid.Count(p => Inside(p.Position)), Is.Zero);
                    Assert.That(liquid.Average(p => p.Position.z - hub.z), Is.GreaterThan(Spacing));
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }
    }
}
#endif
