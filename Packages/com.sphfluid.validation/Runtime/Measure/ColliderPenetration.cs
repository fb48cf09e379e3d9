using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>How many particles are inside closed colliders.</summary>
    public readonly struct ColliderPenetration
    {
        private ColliderPenetration(int inside, int deep)
        {
            Inside = inside;
            Deep = deep;
        }

        /// <summary>Particles inside a closed collider, however little.</summary>
        public int Inside { get; }

        /// <summary>Particles inside a closed collider and farther than one particle spacing from its surface.</summary>
        public int Deep { get; }

        /// <summary>Counts for a running simulation.</summary>
        public static ColliderPenetration Of(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            float spacing = simulation.Solver.Settings.Spacing;
            int inside = 0, deep = 0;
            foreach (Vector3 position in snapshot.LocalPositions)
            {
                foreach (FluidObstacle obstacle in simulation.Obstacles)
                {
                    if (!obstacle.Mesh.Contains(position)) continue;
                    inside++;
                    if (!obstacle.Mesh.IsNear(position, spacing)) deep++;
                    break;
                }
            }
            return new ColliderPenetration(inside, deep);
        }
    }
}
