using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What Automatic picked for a liquid, why, and what else it considered.</summary>
    public sealed class FluidMethodChoice
    {
        // A frame may be up to twice as long as those that the choice is for before steps are left out.
        private const double LongestFrame = 2.0;

        internal FluidMethodChoice(in AutomaticSpec asked, long particles, IReadOnlyList<FluidMethodCandidate> considered, int pick)
        {
            Asked = asked;
            Particles = particles;
            Considered = considered;
            Pick = considered[pick];
            Rank = pick;
        }

        /// <summary>The pick.</summary>
        public FluidMethodCandidate Pick { get; }

        /// <summary>The method in use.</summary>
        public FluidMethodKind Method => Pick.Method;

        /// <summary>Time that a frame's steps may take [ms].</summary>
        public double FrameBudget => Asked.Budget;

        /// <summary>Frames a second that the budget is for.</summary>
        public double FrameRate => Asked.FrameRate;

        /// <summary>Number of particles that the costs are for.</summary>
        public long Particles { get; }

        /// <summary>
        /// All that was considered, the pick among them, the most faithful first. What comes after one that fits is not measured and not
        /// listed.
        /// </summary>
        public IReadOnlyList<FluidMethodCandidate> Considered { get; }

        /// <summary>Whether the pick's steps fit the budget. Where they do not, the liquid keeps time and frames take longer.</summary>
        public bool FitsBudget => MethodRule.Fits(Pick, FrameBudget);

        /// <summary>Whether the pick's cost is known; if not, it is measured at the next start and the pick may be another.</summary>
        public bool IsMeasured => !double.IsNaN(Pick.MillisecondsAFrame);

        /// <summary>
        /// Particle spacing at which the liquid would fit the budget, and keep its shape, by these costs [m]; 0 where the pick does, or
        /// none was found. It is proposed and never set.
        /// </summary>
        public float ProposedSpacing { get; internal set; }

        /// <summary>About how many particles the proposed spacing gives; 0 without one.</summary>
        public long ProposedParticles { get; internal set; }

        /// <summary>The method that would be picked at the proposed spacing.</summary>
        public FluidMethodKind ProposedMethod { get; internal set; }

        /// <summary>What was picked and why, with figures, as sentences.</summary>
        public string Reason => MethodChoiceText.Reason(this);

        internal AutomaticSpec Asked { get; }

        /// <summary>Place of the pick among <see cref="Considered"/>.</summary>
        internal int Rank { get; }

        /// <summary>Whether the pick came with a save, and was not chosen here.</summary>
        internal bool IsRestored { get; private set; }

        /// <summary>
        /// The simulation as it runs by the pick. The most steps a frame are raised to what frames twice as long need, so that the liquid
        /// keeps time.
        /// </summary>
        internal FluidSpec Apply(FluidSpec spec)
        {
            spec.Method = Method;
            spec.Profile.Rules = Pick.Offer.Apply(spec.Profile.Rules);
            double needed = Math.Ceiling(LongestFrame * Pick.StepsAFrame);
            if (spec.MaxSubstepsPerFrame < needed) spec.MaxSubstepsPerFrame = (int)Math.Min(needed, int.MaxValue);
            return spec;
        }

        /// <summary>Whether the liquid runs by another choice as by this one.</summary>
        internal bool IsSameAs(FluidMethodChoice other) => Method == other.Method &&
            Pick.MaxCompression.Equals(other.Pick.MaxCompression) &&
            Pick.Offer.SoundSpeedRatio.Equals(other.Pick.Offer.SoundSpeedRatio) && Pick.Substeps == other.Pick.Substeps &&
            Pick.StepsAFrame.Equals(other.Pick.StepsAFrame);

        /// <summary>Writes what a restored liquid goes on by.</summary>
        internal void Save(SaveWriter writer)
        {
            writer.Write(Pick.Offer.Method);
            writer.Write(Pick.Offer.MaxCompression);
            writer.Write(Pick.Offer.SoundSpeedRatio);
            writer.Write(Pick.Offer.Substeps);
            writer.Write(Pick.Offer.CostRatio);
            writer.Write(Pick.Offer.StepsAFrame);
            writer.Write(Pick.Offer.SoundSpeed);
            writer.Write(Pick.Offer.LeastSoundSpeed);
            writer.Write(Pick.Offer.AsTheProfileAsks);
            writer.Write(Pick.MillisecondsAStep);
            writer.Write(Pick.CostSource);
            writer.Write(Particles);
        }

        /// <summary>Reads what <see cref="Save"/> wrote.</summary>
        internal static FluidMethodChoice Load(in AutomaticSpec asked, SaveReader reader)
        {
            var offer = new MethodOffer
            {
                Method = reader.Read<FluidMethodKind>(),
                MaxCompression = reader.Read<float>(),
                SoundSpeedRatio = reader.Read<float>(),
                Substeps = reader.Read<int>(),
                CostRatio = reader.Read<double>(),
                StepsAFrame = reader.Read<double>(),
                SoundSpeed = reader.Read<double>(),
                LeastSoundSpeed = reader.Read<double>(),
                AsTheProfileAsks = reader.Read<bool>(),
            };
            var pick = new FluidMethodCandidate(offer, reader.Read<double>(), reader.Read<FluidCostSource>(), null);
            return new FluidMethodChoice(asked, reader.Read<long>(), new[] { pick }, 0) { IsRestored = true };
        }

        /// <summary>The choice that a save of a simulation with a given method leaves: that method, as the profile asks.</summary>
        internal static FluidMethodChoice OfSave(in FluidSpec spec, FluidMethodKind method, long particles)
        {
            var offer = new MethodOffer
            {
                Method = method,
                MaxCompression = spec.Profile.Rules.MaxCompression,
                SoundSpeedRatio = spec.Profile.Rules.SoundSpeedRatio,
                CostRatio = 1.0,
                AsTheProfileAsks = true,
            };
            var pick = new FluidMethodCandidate(offer, double.NaN, FluidCostSource.Unknown, null);
            return new FluidMethodChoice(spec.Automatic, particles, new[] { pick }, 0) { IsRestored = true };
        }
    }
}
