using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the iterations that the rule takes leave of the viscous equations in a running liquid, in double precision over all pairs.
    /// </summary>
    public sealed class ViscousSolutionTests
    {
        private const float Spacing = 0.025f;

        // Of what the velocities before the step leave: 0.05 by ImplicitViscosity, and single precision.
        private const double Left = 0.05 + 1e-3;

        // Times the viscosity at the border of explicit steps as long as those of water.
        [TestCase(1.0)]
        [TestCase(20.0)]
        [TestCase(1000.0)]
        public void AStepLeavesATwentiethOfTheResidual(double overBorder)
        {
            FluidSolverSettings water = Rules(1e-6),
                settings = Rules(overBorder * 0.072 * 0.97628 * water.SupportRadius * water.SupportRadius / water.TimeStep);
            Assert.That(settings.Own<StandardSettings>().ImplicitViscosity, Is.True);
            FluidParticle[] flow = Flow(settings, out Dictionary<uint, float> densities);
            using (var rig = new StandardStateRig(settings, flow.Length))
            {
                FluidParticle[] particles = rig.FillSorted(flow);
                rig.FillList(particles, true);
                double c2 = (double)settings.SoundSpeed * settings.SoundSpeed;
                rig.SetTerms(particles.Select(p => densities[p.Id])
                    .Select(d => new Vector2(d, (float)(Math.Max(0.0, c2 * (d - settings.RestDensity)) / ((double)d * d)))).ToArray());
                Double3[] before = particles.Select(p => (Double3)p.VelT0).ToArray(), after = Solve(rig, out Double3[] kicked);

                var reference = new ViscousReference(settings, particles, settings.TimeStep);
                Double3[] right = kicked.Select((v, i) => v + reference.WallDrive(i)).ToArray(), exact = reference.Solve(right);
                double residual = Norm(right, reference.Times(after)) / Norm(right, reference.Times(before));
                double error = Norm(after, exact) / Norm(before, exact),
                    ofSpeed = Norm(after, exact) / Norm(exact, new Double3[exact.Length]);
                string figures =
                    $"{overBorder} times the border, {settings.Viscosity / settings.RestDensity:g3} m²/s, steps of " +
                    $"{1e3 * settings.TimeStep:g3} ms, " +
                    $"{ImplicitViscosity.Iterations(settings, settings.TimeStep)} iterations: residual {residual:g3} and error " +
                    $"{error:g3} of those before the step, error {ofSpeed:g3} of the speed";
                Assert.That(Norm(before, exact), Is.GreaterThan(1e-4), "the step has something to do: " + figures);
                Assert.That(residual, Is.LessThan(Left), figures);
                Assert.That(error, Is.LessThan(Left), figures);
                TestContext.WriteLine(figures);
            }
        }

        private static Double3[] Solve(StandardStateRig rig, out Double3[] kicked)
        {
            rig.State.RequireViscous();
            var kick = new KickParticlesPass(rig.Shaders);
            var diffuse = new DiffuseVelocitiesPass(rig.Shaders);
            float length = rig.State.Settings.TimeStep;
            GpuTest.Run(cmd =>
            {
                kick.Record(cmd, rig.State, new FluidStep(length, length, false));
                diffuse.Record(cmd, rig.State, new FluidStep(length, length, false));
            });
            kicked = Read(rig.State.Buffers.NewVelocities, rig.State.ParticleCount);
            return Read(rig.State.Viscous.Diffused, rig.State.ParticleCount);
        }

        private static Double3[] Read(GraphicsBuffer buffer, int count) =>
            GpuTest.Read<Vector4>(buffer, count).Select(v => (Double3)(Vector3)v).ToArray();

        // A block that shears and turns, just after it has met the floor that holds it.
        private static FluidParticle[] Flow(in FluidSolverSettings settings, out Dictionary<uint, float> densities)
        {
            const int side = 9;
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(side, side, side), Spacing, 0.02f * Spacing, 2);
            for (int i = 0; i < start.Length; i++)
            {
                Vector3 p = start[i].Position;
                start[i].VelT0 = new Vector3(Mathf.Sin(30f * p.y) - 2f * p.z, -1f, Mathf.Sin(50f * p.x) + 2f * p.x);
                start[i].Position = p + (0.5f * (side * Spacing - settings.DomainSize.y) + 0.2f * Spacing) * Vector3.up;
            }
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(20);
                FluidParticle[] particles = rig.Particles();
                float[] found = rig.Densities();
                densities = Enumerable.Range(0, particles.Length).ToDictionary(i => particles[i].Id, i => found[i]);
                return particles;
            }
        }

        private static FluidSolverSettings Rules(double kinematic)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Vector3.one;
            input.Spacing = Spacing;
            input.LiquidHeight = input.LiquidDepth = 1f;
            input.KinematicViscosity = (float)kinematic;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Friction = 1f;
            return settings;
        }

        private static double Norm(Double3[] a, Double3[] b)
        {
            Double3[] d = a.Zip(b, (x, y) => x - y).ToArray();
            return Math.Sqrt(ViscousReference.Product(d, d) / d.Length);
        }
    }
}
