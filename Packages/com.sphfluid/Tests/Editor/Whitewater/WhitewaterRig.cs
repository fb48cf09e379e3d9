using System;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A liquid and its whitewater, to test one pass at a time.</summary>
    internal sealed class WhitewaterRig : IDisposable
    {
        public const float Spacing = 0.05f;
        public static readonly Vector3 Domain = new Vector3(1f, 0.8f, 0.9f);

        private readonly FluidShaderSet shaders;

        public WhitewaterRig(in FluidSolverSettings settings, FluidParticle[] particles, int capacity = 1)
        {
            GpuTest.Require();
            shaders = TestShaders.PackageSet;
            Solver = new FluidSolver(settings, shaders, particles);
            Buffers = new WhitewaterBuffers(capacity);
            GpuTest.Run(Solver.RecordNeighbourSetup);
            Buffers.Reserve(Solver.ParticleCount);
        }

        public FluidSolver Solver { get; }

        public WhitewaterBuffers Buffers { get; }

        /// <summary>Water in <see cref="Domain"/>.</summary>
        public static FluidSolverSettings Settings(FluidMethodKind method, FluidAxes periodic = FluidAxes.None,
            FluidFaces open = FluidFaces.None)
        {
            FluidRuleInput input = method == FluidMethodKind.Standard ? FluidRuleInput.Water : FluidRuleInput.ThesisWater;
            input.Method = method;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.LiquidHeight = Domain.y;
            input.LiquidDepth = 0.5f * Domain.y;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = periodic;
            settings.Boundaries.Open = open;
            return settings;
        }

        /// <summary>The liquid in the order of the GPU.</summary>
        public FluidParticle[] Particles => GpuTest.Read<FluidParticle>(Solver.Particles, Solver.ParticleCount);

        public uint[] State => GpuTest.Read<uint>(Buffers.State, WhitewaterBuffers.StateSlots);

        /// <summary>Puts pieces in the place of the present ones.</summary>
        public void Put(WhitewaterPiece[] pieces, params (int slot, uint value)[] others)
        {
            if (pieces.Length > 0) Buffers.Present.SetData(pieces);
            var state = new uint[WhitewaterBuffers.StateSlots];
            state[0] = (uint)pieces.Length;
            foreach ((int slot, uint value) in others) state[slot] = value;
            Buffers.State.SetData(state);
        }

        public void Measure(float amount, float duration) =>
            GpuTest.Run(cmd => new WhitewaterPotentialsPass(shaders).Record(cmd, Solver, Buffers, amount, duration));

        public WhitewaterPiece[] Move(int count, float duration)
        {
            GpuTest.Run(cmd => new WhitewaterMotionPass(shaders).Record(cmd, Solver, Buffers, duration));
            return GpuTest.Read<WhitewaterPiece>(Buffers.Present, count);
        }

        public WhitewaterPiece[] List(int step, float foamLife, float duration)
        {
            GpuTest.Run(cmd => new WhitewaterListPass(shaders).Record(cmd, Solver, Buffers, step, foamLife, duration));
            return GpuTest.Read<WhitewaterPiece>(Buffers.Next, (int)State[0]);
        }

        public static float Number(uint bits) => BitConverter.Int32BitsToSingle(unchecked((int)bits));

        public static uint Bits(float number) => unchecked((uint)BitConverter.SingleToInt32Bits(number));

        public void Dispose()
        {
            Buffers.Dispose();
            Solver.Dispose();
        }
    }
}
