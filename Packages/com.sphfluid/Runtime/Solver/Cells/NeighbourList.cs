using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Neighbours that a step's density pass finds, kept for its motion pass and for later steps (Shaders/Solver/Cells/NeighbourList.hlsl):
    /// they look at neighbours only, not at all particles of the cells around. Whoever has more than the list holds searches the cells
    /// again.
    /// </summary>
    internal sealed class NeighbourList : BufferSet
    {
        /// <summary>LIST_LANES in Shaders/Solver/Cells/NeighbourList.hlsl.</summary>
        public const int Lanes = 32;

        // Entries over a full lattice's neighbours: for compression and clumps.
        private const double Reserve = 1.5;

        // Of a full lattice's neighbours: whoever has fewer stands at a surface.
        private const double Surface = 0.75;

        private static readonly int ListLength = Shader.PropertyToID("_ListLength");
        private static readonly int InverseSupport = Shader.PropertyToID("_InverseSupport");
        private static readonly int SupportSquared = Shader.PropertyToID("_SupportSquared");
        private static readonly int Ahead = Shader.PropertyToID("_Ahead");
        private static readonly int FewNeighbours = Shader.PropertyToID("_FewNeighbours");

        /// <summary>Runs of pairs, 32 particles side by side; the shader tells how.</summary>
        public readonly FluidBuffer Neighbours;

        /// <summary>Behind them, neighbours of each particle, listed or not.</summary>
        public readonly BufferRange Counts;

        /// <summary>And other numbers of each: ρ [kg/m³], as bits.</summary>
        public readonly BufferRange Densities;

        /// <summary>1 + the place of its walls of triangles, or 0.</summary>
        public readonly BufferRange WallSlot;

        /// <summary>Of each plane of those walls the number of a body that the liquid moves.</summary>
        public readonly BufferRange WallBodies;

        /// <summary>A list for a number of particles.</summary>
        /// <param name="particleCount">Number of particles.</param>
        /// <param name="length">Most neighbours of a particle that are listed, even; 0 for a step that searches twice.</param>
        /// <param name="isPlanned">Whether only its size is asked for.</param>
        public NeighbourList(int particleCount, int length, bool isPlanned = false) : base(isPlanned)
        {
            Length = length;
            long words = WordCount(particleCount, length);
            Neighbours = Add("Neighbours", ElementCount(particleCount, length), sizeof(uint));
            Counts = Neighbours.Range("NeighbourCounts", words);
            Densities = Neighbours.Range("Densities", words + particleCount);
            WallSlot = Neighbours.Range("WallSlot", words + 2L * particleCount);
            WallBodies = Neighbours.Range("WallBodies", words + 3L * particleCount);
        }

        /// <summary>Most neighbours of a particle that are listed; somewhat fewer where they are not one run.</summary>
        public int Length { get; }

        /// <summary>
        /// Entries a particle by κ = R/dx: 4π κ³/3 neighbours on a lattice, and half as many again, even. 52, 72, 100 for κ = 2, 2.25, 2.5.
        /// </summary>
        public static int LengthFor(in FluidSolverSettings settings) =>
            2 * (int)Math.Ceiling(Reserve / 2.0 * Expected(settings));

        /// <summary>Words of a particle: one that begins a run, and two neighbours in each other.</summary>
        public static int ColumnWords(int length) => length > 0 ? length / 2 + 1 : 0;

        /// <summary>Whether one buffer of the device holds the list; a step does without where it does not.</summary>
        public static bool Fits(int particleCount, int length) =>
            ElementCount(particleCount, length) * sizeof(uint) <= SystemInfo.maxGraphicsBufferSize;

        /// <summary>Records the list for the kernel that fills it.</summary>
        public void SetOut(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetInt(cmd, ListLength, Length);
            kernel.SetOut(cmd, Counts);
            kernel.SetOut(cmd, Densities);
        }

        /// <summary>Records the list for a kernel that reads it.</summary>
        public void Set(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetInt(cmd, ListLength, Length);
            kernel.Set(cmd, Counts);
        }

        /// <summary>
        /// Records ScatterParticles.compute for the sort: which particles are at a surface, and how long the lists must last.
        /// </summary>
        public void SetMeeting(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            FluidSolverSettings settings = state.Settings;
            kernel.SetFloat(cmd, InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, SupportSquared, settings.SupportRadius * settings.SupportRadius);
            kernel.SetFloat(cmd, Ahead, state.ListTime);
            kernel.SetInt(cmd, FewNeighbours, (int)(Surface * Expected(settings)));
            kernel.Set(cmd, Counts);
        }

        // Of a particle, behind the entries.
        private const int Numbers = 4;

        private static double Expected(in FluidSolverSettings settings) =>
            4.0 / 3.0 * Math.PI * Math.Pow(settings.SupportRadius / (double)settings.Spacing, 3.0);

        private static long ElementCount(int particleCount, int length) =>
            WordCount(particleCount, length) + Numbers * (long)particleCount;

        // Of the columns.
        private static long WordCount(int particleCount, int length) =>
            ((long)particleCount + Lanes - 1) / Lanes * Lanes * ColumnWords(length);
    }
}
