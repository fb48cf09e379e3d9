using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Water that rises between plates or sinks there, in a periodic slab. A plate that dips into a tank parts it into a slot of 8
    /// spacings, 2.4 mm, and one of 16; faces of the domain are their other walls. By Jurin's law the contact lines of a slot carry the
    /// weight of what stands in it above the level at zero pressure, 2 σ cos θ = ρ g d h, whatever the shape of the surface.
    /// </summary>
    public sealed class CapillaryRiseTests
    {
        private const float Spacing = 3e-4f, Tension = 0.0728f, Density = 1000f, Gravity = 9.81f;

        // In spacings. Water stands Level high at first, and the plate's lower edge is Edge above the floor.
        private const int Narrow = 8, Plate = 3, Wide = 16, Level = 8, Edge = 3, Top = 14, Slab = 7;

        // Of the column that swings between both slots, with an allowance for what moves below the plate.
        private static readonly double period =
            2.0 * Math.PI * Math.Sqrt(1.5 * Level * Spacing / (Gravity * (1.0 + Narrow / (double)Wide)));

        private static Vector3 Domain => Spacing * new Vector3(Narrow + Plate + Wide, Top, Slab);

        // Of Jurin's difference, 5.15 spacings at 60 degrees and as much down at 120, 0.7 and 1.3 come: the paper Standard says why. What
        // is asserted is the direction, more than the half spacing that the slots may differ by at 90 degrees, and that it does not go
        // beyond Jurin's.
        [Test]
        public void WaterStandsHigherWhereItWetsThePlatesThanWhereItDoesNot()
        {
            double wets = Rise(60f, 1), repels = Rise(120f, 1),
                jurin = (Jurin(Narrow * Spacing, 60.0) - Jurin(Wide * Spacing, 60.0)) / Spacing;
            string figures =
                $"{wets:f2} and {repels:f2} spacings after a fifth of a period of {1e3 * period:f0} ms, {jurin:f2} and {-jurin:f2} by " +
                "Jurin";
            TestContext.WriteLine(figures);
            Assert.That(wets - repels, Is.InRange(0.6, 2.0 * jurin), figures);
            Assert.That(repels, Is.Negative, figures);
        }

        [TestCase(60f)]
        [TestCase(90f)]
        [TestCase(120f)]
        [Explicit("Each angle for longer: a minute.")]
        public void WaterRisesWhereItWetsThePlatesAndSinksWhereItDoesNot(float angle)
        {
            double jurin = (Jurin(Narrow * Spacing, angle) - Jurin(Wide * Spacing, angle)) / Spacing, rise = Rise(angle, 2);
            string figures = $"{rise:f2} spacings after two fifths of a period of {1e3 * period:f0} ms, {jurin:f2} by Jurin";
            TestContext.WriteLine(figures);
            if (angle == 90f) Assert.That(rise, Is.EqualTo(0.0).Within(0.5), figures);
            else Assert.That(rise * Math.Sign(jurin), Is.InRange(0.4, Math.Abs(jurin)), figures);
        }

        // After so many fifths of a period, in spacings.
        private static double Rise(float angle, int fifths)
        {
            using (var rig = new BodyRig(Water(angle)))
            {
                Dip(rig);
                rig.Start(Pool());
                Settle(rig, 0.2 * fifths * period);
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
                return Rise(rig) / Spacing;
            }
        }

        private static double Jurin(double width, double angle) =>
            2.0 * Tension * Math.Cos(angle * Math.PI / 180.0) / (Density * Gravity * width);

        // How much higher the water stands in the narrow slot than in the wide one, by their volumes above the plate's lower edge [m].
        private static double Rise(BodyRig rig)
        {
            FluidParticle[] particles = rig.Particles();
            float[] densities = rig.Densities();
            float edge = (Edge - 0.5f * Top) * Spacing, plate = (Narrow + 0.5f * Plate) * Spacing - 0.5f * Domain.x;
            double narrow = 0.0, wide = 0.0;
            for (int i = 0; i < particles.Length; i++)
            {
                if (particles[i].Position.y < edge) continue;
                // a particle at the surface lacks neighbours, not volume
                double volume = rig.Settings.ParticleMass / Math.Max(densities[i], Density);
                if (particles[i].Position.x < plate) narrow += volume;
                else wide += volume;
            }
            return (narrow / Narrow - wide / Wide) / (Spacing * Domain.z);
        }

        private static void Settle(BodyRig rig, double time)
        {
            const int steps = 8;
            double end = rig.Solver.SimulatedTime + time;
            float left = Mathf.Exp(-6f * steps * rig.Settings.TimeStep / (float)period);
            var damping = new DampVelocitiesPass(rig.Shaders);
            while (rig.Solver.SimulatedTime < end)
            {
                rig.UpdateBodies();
                GpuTest.Run(cmd =>
                {
                    for (int i = 0; i < 10; i++)
                    {
                        rig.Solver.RecordSteps(cmd, steps);
                        damping.Record(cmd, rig.State, left);
                    }
                });
            }
            rig.Setup();
        }

        // It goes on beyond the faces that are periodic, and out of the domain above.
        private static void Dip(BodyRig rig)
        {
            Vector3 size = Spacing * new Vector3(Plate, Top, 3 * Slab);
            rig.AddBox(size).position = Spacing * new Vector3(Narrow + 0.5f * Plate, Edge, 0f) -
                0.5f * new Vector3(Domain.x, Domain.y - size.y, 0f);
        }

        private static FluidParticle[] Pool()
        {
            FluidParticle[] all = ParticleSets.Lattice(new Vector3Int(Narrow + Plate + Wide, Level, Slab), Spacing, 0.02f * Spacing, 3);
            return all.Where(p => !IsPlate(p.Position)).Select((p, i) =>
                new FluidParticle(p.Position - 0.5f * (Top - Level) * Spacing * Vector3.up, Vector3.zero, (uint)i)).ToArray();
        }

        private static bool IsPlate(Vector3 inPool)
        {
            float x = inPool.x / Spacing + 0.5f * (Narrow + Plate + Wide), y = inPool.y / Spacing + 0.5f * Level;
            return x > Narrow && x < Narrow + Plate && y > Edge;
        }

        private static FluidSolverSettings Water(float angle)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.RestDensity = Density;
            input.Gravity = Gravity * Vector3.down;
            input.LiquidHeight = input.LiquidDepth = Level * Spacing;
            input.SurfaceTension = Tension;
            input.ContactAngle = angle;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = FluidAxes.Z;
            return settings;
        }
    }
}
