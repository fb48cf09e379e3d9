using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class FluidObstaclesTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(0.8f, 0.8f, 0.8f);

        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders()
        {
            GpuTest.Require();
            shaders = TestShaders.CreateSet();
        }

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Thesis)]
        public void AMeshHoldsFallingLiquidOfAnyMethod(FluidMethodKind method)
        {
            Assert.That(Lowest(method, null), Is.LessThan(-0.3f), "nothing is there");
            Assert.That(Lowest(method, o => o.Add(Shelf(), Matrix4x4.identity)), Is.GreaterThan(-0.06f), "a mesh");
        }

        [Test]
        public void AColliderHoldsFallingLiquidWhereverTheDomainIs()
        {
            var holder = new GameObject("Shelf") { hideFlags = HideFlags.HideAndDontSave };
            try
            {
                var domain = new Vector3(5f, 1f, -2f);
                holder.transform.position = domain + 0.05f * Vector3.down;
                holder.AddComponent<BoxCollider>().size = new Vector3(2f, 0.1f, 2f);
                float lowest = Lowest(FluidMethodKind.Standard, o => o.Add(holder.GetComponent<Collider>()), Matrix4x4.Translate(-domain));
                Assert.That(lowest, Is.GreaterThan(-0.06f));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
            }
        }

        [Test]
        public void ACharacterControllerIsFollowedAsItWalks()
        {
            var holder = new GameObject("Walker") { hideFlags = HideFlags.HideAndDontSave };
            try
            {
                CharacterController character = holder.AddComponent<CharacterController>();
                character.radius = 0.1f;
                character.height = 0.6f;
                using (var obstacles = new FluidObstacles(Settings(FluidMethodKind.Standard)))
                {
                    obstacles.Add(character);
                    obstacles.Update(Matrix4x4.identity);
                    for (int frame = 1; frame <= 5; frame++)
                    {
                        holder.transform.SetPositionAndRotation(0.02f * frame * Vector3.right, Quaternion.Euler(0f, 30f * frame, 0f));
                        obstacles.Update(Matrix4x4.identity);
                    }
                    Assert.That((obstacles.Jumps, obstacles.Messages.Count), Is.EqualTo((0, 0)));
                    character.height = 0.4f; // it crouches
                    obstacles.Update(Matrix4x4.identity);
                    Assert.That((obstacles.Jumps, obstacles.Messages.Count), Is.EqualTo((0, 0)));
                    character.radius = 0.2f;
                    obstacles.Update(Matrix4x4.identity);
                    Assert.That(obstacles.Jumps, Is.EqualTo(1), "a ball of other triangles");
                    Assert.That(obstacles.Messages.Last().Text, Does.Contain("CharacterController").And.Contain("length over its radius"));
                }
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
            }
        }

#if SPHFLUID_TERRAIN
        [TestCase(FluidMethodKind.Standard)]
        public void TerrainHoldsFallingLiquidExceptWhereItHasAHole(FluidMethodKind method)
        {
            var holder = new GameObject("Ground") { hideFlags = HideFlags.HideAndDontSave };
            var data = new TerrainData { heightmapResolution = 33, size = new Vector3(3.2f, 1f, 3.2f) };
            try
            {
                holder.transform.position = new Vector3(-1.6f, 0f, -1.6f);
                holder.AddComponent<TerrainCollider>().terrainData = data;
                Assert.That(Lowest(method, o => o.Add(holder.GetComponent<Collider>())), Is.GreaterThan(-0.06f), "the ground at zero");
                data.SetHoles(10, 10, new bool[12, 12]);
                Assert.That(Lowest(method, o => o.Add(holder.GetComponent<Collider>())), Is.LessThan(-0.3f), "a hole below the liquid");
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
                UnityEngine.Object.DestroyImmediate(data);
            }
        }

        [Test]
        public void TerrainWithoutDataOrSizeIsNamedWithTheCure()
        {
            var holder = new GameObject("Ground") { hideFlags = HideFlags.HideAndDontSave };
            var flat = new TerrainData { size = new Vector3(3f, 0f, 3f) };
            try
            {
                TerrainCollider terrain = holder.AddComponent<TerrainCollider>();
                using (var obstacles = new FluidObstacles(Settings(FluidMethodKind.Standard)))
                {
                    obstacles.Add(terrain);
                    foreach (TerrainData data in new[] { null, flat })
                    {
                        terrain.terrainData = data;
                        obstacles.Update(Matrix4x4.identity);
                        FluidMessage message = obstacles.Messages.Single();
                        Assert.That(message.Issue, Is.EqualTo(FluidIssue.MeshEmpty));
                        Assert.That(message.ToString(), Does.Contain("'Ground'").And.Contain("Assign terrain data"));
                    }
                }
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
                UnityEngine.Object.DestroyImmediate(flat);
            }
        }
#endif

        [Test]
        public void LiquidRidesOnAMeshThatMoves()
        {
            FluidSolverSettings settings = Settings(FluidMethodKind.Standard);
            using (var solver = new FluidSolver(settings, shaders, Drop()))
            using (var obstacles = new FluidObstacles(solver.Settings))
            {
                int shelf = obstacles.Add(Shelf(), Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                solver.SetObstacles(obstacles);
                int perFrame = Mathf.CeilToInt(1f / 60f / settings.TimeStep);
                for (int frame = 1; frame <= 12; frame++)
                {
                    obstacles.MoveTo(shelf, Matrix4x4.Translate(0.015f * frame * Vector3.up));
                    obstacles.Update(Matrix4x4.identity);
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, perFrame));
                }

                Assert.That(obstacles.Jumps, Is.Zero);
                Assert.That(LowestNow(solver), Is.GreaterThan(0.16f));
            }
        }

        [Test]
        public void ALightMeshRisesAHeavyOneSinksAndAPushMovesIt()
        {
            FluidSolverSettings settings = Settings(FluidMethodKind.Standard);
            FluidParticle[] pool = ParticleSets.Lattice(new Vector3Int(16, 8, 16), Spacing, 0f, 1);
            for (int i = 0; i < pool.Length; i++) pool[i].Position.y -= 0.2f;
            Vector3 size = 0.2f * Vector3.one, place = 0.2f * Vector3.right, middle = 0.2f * Vector3.down;
            TriangleMesh cube = TriangleMesh.Box(Matrix4x4.Scale(size));
            pool = pool.Where(p => !new Bounds(middle + place, 1.2f * size).Contains(p.Position) &&
                !new Bounds(middle - place, 1.2f * size).Contains(p.Position)).ToArray();
            using (var solver = new FluidSolver(settings, shaders, pool))
            using (var obstacles = new FluidObstacles(solver.Settings))
            {
                float mass = 8f, inertia = mass / 6f * 0.04f;
                int light = obstacles.AddFloating(cube, middle + place, Quaternion.identity, 0.4f * mass, 0.4f * inertia * Vector3.one);
                int heavy = obstacles.AddFloating(cube, middle - place, Quaternion.identity, 4f * mass, Vector3.zero);
                Assert.That(obstacles.ReadPoseNow(light, out _), Is.EqualTo(middle + place));
                for (int frame = 0; frame < 12; frame++)
                {
                    if (frame == 6) obstacles.Push(heavy, 5f * Vector3.up, Vector3.up);
                    obstacles.Update(Matrix4x4.identity);
                    solver.SetObstacles(obstacles);
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, 8, 1f / 480f));
                    if (frame == 5)
                    {
                        Assert.That(obstacles.ReadPoseNow(light, out _).y, Is.GreaterThan(middle.y + 0.002f));
                        Assert.That(obstacles.ReadPoseNow(heavy, out _).y, Is.LessThan(middle.y - 0.01f));
                    }
                }
                Assert.That(obstacles.ReadPoseNow(heavy, out Quaternion turned).y, Is.GreaterThan(middle.y + 0.1f), "pushed up");
                Assert.That(Quaternion.Angle(turned, Quaternion.identity), Is.LessThan(1e-3f),
                    "it has no inertia given, so it does not turn");
            }
        }

        [Test]
        public void WhatCannotFloatIsRefusedWithACure()
        {
            TriangleMesh cube = TriangleMesh.Box(Matrix4x4.identity);
            using (var obstacles = new FluidObstacles(Settings(FluidMethodKind.Standard)))
            using (var thesis = new FluidObstacles(Settings(FluidMethodKind.Thesis)))
            {
                int Add(FluidObstacles to, float mass, float inertia) =>
                    to.AddFloating(cube, Vector3.zero, Quaternion.identity, mass, inertia * Vector3.one);
                Assert.That(() => Add(thesis, 1f, 1f), Throws.TypeOf<NotSupportedException>().With.Message.Contains("Standard"));
                Assert.That(() => Add(obstacles, 0f, 1f), Throws.TypeOf<ArgumentOutOfRangeException>());
                Assert.That(() => Add(obstacles, float.NaN, 1f), Throws.TypeOf<ArgumentOutOfRangeException>());
                Assert.That(() => Add(obstacles, 1f, -1f), Throws.TypeOf<ArgumentOutOfRangeException>());
                int fixedMesh = obstacles.Add(cube, Matrix4x4.identity), floating = Add(obstacles, 1f, 1f);
                Assert.That(() => obstacles.Push(fixedMesh, Vector3.up, Vector3.zero),
                    Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("AddFloating"));
                Assert.That(() => obstacles.MoveTo(floating, Matrix4x4.identity),
                    Throws.InvalidOperationException.With.Message.Contains("Push"));
            }
        }

        [Test]
        public void WhatIsClearedHoldsNothing()
        {
            using (var obstacles = new FluidObstacles(Settings(FluidMethodKind.Standard)))
            {
                obstacles.Add(Shelf(), Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                Assert.That(obstacles.TriangleCount, Is.EqualTo(4), "the top and the bottom; the sides are beyond the domain");
                Assert.That(obstacles.Found.Count, Is.EqualTo(1));
                Assert.That(obstacles.Found[0].Collider, Is.Null);
                Assert.That(obstacles.Found[0].Mesh.Contains(0.05f * Vector3.down), Is.True);

                obstacles.Clear();
                obstacles.Update(Matrix4x4.identity);
                Assert.That((obstacles.TriangleCount, obstacles.Found.Count), Is.EqualTo((0, 0)));
            }
        }

        [Test]
        public void AMirroredMeshIsReportedAndPutAtOnce()
        {
            using (var obstacles = new FluidObstacles(Settings(FluidMethodKind.Standard)))
            {
                int shelf = obstacles.Add(Shelf(), Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                obstacles.MoveTo(shelf, Matrix4x4.Scale(new Vector3(-1f, 1f, 1f)));
                obstacles.Update(Matrix4x4.identity);
                Assert.That(obstacles.Jumps, Is.EqualTo(1));
                Assert.That(obstacles.Messages.Single().Text, Does.StartWith("The mesh was mirrored"));
            }
        }

        [Test]
        public void WhatCannotBeAnObstacleIsRefusedWithACure()
        {
            FluidSolverSettings settings = Settings(FluidMethodKind.Standard);
            using (var solver = new FluidSolver(settings, shaders, Drop()))
            using (var obstacles = new FluidObstacles(settings))
            using (var others = new FluidObstacles(Settings(FluidMethodKind.Thesis)))
            {
                Assert.That(() => obstacles.Add((TriangleMesh)null, Matrix4x4.identity),
                    Throws.ArgumentException.With.Message.Contains("one triangle or more"));
                Assert.That(() => obstacles.Add((Collider)null), Throws.ArgumentNullException);
                Assert.That(() => obstacles.Add(Shelf(), Matrix4x4.identity, 1.5f), Throws.TypeOf<ArgumentOutOfRangeException>());
                Assert.That(() => obstacles.MoveTo(0, Matrix4x4.identity),
                    Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("Add returned"));
                Assert.That(() => solver.SetObstacles(others), Throws.ArgumentException.With.Message.Contains("settings of the solver"));
            }
        }

        // A slab across the domain, its top at zero.
        private static TriangleMesh Shelf() =>
            TriangleMesh.Box(Matrix4x4.TRS(0.05f * Vector3.down, Quaternion.identity, new Vector3(2f, 0.1f, 2f)));

        private static FluidSolverSettings Settings(FluidMethodKind method)
        {
            FluidRuleInput input = method == FluidMethodKind.Standard ? FluidRuleInput.Water : FluidRuleInput.ThesisWater;
            input.Method = method;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.LiquidHeight = 0.6f;
            input.LiquidDepth = 0.2f;
            return FluidRules.Derive(input);
        }

        private static FluidParticle[] Drop()
        {
            FluidParticle[] drop = ParticleSets.Lattice(new Vector3Int(4, 4, 4), Spacing, 0f, 1);
            for (int i = 0; i < drop.Length; i++) drop[i].Position.y += 0.03f + 2f * Spacing;
            return drop;
        }

        // Height of the lowest particle after half a second.
        private float Lowest(FluidMethodKind method, Action<FluidObstacles> add, Matrix4x4? worldToSimulation = null)
        {
            FluidSolverSettings settings = Settings(method);
            using (var solver = new FluidSolver(settings, shaders, Drop()))
            using (var obstacles = new FluidObstacles(solver.Settings))
            {
                add?.Invoke(obstacles);
                obstacles.Update(worldToSimulation ?? Matrix4x4.identity);
                solver.SetObstacles(obstacles);
                GpuTest.Run(cmd => solver.RecordSteps(cmd, Mathf.CeilToInt(0.5f / settings.TimeStep)));
                return LowestNow(solver);
            }
        }

        private static float LowestNow(FluidSolver solver)
        {
            GpuTest.Run(cmd => solver.RecordNeighbourSetup(cmd)); // brings what is read up to date
            return GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount).Min(p => p.Position.y);
        }
    }
}
