using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A Rigidbody in the liquid. The GPU has a body of its own, which the liquid moves within the steps; what PhysX does beside that
    /// (contacts, joints, forces of scripts) is found from the Rigidbody's velocities and places and pushes the GPU's body. PhysX in turn gets the liquid's
    /// force as last known, and corrections towards the GPU's body.
    /// </summary>
    internal sealed class RigidbodyFloat
    {
        // Of a step's displacement or turn: what rounding, and PhysX's way of turning, leave.
        const float Unexplained = 0.01f;

        // Of a velocity, and of 1 m/s or 1 rad/s: what the rounding of a frame's physics steps leaves. Handed on, it would make the liquid depend on what PhysX is given.
        const float Rounding = 4e-6f;

        // Over the support radius: farther in a step is no push, the body was put elsewhere.
        const float Elsewhere = 4f;

        // Corrections below this would keep bodies from resting [m, rad].
        const float LeastCorrection = 1e-5f;

        readonly Rigidbody rigidbody;
        readonly FloatFollower follower = new FloatFollower();
        readonly float reach;
        FloatMotion last;
        FloatChange refused;
        Vector3 expectedVelocity, expectedAngularVelocity; // of the frame, without what others do
        FloatShift shift;
        float stepLength;
        bool isKnown, corrected;
        uint epoch;

        public RigidbodyFloat(Rigidbody rigidbody, float reach, in FloatSpace space)
        {
            this.rigidbody = rigidbody;
            this.reach = reach;
            Body = new FloatingBody(RigidbodyMass.Of(rigidbody, space.ToSimulation), PoseOf(space, rigidbody.transform.position, rigidbody.transform.rotation));
        }

        /// <summary>The scene's body.</summary>
        public Rigidbody Rigidbody => rigidbody;

        /// <summary>The body on the GPU.</summary>
        public FloatingBody Body { get; }

        /// <summary>Whether it is in the domain in this frame.</summary>
        public bool IsPresent { get; set; }

        /// <summary>Whether the liquid can move a Rigidbody.</summary>
        public static bool Moves(Rigidbody rigidbody) => rigidbody != null && !rigidbody.isKinematic;

        /// <summary>Before a physics step: the liquid's force, and once a frame a correction.</summary>
        public void FixedUpdate(in FloatSpace space, float deltaTime)
        {
            Sample(space);
            FloatingMass mass = Body.Mass;
            Vector3 velocity = Vector3.zero, angularVelocity = Vector3.zero;
            if (Body.KnownFrame >= 0)
            {
                FloatingState known = Body.Known;
                float part = known.Time > 0f ? deltaTime / known.Time : 0f;
                Quaternion axes = last.Pose.Rotation;
                velocity = mass.InverseMass * part * known.Impulse;
                angularVelocity = axes * Vector3.Scale(mass.InverseInertia, Quaternion.Inverse(axes) * (part * known.AngularImpulse));
                if (!corrected) Correct(space, known, deltaTime, ref velocity, ref angularVelocity);
            }

            velocity = new Vector3(Vector3.Dot(mass.FreeX, velocity), Vector3.Dot(mass.FreeY, velocity), Vector3.Dot(mass.FreeZ, velocity));
            float kept = Kept(mass.Damping, deltaTime);
            Vector3 change = velocity + deltaTime * mass.Gravity;
            expectedVelocity = kept * (expectedVelocity + change);
            expectedAngularVelocity = Kept(mass.AngularDamping, deltaTime) * (expectedAngularVelocity + angularVelocity);
            velocity += shift.Begin(kept * (last.Velocity + change), kept);
            if (velocity != Vector3.zero) rigidbody.AddForce(space.ToWorld * velocity, ForceMode.VelocityChange);
            if (angularVelocity != Vector3.zero) rigidbody.AddTorque(space.ToWorld * angularVelocity, ForceMode.VelocityChange);
            stepLength = deltaTime;
        }

        /// <summary>Once a frame, before the liquid's steps: where the Rigidbody is, and what others than the liquid did to it.</summary>
        public void Follow(in FloatSpace space)
        {
            bool wasKnown = isKnown;
            Sample(space);
            FloatingMass mass = RigidbodyMass.Of(rigidbody, space.ToSimulation);
            if (!mass.IsNear(Body.Mass)) Body.Mass = mass;
            Look(space); // as the colliders are seen: interpolated, where it is
            Body.Velocity = last.Velocity;
            Body.AngularVelocity = last.AngularVelocity;
            if (!wasKnown) Restart();
            else if (refused.Displacement.magnitude > Elsewhere * reach) Restart();
            else Body.Push(Beyond(last.Velocity - expectedVelocity, expectedVelocity, Rounding, Rounding),
                Beyond(last.AngularVelocity - expectedAngularVelocity, expectedAngularVelocity, Rounding, Rounding),
                refused.Displacement, refused.Rotation);
            refused = default;
            expectedVelocity = last.Velocity;
            expectedAngularVelocity = last.AngularVelocity;
            corrected = false;
        }

        /// <summary>The steps of the frame were recorded.</summary>
        /// <param name="frame">Number of the frame.</param>
        /// <param name="time">The liquid's time [s].</param>
        /// <param name="lead">How much later that is than the last physics step [s].</param>
        public void Note(long frame, double time, float lead)
        {
            if (epoch != Body.Epoch) follower.Restart(); // of what was before a seed nothing holds
            epoch = Body.Epoch;
            FloatMotion now = last;
            now.Pose = Turned(last.Pose, lead * last.Velocity, lead * last.AngularVelocity);
            follower.Note(frame, time, now);
        }

        /// <summary>Where the colliders of the Rigidbody are seen now.</summary>
        public void Look(in FloatSpace space) => Body.Pose = PoseOf(space, rigidbody.transform.position, rigidbody.transform.rotation);

        /// <summary>Writes what was last seen and given.</summary>
        public void Save(SaveWriter writer)
        {
            Body.Save(writer);
            follower.Save(writer);
            writer.Write(last);
            writer.Write(refused);
            writer.Write(expectedVelocity);
            writer.Write(expectedAngularVelocity);
            writer.Write(shift);
            writer.Write(stepLength);
            writer.Write(isKnown);
            writer.Write(corrected);
            writer.Write(epoch);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            Body.Load(reader);
            follower.Load(reader);
            last = reader.Read<FloatMotion>();
            refused = reader.Read<FloatChange>();
            expectedVelocity = reader.Read<Vector3>();
            expectedAngularVelocity = reader.Read<Vector3>();
            shift = reader.Read<FloatShift>();
            stepLength = reader.Read<float>();
            isKnown = reader.Read<bool>();
            corrected = reader.Read<bool>();
            epoch = reader.Read<uint>();
        }

        void Restart()
        {
            Body.Seed();
            follower.Restart();
        }

        // A displacement is given as a velocity of one step, which contacts may refuse; a turn at once, since PhysX bounds angular velocities.
        void Correct(in FloatSpace space, in FloatingState known, float deltaTime, ref Vector3 velocity, ref Vector3 angularVelocity)
        {
            corrected = true;
            FloatChange change = follower.Correct(
                new FloatMotion { Pose = known.Pose, Velocity = known.Velocity, AngularVelocity = known.AngularVelocity }, Body.KnownFrame);
            velocity += change.Velocity;
            angularVelocity += change.AngularVelocity;
            if (change.Displacement.magnitude < LeastCorrection && change.Rotation.magnitude < LeastCorrection) return;
            shift.Next = change.Displacement / deltaTime;
            last.Pose = Turned(last.Pose, Vector3.zero, change.Rotation);
            Quaternion rotation = space.ToWorld * last.Pose.Rotation * Quaternion.Inverse(RigidbodyMass.Axes(rigidbody));
            rigidbody.rotation = rotation;
            rigidbody.position = space.ToWorld * last.Pose.Centre + space.Position - rotation * rigidbody.centerOfMass;
        }

        // What the last physics step did beside going on by its velocities.
        void Sample(in FloatSpace space)
        {
            FloatMotion now = MotionOf(space);
            if (isKnown)
            {
                Vector3 displacement = stepLength * now.Velocity, rotation = stepLength * now.AngularVelocity;
                refused.Displacement += Beyond(now.Pose.Centre - last.Pose.Centre - displacement, displacement, LeastCorrection, Unexplained);
                refused.Rotation += Beyond(now.Pose.TurnFrom(last.Pose) - rotation, rotation, LeastCorrection, Unexplained);
                if (stepLength > 0f) refused.Displacement -= stepLength * shift.End(now.Velocity);
            }

            stepLength = 0f;
            now.Velocity -= shift.Left;
            last = now;
            isKnown = true;
        }

        // As PhysX damps.
        static float Kept(float damping, float deltaTime) => Mathf.Max(0f, 1f - damping * deltaTime);

        static FloatingPose Turned(in FloatingPose pose, Vector3 displacement, Vector3 rotation) => new FloatingPose(
            pose.Centre + displacement, Quaternion.AngleAxis(rotation.magnitude * Mathf.Rad2Deg, rotation.normalized) * pose.Rotation);

        // What others did: nothing up to a least amount and a share of what is explained.
        static Vector3 Beyond(Vector3 found, Vector3 explained, float least, float share) =>
            found.magnitude > least + share * explained.magnitude ? found : Vector3.zero;

        FloatMotion MotionOf(in FloatSpace space) => new FloatMotion
        {
            Pose = PoseOf(space, rigidbody.position, rigidbody.rotation),
            Velocity = space.ToSimulation * rigidbody.GetPointVelocity(rigidbody.worldCenterOfMass), // its velocity is called otherwise in 2022.3 and 6000.0
            AngularVelocity = space.ToSimulation * rigidbody.angularVelocity,
        };

        FloatingPose PoseOf(in FloatSpace space, Vector3 position, Quaternion rotation) => new FloatingPose(
            space.ToSimulation * (position + rotation * rigidbody.centerOfMass - space.Position),
            space.ToSimulation * rotation * RigidbodyMass.Axes(rigidbody));
    }
}
