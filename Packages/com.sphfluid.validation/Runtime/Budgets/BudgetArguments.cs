using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which budgets <c>budgets</c> gives the method Automatic, for which liquids, and where it writes.</summary>
    public sealed class BudgetArguments : MeasuringArguments
    {
        private static readonly double[] UsualBudgets = { 0.5, 1.0, 2.0, 4.0, 8.0, 20.0 };
        private static readonly int[] UsualParticles = { 500, 4000 };

        private readonly List<double> budgets = new List<double>();
        private readonly List<int> particles = new List<int>();

        internal BudgetArguments() : base("budgets", "Build/budgets")
        {
            Options.Add("--budget", "MS...", "milliseconds a frame that the steps may take", string.Join(" ", UsualBudgets), flag =>
            {
                foreach (string word in flag.Values()) budgets.Add(CommandLineWords.Milliseconds(flag.Name, word));
            });
            Options.Add("--particles", "N...", "about so many particles", string.Join(" ", UsualParticles), flag =>
            {
                foreach (string word in flag.Values()) particles.Add(CommandLineWords.Integer(flag.Name, word, 64, 16 * 1024 * 1024));
            });
            Options.Add("--repeat", "R", "runs of everything, each with another start jitter", $"{Repeats}",
                flag => Repeats = flag.Integer(1, 99));
            AddFolder();
        }

        /// <summary>The budgets [ms].</summary>
        public IReadOnlyList<double> Budgets => budgets;

        /// <summary>Numbers of particles.</summary>
        public IReadOnlyList<int> Particles => particles;

        /// <summary>Runs of everything.</summary>
        public int Repeats { get; private set; } = 3;

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static BudgetArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new BudgetArguments();
            result.Read(commandLine);
            if (result.budgets.Count == 0) result.budgets.AddRange(UsualBudgets);
            if (result.particles.Count == 0) result.particles.AddRange(UsualParticles);
            return result;
        }
    }
}
