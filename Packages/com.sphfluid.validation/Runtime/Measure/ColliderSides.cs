using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// On which side of each closed collider every particle was at the start, to count those that got through since: out of a vessel
    /// or into a obstacle. A side is how often the surface winds round a particle. Open meshes have no sides; colliders that came or
    /// went in between are left out.
    /// </summary>
    public sealed class ColliderSides
    {
        private readonly FluidSolver solver;
        private readonly Dictionary<Component, Dictionary<uint, int>> start = new Dictionary<Component, Dictionary<uint, int>>();

        private ColliderSides(FluidSolver solver) => this.solver = solver;

        /// <summary>The sides now.</summary>
        /// <param name="simulation">A running simulation.</param>
        /// <param name="snapshot">Its particles.</param>
        public static ColliderSides Of(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            var sides = new ColliderSides(simulation.Solver);
            foreach (FluidObstacle obstacle in simulation.Obstacles)
            {
                if (obstacle.Source != null && obstacle.Mesh.IsClosed) sides.start[obstacle.Source] = SidesOf(obstacle, snapshot);
            }
            return sides;
        }

        /// <summary>Whether the liquid is still the one that these sides are of; it is another after a restart.</summary>
        public bool AreOf(FluidSimulation simulation) => simulation.Solver == solver;

        /// <summary>Particles that are on another side of a collider than at the start.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="snapshot">Its particles now.</param>
        public int CountChanged(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            var changed = new HashSet<uint>();
            foreach (FluidObstacle obstacle in simulation.Obstacles)
            {
                if (obstacle.Source == null || !start.TryGetValue(obstacle.Source, out Dictionary<uint, int> before)) continue;
                foreach (KeyValuePair<uint, int> now in SidesOf(obstacle, snapshot))
                {
                    if (before.TryGetValue(now.Key, out int side) && side != now.Value) changed.Add(now.Key);
                }
            }
            return changed.Count;
        }

        private static Dictionary<uint, int> SidesOf(FluidObstacle obstacle, FluidSnapshot snapshot)
        {
            var sides = new Dictionary<uint, int>(snapshot.Count);
            for (int i = 0; i < snapshot.Count; i++) sides[snapshot.Ids[i]] = obstacle.Mesh.Winding(snapshot.LocalPositions[i]);
            return sides;
        }
    }
}
