using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace SphFluid
{
    /// <summary>What a step took with a number of particles.</summary>
    internal struct StepCost
    {
        /// <summary>The number of particles.</summary>
        public long Particles;

        /// <summary>Time of a step [ms].</summary>
        public double Milliseconds;

        /// <summary>Whether the graphics device timed it in play; else a start did, by the clock of the CPU.</summary>
        public bool InPlay;
    }

    /// <summary>
    /// What steps cost on one device: by method, support radius and bodies, and by number of particles in powers of two, as few particles
    /// leave a device idle. Between two sizes the cost is on the line through both; beyond the largest it goes on along the line through
    /// the last two.
    /// </summary>
    internal sealed class StepCostTable
    {
        /// <summary>Largest ratio of two numbers of particles of which one's cost speaks for the other's.</summary>
        public const double NearRatio = 2.0;

        private const int Sizes = 40;

        private readonly Dictionary<StepCostKey, SortedList<int, StepCost>> costs =
            new Dictionary<StepCostKey, SortedList<int, StepCost>>();

        /// <summary>Number of costs.</summary>
        public int Count
        {
            get
            {
                int count = 0;
                foreach (SortedList<int, StepCost> sizes in costs.Values) count += sizes.Count;
                return count;
            }
        }

        /// <summary>
        /// Takes in a measurement, in the place of an older one of this size. One of a start does not replace one of play.
        /// </summary>
        /// <param name="key">Of which steps it is.</param>
        /// <param name="cost">What was measured.</param>
        /// <returns>False where the numbers are none of a measurement, or one of play is known.</returns>
        public bool Record(in StepCostKey key, in StepCost cost)
        {
            if (cost.Particles < 1 || !(cost.Milliseconds > 0.0) || double.IsInfinity(cost.Milliseconds)) return false;
            if (!costs.TryGetValue(key, out SortedList<int, StepCost> sizes)) costs.Add(key, sizes = new SortedList<int, StepCost>());
            int size = SizeOf(cost.Particles);
            if (!cost.InPlay && sizes.TryGetValue(size, out StepCost known) && known.InPlay) return false;
            sizes[size] = cost;
            return true;
        }

        /// <summary>The cost of a step.</summary>
        /// <param name="key">Of which steps.</param>
        /// <param name="particles">Number of particles, 1 or more.</param>
        /// <param name="cost">The cost with that number, and the number of particles that was measured nearest to it.</param>
        /// <returns>False where nothing is known of such steps.</returns>
        public bool TryFind(in StepCostKey key, long particles, out StepCost cost)
        {
            cost = default;
            if (particles < 1 || !costs.TryGetValue(key, out SortedList<int, StepCost> sizes)) return false;
            IList<StepCost> known = sizes.Values;
            int above = 0;
            while (above < known.Count && known[above].Particles < particles) above++;
            StepCost nearest = above == known.Count || above > 0 &&
                particles * (double)particles < known[above - 1].Particles * (double)known[above].Particles
                ? known[above - 1] : known[above];
            cost = new StepCost { Particles = nearest.Particles, InPlay = nearest.InPlay, Milliseconds = On(known, above, particles) };
            return true;
        }

        /// <summary>Whether a cost speaks for a number of particles.</summary>
        public static bool IsNear(in StepCost cost, long particles) =>
            particles <= NearRatio * cost.Particles && cost.Particles <= NearRatio * particles;

        /// <summary>Forgets what is known of some steps.</summary>
        public void Forget(in StepCostKey key) => costs.Remove(key);

        /// <summary>The table as lines: key, number of particles, milliseconds, and whether they are of play.</summary>
        public string ToText()
        {
            var text = new StringBuilder();
            foreach (KeyValuePair<StepCostKey, SortedList<int, StepCost>> entry in costs)
                foreach (StepCost cost in entry.Value.Values)
                {
                    text.Append(
                        FormattableString.Invariant($"{entry.Key} {cost.Particles} {cost.Milliseconds:R} ") +
                        FormattableString.Invariant($"{(cost.InPlay ? "play" : "start")}\n"));
                }
            return text.ToString();
        }

        /// <summary>A table from its lines; what is none of them is passed over.</summary>
        public static StepCostTable Parse(string text)
        {
            var table = new StepCostTable();
            foreach (string line in text.Split('\n'))
            {
                string[] words = line.Split(' ');
                if (words.Length != 4 || words[3] != "play" && words[3] != "start") continue;
                if (!long.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out long particles)) continue;
                if (!double.TryParse(words[2], NumberStyles.Float, CultureInfo.InvariantCulture, out double milliseconds)) continue;
                table.Record(StepCostKey.Parse(words[0]),
                    new StepCost { Particles = particles, Milliseconds = milliseconds, InPlay = words[3] == "play" });
            }
            return table;
        }

        private static double On(IList<StepCost> known, int above, long particles)
        {
            if (known.Count == 1) return known[0].Milliseconds * particles / known[0].Particles;
            StepCost low = known[Math.Max(0, Math.Min(above, known.Count - 1) - 1)],
                high = known[Math.Max(1, Math.Min(above, known.Count - 1))];
            double slope = (high.Milliseconds - low.Milliseconds) / (high.Particles - low.Particles);
            double line = low.Milliseconds + slope * (particles - low.Particles);
            if (above == 0) return Between(low.Milliseconds * particles / low.Particles, line, low.Milliseconds);
            return above < known.Count ? line : Between(high.Milliseconds, line, high.Milliseconds * particles / high.Particles);
        }

        private static double Between(double least, double value, double most) => Math.Max(least, Math.Min(value, most));

        private static int SizeOf(long particles) => Math.Max(0, Math.Min(Sizes - 1, (int)Math.Round(Math.Log(particles, 2.0))));
    }
}
