using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Buffers and passes of the thesis method around given particles, to test one block at a time.</summary>
    internal sealed class ThesisRig : IDisposable
    {
        private readonly FluidShaderSet shaders;
        private readonly ThesisStepper stepper;
        private GraphicsBuffer triangles;
        private GraphicsBuffer colliders;

        public ThesisRig(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            shaders = TestShaders.CreateSet();
            stepper = new ThesisStepper(settings, shaders, particles.Length);
            if (particles.Length > 0) State.Published.Particles.SetData(particles);
        }

        public ThesisState State => stepper.State;

        public FluidShaderSet Shaders => shaders;

        /// <summary>A step of the settings' length after another of the same.</summary>
        public FluidStep Step => new FluidStep(State.Settings.TimeStep, State.Settings.TimeStep, false);

        /// <summary>Runs the blocks 6.2.2 to 6.3.1: the particles are then in the order of their cells, with densities.</summary>
        public void RunNeighbourSetup() => GpuTest.Run(cmd => stepper.RecordNeighbourSetup(cmd));

        /// <summary>Runs block 6.3.2 after the neighbour setup.</summary>
        public void RunForce() => GpuTest.Run(cmd => new CalculateForcePass(shaders).Record(cmd, State));

        /// <summary>Runs block 6.3.3 after the force.</summary>
        public void RunAcceleration() => GpuTest.Run(cmd => new CalculateAccelerationPass(shaders).Record(cmd, State, Step));

        public FluidParticle[] ReadParticles() => GpuTest.Read<FluidParticle>(State.Published.Particles, State.ParticleCount);

        public float[] ReadDensity() => GpuTest.Read<float>(State.Published.Density, State.ParticleCount);

        public float[] ReadPressure() => GpuTest.Read<float>(State.Published.Pressure, State.ParticleCount);

        public Vector4[] ReadForce() => GpuTest.Read<Vector4>(State.Buffers.Force, State.ParticleCount);

        public Vector4[] ReadAcceleration() => GpuTest.Read<Vector4>(State.Buffers.Acceleration, State.ParticleCount);

        public void SetMeshes(IReadOnlyList<ReferenceMesh> meshes)
        {
            var allTriangles = new List<CollisionTriangle>();
            var records = new List<CollisionCollider>();
            foreach (ReferenceMesh mesh in meshes) records.Add(Record(mesh, allTriangles));

            triangles = GpuBuffers.Create("Triangles", allTriangles.Count, CollisionTriangle.Stride);
            colliders = GpuBuffers.Create("Colliders", records.Count, CollisionCollider.Stride);
            triangles.SetData(allTriangles.ToArray());
            colliders.SetData(records.ToArray());
            State.SetTriangles(triangles, colliders, records.Count);
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref triangles);
            GpuBuffers.Dispose(ref colliders);
            stepper.Dispose();
            UnityEngine.Object.DestroyImmediate(shaders);
        }

        private static CollisionCollider Record(ReferenceMesh mesh, List<CollisionTriangle> all)
        {
            Vector3 min = Vector3.positiveInfinity;
            Vector3 max = Vector3.negativeInfinity;
            int first = all.Count;
            foreach (Double3[] t in mesh.Triangles)
            {
                all.Add(new CollisionTriangle { A = ToFloat(t[0]), B = ToFloat(t[1]), C = ToFloat(t[2]) });
                foreach (Double3 corner in t)
                {
                    min = Vector3.Min(min, ToFloat(corner));
                    max = Vector3.Max(max, ToFloat(corner));
                }
            }

            return new CollisionCollider
            {
                BoundsMin = min,
                FirstTriangle = (uint)first,
                BoundsMax = max,
                TriangleCount = (uint)mesh.Triangles.Count | (mesh.Closed ? CollisionCollider.ClosedBit : 0u),
            };
        }

        private static Vector3 ToFloat(Double3 v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);
    }
}
