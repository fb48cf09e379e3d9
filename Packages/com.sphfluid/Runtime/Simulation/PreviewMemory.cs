using System;
using System.Collections.Generic;
using System.Diagnostics;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Previews of a simulation's start, one after another while it is edited. Liquid is filled once and kept until something changed that
    /// it follows from; liquid that takes long to fill waits until nothing changes any more, and filling it can be cancelled.
    /// </summary>
    internal sealed class PreviewMemory : IDisposable
    {
        /// <summary>Time that a fill may take to be made while something changes [s].</summary>
        public const double Quick = 0.1;

        /// <summary>Time without a change after which a long one is made [s].</summary>
        public const double Idle = 1.0;

        // Between two questions whether to go on, in particles.
        private const int Stretch = 4096;

        private readonly CollisionScene collision = new CollisionScene();
        private readonly List<FluidMessage> beginMessages = new List<FluidMessage>();
        private PreviewKey filled, changing;
        private FluidStart start;
        private long filledColliders, changingColliders;
        private double changedAt, took;

        /// <summary>What the simulation would start with, as of the last look; null when it cannot.</summary>
        public FluidPreview Preview { get; private set; }

        /// <summary>
        /// Where the particles are at the start, also where an error keeps it from starting; null where none could be filled.
        /// </summary>
        public FillPoints Points { get; private set; }

        /// <summary>Whether <see cref="Points"/> are those of the relaxed start.</summary>
        public bool IsRelaxed { get; private set; }

        /// <summary>Where vessels leak, in simulation space [m].</summary>
        public IReadOnlyList<Vector3> Leaks { get; private set; } = Array.Empty<Vector3>();

        /// <summary>Whether a change waits for an idle moment.</summary>
        public bool Waits { get; private set; }

        /// <summary>Whether filling was cancelled, until the next change.</summary>
        public bool IsCancelled { get; private set; }

        /// <summary>Number of times that liquid was filled.</summary>
        public int Fills { get; private set; }

        /// <summary>Checks the simulation, and fills its liquid where that is due.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="now">Time [s].</param>
        /// <param name="goesOn">Asked now and then with the seconds that filling took so far; false cancels it. Null: it goes on.</param>
        /// <param name="messages">What is wrong or worth knowing, errors first; as it was where this returns false.</param>
        /// <returns>False where the preview stays what it was: filling waits or was cancelled.</returns>
        public bool Look(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, double now, Func<double, bool> goesOn,
            ref List<FluidMessage> messages)
        {
            var key = new PreviewKey(spec, volumes);
            if (SceneObjects.IsPrefabAsset(spec.Owner))
            {
                messages = FluidChecks.Preview(spec, volumes, out FluidSolverSettings? _);
                Preview = null;
                return true;
            }
            if (CanGather(spec)) collision.Gather(spec.Query());
            if (IsChange(key)) (changing, changingColliders, changedAt, IsCancelled) = (key, collision.Changes, now, false);
            Waits = !IsFilled(key) && took > Quick && now - changedAt < Idle;
            if (Waits || IsCancelled) return false;
            bool anew = !IsFilled(key);
            try
            {
                messages = FluidChecks.Check(spec, collision, (s, found) => Begin(s, volumes, key, goesOn, found),
                    out FluidStart checkedStart);
                if (checkedStart == null) Preview = null;
                else if (anew || Preview == null) Preview = new FluidPreview(spec, checkedStart, collision);
                return true;
            }
            catch (OperationCanceledException)
            {
                (IsCancelled, filled, Preview, Points) = (true, null, null, null);
                return false;
            }
        }

        /// <summary>
        /// Brings the liquid of the last look to rest as its start would, on the GPU, and shows the particles where they are then.
        /// </summary>
        /// <param name="spec">The simulation, with a profile and without errors.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="watch">Watches, and may cancel.</param>
        /// <param name="report">Receives how it went.</param>
        /// <returns>False where it was cancelled, or the simulation cannot start.</returns>
        /// <exception cref="FluidDeviceException">The device cannot run or hold it.</exception>
        public bool TryRelax(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, in StartWatch watch, Action<FluidMessage> report)
        {
            FluidChecks.Check(spec, volumes, collision, FluidSpawner.Fill, out FluidStart begun);
            if (begun == null) return false;
            try
            {
                Points = new FillPoints(RelaxedStart.Particles(begun.Resolve(spec), begun, collision, watch, report));
                return IsRelaxed = true;
            }
            catch (OperationCanceledException)
            {
                return false;
            }
        }

        /// <inheritdoc/>
        public void Dispose() => collision.Dispose();

        // Without numbers to measure by there is nothing to look for.
        private static bool CanGather(in FluidSpec spec) => AffineMath.IsFinite(spec.DomainSize) && AffineMath.IsFinite(spec.Spacing) &&
            AffineMath.IsFinite(spec.Position);

        private bool IsChange(PreviewKey key) => !key.Is(changing) || collision.Changes != changingColliders;

        private bool IsFilled(PreviewKey key) => key.Is(filled) && collision.Changes == filledColliders;

        private FluidStart Begin(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, PreviewKey key, Func<double, bool> goesOn,
            List<FluidMessage> found)
        {
            if (!IsFilled(key))
            {
                beginMessages.Clear();
                (filled, Points, IsRelaxed) = (null, null, false);
                var clock = Stopwatch.StartNew();
                Fills++;
                start = FluidChecks.Begin(spec, volumes, collision, request => Fill(request, clock, goesOn), beginMessages,
                    out IReadOnlyList<LiquidShape> shapes);
                Leaks = LeaksOf(shapes);
                took = clock.Elapsed.TotalSeconds;
                (filled, filledColliders) = (key, collision.Changes);
            }
            found.AddRange(beginMessages);
            return start;
        }

        private SpawnResult Fill(SpawnRequest request, Stopwatch clock, Func<double, bool> goesOn)
        {
            int left = Stretch;
            SpawnResult filledUp = FluidSpawner.Fill(request, () =>
            {
                if (--left > 0) return;
                left = Stretch;
                if (goesOn != null && !goesOn(clock.Elapsed.TotalSeconds)) throw new OperationCanceledException();
            });
            Points = new FillPoints(filledUp.Particles);
            return new SpawnResult(new List<FluidParticle>(), filledUp.Tallies, filledUp.Needed, filledUp.Fastest); // the rest is not kept
        }

        private static IReadOnlyList<Vector3> LeaksOf(IReadOnlyList<LiquidShape> shapes)
        {
            var leaks = new List<Vector3>();
            foreach (LiquidShape shape in shapes)
                if (shape is LiquidVessel { Leak: VesselLeak leak }) leaks.Add(leak.Position);
            return leaks;
        }
    }
}
