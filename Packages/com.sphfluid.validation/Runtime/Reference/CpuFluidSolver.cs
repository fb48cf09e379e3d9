using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The thesis method on the CPU, as Burst jobs on all cores: same settings, equations and particle order as
    /// <see cref="FluidSolver"/>, in double precision. An oracle for tests and measurements, not for play. Particles are
    /// sorted by cell, then by their place in the step before; results do not depend on the number of cores.
    /// </summary>
    public sealed class CpuFluidSolver : IDisposable
    {
        private const int Batch = 32;

        // Below every pressure: equation (10) as printed.
        private const double NoFloor = -1e30;

        private readonly FluidSolverSettings settings;
        private readonly CpuFluidBuffers buffers;
        private readonly CpuMeshes meshes;
        private readonly CpuNeighbours neighbours;
        private readonly CpuRounding rounding;
        private double previousStep;
        private bool densityFresh;
        private bool disposed;

        /// <summary>Takes a copy of the particles.</summary>
        /// <param name="settings">The physics; <see cref="ThesisRules.With"/> sets the thesis's switches.</param>
        /// <param name="initial">Particles at the start, one or more, inside the domain.</param>
        /// <param name="precision">In what values are kept.</param>
        /// <exception cref="ArgumentException">A constant or the particles cannot be computed with.</exception>
        public CpuFluidSolver(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> initial,
            CpuFluidPrecision precision = CpuFluidPrecision.Double)
        {
            settings.Validate();
            FluidParticle[] particles = FluidSolver.CheckParticles(settings, initial);
            this.settings = settings;
            Precision = precision;
            rounding = new CpuRounding { ToFloat = precision == CpuFluidPrecision.Single };
            FluidGrid grid = FluidGrid.For(settings);
            buffers = new CpuFluidBuffers(particles, grid.CellCount);
            meshes = new CpuMeshes();
            neighbours = new CpuNeighbours(grid, settings, buffers.First);
        }

        /// <summary>In what values are kept.</summary>
        public CpuFluidPrecision Precision { get; }

        /// <summary>The physics, a copy.</summary>
        public FluidSolverSettings Settings => settings;

        /// <summary>Number of particles.</summary>
        public int ParticleCount => buffers.Particles.Length;

        /// <summary>Steps done since the start.</summary>
        public long StepCount { get; private set; }

        /// <summary>Time since the start [s].</summary>
        public double SimulatedTime { get; private set; }

        /// <summary>Particles, in the order of the last sort. Ask again after each step: two arrays alternate.</summary>
        public NativeArray<CpuFluidParticle>.ReadOnly Particles => Alive().Particles.AsReadOnly();

        /// <summary>Density [kg/m³] of each particle, as of the last step's start or the last <see cref="UpdateDensity"/>.</summary>
        public NativeArray<double>.ReadOnly Density => Alive().Density.AsReadOnly();

        /// <summary>Pressure [Pa] of each particle, as of the density.</summary>
        public NativeArray<double>.ReadOnly Pressure => Alive().Pressure.AsReadOnly();

        /// <summary>Force density [N/m³] on each particle in the last step.</summary>
        public NativeArray<double3>.ReadOnly Force => Alive().Force.AsReadOnly();

        /// <summary>Acceleration [m/s²] of each particle in the last step, collisions and gravity included.</summary>
        public NativeArray<double3>.ReadOnly Acceleration => Alive().Acceleration.AsReadOnly();

        /// <summary>Events since the start, and maxima of the last <see cref="Step(int, float)"/>.</summary>
        public FluidCounters Counters => Alive().ReadCounters(settings.RestDensity);

        /// <summary>Adds a mesh that the liquid collides with.</summary>
        /// <param name="corners">Three corners a triangle [m], simulation space; cross(B − A, C − A) points out of the solid.</param>
        /// <param name="closed">True: the mesh encloses a volume, and pushes out what got inside. False: a sheet with two sides.</param>
        /// <exception cref="ArgumentException">There is no triangle, or a corner too few.</exception>
        public void AddMesh(IReadOnlyList<Vector3> corners, bool closed)
        {
            Alive();
            meshes.Add(corners, closed);
        }

        /// <summary>Does a number of steps and waits for them.</summary>
        /// <param name="steps">Number of steps, zero or more.</param>
        public void Step(int steps)
        {
            Step(steps, settings.TimeStep);
        }

        /// <summary>Does a number of steps of another length than the settings have, and waits for them.</summary>
        /// <param name="steps">Number of steps, zero or more.</param>
        /// <param name="timeStep">Length of each [s], positive; the first kick after a change is the mean of both lengths.</param>
        public void Step(int steps, float timeStep)
        {
            Alive();
            if (!(timeStep > 0f) || float.IsInfinity(timeStep))
            {
                throw new ArgumentOutOfRangeException(nameof(timeStep), timeStep,
                    "The length of a step must be a positive number of seconds.");
            }

            if (steps < 0) throw new ArgumentOutOfRangeException(nameof(steps), steps, "The number of steps must be zero or more.");

            buffers.ResetMaxima();
            for (int i = 0; i < steps; i++)
            {
                UpdateDensity();
                Move(timeStep, StepCount == 0 ? timeStep : previousStep);
                previousStep = timeStep;
                densityFresh = false;
                StepCount++;
                SimulatedTime += timeStep;
            }
        }

        /// <summary>Sorts the particles and computes density and pressure at their present positions; the next step uses it.</summary>
        public void UpdateDensity()
        {
            Alive();
            if (densityFresh) return;

            int count = ParticleCount;
            double h = settings.SupportRadius;
            JobHandle cells = new CpuCellJob { Neighbours = neighbours, Particles = buffers.Particles, Cells = buffers.Cells }
                .Schedule(count, Batch);
            JobHandle lists = new CpuCellListJob { Cells = buffers.Cells, First = buffers.First, Order = buffers.Order }
                .Schedule(cells);
            JobHandle sorted = new CpuReorderJob { Source = buffers.Particles, Order = buffers.Order, Sorted = buffers.Sorted }
                .Schedule(count, Batch, lists);
            buffers.SwapParticles();
            var density = new CpuDensityJob
            {
                Neighbours = neighbours,
                Rounding = rounding,
                SmoothLengthSquared = h * h,
                Coefficient = settings.ParticleMass * CpuKernels.Poly6Factor(h),
                RestDensity = settings.RestDensity,
                Stiffness = settings.Own<ThesisSettings>().Stiffness,
                PressureFloor = settings.PressureClamp ? 0.0 : NoFloor,
                SelfDensity = settings.Own<ThesisSettings>().SelfDensity,
                Particles = buffers.Particles,
                Density = buffers.Density,
                Pressure = buffers.Pressure,
            };
            density.Schedule(count, Batch, sorted).Complete();
            densityFresh = true;
        }

        /// <summary>The particles as floats, in the order of the last sort.</summary>
        /// <returns>A new array.</returns>
        public FluidParticle[] ToFloat()
        {
            NativeArray<CpuFluidParticle> particles = Alive().Particles;
            var copy = new FluidParticle[particles.Length];
            for (int i = 0; i < copy.Length; i++) copy[i] = particles[i].ToFloat();

            return copy;
        }

        /// <summary>Releases the memory.</summary>
        public void Dispose()
        {
            if (!disposed)
            {
                disposed = true;
                buffers.Dispose();
                meshes.Dispose();
            }
        }

        private void Move(float timeStep, double previous)
        {
            double kick = 0.5 * (previous + timeStep);
            int count = ParticleCount;
            double factor = settings.ParticleMass * CpuKernels.SpikyGradientFactor(settings.SupportRadius);
            double3 half = 0.5 * CpuFluidParticle.Double(settings.DomainSize);
            var force = new CpuForceJob
            {
                Neighbours = neighbours,
                Rounding = rounding,
                SmoothLength = settings.SupportRadius,
                PressureCoefficient = settings.Own<ThesisSettings>().PressureHalf ? 0.5 * factor : factor,
                ViscosityCoefficient = settings.Viscosity * factor,
                Particles = buffers.Particles,
                Density = buffers.Density,
                Pressure = buffers.Pressure,
                Force = buffers.Force,
            };
            var acceleration = new CpuAccelerationJob
            {
                Rounding = rounding,
                Collision = meshes.Collision(settings, half, timeStep, kick),
                PrintedMass = settings.Own<ThesisSettings>().ForceTimesMass ? settings.ParticleMass : 0.0,
                AccelerationLimit = settings.Own<ThesisSettings>().AccelerationLimitEnabled ? AccelerationLimit(timeStep) : double.MaxValue,
                Gravity = CpuFluidParticle.Double(settings.Gravity),
                BodyForceCentre = CpuFluidParticle.Double(settings.BodyForce.Centre),
                BodyForceRate = CpuFluidParticle.Double(settings.BodyForce.RateSquared),
                Particles = buffers.Particles,
                Density = buffers.Density,
                Force = buffers.Force,
                Acceleration = buffers.Acceleration,
                Events = buffers.Events,
            };
            var position = new CpuNewPositionJob
            {
                Rounding = rounding,
                Period = neighbours.Period,
                TimeStep = timeStep,
                KickStep = kick,
                KickPart = previous / (previous + timeStep),
                FirstStep = StepCount == 0 && settings.Own<ThesisSettings>().HalfKick,
                HalfSize = half,
                Acceleration = buffers.Acceleration,
                Particles = buffers.Particles,
                Events = buffers.Events,
            };
            JobHandle forced = force.Schedule(count, Batch);
            JobHandle accelerated = acceleration.Schedule(count, Batch, forced);
            JobHandle moved = position.Schedule(count, Batch, accelerated);
            buffers.CountEvents().Schedule(moved).Complete();
        }

        // The limit is a distance a step: steps of another length scale it by 1/dt². A float on the GPU.
        private double AccelerationLimit(float timeStep)
        {
            var own = settings.Own<ThesisSettings>();
            double steps = own.AccelerationLimitFixed ? 1.0 : settings.TimeStep / (double)timeStep;
            return (float)(own.AccelerationLimit * steps * steps);
        }

        private CpuFluidBuffers Alive()
        {
            return disposed ? throw new ObjectDisposedException(nameof(CpuFluidSolver)) : buffers;
        }
    }
}
