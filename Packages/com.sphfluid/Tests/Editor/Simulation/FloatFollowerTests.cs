using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A body of the scene's physics after one of the GPU that is known some frames late.</summary>
    public sealed class FloatFollowerTests
    {
        private const float Frame = 1f / 60f;

        // The GPU's body bobs and spins; PhysX gets the acceleration of the frame that is known.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(4)]
        public void ItStaysWithABodyThatBobs(int age)
        {
            var follower = new FloatFollower();
            var gpu = new List<FloatMotion>();
            var accelerations = new List<Vector3>();
            var physics = new FloatMotion { Pose = new FloatingPose(new Vector3(0.05f, 0f, 0f), Quaternion.identity) };
            Vector3 place = Vector3.zero, velocity = Vector3.zero, spin = new Vector3(0f, 0.4f, 0f);
            Quaternion rotation = Quaternion.Euler(0f, 0f, 5f);
            float worst = 0f, worstTurn = 0f;
            for (int n = 0; n < 300; n++)
            {
                if (n >= age)
                {
                    FloatChange change = follower.Correct(gpu[n - age], n - age, new FloatChange { Velocity = accelerations[n - age] });
                    change.Velocity += Frame * accelerations[n - age];
                    follower.Give(change);
                    physics.Velocity += change.Velocity;
                    physics.AngularVelocity += change.AngularVelocity;
                    physics.Pose = Moved(physics.Pose, change.Displacement, change.Rotation);
                }

                physics.Pose = Moved(physics.Pose, Frame * physics.Velocity, Frame * physics.AngularVelocity);
                Vector3 acceleration = -30f * (place - new Vector3(0f, 0.1f, 0f));
                velocity += Frame * acceleration;
                place += Frame * velocity;
                rotation = Moved(new FloatingPose(place, rotation), Vector3.zero, Frame * spin).Rotation;
                accelerations.Add(acceleration);
                gpu.Add(new FloatMotion { Pose = new FloatingPose(place, rotation), Velocity = velocity, AngularVelocity = spin });
                follower.Record(n, n * Frame, physics, Frame);
                if (n < 60) continue;
                worst = Mathf.Max(worst, (physics.Pose.Centre - place).magnitude);
                worstTurn = Mathf.Max(worstTurn, physics.Pose.TurnFrom(gpu[n].Pose).magnitude);
            }

            Assert.That(worst, Is.LessThan(0.002f * age));
            Assert.That(worstTurn, Is.LessThan(1e-3f));
        }

        [Test]
        public void AGapClosesByAQuarterAFrame()
        {
            var follower = new FloatFollower();
            var there = new FloatMotion { Pose = new FloatingPose(new Vector3(0f, 0.08f, 0f), Quaternion.identity) };
            var here = new FloatMotion { Pose = new FloatingPose(Vector3.zero, Quaternion.identity) };
            float place = 0f;
            for (int n = 0; n < 6; n++)
            {
                follower.Record(n, n * Frame, here, Frame); // what is known stays that of the start
                FloatChange change = follower.Correct(there, 0);
                follower.Give(change);
                place += change.Displacement.y;
            }

            Assert.That(place, Is.EqualTo(0.08f * (1f - Mathf.Pow(0.75f, 6f))).Within(1e-5f));
        }

        [Test]
        public void FramesThatAreNotKnownGiveNothing()
        {
            var follower = new FloatFollower();
            var motion = new FloatMotion { Pose = new FloatingPose(Vector3.one, Quaternion.identity) };
            var away = new FloatMotion { Pose = new FloatingPose(Vector3.zero, Quaternion.identity) };
            Assert.That(follower.Correct(away, 0).Displacement, Is.EqualTo(Vector3.zero), "before the first");
            for (int n = 7; n < 7 + FloatFollower.Memory + 3; n++) follower.Record(n, n * Frame, motion, Frame);
            Assert.That(follower.Correct(away, 7).Displacement, Is.EqualTo(Vector3.zero), "too old");
            Assert.That(follower.Correct(away, 3).Displacement, Is.EqualTo(Vector3.zero), "never noted");
            Assert.That(follower.Correct(away, 1000).Displacement, Is.EqualTo(Vector3.zero), "of the future");
            Assert.That(follower.Correct(away, 7 + FloatFollower.Memory).Displacement.magnitude, Is.Positive);
            follower.Restart();
            Assert.That(follower.Correct(away, 7 + FloatFollower.Memory).Displacement, Is.EqualTo(Vector3.zero), "after a restart");
        }

        private static FloatingPose Moved(in FloatingPose pose, Vector3 displacement, Vector3 turn) => new FloatingPose(
            pose.Centre + displacement, Quaternion.AngleAxis(turn.magnitude * Mathf.Rad2Deg, turn.normalized) * pose.Rotation);
    }
}
