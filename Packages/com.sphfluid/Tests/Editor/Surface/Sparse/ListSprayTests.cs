using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Particles that leave the surface as spray: how much of each, against sums over all particles in double precision, and their list.
    /// </summary>
    public sealed class ListSprayTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(1.5f, 1.2f, 0.9f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(1, FluidAxes.None)]
        [TestCase(255, FluidAxes.X | FluidAxes.Y)]
        [TestCase(256, FluidAxes.None)]
        [TestCase(257, FluidAxes.Z)]
        [TestCase(1009, FluidAxes.None)]
        [TestCase(4099, FluidAxes.None)]
        public void AsMuchLeavesTheSurfaceAsTheReferenceHas(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(periodic);
            SurfaceFieldSettings field = Field(settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            using (var rig = new BlockFieldRig(shaders, settings, Flowing(count, Domain)))
            {
                rig.Record(field, grid);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, count);
                Vector4[] kernels = GpuTest.Read<Vector4>(rig.Passes.Particles.Kernels, count);
                SprayPart[] spray = GpuTest.Read<SprayPart>(rig.Passes.Spray.Spray, count);
                var reference = new SurfaceFieldReference(particles, settings, field, grid);
                for (int i = 0; i < count; i++)
                {
                    Assert.AreEqual(reference.Spray(i), spray[i].Part, 1e-4, $"spray of particle {i} of {count}");
                    Assert.AreEqual(reference.Weight(i), Math.Abs(kernels[i].w), 1e-4, $"weight of particle {i} of {count}");
                    Double3 missed = field.LongestShift * (Double3)spray[i].Stretch - reference.Apart(i);
                    Assert.Less(missed.Length, 3e-3 * field.LongestShift, $"stretch of particle {i} of {count}");
                    Assert.AreEqual(kernels[i].w < 0f, spray[i].Stretch != Vector3.zero && spray[i].Part < 1f, $"particle {i} of {count}");
                }
            }
        }

        [TestCase(1, 1, 1, 1f, 1f)]
        [TestCase(2, 1, 1, 1f, 0f)]
        [TestCase(9, 1, 1, 1f, 0f)]
        [TestCase(2, 2, 2, 0.3f, 0f)]
        [TestCase(9, 9, 1, 0f, 0f)]
        [TestCase(9, 9, 5, 0f, 0f)]
        public void ClumpsThatFlyApartLeaveAndStreamsAndFilmsStay(int x, int y, int z, float apart, float together)
        {
            Vector3[] positions = Lattice(x, y, z).ToArray();
            Vector3 place = Spacing * new Vector3(x / 2, y / 2, 0f);
            int middle = Array.IndexOf(positions, place);
            SprayOf(positions, p => 20f * (p - place), out float[] spray, out _);
            Assert.AreEqual(apart, spray[middle], 0.15f, "apart");
            SprayOf(positions, _ => Vector3.down, out spray, out _);
            Assert.AreEqual(together, spray[middle], 0.15f, "together");
        }

        [Test]
        public void TheCountThatIsReadBackIsThatOfTheDrawnOnes()
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            FluidParticle[] particles = ParticleSets.Random(1009, Domain, 0f, 1009);
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var surface = new SparseSurface(shaders) { SprayVertices = 84 })
            {
                SurfaceFieldSettings field = Field(settings);
                GpuTest.Run(cmd => surface.Record(cmd, solver, field, SurfaceGrid.OverDomain(Domain, field.CellSize), default));
                UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                uint vertices = GpuTest.Read<uint>(surface.Spray.DrawArguments, 4)[0];
                Assert.That(vertices, Is.GreaterThan(0u));
                Assert.That(surface.SprayCount, Is.EqualTo(vertices / 84));
            }
        }

        [TestCase(1, 0.5)]
        [TestCase(255, 1.0)]
        [TestCase(256, 0.3)]
        [TestCase(257, 0.0)]
        [TestCase(1009, 0.5)]
        [TestCase(70001, 0.1)]
        public void SprayIsListedInTheLiquidsOrder(int count, double part)
        {
            const int vertices = 84;
            var random = new System.Random(count);
            using (var solver = new FluidSolver(Settings(FluidAxes.None), shaders, ParticleSets.Random(count, Domain, 1f, count)))
            using (var spray = new SprayParticles())
            {
                float[] amounts = Enumerable.Range(0, count)
                    .Select(_ => random.NextDouble() < part ? (float)random.NextDouble() + 1e-3f : 0f).ToArray();
                spray.Reserve(count);
                spray.Spray.SetData(amounts.Select(amount => new SprayPart { Part = amount }).ToArray());
                GpuTest.Run(cmd => new ListSprayPass(shaders).Record(cmd, solver, spray, vertices));
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(solver.Particles, count);
                int[] leaving = Enumerable.Range(0, count).Where(i => amounts[i] > 0f).ToArray();
                CollectionAssert.AreEqual(new[] { (uint)(leaving.Length * vertices), 1u, 0u, 0u },
                    GpuTest.Read<uint>(spray.DrawArguments, 4));
                float[] listed = GpuTest.Read<float>(spray.Particles, count * 8);
                for (int k = 0; k < leaving.Length; k++)
                {
                    FluidParticle particle = particles[leaving[k]];
                    Assert.AreEqual(particle.Position, new Vector3(listed[8 * k], listed[8 * k + 1], listed[8 * k + 2]), $"entry {k}");
                    Assert.AreEqual(amounts[leaving[k]], listed[8 * k + 3], $"entry {k}");
                    Assert.AreEqual(particle.VelT1, new Vector3(listed[8 * k + 4], listed[8 * k + 5], listed[8 * k + 6]), $"entry {k}");
                    Assert.AreEqual(particle.Id, BitConverter.ToUInt32(BitConverter.GetBytes(listed[8 * k + 7]), 0), $"entry {k}");
                }
            }
        }

        // A drop falls into a pool: what the surface lost of it is drawn as spray, in each of a hundred frames, and nothing jumps.
        [Test]
        public void ADropIsShownOnceInEachOfAHundredFrames()
        {
            const int frames = 100;
            Vector3[] pool = Lattice(9, 9, 5).ToArray();
            float last = 1f;
            bool left = false, joined = false;
            for (int frame = 0; frame < frames; frame++)
            {
                float height = Mathf.Lerp(4f, 0f, frame / (frames - 1f));
                Vector3 drop = Spacing * new Vector3(4.3f, 4.4f, 4f + height);
                SprayOf(pool.Append(drop).ToArray(), p => p == drop ? Vector3.down : Vector3.zero, out float[] spray, out float[] kept);
                float shown = spray[pool.Length];
                Assert.AreEqual(1f, shown + kept[pool.Length], 1e-4f,
                    $"frame {frame}: the part drawn as drops and the part in the surface");
                Assert.AreEqual(last, shown, 0.2f, $"frame {frame}");
                last = shown;
                left |= shown == 1f;
                joined |= shown == 0f;
            }
            Assert.IsTrue(left && joined, "The drop comes from spray and ends in the surface.");
        }

        // By place in the array: which part is spray, and which part of its weight in a surface without spray a particle still has.
        private void SprayOf(Vector3[] positions, Func<Vector3, Vector3> velocity, out float[] spray, out float[] kept)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            SurfaceFieldSettings field = Field(settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            Vector3 middle = 0.5f * positions.Aggregate((a, b) => a + b) / positions.Length;
            var liquid = new FluidParticle[positions.Length];
            for (int i = 0; i < liquid.Length; i++) liquid[i] = new FluidParticle(positions[i] - middle, velocity(positions[i]), (uint)i);
            using (var rig = new BlockFieldRig(shaders, settings, liquid))
            {
                rig.Record(field.WithSpray(false), grid);
                float[] whole = ById(rig, GpuTest.Read<Vector4>(rig.Passes.Particles.Kernels, liquid.Length).Select(kernel => kernel.w));
                rig.Record(field, grid);
                float[] rest = ById(rig, GpuTest.Read<Vector4>(rig.Passes.Particles.Kernels, liquid.Length).Select(kernel => kernel.w));
                spray = ById(rig, GpuTest.Read<SprayPart>(rig.Passes.Spray.Spray, liquid.Length).Select(p => p.Part));
                kept = rest.Select((weight, i) => (weight < 0f ? -2f * weight : weight) / whole[i]).ToArray();
            }
        }

        /// <summary>Particles of which two in three fly as one, the others each on its own way.</summary>
        internal static FluidParticle[] Flowing(int count, Vector3 domain)
        {
            FluidParticle[] particles = ParticleSets.Random(count, domain, 1f, count);
            for (int i = 0; i < count; i++)
            {
                Vector3 own = particles[i].VelT1;
                particles[i].VelT0 = particles[i].VelT1 = i % 3 == 0 ? own : 2f * Vector3.down + 0.3f * own;
            }
            return particles;
        }

        // An element of _Spray. Stretches have 10 bits an axis, 512 for zero.
        private struct SprayPart
        {
            public float Part;
            private readonly uint stretch;

            public Vector3 Stretch => (new Vector3(stretch & 1023, stretch >> 10 & 1023, stretch >> 20 & 1023) - 512f * Vector3.one) / 511f;
        }

        private static float[] ById(BlockFieldRig rig, IEnumerable<float> values)
        {
            float[] ordered = values.ToArray();
            FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, ordered.Length);
            var byId = new float[ordered.Length];
            for (int i = 0; i < ordered.Length; i++) byId[particles[i].Id] = ordered[i];
            return byId;
        }

        private static IEnumerable<Vector3> Lattice(int x, int y, int z) =>
            from k in Enumerable.Range(0, z)
            from j in Enumerable.Range(0, y)
            from i in Enumerable.Range(0, x)
            select Spacing * new Vector3(i, j, k);

        private static SurfaceFieldSettings Field(in FluidSolverSettings settings) =>
            SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings).WithSpray(true);

        private static FluidSolverSettings Settings(FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = false;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }
    }
}
