using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid
{
    /// <summary>
    /// The Rigidbodies that a liquid moves: those in its domain that are not kinematic and have no collider that opts out.
    /// </summary>
    internal sealed class RigidbodyFloats : IFloatingOwners, System.IDisposable
    {
        private readonly float reach;
        private readonly Dictionary<Rigidbody, RigidbodyFloat> floats = new Dictionary<Rigidbody, RigidbodyFloat>();
        private readonly List<RigidbodyFloat> ordered = new List<RigidbodyFloat>();
        private readonly List<Rigidbody> gone = new List<Rigidbody>();
        private readonly PhysicsClock clock = new PhysicsClock();
        private readonly FloatStacks stacks;
        private FloatSpace space;
        // time of the last frame with steps of physics, of this one's, and how much later than them it is now [s]
        private float stepped, taken, behind;
        private bool atAnyTime; // physics is stepped otherwise than once after each FixedUpdate

        /// <param name="reach">Support radius [m].</param>
        public RigidbodyFloats(float reach)
        {
            this.reach = reach;
            stacks = new FloatStacks(0.05f * reach);
        }

        /// <summary>Number of bodies.</summary>
        public int Count => ordered.Count;

        /// <summary>Begins a look for colliders.</summary>
        public void Begin(Vector3 position, Quaternion rotation)
        {
            space = new FloatSpace(position, rotation);
            foreach (RigidbodyFloat known in ordered) known.Colliders.Clear();
        }

        /// <inheritdoc/>
        public FloatingBody OwnerOf(Collider collider)
        {
            Rigidbody rigidbody = collider.attachedRigidbody;
            if (!RigidbodyFloat.Moves(rigidbody)) return null;
            if (!floats.TryGetValue(rigidbody, out RigidbodyFloat found))
            {
                found = new RigidbodyFloat(rigidbody, reach, space);
                floats.Add(rigidbody, found);
                ordered.Add(found);
            }

            found.Colliders.Add(collider);
            return found.Body;
        }

        /// <summary>Once a frame after the look, before the liquid's steps.</summary>
        /// <param name="scene">Where they are.</param>
        public void Track(Scene scene)
        {
            if (ordered.Count == 0) return;
            Leave();
            atAnyTime = Physics.simulationMode != SimulationMode.FixedUpdate || scene.GetPhysicsScene() != Physics.defaultPhysicsScene;
            taken = 0f;
            if (atAnyTime) TakeSteps(scene);
            else clock.Dispose();
            foreach (RigidbodyFloat known in ordered) known.See(space);
            stacks.Find(ordered);
            foreach (RigidbodyFloat known in ordered) known.Track(space);
        }

        /// <summary>The steps of a frame were given to the GPU.</summary>
        /// <param name="bodies">The bodies on the GPU.</param>
        /// <param name="time">The liquid's time [s].</param>
        public void Record(FloatingBodies bodies, double time)
        {
            if (ordered.Count == 0) return;
            bodies.Request();
            float age = atAnyTime ? behind : Time.time - Time.fixedTime;
            foreach (RigidbodyFloat known in ordered)
                if (bodies.Has(known.Body)) known.Record(bodies.Frame - 1, time, age);
        }

        /// <summary>Before a physics step.</summary>
        public void FixedUpdate(Vector3 position, Quaternion rotation, float deltaTime)
        {
            if (atAnyTime) return;
            Give(new FloatSpace(position, rotation), deltaTime);
            foreach (RigidbodyFloat known in ordered) known.Stepped(deltaTime, false);
        }

        /// <summary>After a frame with steps of physics, where it is not known when the next come: for as long as those took.</summary>
        public void GiveAhead()
        {
            if (taken > 0f) Give(space, taken);
        }

        /// <summary>Writes the bodies, once no read-back is under way.</summary>
        public void Save(SaveWriter writer, FloatingBodies bodies)
        {
            bodies.Save(writer, KeyOf);
            List<RigidbodyFloat> there = ordered.FindAll(f => f.Rigidbody != null);
            writer.Write(there.Count);
            foreach (RigidbodyFloat known in there)
            {
                writer.WriteKey(known.Rigidbody);
                writer.WritePart(known.Save);
            }
        }

        /// <summary>Goes on from a save, after a look.</summary>
        public void Load(SaveReader reader, FloatingBodies bodies)
        {
            Leave();
            stacks.Clear();
            Dictionary<string, RigidbodyFloat> byKey = SaveReader.ByKey(ordered, f => f.Rigidbody);
            bodies.Load(reader, byKey, f => f.Body);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                bool isThere = reader.TryFind(byKey, out RigidbodyFloat known);
                SaveReader own = reader.ReadPart();
                if (isThere) known.Load(own);
            }
            foreach (RigidbodyFloat known in ordered) known.Look(space);
        }

        public void Dispose() => clock.Dispose();

        private void Give(in FloatSpace now, float time)
        {
            foreach (KeyValuePair<Rigidbody, RigidbodyFloat> known in floats)
                if (RigidbodyFloat.Moves(known.Key)) known.Value.Correct(now, time);
            stacks.Correct();
            foreach (KeyValuePair<Rigidbody, RigidbodyFloat> known in floats)
                if (RigidbodyFloat.Moves(known.Key)) known.Value.Give(now, time);
        }

        private void TakeSteps(Scene scene)
        {
            taken = clock.Advance(scene);
            if (taken > 0f) stepped = taken;
            behind = Mathf.Clamp(behind + Time.deltaTime - taken, 0f, stepped);
            foreach (RigidbodyFloat known in ordered) known.Stepped(taken, true);
        }

        private string KeyOf(FloatingBody body)
        {
            RigidbodyFloat known = ordered.Find(f => f.Body == body);
            return known == null || known.Rigidbody == null ? "" : ScenePath.GetPath(known.Rigidbody);
        }

        private void Leave()
        {
            foreach (KeyValuePair<Rigidbody, RigidbodyFloat> known in floats)
                if (known.Value.Colliders.Count == 0) gone.Add(known.Key);
            foreach (Rigidbody rigidbody in gone)
            {
                ordered.Remove(floats[rigidbody]);
                floats.Remove(rigidbody);
            }

            gone.Clear();
        }
    }
}
