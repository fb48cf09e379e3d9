using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Sums of what walls do to the liquid, against the liquid's own momentum and against sums in double precision.</summary>
    public sealed class WallForceTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-4f;

        // Nobody has a neighbour, so that all that changes a velocity is a face, by pressure or by the shell.
        [Test]
        public void FacesGiveEachPatchWhatTheyTakeOfTheParticlesThatStandOnIt([Values(0, 1, 63, 64, 65, 257, 1009)] int count)
        {
            FluidSolverSettings settings = Still(new Vector3(0.6f, 0.5f, 0.7f));
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, settings.DomainSize, 40f, 6));
                rig.State.List.Counts.SetData(new uint[Math.Max(count, 1)]);
                rig.SetTerms(Enumerable.Range(0, count).Select(i => new Vector2(settings.RestDensity, 1e-3f * (i % 7))).ToArray());
                WallPatch[] patches = MovedOver(rig, Array.Empty<FluidObstacle>(), out Vector4[] velocities,
                    new WallPlan(new Vector3(-0.3f, 0.04f, -0.1f), Vector3.right, new Vector2(0.31f, 0.17f)),
                    new WallPlan(new Vector3(0.3f, -0.1f, 0f), Vector3.left, new Vector2(2f, 2f)),
                    new WallPlan(new Vector3(0.05f, -0.25f, 0.02f), Vector3.up, new Vector2(0.02f, 0.4f)));
                double step = TimeStep, push = settings.RestDensity / StandardReference.Response(settings) * step;
                foreach (WallPatch patch in patches)
                {
                    double sum = 0.0, size = 0.0;
                    Vector3 normal = patch.Rotation * Vector3.forward;
                    for (int i = 0; i < count; i++)
                    {
                        double change = Double3.Dot((Double3)(Vector3)velocities[i] - (Double3)start[i].VelT0, (Double3)normal);
                        double away = Double3.Dot((Double3)start[i].Position - (Double3)patch.Centre, (Double3)normal);
                        if (away > settings.SupportRadius) continue; // of the face at the other side
                        double share = change * Share(patch, (Double3)start[i].Position, settings.Spacing, axis =>
                        {
                            double half = Math.Abs(Vector3.Dot(0.5f * settings.DomainSize, axis)), centre = Vector3.Dot(patch.Centre, axis);
                            return (-half - centre, half - centre);
                        });
                        sum += share;
                        size += Math.Abs(share);
                    }

                    Assert.That(patch.Impulse,
                        Is.EqualTo(settings.ParticleMass * sum).Within(settings.ParticleMass * (2e-6 * size + 1e-7)));
                    if (count > 256) Assert.That(size, Is.GreaterThan(0.01), "something is there");
                    Assert.That(patch.Seconds, Is.EqualTo(step).Within(1e-6).Percent);
                }
            }
        }

        // Both planes are square to each other. The first patch's wall ends where the second's begins, so it also has what the second plane
        // pushes along its normal, of particles that stand within a spacing of its edge.
        [Test]
        public void PlanesOfMeshesGiveEachPatchItsOwnPart([Values(1, 63, 64, 65, 257)] int count)
        {
            FluidSolverSettings settings = Still(Vector3.one);
            Vector3 first = new Vector3(0.6f, 0.8f, 0f), second = new Vector3(-0.8f, 0.6f, 0f);
            Vector3 firstPush = -0.9f / Spacing * first, secondPush = -0.4f / Spacing * second - 0.2f / Spacing * first;
            var random = new System.Random(count);
            TriangleMesh sheet = TriangleMesh.FromCorners(new[]
            {
                -0.3f * Vector3.forward, 0.4f * second - 0.3f * Vector3.forward, 0.4f * second + 0.3f * Vector3.forward,
                -0.3f * Vector3.forward, 0.4f * second + 0.3f * Vector3.forward, 0.3f * Vector3.forward,
            });
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            using (bodies)
            using (var obstacles = new FluidObstacles(settings))
            {
                obstacles.Add(sheet, Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                FluidParticle[] corner = ParticleSets.Random(count, Vector3.one, 20f, 5);
                for (int i = 0; i < count; i++)
                {
                    corner[i].Position = (0.4f + 0.7f * (float)random.NextDouble()) * Spacing * first +
                        (0.4f + 1.2f * (float)random.NextDouble()) * Spacing * second +
                        0.4f * (float)(random.NextDouble() - 0.5) * Vector3.forward;
                }
                FluidParticle[] start = rig.FillSorted(corner);
                rig.State.List.Counts.SetData(new uint[count]);
                WalledStateRig.SetWalls(rig,
                    start.Select(p => StoredWall.Pack(p.Position, false, 0.3f, new[] { firstPush, secondPush },
                    (first, Vector3.Dot(p.Position, first)), (second, Vector3.Dot(p.Position, second)))).ToList());
                rig.SetTerms(Enumerable.Range(0, count).Select(i => new Vector2(settings.RestDensity, 1e-3f * (1 + i % 7))).ToArray());
                WallPatch[] patches = MovedOver(rig, obstacles.Found, out Vector4[] velocities,
                    new WallPlan(0.1f * second, first, new Vector2(2f, 0.9f)), new WallPlan(0.6f * first, second, new Vector2(0.17f, 2f)));
                Assert.That(patches[0].Area, Is.EqualTo(0.4 * 0.6).Within(1e-4).Percent);
                Assert.That(patches[1].Area, Is.EqualTo(0.34).Within(1e-4).Percent, "of none its own");
                double unit = TimeStep * settings.RestDensity / StandardReference.Response(settings);
                double ofFirst = 0.0, ofSecond = 0.0;
                for (int i = 0; i < count; i++)
                {
                    double push = unit * 1e-3 * (1 + i % 7), away = Vector3.Dot(start[i].Position, first);
                    var place = (Double3)start[i].Position;
                    Func<Vector3, (double, double)> sheetAlong = axis => Math.Abs(axis.z) > 0.9 ? (-0.3, 0.3)
                        : Vector3.Dot(axis, second) > 0f ? (-0.1, 0.3) : (-0.3, 0.1);
                    ofFirst += push * 0.9 / Spacing * Share(patches[0], place - away * (Double3)first, Spacing, sheetAlong);
                    bool isNear = away < Spacing; // as deep as the patch
                    Double3 foot = place - Double3.Dot(place, (Double3)second) * (Double3)second;
                    ofFirst += isNear ? push * 0.2 / Spacing * Share(patches[0], foot, Spacing, sheetAlong) : 0.0;
                    ofSecond += push * 0.4 / Spacing * Share(patches[1], foot, Spacing, _ => (-10.0, 10.0));
                }

                double mass = settings.ParticleMass;
                Assert.That(patches[0].Impulse, Is.EqualTo(mass * ofFirst).Within(mass * (5e-4 * ofFirst + 1e-6))); // normals to 3e-5
                Assert.That(patches[1].Impulse, Is.EqualTo(mass * ofSecond).Within(mass * (5e-4 * ofSecond + 1e-6)));
            }
        }

        // From pressure, shell and contact alike: what the liquid loses the walls have.
        [TestCase(false, false, false)]
        [TestCase(true, false, false)]
        [TestCase(false, true, false)]
        [TestCase(true, true, false)]
        [TestCase(false, false, true)]
        [TestCase(true, false, true)]
        public void TheMomentumOfAHitIsAllOnTheWalls(bool onMesh, bool isViscous, bool isCorrected)
        {
            var domain = new Vector3(0.8f, 0.6f, 0.6f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 0.3f, 4f);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Friction = 0f;
            if (isCorrected) settings = CorrectionReference.Corrected(settings);
            if (isViscous)
            {
                settings.Viscosity = 20f;
                StandardSettings own = settings.Own<StandardSettings>();
                own.ImplicitViscosity = true;
                settings = settings.WithOwn(own);
            }

            double tolerance = isViscous ? 2e-3 : 2e-4; // the equations of viscosity are solved to a few digits
            using (var rig = new WallForceRig(settings,
                WallForceRig.Block(new Vector3Int(5, 6, 6), Spacing, new Vector3(-0.3f, -0.15f, -0.15f), new Vector3(4f, 0.5f, 0f))))
            {
                WallPatch[] faces = rig.AddFaces();
                WallPatch front = rig.Add(new Vector3(0.1f, 0f, 0f), Vector3.left, 4f, 4f);
                if (onMesh)
                {
                    rig.Obstacles
                        .Add(TriangleMesh.Box(Matrix4x4.TRS(new Vector3(0.2f, 0f, 0f), Quaternion.identity, new Vector3(0.2f, 2f, 2f))),
                            Matrix4x4.identity, 0f);
                }
                Double3 before = rig.Momentum();
                for (int frame = 0; frame < 8; frame++) rig.Frame(20);
                rig.Forces.Complete();
                Double3 gone = before - rig.Momentum();
                WallPatch high = onMesh ? front : faces[1];
                Assert.That(high.Impulse, Is.GreaterThan(0.8 * before.X), "the block has hit");
                Assert.That(high.Impulse - faces[0].Impulse, Is.EqualTo(gone.X).Within(tolerance * before.X));
                Assert.That(faces[3].Impulse - faces[2].Impulse, Is.EqualTo(gone.Y).Within(tolerance * before.X));
                Assert.That(rig.Solver.ReadCountersNow().ImpulseLimits, Is.Zero);
                Assert.That(high.PeakPressure(0.002, 1000), Is.GreaterThan(3.0 * high.MeanPressure(rig.Solver.SimulatedTime)),
                    "a hit is short");
            }
        }

        // A rectangle with edges in the seam would lose a quarter of a spacing there: a thirtieth of this one.
        [Test]
        public void ARectangleThatGoesRoundAPeriodicDomainHasAllOfTheHit([Values(0.35f, 0.4f)] float across)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.8f, 0.6f, across), Spacing, 0.3f, 4f);
            settings.Gravity = Vector3.zero;
            settings.Boundaries = new FluidBoundaries { Periodic = FluidAxes.Z };
            var counts = new Vector3Int(5, 6, Mathf.RoundToInt(across / Spacing));
            using (var rig = new WallForceRig(settings,
                WallForceRig.Block(counts, Spacing, new Vector3(-0.3f, -0.15f, -0.5f * across), new Vector3(4f, 0f, 0f))))
            {
                WallPatch front = rig.Forces.Add(new Vector3(0.4f, 0f, 0.07f), WallForceRig.Facing(Vector3.left), new Vector2(across, 4f));
                WallPatch back =
                    rig.Forces.Add(new Vector3(-0.4f, 0f, -0.04f), WallForceRig.Facing(Vector3.right), new Vector2(across, 4f));
                Double3 before = rig.Momentum();
                for (int frame = 0; frame < 8; frame++) rig.Frame(20);
                rig.Forces.Complete();
                Assert.That(front.Impulse, Is.GreaterThan(0.8 * before.X), "the block has hit");
                Assert.That(front.Impulse - back.Impulse, Is.EqualTo((before - rig.Momentum()).X).Within(2e-3 * before.X));
            }
        }

        [Test]
        public void APatchGoesWithItsMeshInTheStepsOfAFrame()
        {
            var domain = new Vector3(1.2f, 0.5f, 0.5f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 0.3f, 4f);
            settings.Gravity = Vector3.zero;
            using (var rig = new WallForceRig(settings,
                WallForceRig.Block(new Vector3Int(4, 6, 6), Spacing, new Vector3(-0.35f, -0.15f, -0.15f), Vector3.zero)))
            {
                int plate = rig.Obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.1f, 2f, 2f))), At(0f), 0f);
                WallPatch face = rig.Add(new Vector3(-0.4f, 0f, 0f), Vector3.right, 4f, 4f);
                rig.Obstacles.Carry(plate, face);
                rig.Frame(1);
                for (int frame = 1; frame <= 6; frame++)
                {
                    float gone = 0.05f * frame; // a spacing, beyond the patch's depth if it stayed
                    rig.Obstacles.MoveTo(plate, At(gone));
                    rig.Forces.Move(face, new Vector3(-0.4f + gone, 0f, 0f), face.Rotation, face.Size);
                    rig.Frame(20);
                }

                rig.Forces.Complete();
                double momentum = rig.Momentum().X;
                Assert.That(momentum, Is.GreaterThan(0.5 * 4 * 36 * settings.ParticleMass * 0.05 / (20 * settings.TimeStep)),
                    "the plate pushes the liquid");
                Assert.That(face.Impulse, Is.EqualTo(momentum).Within(2e-3 * momentum));
            }
        }

        // To the bit on some devices; another's compiler fuses other products and sums once the kernel also adds up forces.
        [Test]
        public void TheLiquidMovesAsWithoutPatches()
        {
            FluidParticle[] Run(bool read)
            {
                FluidSolverSettings settings = BodyRig.Water(new Vector3(0.5f, 0.5f, 0.5f), Spacing, 0.3f);
                using (var rig =
                    new WallForceRig(settings, WallForceRig.Block(new Vector3Int(5, 6, 6), Spacing, -0.25f * Vector3.one, Vector3.right)))
                {
                    rig.Obstacles
                        .Add(TriangleMesh.Box(Matrix4x4.TRS(new Vector3(0f, -0.2f, 0f), Quaternion.Euler(0f, 30f, 0f), 0.1f * Vector3.one)),
                            Matrix4x4.identity);
                    if (read) rig.AddFaces();
                    rig.Frame(25);
                    return rig.Particles().OrderBy(p => p.Id).ToArray();
                }
            }

            FluidParticle[] with = Run(true), without = Run(false);
            Assert.That(with.Select(p => p.Id), Is.EqualTo(without.Select(p => p.Id)));
            Assert.That(with.Zip(without, (a, b) => (a.Position - b.Position).magnitude).Max(), Is.LessThan(1e-4f * Spacing));
            Assert.That(with.Zip(without, (a, b) => (a.VelT0 - b.VelT0).magnitude).Max(), Is.LessThan(1e-3f), "of 1 m/s");
        }

        private static Matrix4x4 At(float gone) => Matrix4x4.Translate(new Vector3(-0.45f + gone, 0f, 0f));

        private static FluidSolverSettings Still(Vector3 domain)
        {
            FluidSolverSettings settings = StandardStateRig.Water(domain, Spacing);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Friction = 0f;
            return settings;
        }

        // Records a single step of MoveParticles with patches, and hands out the velocities after it.
        private static WallPatch[] MovedOver(StandardStateRig rig, IReadOnlyList<FluidObstacle> solids, out Vector4[] velocities,
            params WallPlan[] plans)
        {
            var forces = new WallForces(rig.Shaders);
            rig.State.WallForces = forces;
            WallPatch[] patches = plans.Select(p => forces.Add(p.Centre, WallForceRig.Facing(p.Normal), p.Size)).ToArray();
            var step = new FluidStep(TimeStep, TimeStep, false);
            GpuTest.Run(cmd =>
            {
                forces.Begin(rig.State, 1, solids);
                forces.RecordStep(cmd, rig.State, step, TimeStep);
                new MoveParticlesPass(rig.Shaders).Record(cmd, rig.State, step);
                forces.End(cmd);
            });
            forces.Complete();
            velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, rig.State.ParticleCount);
            forces.Dispose();
            rig.State.WallForces = null;
            return patches;
        }

        // What of (1 - t²)² about a foot, up to a reach and to the ends of the wall, lies on a patch.
        private static double Share(WallPatch patch, Double3 foot, double spacing, Func<Vector3, (double Low, double High)> wallAlong)
        {
            Double3 d = foot - (Double3)patch.Centre;
            double reach = 0.94 * spacing;
            double Along(Vector3 axis, double length)
            {
                (double low, double high) = wallAlong(axis);
                double x = Math.Max(low, Math.Min(high, Double3.Dot(d, (Double3)axis)));
                double Over(double from, double to) => to <= from ? 0.0 : Primitive((to - x) / reach) - Primitive((from - x) / reach);
                return Over(Math.Max(low, -0.5 * length), Math.Min(high, 0.5 * length)) / Over(low, high);
            }

            return Along(patch.Rotation * Vector3.right, patch.Size.x) * Along(patch.Rotation * Vector3.up, patch.Size.y);
        }

        private static double Primitive(double t)
        {
            double u = Math.Max(-1.0, Math.Min(1.0, t));
            return u - 2.0 / 3.0 * u * u * u + u * u * u * u * u / 5.0;
        }

        private readonly struct WallPlan
        {
            public readonly Vector3 Centre, Normal;
            public readonly Vector2 Size;

            public WallPlan(Vector3 centre, Vector3 normal, Vector2 size)
            {
                Centre = centre;
                Normal = normal;
                Size = size;
            }
        }
    }
}
