using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Deals a plan's work to shards: the longest first, each to the shard that has least. The greatest share is then at most 4/3 of the
    /// best possible one (R. L. Graham, "Bounds on multiprocessing timing anomalies", SIAM J. Appl. Math. 17, 1969). The order of the plan
    /// decides between equals, so that every machine deals alike. Costs 5, 4, 3, 3 on two shards: 5 + 3 and 4 + 3.
    /// </summary>
    internal static class ShardDeal
    {
        /// <summary>The shard of each piece of work, from 1.</summary>
        /// <param name="work">Expected work in the order of the plan. Pieces of one group stay together.</param>
        /// <param name="shards">Number of shards.</param>
        public static int[] Of(IReadOnlyList<(string Group, double Cost)> work, int shards)
        {
            var shardOf = new Dictionary<string, int>();
            var loads = new (double Cost, int Pieces)[shards];
            // GroupBy keeps the order of first appearance, OrderByDescending that of equals.
            foreach (var group in work.GroupBy(w => w.Group).Select(g => (g.Key, Cost: g.Sum(w => w.Cost), Pieces: g.Count()))
                .OrderByDescending(g => g.Cost))
            {
                int least = 0;
                for (int s = 1; s < shards; s++)
                {
                    if (loads[s].CompareTo(loads[least]) < 0) least = s;
                }
                loads[least] = (loads[least].Cost + group.Cost, loads[least].Pieces + group.Pieces);
                shardOf.Add(group.Key, least + 1);
            }
            return work.Select(w => shardOf[w.Group]).ToArray();
        }
    }
}
