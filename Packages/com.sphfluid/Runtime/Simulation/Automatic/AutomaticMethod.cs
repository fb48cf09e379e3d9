using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The choice of a simulation whose Method is Automatic, for as long as it lasts: from a start until a setting changes that it follows
    /// from. While the liquid runs the method changes only where its own settings, the budget or the frame rate as they are typed, do, or
    /// where it is asked for; other changes keep the method and are answered by its softness alone.
    /// </summary>
    internal sealed class AutomaticMethod
    {
        private FluidMethodChoice advised;
        private FluidLiveKey key;
        private AutomaticSpec asked;
        private FluidMethodKind? fallback;
        private FluidShaderSet fallbackOf;

        /// <summary>The choice in use; null where there is none yet.</summary>
        public FluidMethodChoice Choice { get; private set; }

        /// <summary>The simulation as it runs: by the choice, before there is one by the first method that this device runs.</summary>
        /// <param name="asSet">The simulation as its settings have it.</param>
        public FluidSpec Resolve(FluidSpec asSet)
        {
            if (!asSet.Automatic.IsOn) return asSet;
            if (Choice != null) return Choice.Apply(asSet);
            asSet.Method = Fallback(asSet);
            return asSet;
        }

        /// <summary>A start or a restored save came with a choice; null: with none.</summary>
        /// <param name="choice">The choice.</param>
        /// <param name="spec">The simulation, with a profile.</param>
        public void Accept(FluidMethodChoice choice, in FluidSpec spec)
        {
            (Choice, advised) = (choice, null);
            if (choice != null) (asked, key) = (spec.Automatic, KeyOf(spec));
        }

        /// <summary>The next start chooses anew, and nothing is in use until then.</summary>
        public void Forget() => Choice = advised = null;

        /// <summary>
        /// Chooses again where a setting has changed that the choice follows from. Another method only where the budget or its frame rate
        /// changed.
        /// </summary>
        /// <param name="spec">The simulation, by the present choice.</param>
        /// <param name="run">The running liquid.</param>
        /// <param name="report">Receives what changed.</param>
        public void Update(in FluidSpec spec, FluidRun run, Action<FluidMessage> report)
        {
            if (Choice == null || !spec.Automatic.IsOn) return;
            FluidLiveKey now = KeyOf(spec);
            if (now.Equals(key)) return;
            ChooseAgain(spec, run, !spec.Automatic.HasBudgetOf(asked), report);
        }

        /// <summary>Chooses again by what is known now; what is not known is timed if another method may be picked.</summary>
        /// <param name="spec">The simulation, by the present choice.</param>
        /// <param name="run">The running liquid.</param>
        /// <param name="mayChangeMethod">Whether another method may be picked, with which the liquid starts again.</param>
        /// <param name="report">Receives what changed.</param>
        public void ChooseAgain(in FluidSpec spec, FluidRun run, bool mayChangeMethod, Action<FluidMessage> report)
        {
            (asked, key) = (spec.Automatic, KeyOf(spec));
            FluidMethodChoice best =
                MethodChooser.Choose(spec, run.Start, run.HasBodies, mayChangeMethod ? MeterOf(spec, run) : null, Choice);
            if (best == null) return;
            if (best.Method == Choice.Method || mayChangeMethod)
            {
                bool isNew = !best.IsSameAs(Choice) || mayChangeMethod;
                Choice = run.Start.Choice = best;
                advised = null;
                if (isNew) report(MethodChoiceText.Message(best, spec.Owner));
                return;
            }
            FluidMethodChoice kept = MethodChooser.Choose(spec, run.Start, run.HasBodies, null, Choice, Choice.Method);
            if (kept != null && !kept.IsSameAs(Choice)) Choice = run.Start.Choice = kept;
            if (advised != null && advised.IsSameAs(best)) return;
            advised = best;
            report(new FluidMessage(FluidSeverity.Info, FluidIssue.MethodChoice, spec.Owner,
                $"By the changed settings another method than {Choice.Method}, which stays in use, would be picked: {best.Reason}",
                "Press Choose Again or call ChooseMethodAgain, which starts the liquid again."));
        }

        // As the settings have them, so that a choice's own changes are none.
        private static FluidLiveKey KeyOf(in FluidSpec spec) => FluidLiveKey.AsGiven(spec.AsSet());

        // The particles as they are now.
        private static StepMeter MeterOf(in FluidSpec spec, FluidRun run)
        {
            FluidShaderSet shaders = spec.Profile.Shaders;
            return (in FluidSolverSettings settings) =>
            {
                var particles = new List<FluidParticle>();
                FluidReports.TryReadParticles(run.Solver, particles);
                return StepCalibration.Measure(settings, shaders, particles, run.Collision);
            };
        }

        /// <summary>
        /// The method that a simulation is taken for before there is a choice: the first that may be picked and runs here; Standard where
        /// none does.
        /// </summary>
        private FluidMethodKind Fallback(in FluidSpec spec)
        {
            if (fallback.HasValue && ReferenceEquals(fallbackOf, spec.Profile.Shaders)) return fallback.Value;
            (fallback, fallbackOf) = (FluidMethodKind.Standard, spec.Profile.Shaders);
            foreach (FluidMethod method in FluidMethods.All)
            {
                if (!method.MayBePicked || MethodObstacles.Find(new FluidSpec { Profile = spec.Profile }, method) != null) continue;
                fallback = method.Kind;
                break;
            }
            return fallback.Value;
        }
    }
}
