using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A Rigidbody in the liquid. The GPU has a body of its own, which the liquid moves within the steps; what PhysX does beside that
    /// (contacts, joints, forces of scripts) is found from the Rigidbody's velocities and places and pushes the GPU's body. PhysX in turn
    /// gets the liquid's force as last known, and corrections towards the GPU's body.
    /// </summary>
    internal sealed class RigidbodyFloat
    {
        // Of a step's displacement or turn: what rounding, and PhysX's way of turning, leave.
        private const float Unexplained = 0.01f;

        // Of a velocity, and of 1 m/s or 1 rad/s: what the rounding of a frame's physics steps leaves. Handed on, it would make the liquid
        // depend on what PhysX is given.
        private const float Rounding = 1e-5f;

        // Over the support radius: farther in a step is no push, the body was put elsewhere.
        private const float Elsewhere = 4f;

        // Part of a frame's force that the next is given: what an impact gives at once, corrections have given before it is known as a
        // force.
        private const float Evenness = 0.25f;

        // Corrections below this would keep bodies from resting [m, rad].
        private const float LeastCorrection = 1e-5f;

        // A body farther than this from the GPU's does not fall asleep there [m].
        private const float RestGap = 1e-3f;

        private readonly Rigidbody rigidbody;
        private readonly FloatFollower follower = new FloatFollower();
        private readonly float reach;
        private State state;

        // What is last seen and given.
        private struct State
        {
            public FloatingMass Mass;
            public FloatMotion Last;
            // Given: with the next steps of physics; Asked: with the next one, by the forces of scripts
            public FloatChange Refused, Correction, Given, Asked;
            // accelerations by the liquid, evened out; of a stack Share is what contacts leave of it, and Spread what they take
            public FloatChange Pull, Share, Spread;
            public Vector3 ExpectedVelocity, ExpectedAngularVelocity; // of the frame, without what others do
            public FloatShift Shift, Turn;
            public FloatRest Rest;
            // Unseen: what a fall in several steps may differ from one in one; Acted: time since a correction was given
            public float StepLength, Unseen, Acted;
            public uint Epoch;
            public bool IsKnown, IsPulled, IsCorrected, IsHeld; // IsHeld: the last correction was refused
        }

        public RigidbodyFloat(Rigidbody rigidbody, float reach, in FloatSpace space)
        {
            this.rigidbody = rigidbody;
            this.reach = reach;
            state.Mass = RigidbodyMass.Read(rigidbody, space.ToSimulation);
            Body = new FloatingBody(state.Mass, PoseOf(space, rigidbody.transform.position, rigidbody.transform.rotation));
        }

        /// <summary>The scene's body.</summary>
        public Rigidbody Rigidbody => rigidbody;

        /// <summary>The body on the GPU.</summary>
        public FloatingBody Body { get; }

        /// <summary>Its colliders in the domain in this frame; none: it is not there.</summary>
        public List<Collider> Colliders { get; } = new List<Collider>();

        /// <summary>How it answers to impulses.</summary>
        public FloatingMass Mass => state.Mass;

        /// <summary>Where it was last seen.</summary>
        public FloatMotion Motion => state.Last;

        /// <summary>Accelerations by the liquid, evened out.</summary>
        public FloatChange Pull => state.Pull;

        /// <summary>With the next step of physics: towards the GPU's body.</summary>
        public FloatChange Correction => state.Correction;

        /// <summary>Whether it moves and turns about all axes.</summary>
        public bool IsFree
        {
            get
            {
                Vector3 turns = state.Mass.InverseInertia;
                return rigidbody.constraints == RigidbodyConstraints.None && Mathf.Min(turns.x, turns.y, turns.z) > 0f;
            }
        }

        /// <summary>Whether it sleeps.</summary>
        public bool IsAsleep => rigidbody.IsSleeping();

        /// <summary>Whether it may fall asleep.</summary>
        public bool IsCalm { get; private set; }

        /// <summary>Whether the liquid can move a Rigidbody.</summary>
        public static bool Moves(Rigidbody rigidbody) => rigidbody != null && !rigidbody.isKinematic;

        /// <summary>Physics was stepped, or will be before anything is looked at.</summary>
        /// <param name="time">For how long [s].</param>
        /// <param name="unseen">Whether that may have been in several steps.</param>
        public void Stepped(float time, bool unseen)
        {
            state.StepLength += time;
            state.Unseen = unseen ? 0.5f * time * time * state.Mass.Gravity.magnitude : 0f;
        }

        /// <summary>Before physics is stepped for a time: once a frame a correction.</summary>
        public void Correct(in FloatSpace space, float time)
        {
            Sample(space);
            state.Correction = default;
            if (state.IsCorrected || Body.KnownFrame < 0 || rigidbody.IsSleeping()) return;
            state.IsCorrected = true;
            state.Correction = CorrectionBy(Body.Known, time);
        }

        /// <summary>
        /// Of a body of a stack: it takes the part of the correction that all have; by the rest the GPU's body goes its way.
        /// </summary>
        public void Apply(in FloatChange common)
        {
            var rest = new FloatChange
            {
                Displacement = state.Correction.Displacement - common.Displacement,
                Rotation = state.Correction.Rotation - common.Rotation
            };
            follower.Give(rest);
            Body.Push(Vector3.zero, Vector3.zero, -rest.Displacement, -rest.Rotation);
            state.Correction = common;
        }

        /// <summary>After that: the liquid's force and the correction.</summary>
        public void Give(in FloatSpace space, float time)
        {
            if (rigidbody.IsSleeping()) return;
            state.Asked.Velocity =
                time * state.Mass.Free(state.Mass.InverseMass * (space.ToSimulation * rigidbody.GetAccumulatedForce(time)));
            state.Asked.AngularVelocity = time * TurningBy(space.ToSimulation * rigidbody.GetAccumulatedTorque(time));
            FloatChange change = default, spread = default;
            if (Body.KnownFrame >= 0)
            {
                (change.Velocity, change.AngularVelocity) = (time * state.Share.Velocity, time * state.Share.AngularVelocity);
                (spread.Velocity, spread.AngularVelocity) = (time * state.Spread.Velocity, time * state.Spread.AngularVelocity);
                Add(state.Correction, time, ref change);
            }

            change.Velocity = state.Mass.Free(change.Velocity);
            state.Given = change;
            Vector3 velocity = change.Velocity + spread.Velocity + state.Shift.Begin(),
                angularVelocity = change.AngularVelocity + spread.AngularVelocity + state.Turn.Begin();
            if (velocity != Vector3.zero) rigidbody.AddForce(space.ToWorld * velocity, ForceMode.VelocityChange);
            if (angularVelocity != Vector3.zero) rigidbody.AddTorque(space.ToWorld * angularVelocity, ForceMode.VelocityChange);
        }

        /// <summary>Once a frame, before the liquid's steps: where the Rigidbody is, and what the liquid does to it.</summary>
        public void See(in FloatSpace space)
        {
            Sample(space);
            FloatingMass found = RigidbodyMass.Read(rigidbody, space.ToSimulation);
            if (!found.IsNear(state.Mass)) state.Mass = found;
            Rest();
        }

        /// <summary>It bears nothing and rests on nothing.</summary>
        public void StandAlone() => Stand(0, state.Mass.Mass, state.Pull, default);

        /// <summary>It is one of a stack.</summary>
        /// <param name="stack">Number of the stack.</param>
        /// <param name="mass">Mass of the stack [kg].</param>
        /// <param name="share">Accelerations of the body by what the liquid does to the stack.</param>
        /// <param name="spread">What contacts take of <see cref="Pull"/>.</param>
        public void Stand(int stack, float mass, in FloatChange share, in FloatChange spread) =>
            (Body.Stack, Body.StackMass, state.Share, state.Spread) = (stack, mass, share, spread);

        /// <summary>Puts it to sleep.</summary>
        public void Sleep()
        {
            state.Rest.Begin();
            rigidbody.Sleep();
        }

        /// <summary>Wakes it.</summary>
        public void Wake() => rigidbody.WakeUp();

        /// <summary>After that: what others than the liquid did to it.</summary>
        public void Track(in FloatSpace space)
        {
            Body.Mass = rigidbody.IsSleeping() ? FloatingMass.Held : state.Mass;
            Look(space); // as the colliders are seen: interpolated, where it is
            Body.Velocity = state.Last.Velocity;
            Body.AngularVelocity = state.Last.AngularVelocity;
            if (state.Refused.Displacement.magnitude > Elsewhere * reach) Restart();
            else Body.Push(Beyond(state.Last.Velocity - state.ExpectedVelocity, state.ExpectedVelocity, Rounding, Rounding),
                Beyond(state.Last.AngularVelocity - state.ExpectedAngularVelocity, state.ExpectedAngularVelocity, Rounding, Rounding),
                state.Refused.Displacement, state.Refused.Rotation);
            state.Refused = default;
            state.ExpectedVelocity = state.Last.Velocity;
            state.ExpectedAngularVelocity = state.Last.AngularVelocity;
            state.IsCorrected = false;
        }

        /// <summary>The steps of the frame were recorded.</summary>
        /// <param name="frame">Number of the frame.</param>
        /// <param name="time">The liquid's time [s].</param>
        /// <param name="lead">How much later that is than the last physics step [s].</param>
        public void Record(long frame, double time, float lead)
        {
            if (state.Epoch != Body.Epoch) follower.Restart(); // of what was before a seed nothing holds
            state.Epoch = Body.Epoch;
            FloatMotion now = state.Last;
            now.Pose = Turned(now.Pose, lead * now.Velocity, lead * now.AngularVelocity);
            follower.Record(frame, time, now, state.Acted, lead);
            state.Acted = 0f;
        }

        /// <summary>Where the colliders of the Rigidbody are seen now.</summary>
        public void Look(in FloatSpace space) => Body.Pose = PoseOf(space, rigidbody.transform.position, rigidbody.transform.rotation);

        /// <summary>Writes what was last seen and given.</summary>
        public void Save(SaveWriter writer)
        {
            Body.Save(writer);
            follower.Save(writer);
            writer.Write(state);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            Body.Load(reader);
            follower.Load(reader);
            state = reader.Read<State>();
            if (Body.Mass.InverseMass == 0f) rigidbody.Sleep();
        }

        private void Restart()
        {
            Body.Seed();
            follower.Restart();
        }

        // Accelerations by the liquid's force as last known.
        private FloatChange PullOf(in FloatingState known)
        {
            float part = known.Time > 0f ? 1f / known.Time : 0f;
            return new FloatChange
            {
                Velocity = state.Mass.Free(state.Mass.InverseMass * part * known.Impulse),
                AngularVelocity = TurningBy(part * known.AngularImpulse)
            };
        }

        // The angular acceleration by a torque.
        private Vector3 TurningBy(Vector3 torque)
        {
            Quaternion axes = state.Last.Pose.Rotation;
            return axes * Vector3.Scale(state.Mass.InverseInertia, Quaternion.Inverse(axes) * torque);
        }

        // PhysX bounds how fast a body turns.
        private FloatChange CorrectionBy(in FloatingState known, float time)
        {
            FloatChange rates = state.Share;
            rates.Velocity += state.Mass.Gravity;
            float mostTurn = time * Mathf.Max(0f, rigidbody.maxAngularVelocity - state.Last.AngularVelocity.magnitude);
            return follower.Correct(
                new FloatMotion { Pose = known.Pose, Velocity = known.Velocity, AngularVelocity = known.AngularVelocity }, Body.KnownFrame,
                rates, mostTurn, state.IsHeld);
        }

        // A displacement and a turn are velocities of one step.
        private void Add(in FloatChange change, float time, ref FloatChange given)
        {
            given.Velocity += change.Velocity;
            given.AngularVelocity += change.AngularVelocity;
            if (change.Displacement.magnitude < LeastCorrection && change.Rotation.magnitude < LeastCorrection) return;
            (given.Displacement, given.Rotation) = (change.Displacement, change.Rotation);
            state.Shift.Next = change.Displacement / time;
            state.Turn.Next = change.Rotation / time;
        }

        // The liquid's force evened out; and a body in calm liquid may sleep, which forces alone would never let it.
        private void Rest()
        {
            IsCalm = false;
            if (Body.KnownFrame < 0) return;
            FloatingState known = Body.Known;
            FloatChange pull = PullOf(known);
            float part = state.IsPulled ? Evenness : 1f;
            state.Pull.Velocity += part * (pull.Velocity - state.Pull.Velocity);
            state.Pull.AngularVelocity += part * (pull.AngularVelocity - state.Pull.AngularVelocity);
            state.IsPulled = true;
            bool asleep = rigidbody.IsSleeping();
            float energy =
                Mathf.Max(Energy(known.Velocity, known.AngularVelocity), Energy(state.Last.Velocity, state.Last.AngularVelocity));
            Vector3 acceleration = pull.Velocity + state.Mass.Free(state.Mass.Gravity);
            bool isBehind = (known.Pose.Centre - state.Last.Pose.Centre).magnitude > RestGap;
            if (!state.Rest.Turns(asleep, acceleration, isBehind ? float.PositiveInfinity : energy, rigidbody.sleepThreshold, known.Time))
            {
                return;
            }
            if (asleep) rigidbody.WakeUp();
            else IsCalm = true;
        }

        // Over the mass, or somewhat more of what turns.
        private float Energy(Vector3 velocity, Vector3 angularVelocity) =>
            0.5f * (velocity.sqrMagnitude + state.Mass.InverseMass * state.Mass.Inertia.magnitude * angularVelocity.sqrMagnitude);

        // What steps of physics did beside going on by its velocities.
        private void Sample(in FloatSpace space)
        {
            FloatMotion now = MotionOf(space);
            float step = state.StepLength;
            if (state.IsKnown && !rigidbody.IsSleeping())
            {
                Vector3 displacement = step * now.Velocity, rotation = step * now.AngularVelocity;
                state.Refused.Displacement += Beyond(now.Pose.Centre - state.Last.Pose.Centre - displacement, displacement,
                    LeastCorrection + state.Unseen, Unexplained);
                state.Refused.Rotation += Beyond(now.Pose.TurnFrom(state.Last.Pose) - rotation, rotation, LeastCorrection, Unexplained);
                if (step > 0f) EndStep(space, step, ref now);
            }

            if (!state.IsKnown) (state.ExpectedVelocity, state.ExpectedAngularVelocity) = (now.Velocity, now.AngularVelocity);
            if (step > 0f || rigidbody.IsSleeping())
            {
                (state.StepLength, state.Given, state.Asked, state.Shift, state.Turn) = (0f, default, default, default, default);
            }
            state.Last = now;
            state.IsKnown = true;
        }

        // What the liquid, gravity and damping made of the velocities is expected. Shifts are taken back, so that scripts find a body's own
        // velocities.
        private void EndStep(in FloatSpace space, float step, ref FloatMotion now)
        {
            float kept = Kept(state.Mass.Damping, step), keptTurn = Kept(state.Mass.AngularDamping, step);
            Vector3 velocity = state.Given.Velocity + step * state.Mass.Gravity, angularVelocity = state.Given.AngularVelocity;
            (state.Given.Velocity, state.Acted) = (velocity, state.Acted + step);
            follower.Give(state.Given);
            state.ExpectedVelocity = kept * (state.ExpectedVelocity + velocity);
            state.ExpectedAngularVelocity = keptTurn * (state.ExpectedAngularVelocity + angularVelocity);
            Vector3 refused = state.Shift.End(now.Velocity, kept * (state.Last.Velocity + velocity + state.Asked.Velocity), kept,
                out Vector3 left);
            state.IsHeld = refused != Vector3.zero;
            state.Refused.Displacement -= step * refused;
            state.Refused.Rotation -= step * state.Turn.End(
                now.AngularVelocity, keptTurn * (state.Last.AngularVelocity + angularVelocity + state.Asked.AngularVelocity), keptTurn,
                out Vector3 leftTurn);
            now.Velocity -= left;
            now.AngularVelocity -= leftTurn;
            if (leftTurn != Vector3.zero) rigidbody.angularVelocity -= space.ToWorld * leftTurn;
            if (left == Vector3.zero) return;
#if UNITY_6000_0_OR_NEWER
            rigidbody.linearVelocity -= space.ToWorld * left;
#else
            rigidbody.velocity -= space.ToWorld * left;
#endif
        }

        // As PhysX damps.
        private static float Kept(float damping, float deltaTime) => Mathf.Max(0f, 1f - damping * deltaTime);

        private static FloatingPose Turned(in FloatingPose pose, Vector3 displacement, Vector3 rotation) => new FloatingPose(
            pose.Centre + displacement, Quaternion.AngleAxis(rotation.magnitude * Mathf.Rad2Deg, rotation.normalized) * pose.Rotation);

        // What others did: nothing up to a least amount and a share of what is explained.
        private static Vector3 Beyond(Vector3 found, Vector3 explained, float least, float share) =>
            found.magnitude > least + share * explained.magnitude ? found : Vector3.zero;

        private FloatMotion MotionOf(in FloatSpace space) => new FloatMotion
        {
            Pose = PoseOf(space, rigidbody.position, rigidbody.rotation),
            // its velocity is called otherwise in 2022.3 and 6000.0
            Velocity = space.ToSimulation * rigidbody.GetPointVelocity(rigidbody.worldCenterOfMass),
            AngularVelocity = space.ToSimulation * rigidbody.angularVelocity,
        };

        private FloatingPose PoseOf(in FloatSpace space, Vector3 position, Quaternion rotation) => new FloatingPose(
            space.ToSimulation * (position + rotation * rigidbody.centerOfMass - space.Position),
            space.ToSimulation * rotation * RigidbodyMass.Axes(rigidbody));
    }
}
