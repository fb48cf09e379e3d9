using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A force of the Standard method with passes of its own: its settings and rules, its limit of the time step, its buffers and its
    /// passes. A force is one folder with a class like this, and a line in <see cref="StandardForces"/>.
    /// </summary>
    internal abstract class ParticleForce
    {
        /// <summary>What a liquid asks for by it.</summary>
        public abstract FluidMethodFeatures Feature { get; }

        /// <summary>What it appends to the name of the work that kept costs are of: a plus and a word.</summary>
        public abstract string CostVariant { get; }

        /// <summary>Passes over every particle's neighbours that it adds to a step.</summary>
        public abstract int Walks { get; }

        /// <summary>Its shaders, by the names of their passes.</summary>
        public abstract IReadOnlyList<string> Shaders { get; }

        /// <summary>The fields of a profile that it reads, by their serialised names.</summary>
        public abstract IReadOnlyList<string> ProfileFields { get; }

        /// <summary>Whether walls have to push by their whole profile while it acts: <see cref="CellState.SteepestWall"/>.</summary>
        public virtual bool NeedsWholeWalls => false;

        /// <summary>Whether it makes mirrors of the domain's faces: <see cref="CellState.HasMirrors"/>.</summary>
        public virtual bool MakesMirrors => false;

        /// <summary>Whether it takes something along in the sort: its buffers are <see cref="ICarriedBuffers"/>.</summary>
        public virtual bool Carries => false;

        /// <summary>What of it the present device cannot run, a sentence each with its cure.</summary>
        public virtual IEnumerable<string> Shortfalls => Array.Empty<string>();

        /// <summary>Its constants by rule.</summary>
        /// <param name="input">The liquid.</param>
        /// <param name="settings">Settings that take them.</param>
        /// <exception cref="System.ArgumentException">It cannot act in a liquid that asks for it.</exception>
        public abstract void Derive(in FluidRuleInput input, ref StandardSettings settings);

        /// <summary>Checks its constants.</summary>
        /// <exception cref="System.ArgumentException">One is out of range; the message names it.</exception>
        public abstract void Validate(in StandardSettings settings);

        /// <summary>Whether it acts.</summary>
        public abstract bool Acts(in StandardSettings settings);

        /// <summary>
        /// Its name and why it acts in a liquid, as the end of a sentence: "surface friction, which acts in this liquid of 2 Pa s".
        /// </summary>
        public abstract string Describe(in FluidRuleInput input);

        /// <summary>Least speed of sound by which the liquid withstands it [m/s].</summary>
        public virtual double LeastSoundSpeed(in FluidRuleInput input, in StandardSettings settings) => 0.0;

        /// <summary>The largest stable step [s]; infinite where it sets none.</summary>
        public virtual double LargestStep(in FluidSolverSettings settings) => double.PositiveInfinity;

        /// <summary>Makes what it keeps for each particle.</summary>
        public abstract BufferSet MakeBuffers(int particleCount, bool isPlanned);

        /// <summary>Makes its passes.</summary>
        public abstract ForcePasses MakePasses(FluidShaderSet shaders);

        /// <summary>Records its part in StandardDensity.compute.</summary>
        public virtual void SetDensity(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
        }

        /// <summary>Records its part in PairForces.hlsl.</summary>
        public virtual void SetMotion(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
        }
    }

    /// <summary>The passes of a <see cref="ParticleForce"/>.</summary>
    internal abstract class ForcePasses
    {
        /// <summary>Records what the force changes of the velocities with which a step begins.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers; those of the force are there.</param>
        /// <param name="step">The step.</param>
        public abstract void Record(CommandBuffer cmd, StandardState state, in FluidStep step);
    }
}
