namespace SphFluid
{
    /// <summary>
    /// Notes what the steps of a liquid cost in play, once its timer's means are complete, and whether the choice of its method was right
    /// about it.
    /// </summary>
    internal sealed class StepCostWatch
    {
        // Of the budget, above which something is said.
        private const double Tolerance = 1.1;

        /// <summary>Whether the cost is still to be noted.</summary>
        public bool IsUnderWay { get; private set; }

        /// <summary>A liquid was started whose cost is to be noted.</summary>
        public void Begin() => IsUnderWay = true;

        /// <summary>It does not run any more.</summary>
        public void End() => IsUnderWay = false;

        /// <summary>Looks whether the means are complete.</summary>
        /// <param name="timer">Times the steps.</param>
        /// <param name="run">The running liquid.</param>
        /// <param name="choice">By which it runs; null: its method is given.</param>
        /// <param name="owner">The object that messages name.</param>
        /// <returns>What is to be said; null: nothing.</returns>
        public FluidMessage? Look(StepTimer timer, FluidRun run, FluidMethodChoice choice, UnityEngine.Object owner)
        {
            if (!IsUnderWay || timer == null || timer.FrameCount < StepTimer.Window) return null;
            IsUnderWay = false;
            Record(timer, run.Solver, run.HasBodies);
            if (choice == null || !choice.IsMeasured || !choice.FitsBudget || timer.MillisecondsAFrame <= Tolerance * choice.FrameBudget)
            {
                return null;
            }
            return new FluidMessage(FluidSeverity.Info, FluidIssue.MethodChoice, owner,
                System.FormattableString.Invariant($"The steps take {timer.MillisecondsAFrame:0.00} ms a frame in play, where ") +
                System.FormattableString.Invariant($"{choice.Pick.MillisecondsAFrame:0.00} ms at most were expected and ") +
                System.FormattableString.Invariant($"{choice.FrameBudget:0.##} ms are allowed."),
                "Press Choose Again or call ChooseMethodAgain, or start again: the method is picked by what was measured now.");
        }

        /// <summary>Notes the means of a timer.</summary>
        public static void Record(StepTimer timer, FluidSolver solver, bool hasBodies)
        {
            FluidMethod method = FluidMethods.Get(solver.Kind);
            double passes = method.PassesOf(solver.Settings, solver.LastTimeStep, solver.Counters.MaxSpeed);
            StepCosts.Record(StepCostKey.Create(solver.Settings, hasBodies), new StepCost
            {
                Particles = solver.LiveCount,
                Milliseconds = timer.MillisecondsAFrame / timer.StepsAFrame * method.PassesAStep / passes,
                InPlay = true,
            });
        }
    }
}
