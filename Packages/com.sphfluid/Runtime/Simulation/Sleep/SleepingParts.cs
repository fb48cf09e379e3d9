using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Which parts of a running liquid may sleep. What moves, drains or pushes liquid keeps awake where it is: a collider that has changed
    /// both where it was and where it is. What is born, and liquid that flows, the GPU sees by itself.
    /// </summary>
    internal sealed class SleepingParts
    {
        // Of R, around what keeps liquid awake: it is a frame and a sort late.
        private const float Margin = 2f;

        private readonly FluidSolver solver;
        private readonly Dictionary<object, FluidObstacle> known = new Dictionary<object, FluidObstacle>();
        private readonly HashSet<object> gone = new HashSet<object>();
        private readonly List<Bounds> boxes = new List<Bounds>();

        public SleepingParts(FluidSolver solver) => this.solver = solver;

        /// <summary>When parts of a liquid sleep; null: none do.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="settings">Its constants.</param>
        public static SleepRule? RuleFor(in FluidSpec spec, in FluidSolverSettings settings)
        {
            double acceleration = LiquidPotential.Acceleration(settings);
            bool may = spec.SleepsAtRest && spec.PartsSleep && acceleration > 0.0;
            return may ? new SleepRule(acceleration, settings.Spacing, SleepWatch.Thinness(settings)) : (SleepRule?)null;
        }

        /// <summary>The liquid goes on from a save: all that is there counts as new.</summary>
        public void Forget() => known.Clear();

        /// <summary>Tells the solver what keeps liquid awake in a frame, before its steps.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="solids">Its colliders.</param>
        /// <param name="zones">What pushes the liquid.</param>
        /// <param name="flows">What comes into it and leaves it.</param>
        public void Update(in FluidSpec spec, IReadOnlyList<FluidObstacle> solids, FluidZones zones, FluidFlows flows)
        {
            if (!spec.SleepsAtRest || !spec.PartsSleep) return;
            boxes.Clear();
            AddChanged(solids);
            foreach (ForceZone zone in zones.Acting) boxes.Add(zone.Bounds);
            flows.AddDrained(spec, boxes);
            float margin = Margin * solver.Settings.SupportRadius;
            for (int i = 0; i < boxes.Count; i++) boxes[i] = new Bounds(boxes[i].center, boxes[i].size + 2f * margin * Vector3.one);
            solver.State.KeepAwake(boxes);
        }

        private void AddChanged(IReadOnlyList<FluidObstacle> solids)
        {
            gone.Clear();
            gone.UnionWith(known.Keys);
            foreach (FluidObstacle solid in solids)
            {
                object key = solid.State.Key;
                gone.Remove(key);
                bool isKnown = known.TryGetValue(key, out FluidObstacle before);
                bool same = isKnown && ReferenceEquals(before, solid);
                if (same && !Floats(solid)) continue;
                boxes.Add(solid.Mesh.Bounds);
                if (isKnown && !same) boxes.Add(before.Mesh.Bounds);
                known[key] = solid;
            }
            foreach (object key in gone)
            {
                boxes.Add(known[key].Mesh.Bounds);
                known.Remove(key);
            }
        }

        // It is pushed by the liquid around it, which is to answer.
        private static bool Floats(FluidObstacle solid)
        {
            Rigidbody body = solid.Collider == null ? null : solid.Collider.attachedRigidbody;
            return body != null && !body.isKinematic && !body.IsSleeping();
        }
    }
}
