using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>Plays a sequence: has frames read ahead of where it stands, and makes the particles to show of those around.</summary>
    internal sealed class SequencePlayer : IFluidPlayback, IDisposable
    {
        private readonly SequencePlan plan;
        private readonly SequenceLoader loader;
        private readonly Object owner;
        private readonly Action<FluidMessage> report;
        private NativeArray<FluidParticle> particles;
        private NativeArray<int> counts;
        private PlaybackPlace place, shown;
        private bool waits, jumps, saidOutside, saidNotFinite;

        /// <param name="plan">The sequence.</param>
        /// <param name="owner">The object that messages name.</param>
        /// <param name="report">Receives messages.</param>
        /// <param name="reader">Reads the frames; null: from the files.</param>
        public SequencePlayer(SequencePlan plan, Object owner, Action<FluidMessage> report, ISequenceReader reader = null)
        {
            this.plan = plan;
            this.owner = owner;
            this.report = report;
            int most = (int)Math.Max(1L, plan.MostParticles);
            particles = new NativeArray<FluidParticle>(most, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            counts = new NativeArray<int>(ShowParticlesJob.CountLength, Allocator.Persistent);
            loader = new SequenceLoader(reader ?? plan.MakeReader(), plan.Sequence.Frames.Count, Math.Max(1, plan.Slots), most);
        }

        /// <summary>The sequence.</summary>
        public ParticleSequence Sequence => plan.Sequence;

        /// <summary>Whether a frame is needed that is not read yet.</summary>
        public bool IsBuffering { get; private set; }

        /// <summary>The frame that is shown, the earlier of two; −1: none so far.</summary>
        public int ShownFrame { get; private set; } = -1;

        /// <summary>Particles of it that are left out: outside of the domain, or no numbers.</summary>
        public int LeftOut { get; private set; }

        /// <summary>Frames that were read so far.</summary>
        public long Reads => loader.Reads;

        /// <summary>Memory that it takes [bytes].</summary>
        public long Bytes => plan.Bytes;

        /// <inheritdoc/>
        public long MostParticles => plan.MostParticles;

        /// <inheritdoc/>
        public void Check(Vector3 domainSize, float spacing, List<FluidMessage> messages) => plan.Check(domainSize, spacing, messages);

        /// <summary>Goes to a time; frames are read from there on.</summary>
        /// <param name="time">Time since the first frame [s], within the sequence.</param>
        /// <param name="direction">1: it goes on to later frames, −1: back to earlier ones.</param>
        /// <param name="loop">What happens past the ends.</param>
        /// <param name="isJump">Whether it does not follow from where it was.</param>
        /// <param name="waits">Whether frames are waited for that are not read yet.</param>
        public void MoveTo(double time, int direction, FluidPlaybackLoop loop, bool isJump, bool waits)
        {
            PlaybackPlace at = PlaybackTime.Find(Sequence, time);
            place = plan.Interpolates ? at : new PlaybackPlace(at.Nearer, at.Nearer, 0.0, Sequence.Frames[at.Nearer].Time);
            jumps |= isJump;
            this.waits = waits;
            loader.Want(new SequenceWalk(direction > 0 ? place.From : place.To, direction, Sequence.Frames.Count, loop));
        }

        /// <inheritdoc/>
        public bool TryTake(Vector3 domainSize, Vector3 period, bool isNew, out FluidPlaybackFrame frame)
        {
            frame = default;
            // Not while a liquid is about to start, which forgets the messages before it.
            while (loader.TryTakeFailure(out SequenceFailure failure)) Report(failure);
            PlaybackPlace at = Playable(place);
            if (!TryFind(at.From, out SequenceSlot from) || !TryFind(at.To, out SequenceSlot to)) return false;
            if (!isNew && !jumps && ShownFrame >= 0 && at.From == shown.From && at.To == shown.To && at.Share == shown.Share) return false;
            Make(from, to, at, domainSize, period);
            frame = new FluidPlaybackFrame(particles, counts[ShowParticlesJob.Shown], at.Time, jumps);
            (shown, ShownFrame, jumps) = (at, at.From, false);
            ReportLeftOut(at.From, domainSize);
            return true;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            loader.Dispose();
            particles.Dispose();
            counts.Dispose();
        }

        // Before a frame that cannot be read the one before it stays.
        private PlaybackPlace Playable(in PlaybackPlace at)
        {
            if (waits)
            {
                loader.WaitFor(at.From);
                loader.WaitFor(at.To);
            }
            return at.To != at.From && !loader.HasFailed(at.From) && loader.HasFailed(at.To)
                ? new PlaybackPlace(at.From, at.From, 0.0, Sequence.Frames[at.From].Time) : at;
        }

        private bool TryFind(int frame, out SequenceSlot slot)
        {
            slot = loader.Find(frame);
            IsBuffering = slot == null && !loader.HasFailed(frame);
            return slot != null;
        }

        private void Make(SequenceSlot from, SequenceSlot to, in PlaybackPlace at, Vector3 domainSize, Vector3 period)
        {
            new ShowParticlesJob
            {
                From = from.Particles,
                To = to.Particles,
                FromCount = from.Count,
                ToCount = to.Count,
                Share = (float)at.Share,
                Duration = (float)(Sequence.Frames[at.To].Time - Sequence.Frames[at.From].Time),
                Blend = plan.Blend,
                Half = 0.5f * domainSize,
                Period = period,
                Particles = particles,
                Counts = counts,
            }.Run();
        }

        private void Report(in SequenceFailure failure) => report(new FluidMessage(FluidSeverity.Warning, FluidIssue.PlaybackFrame, owner,
            $"'{Sequence.Frames[failure.Frame].Name}' {failure.Text}, so its frame is not shown: the one before it stays.", failure.Cure));

        private void ReportLeftOut(int frame, Vector3 domainSize)
        {
            int outside = counts[ShowParticlesJob.Outside], notFinite = counts[ShowParticlesJob.NotFinite];
            LeftOut = outside + notFinite;
            if (outside > 0 && !saidOutside)
            {
                saidOutside = true;
                string made = Sequence.Spacing > 0f && !AffineMath.Same(Sequence.DomainSize, domainSize)
                    ? $" The sequence was made in one of {FluidMessage.Lengths(Sequence.DomainSize)} m." : "";
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.PlaybackOutside, owner,
                    $"{outside} particles of '{Sequence.Frames[frame].Name}' are outside of the domain of " +
                    $"{FluidMessage.Lengths(domainSize)} m and are left out, as others after them.{made}",
                    "Enlarge the simulation's Domain Size, or set Axes and Scale as the files have them."));
            }
            if (notFinite > 0 && !saidNotFinite)
            {
                saidNotFinite = true;
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.PlaybackOutside, owner,
                    $"{notFinite} particles of '{Sequence.Frames[frame].Name}' have a position or velocity that is not a finite number " +
                    "and are left out, as others after them.",
                    "Look for what went wrong where the sequence was made."));
            }
        }
    }
}
