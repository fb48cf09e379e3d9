using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A kernel of someone else's reads a liquid by FluidBuffers and FluidBuffers.hlsl.</summary>
    [TestFixture(false)]
    [TestFixture(true)]
    public sealed class FluidBuffersTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f), Place = new Vector3(3f, -2f, 1f);
        private static readonly Quaternion Turn = Quaternion.Euler(20f, 130f, -40f);

        private readonly bool sparse;
        private FluidShaderSet shaders;
        private ForcedCells cells;

        /// <param name="sparse">Whether only cells with particles are stored.</param>
        public FluidBuffersTests(bool sparse) => this.sparse = sparse;

        [SetUp]
        public void SetUp()
        {
            shaders = TestShaders.CreateSet();
            cells = new ForcedCells(sparse);
        }

        [TearDown]
        public void TearDown()
        {
            cells.Dispose();
            Object.DestroyImmediate(shaders);
        }

        [TestCase(1, FluidMethodKind.Standard, FluidAxes.None)]
        [TestCase(257, FluidMethodKind.Standard, FluidAxes.None)]
        [TestCase(1009, FluidMethodKind.Standard, FluidAxes.None)]
        [TestCase(1009, FluidMethodKind.Standard, FluidAxes.X | FluidAxes.Z)]
        [TestCase(1009, FluidMethodKind.Thesis, FluidAxes.None)]
        [TestCase(1009, FluidMethodKind.Thesis, FluidAxes.X | FluidAxes.Y | FluidAxes.Z)]
        public void TheLoopFindsEveryParticleWithinAnyRadiusOnce(int count, FluidMethodKind method, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(method, periodic);
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 1f, 3);
            Vector4[] points = Points(settings, particles);
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (GraphicsBuffer asked = GpuBuffers.Create("Points", points.Length, 16),
                found = GpuBuffers.Create("Found", points.Length, 16))
            {
                asked.SetData(points);
                Run(solver, "CountAround", points.Length, asked, found);
                uint[] counts = GpuTest.Read<uint>(found, 4 * points.Length);
                for (int i = 0; i < points.Length; i++)
                {
                    (uint number, uint ids) = Around(points[i], points[i].w, particles, settings.PeriodLength);
                    (uint further, uint furtherIds) = Around(points[i], 2f * points[i].w, particles, settings.PeriodLength);
                    Assert.That(counts.Skip(4 * i).Take(4), Is.EqualTo(new[] { number, ids, further, furtherIds }), $"{points[i]}");
                }
            }
        }

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Thesis)]
        public void ParticlesArriveWithTheirPlaceInTheWorldAndTheirDensity(FluidMethodKind method)
        {
            FluidSolverSettings settings = Settings(method, FluidAxes.None);
            FluidParticle[] particles = ParticleSets.Random(300, Domain, 1f, 5);
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (GraphicsBuffer echo = GpuBuffers.Create("Echo", 900, 16))
            {
                Run(solver, "EchoParticles", 300, null, echo);
                Vector4[] seen = GpuTest.Read<Vector4>(echo, 900);
                float[] densities = GpuTest.Read<float>(solver.Density, 300), pressures = GpuTest.Read<float>(solver.Pressure, 300);
                for (int i = 0; i < 300; i++)
                {
                    FluidParticle particle = particles[(int)seen[3 * i].w];
                    Assert.That(((Vector3)seen[3 * i] - (Place + Turn * particle.Position)).magnitude, Is.LessThan(1e-5));
                    Assert.That((Vector3)seen[3 * i + 1], Is.EqualTo(particle.VelT0));
                    Assert.That(seen[3 * i + 1].w, Is.EqualTo(1f));
                    Assert.That(seen[3 * i + 2].x, Is.EqualTo(densities[i]).And.GreaterThan(0f));
                    Assert.That(seen[3 * i + 2].y, Is.EqualTo(pressures[i]));
                    Assert.That(seen[3 * i + 2].z, Is.LessThan(1e-5), "there and back");
                    Assert.That(seen[3 * i + 2].w,
                        Is.EqualTo(settings.Spacing + settings.SupportRadius + settings.ParticleMass + settings.RestDensity));
                }
                Assert.That(seen.Where((_, i) => i % 3 == 0).Select(v => v.w).Distinct().Count(), Is.EqualTo(300));
            }
        }

        [Test]
        public void SlotsOfParticlesThatLeftAreMarkedAndInNoCell()
        {
            FluidSolverSettings settings = Settings(FluidMethodKind.Standard, FluidAxes.None);
            FluidParticle[] particles = ParticleSets.Random(300, Domain, 0f, 5);
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (GraphicsBuffer echo = GpuBuffers.Create("Echo", 900, 16), asked = GpuBuffers.Create("Points", 1, 16),
                found = GpuBuffers.Create("Found", 1, 16))
            {
                solver.Exchange
                    .SetDrains(
                        new[]
                        { (DrainZone.Box(Matrix4x4.TRS(0.25f * Domain.x * Vector3.right, Quaternion.identity,
                            new Vector3(0.25f * Domain.x, 1f, 1f))), SourceCounts.Removed) });
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 1, 1e-5f));
                Run(solver, "EchoParticles", solver.ParticleCount, null, echo);
                int alive = GpuTest.Read<Vector4>(echo, 3 * solver.ParticleCount).Where((_, i) => i % 3 == 1).Count(v => v.w == 1f);
                asked.SetData(new[] { new Vector4(0f, 0f, 0f, 1f) });
                Run(solver, "CountAround", 1, asked, found);
                Assert.That(solver.ParticleCount, Is.EqualTo(300));
                Assert.That(alive, Is.InRange(100, 200));
                Assert.That(GpuTest.Read<uint>(found, 1)[0], Is.EqualTo(alive));
            }
        }

        [Test]
        public void BuffersOfNoLiquidOrAStoppedOneSayWhatToDo()
        {
            var properties = new MaterialPropertyBlock();
            FluidBuffers none = default;
            Assert.That(none.IsValid, Is.False);
            Assert.That(() => none.Bind(properties), Throws.InvalidOperationException.With.Message.Contains("TryGetBuffers"));
            Assert.That(() => new FluidBuffers(null, Matrix4x4.identity), Throws.ArgumentNullException);
            FluidBuffers buffers;
            using (var solver =
                new FluidSolver(Settings(FluidMethodKind.Standard, FluidAxes.None), shaders, ParticleSets.Random(10, Domain, 0f, 5)))
            {
                buffers = new FluidBuffers(solver, Matrix4x4.identity);
                Assert.That(buffers.IsValid);
                Assert.That(() => buffers.Bind(properties), Throws.Nothing);
                Assert.That(() => buffers.Bind((MaterialPropertyBlock)null), Throws.ArgumentNullException);
                Assert.That(() => buffers.Bind((Material)null), Throws.ArgumentNullException);
                Assert.That(() => buffers.Bind(null, null, 0), Throws.ArgumentNullException);
            }
            Assert.That(buffers.IsValid, Is.False);
            Assert.That(() => buffers.Particles, Throws.InvalidOperationException.With.Message.Contains("stopped"));
        }

        private static FluidSolverSettings Settings(FluidMethodKind method, FluidAxes periodic)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = method;
            input.DomainSize = Domain;
            input.Spacing = 0.04f;
            input.LiquidHeight = input.LiquidDepth = 0.5f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        // At particles, within, on the faces, in corners and beyond, with radii below and above the support radius.
        private static Vector4[] Points(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            var random = new System.Random(4);
            var points = new Vector4[61];
            for (int i = 0; i < points.Length; i++)
            {
                Vector3 place = Vector3.Scale(ParticleSets.RandomVector(random), (i % 4 == 3 ? 1.3f : 1f) * Domain);
                if (i % 4 == 1) place = particles[i % particles.Length].Position;
                if (i % 4 == 2)
                {
                    place = 0.5f *
                        Vector3.Scale(new Vector3(Math.Sign(place.x), Math.Sign(place.y), i % 8 == 2 ? 0.3f : Math.Sign(place.z)), Domain);
                }
                points[i] = place;
                points[i].w = settings.SupportRadius * (i % 3 == 0 ? 0.4f : i % 3 == 1 ? 1f : 1.7f);
            }
            return points;
        }

        private static (uint count, uint ids) Around(Vector3 place, float radius, FluidParticle[] particles, Vector3 period)
        {
            (uint count, uint ids) = (0u, 0u);
            foreach (FluidParticle particle in particles)
            {
                double squared = 0.0;
                for (int axis = 0; axis < 3; axis++)
                {
                    double d = (double)place[axis] - particle.Position[axis];
                    if (period[axis] > 0f) d -= period[axis] * Math.Round(d / period[axis]);
                    squared += d * d;
                }
                if (squared >= (double)radius * radius) continue;
                count++;
                ids += particle.Id;
            }
            return (count, ids);
        }

        private static void Run(FluidSolver solver, string kernelName, int threads, GraphicsBuffer points, GraphicsBuffer written)
        {
            ComputeShader shader = TestShaders.Load("Tests/Editor/Solver/FluidBuffersEcho.compute");
            int kernel = shader.FindKernel(kernelName);
            GpuTest.Run(cmd =>
            {
                solver.RecordNeighbourSetup(cmd);
                new FluidBuffers(solver, Matrix4x4.TRS(Place, Turn, Vector3.one)).Bind(cmd, shader, kernel);
                if (points != null) cmd.SetComputeBufferParam(shader, kernel, "_Points", points);
                cmd.SetComputeIntParam(shader, "_PointCount", threads);
                cmd.SetComputeBufferParam(shader, kernel, points != null ? "_Found" : "_Echo", written);
                cmd.DispatchCompute(shader, kernel, (threads + 63) / 64, 1, 1);
            });
        }
    }
}
