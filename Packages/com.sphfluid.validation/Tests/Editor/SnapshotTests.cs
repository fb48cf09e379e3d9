using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A snapshot is of the liquid alone: what left through an open face is not in it.</summary>
    public sealed class SnapshotTests
    {
        [Test]
        public void WhatLeftTheDomainIsNotInIt()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = new Vector3(0.4f, 0.6f, 0.35f);
            input.Spacing = 0.05f;
            input.LiquidHeight = input.LiquidDepth = 0.4f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Open = FluidFaces.LowY;
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(7, 8, 6), 0.05f, 1e-3f, 5);
            FluidShaderSet shaders = TestShaders.CreateSet();
            using (var solver = new FluidSolver(settings, shaders, start))
            {
                while (solver.ReadCountersNow().Removed < 50) GpuTest.Run(cmd => solver.RecordSteps(cmd, 10));
                FluidSnapshot snapshot = FluidSnapshot.Read(solver);
                uint[] liquid = GpuTest.Read<FluidParticle>(solver.Particles, start.Length).Where(p => !p.IsRemoved)
                    .Select(p => p.Id).ToArray();
                Assert.That(liquid.Length, Is.GreaterThan(0).And.LessThan(start.Length));
                Assert.That(snapshot.Ids, Is.EquivalentTo(liquid));
                Assert.That(snapshot.Densities, Is.All.GreaterThan(0f));
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
