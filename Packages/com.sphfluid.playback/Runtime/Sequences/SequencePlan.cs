using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>What of a playback can only change with a new beginning.</summary>
    internal struct PlaybackOptions : IEquatable<PlaybackOptions>
    {
        public string Folder;
        public float FrameRate;
        public FluidSequenceAxes Axes;
        public float Scale;

        /// <summary>Memory that frames may take [MiB].</summary>
        public int MemoryBudget;

        public bool Interpolates;

        public readonly bool Equals(PlaybackOptions other) => Folder == other.Folder && FrameRate.Equals(other.FrameRate) &&
            Axes == other.Axes && Scale.Equals(other.Scale) &&
            MemoryBudget == other.MemoryBudget && Interpolates == other.Interpolates;

        public override readonly bool Equals(object obj) => obj is PlaybackOptions other && Equals(other);

        public override readonly int GetHashCode() => HashCode.Combine(Folder, FrameRate, Axes, Scale, MemoryBudget, Interpolates);
    }

    /// <summary>A sequence and how it is to be played: what is known before a frame is read.</summary>
    internal sealed class SequencePlan : IFluidPlayback
    {
        // A sequence of the simulation's own spacing but for the digits that were written down.
        private const float SpacingTolerance = 0.01f;

        private readonly PlaybackOptions options;
        private readonly Object owner;

        private SequencePlan(in PlaybackOptions options, ParticleSequence sequence, Object owner)
        {
            this.options = options;
            this.owner = owner;
            Sequence = sequence;
            Slots = (int)Math.Min(sequence.Frames.Count,
                Math.Max(0L, ((long)options.MemoryBudget << 20) - FixedBytes) / Math.Max(1L, FrameBytes));
        }

        /// <summary>The sequence.</summary>
        public ParticleSequence Sequence { get; }

        /// <summary>Frames that are held in memory.</summary>
        public int Slots { get; }

        /// <summary>Memory that the playback takes [bytes].</summary>
        public long Bytes => FixedBytes + Slots * FrameBytes;

        /// <summary>Whether particles are shown between frames; without numbers nobody knows which is which.</summary>
        public bool Interpolates => options.Interpolates && Sequence.HasIds;

        /// <summary>How they go from one to the next.</summary>
        public SequenceBlend Blend => Sequence.HasVelocities ? SequenceBlend.Hermite : SequenceBlend.Linear;

        /// <inheritdoc/>
        public long MostParticles => Sequence.MostParticles;

        private long FrameBytes => Sequence.MostParticles * StoredParticle.Stride;

        // The file as it is read, and the particles as they are shown.
        private long FixedBytes => Sequence.MostBytes + Sequence.MostParticles * FluidParticle.Stride;

        /// <summary>Opens a sequence.</summary>
        /// <param name="options">Which, and how it is to be played.</param>
        /// <param name="owner">The object that messages name.</param>
        /// <param name="problem">Why it cannot be played.</param>
        /// <returns>Null where it cannot.</returns>
        public static SequencePlan TryMake(in PlaybackOptions options, Object owner, out FluidMessage? problem)
        {
            problem = null;
            if (string.IsNullOrWhiteSpace(options.Folder))
            {
                problem = Invalid(owner, "No folder is given, so nothing is played.",
                    "Set Folder to a sequence: a folder with sequence.json or .ply files.");
                return null;
            }
            if (!(options.Scale > 0f) || float.IsInfinity(options.Scale))
            {
                problem = Invalid(owner, FormattableString.Invariant($"Scale is {options.Scale}, so nothing is played."),
                    "Set Scale to the metres of a unit of length in the files; 1 for metres.");
                return null;
            }
            try
            {
                var plan = new SequencePlan(options, SequenceFolder.Open(options.Folder, options.FrameRate), owner);
                if (plan.Slots >= Math.Min(2, plan.Sequence.Frames.Count)) return plan;
                long needed = (plan.FixedBytes + 2L * plan.FrameBytes + (1L << 20) - 1) >> 20;
                problem = Invalid(owner,
                    $"A Memory Budget of {options.MemoryBudget} MiB holds fewer than two frames of {plan.MostParticles} particles, so " +
                    "nothing is played.",
                    $"Raise Memory Budget to {needed} or more.");
            }
            catch (SequenceException exception)
            {
                problem = Invalid(owner, $"'{options.Folder}' {exception.Message}, so nothing is played.", exception.Cure);
            }
            return null;
        }

        /// <summary>Reads its frames.</summary>
        public ISequenceReader MakeReader() =>
            new SequenceReader(Sequence, IsOwn ? FluidSequenceAxes.AsUnity : options.Axes, IsOwn ? 1f : options.Scale);

        /// <inheritdoc/>
        public void Check(Vector3 domainSize, float spacing, List<FluidMessage> messages)
        {
            if (Sequence.Spacing > 0f && Mathf.Abs(Sequence.Spacing - spacing) > SpacingTolerance * spacing)
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.PlaybackDiffers, owner,
                    FormattableString.Invariant($"The sequence was made with a particle spacing of {Sequence.Spacing:G4} m, and the ") +
                    FormattableString.Invariant($"simulation's is {spacing:G4} m: surface and densities are those of another liquid."),
                    FormattableString.Invariant($"Set the simulation's Particle Spacing to {Sequence.Spacing:G4}.")));
            }
            if (options.Interpolates && !Sequence.HasIds)
            {
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.PlaybackDiffers, owner,
                    "The particles of the sequence have no ids, so each frame is shown as it is, and nothing between two.",
                    "Write the property id, the same number for a particle in all frames."));
            }
            if (IsOwn && (options.Axes != FluidSequenceAxes.AsUnity || options.Scale != 1f))
            {
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.PlaybackDiffers, owner,
                    $"The folder has a {SequenceManifest.FileName}, so its particles are in simulation space already: Axes and Scale are " +
                    "not used.", "Set Axes to As Unity and Scale to 1."));
            }
        }

        /// <summary>Nothing is shown before it is played.</summary>
        public bool TryTake(Vector3 domainSize, Vector3 period, bool isNew, out FluidPlaybackFrame frame)
        {
            frame = default;
            return false;
        }

        // Written for this package.
        private bool IsOwn => Sequence.Spacing > 0f;

        private static FluidMessage Invalid(Object owner, string text, string cure) =>
            new FluidMessage(FluidSeverity.Error, FluidIssue.PlaybackInvalid, owner, text, cure);
    }
}
