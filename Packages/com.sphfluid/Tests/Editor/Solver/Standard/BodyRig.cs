using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A liquid among colliders.</summary>
    internal sealed class BodyRig : IDisposable
    {
        private readonly ColliderRig colliders = new ColliderRig();
        private StandardRig liquid;

        public BodyRig(in FluidSolverSettings settings)
        {
            Settings = settings;
            colliders.DomainSize = settings.DomainSize;
            colliders.Spacing = settings.Spacing;
            Bodies = new CollisionBodies(settings);
        }

        public FluidSolverSettings Settings { get; }
        public CollisionBodies Bodies { get; }
        public FluidSolver Solver => liquid.Solver;
        public FluidShaderSet Shaders => liquid.Shaders;
        public StandardState State => liquid.State;
        public IReadOnlyList<FluidObstacle> Solids => colliders.Scene.Solids;

        /// <summary>By rule for water of a depth in a domain.</summary>
        public static FluidSolverSettings Water(Vector3 domain, float spacing, float depth, float expectedSpeed = 0f,
            FluidMethodKind method = FluidMethodKind.Standard)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = method;
            input.DomainSize = domain;
            input.Spacing = spacing;
            input.LiquidHeight = depth;
            input.LiquidDepth = depth;
            input.MinSpeed = Mathf.Max(input.MinSpeed, expectedSpeed);
            return FluidRules.Derive(input);
        }

        /// <summary>Adds triangles, three corners each.</summary>
        public Transform Add(IReadOnlyList<Vector3> corners)
        {
            var vertices = new Vector3[corners.Count];
            var indices = new int[corners.Count];
            for (int i = 0; i < indices.Length; i++)
            {
                vertices[i] = corners[i];
                indices[i] = i;
            }
            var mesh = new Mesh
            {
                name = "Test Triangles", indexFormat = UnityEngine.Rendering.IndexFormat.UInt32, vertices = vertices,
                triangles = indices
            };
            return colliders.AddMesh(mesh).transform;
        }

        /// <summary>Adds a ball around the origin, of rings of quads.</summary>
        public Transform AddBall(float radius, int rings)
        {
            Vector3 At(int ring, int step)
            {
                float polar = Mathf.PI * ring / rings, turn = Mathf.PI * step / rings;
                return radius * new Vector3(Mathf.Sin(polar) * Mathf.Cos(turn), Mathf.Cos(polar), Mathf.Sin(polar) * Mathf.Sin(turn));
            }
            var corners = new List<Vector3>();
            for (int ring = 0; ring < rings; ring++)
                for (int step = 0; step < 2 * rings; step++)
                {
                    Vector3 a = At(ring, step), b = At(ring, step + 1), c = At(ring + 1, step), d = At(ring + 1, step + 1);
                    if (ring > 0) corners.AddRange(new[] { a, b, c });
                    if (ring < rings - 1) corners.AddRange(new[] { b, d, c });
                }
            return Add(corners);
        }

        public Transform AddBox(Vector3 size)
        {
            Transform box = colliders.AddMesh(TestMeshes.Cube()).transform;
            box.localScale = size;
            return box;
        }

        public void Start(FluidParticle[] particles)
        {
            liquid = new StandardRig(Settings, particles);
            UpdateBodies();
            liquid.Solver.SetBodies(Bodies);
        }

        public void UpdateBodies()
        {
            colliders.Gather();
            Bodies.Update(colliders.Scene.Solids);
        }

        /// <summary>Follows the colliders and steps.</summary>
        public void Frame(int steps)
        {
            UpdateBodies();
            liquid.Steps(steps);
        }

        public FluidParticle[] Particles() => liquid.Particles();
        public float[] Densities() => liquid.Densities();
        public void Setup() => liquid.Setup();

        public void Dispose()
        {
            liquid?.Dispose();
            Bodies.Dispose();
            colliders.Dispose();
        }
    }
}
