using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Liquids of ../methods, the page that the Robust method's limits are from, by any method, and their sums in double precision.
    /// </summary>
    internal sealed class RobustLiquid : IDisposable
    {
        private readonly StandardRig rig;

        public RobustLiquid(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            Settings = settings;
            rig = new StandardRig(settings, particles);
        }

        public FluidSolverSettings Settings { get; }

        public FluidSolver Solver => rig.Solver;

        /// <summary>Steps, and what readers see behind them.</summary>
        public void Frame(int steps) => rig.Steps(steps);

        /// <summary>Steps of another length than the settings have.</summary>
        public void Frame(int steps, float length) => GpuTest.Run(cmd =>
        {
            Solver.RecordSteps(cmd, steps, length);
            Solver.RecordNeighbourSetup(cmd);
        });

        /// <summary>Takes a part of the velocities.</summary>
        public void Damp(float left)
        {
            FluidParticle[] slowed = Particles();
            for (int i = 0; i < slowed.Length; i++) slowed[i] = new FluidParticle(slowed[i].Position, left * slowed[i].VelT0, slowed[i].Id);
            Solver.SetParticles(slowed);
        }

        public FluidParticle[] Particles() => rig.Particles();

        public float[] Densities() => rig.Densities();

        /// <summary>Mean of max(0, ρ/ρ0 − 1).</summary>
        public double Compression() => Densities().Average(d => Math.Max(0.0, d / (double)Settings.RestDensity - 1.0));

        /// <summary>Root of the mean square of the speeds [m/s].</summary>
        public double Speed() => Math.Sqrt(Particles().Average(p => Double3.Dot(p.VelT0, p.VelT0)));

        /// <summary>Twice the height of the centre over the floor [m].</summary>
        public double Height() => 2.0 * Particles().Average(p => p.Position.y + 0.5 * Settings.DomainSize.y);

        /// <summary>Kinetic energy and that in gravity over the floor, of a mass of 1 [J/kg].</summary>
        public static double Energy(IEnumerable<FluidParticle> particles, in FluidSolverSettings settings)
        {
            double g = settings.Gravity.magnitude, half = 0.5 * settings.DomainSize.y;
            return particles.Average(p => 0.5 * Double3.Dot(p.VelT0, p.VelT0) + g * (p.Position.y + half));
        }

        public double Energy() => Energy(Particles(), Settings);

        public void Dispose() => rig.Dispose();

        /// <summary>A column of 8 by 8 particles between walls, H = g = 1, 20 particles high, whose compliance is none.</summary>
        public static RobustLiquid Column(float timeStep, int iterations, int height = 20, float soundSpeed = 1000f)
        {
            float dx = 1f / height;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Robust;
            input.DomainSize = new Vector3(8f * dx, 1.5f, 8f * dx);
            input.Spacing = dx;
            input.SupportRatio = 2f;
            input.Gravity = new Vector3(0f, -1f, 0f);
            input.LiquidHeight = input.LiquidDepth = 1f;
            input.FixedTimeStep = timeStep;
            FluidSolverSettings settings = FluidRules.Derive(input).WithSoundSpeed(soundSpeed)
                .WithOwn((ref RobustSettings own) => own.Iterations = iterations);
            settings.Viscosity = 0.02f * settings.SupportRadius * settings.RestDensity;
            FluidParticle[] lattice = ParticleSets.Lattice(new Vector3Int(8, height, 8), dx, 0.05f * dx, 1);
            for (int i = 0; i < lattice.Length; i++)
            {
                lattice[i] = new FluidParticle(lattice[i].Position - 0.25f * Vector3.up, Vector3.zero, lattice[i].Id);
            }
            var column = new RobustLiquid(settings, lattice);
            column.Solver.PeakSpeed = 0f;
            return column;
        }

        /// <summary>A block of liquid thrown at 4 m/s in a closed box; dx = 2 cm, ν = 0.002 m²/s.</summary>
        /// <param name="method">The method.</param>
        /// <param name="depth">Particles across.</param>
        public static RobustLiquid Thrown(FluidMethodKind method, int depth)
        {
            const float dx = 0.02f;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = method;
            input.DomainSize = new Vector3(40f * dx, 60f * dx, depth * dx);
            input.Spacing = dx;
            input.KinematicViscosity = 0.002f;
            input.InitialSpeed = 4f;
            input.LiquidHeight = 20f * dx;
            input.LiquidDepth = 8f * dx;
            FluidSolverSettings settings = FluidRules.Derive(input);
            FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(16, 20, depth), dx, 0.05f * dx, 1);
            for (int i = 0; i < block.Length; i++)
            {
                block[i] = new FluidParticle(block[i].Position - new Vector3(12f * dx, 20f * dx, 0f), new Vector3(4f, 0f, 0f), block[i].Id);
            }
            return new RobustLiquid(settings, block);
        }
    }
}
