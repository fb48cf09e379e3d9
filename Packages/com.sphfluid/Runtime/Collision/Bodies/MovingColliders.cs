using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Which of the scene's colliders move, and from where: one that rested and is elsewhere now moves for good, one that the liquid moves
    /// from the start. A collider whose motion cannot be followed jumps to its new place.
    /// </summary>
    internal sealed class MovingColliders
    {
        private readonly Dictionary<object, BodyMotion> movers = new Dictionary<object, BodyMotion>();
        private readonly HashSet<ColliderState> resting = new HashSet<ColliderState>();
        private readonly List<FluidObstacle> lastSolids = new List<FluidObstacle>();
        private readonly List<BodyJump> newJumps = new List<BodyJump>();

        /// <summary>The colliders as of the last look.</summary>
        public IReadOnlyList<FluidObstacle> LastSolids => lastSolids;

        /// <summary>Times a motion could not be followed, since the start.</summary>
        public int Jumps { get; private set; }

        /// <summary>Those since the last look, it included.</summary>
        public IReadOnlyList<BodyJump> NewJumps => newJumps;

        /// <summary>Whether the friction of one that moves changed with the last look.</summary>
        public bool FrictionChanged { get; private set; }

        /// <summary>The motion of a collider that moves; null: it rests, or there is none.</summary>
        /// <param name="key">Of the collider's state.</param>
        public BodyMotion MotionOf(object key) => movers.TryGetValue(key, out BodyMotion motion) ? motion : null;

        /// <summary>The motions of those that move.</summary>
        /// <param name="solids">The colliders.</param>
        /// <param name="deform">Of those whose triangles deform, or of the others.</param>
        public IEnumerable<BodyMotion> GetMotions(IReadOnlyList<FluidObstacle> solids, bool deform)
        {
            foreach (FluidObstacle solid in solids)
                if (movers.TryGetValue(solid.State.Key, out BodyMotion motion) && motion.Deformation != null == deform) yield return motion;
        }

        /// <summary>Those that rest, by their friction; from now on they are known to rest where they are.</summary>
        public IReadOnlyList<IGrouping<float, FluidObstacle>> TakeResting(IReadOnlyList<FluidObstacle> solids)
        {
            resting.Clear();
            List<FluidObstacle> still = solids.Where(s => !movers.ContainsKey(s.State.Key)).ToList();
            foreach (FluidObstacle solid in still) resting.Add(solid.State);
            return still.GroupBy(s => s.State.Friction).ToList();
        }

        /// <summary>Looks where the colliders are now.</summary>
        /// <returns>Whether the set of bodies or their cells changed.</returns>
        public bool Track(IReadOnlyList<FluidObstacle> solids)
        {
            newJumps.Clear();
            FrictionChanged = false;
            if (IsSame(solids)) return false;
            bool changed = false;
            var present = new HashSet<object>();
            foreach (FluidObstacle solid in solids)
            {
                present.Add(solid.State.Key);
                changed |= Track(solid);
            }
            foreach (FluidObstacle solid in lastSolids)
            {
                if (present.Contains(solid.State.Key)) continue;
                movers.Remove(solid.State.Key);
                changed = true;
            }
            lastSolids.Clear();
            lastSolids.AddRange(solids);
            return changed;
        }

        /// <summary>Counts a frame: one whose stretch or corners have not changed for long is taken over as a rigid one.</summary>
        /// <returns>Whether one was, so that its cells have to be made anew.</returns>
        public bool Settle()
        {
            bool outgrown = false;
            foreach (BodyMotion motion in movers.Values) outgrown |= motion.Settle();
            return outgrown;
        }

        /// <summary>A motion could not be followed.</summary>
        public void Jump(Component source, BodyFollowing reason)
        {
            Jumps++;
            newJumps.Add(new BodyJump(source, reason));
        }

        /// <summary>
        /// Writes where the last steps left each collider, which of them are bodies of their own, and the corners of those that deform.
        /// </summary>
        public void Save(SaveWriter writer)
        {
            List<FluidObstacle> there = lastSolids.FindAll(s => s.Source != null);
            writer.Write(there.Count);
            foreach (FluidObstacle solid in there)
            {
                bool moves = movers.TryGetValue(solid.State.Key, out BodyMotion motion);
                writer.WriteKey(solid.Source);
                writer.Write(moves);
                writer.Write(moves ? motion.Begun(solid.State) : solid.State.ToSimulation);
                writer.WriteItems<Vector3>(moves ? motion.BegunCorners : null);
            }
        }

        /// <summary>
        /// Goes on from a save: colliders move from where they were then to where they are. Triangles rest where they were then.
        /// </summary>
        /// <param name="reader">The save.</param>
        /// <param name="scene">The colliders as they are now.</param>
        public void Load(SaveReader reader, CollisionScene scene)
        {
            movers.Clear();
            lastSolids.Clear();
            Dictionary<string, FluidObstacle> present = SaveReader.ByKey(scene.Solids, s => s.Source);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                bool isThere = reader.TryFind(present, out FluidObstacle now);
                bool moves = reader.Read<bool>();
                Matrix4x4 place = reader.Read<Matrix4x4>();
                Vector3[] corners = reader.ReadItems<Vector3>();
                if (!isThere) continue;
                FluidObstacle then = scene.At(now, place);
                bool deforms = corners.Length > 0 && corners.Length == then.Mesh.Vertices.Length;
                if (deforms) then = new FluidObstacle(then.State, then.Spacing, then.Mesh.Deformed(corners));
                lastSolids.Add(then);
                if (moves || then.State.Body != null) movers[then.State.Key] = new BodyMotion(then, deforms);
            }
        }

        private bool Track(FluidObstacle solid)
        {
            object key = solid.State.Key;
            if (movers.TryGetValue(key, out BodyMotion motion))
            {
                FrictionChanged |= motion.Friction != solid.State.Friction;
                return Move(motion, solid);
            }
            if (solid.State.Body != null)
            {
                movers[key] = new BodyMotion(solid);
                return true;
            }
            if (resting.Contains(solid.State)) return false;
            FluidObstacle before = lastSolids.Find(s => ReferenceEquals(s.State.Key, key));
            if (before == null || before.State.HasTrianglesOf(solid.State)) return true;
            movers[key] = new BodyMotion(before);
            Move(movers[key], solid);
            return true;
        }

        private bool Move(BodyMotion motion, FluidObstacle solid)
        {
            BodyFollowing following = motion.MoveTo(solid);
            if (following == BodyFollowing.Followed) return false;
            if (following != BodyFollowing.CellsOutgrown)
            {
                Jump(solid.Source, following);
                movers[solid.State.Key] = new BodyMotion(solid);
            }
            return true;
        }

        private bool IsSame(IReadOnlyList<FluidObstacle> solids)
        {
            if (solids.Count != lastSolids.Count) return false;
            for (int i = 0; i < solids.Count; i++)
                if (!ReferenceEquals(solids[i], lastSolids[i])) return false;
            return true;
        }
    }
}
