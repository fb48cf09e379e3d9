using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The motion of colliders as poses.</summary>
    public sealed class BodyPathTests
    {
        private static Matrix4x4 At(Vector3 position, Quaternion rotation, float scale = 1f) =>
            Matrix4x4.TRS(position, rotation, scale * new Vector3(2f, 3f, 4f));

        private static Vector3 Placed(in BodyPose pose, Vector3 fromPivot) => pose.Position + pose.Rotation * fromPivot;

        [Test]
        public void ABodyThatStaysDoesNotMove()
        {
            Matrix4x4 start = At(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 20f, 30f));
            var path = new BodyPath(start);
            for (int i = 1; i < 7; i++) Assert.That(path.TryAdd(0.1 * i, start), Is.True);

            Assert.That(path.Moves(1e-4f), Is.False);
            Assert.That(path.Poses.Select(p => p.Time), Is.EqualTo(new[] { 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6 }).Within(1e-9));
        }

        [Test]
        public void APointOfTheBodyGoesWhereItsColliderTakesIt()
        {
            Quaternion turned = Quaternion.Euler(10f, 20f, 30f);
            Matrix4x4 start = At(new Vector3(1f, 2f, 3f), turned),
                end = At(new Vector3(1.5f, 1f, 3.25f), Quaternion.Euler(0f, 0f, 70f) * turned);
            var path = new BodyPath(start);
            Assert.That(path.TryAdd(0.5, end), Is.True);
            var corner = new Vector3(0.5f, -0.5f, 0.5f);

            Vector3 fromPivot = start.MultiplyPoint3x4(corner) - path.Pivot;

            Assert.That((Placed(path.Poses[1], fromPivot) - end.MultiplyPoint3x4(corner)).magnitude, Is.LessThan(1e-5f));
            Assert.That(path.Moves(1e-4f), Is.True);
        }

        [Test]
        public void ATurnInPlaceIsMotion()
        {
            var path = new BodyPath(At(Vector3.zero, Quaternion.identity));
            path.TryAdd(0.1, At(Vector3.zero, Quaternion.Euler(0f, 1f, 0f)));

            Assert.That(path.Moves(1e-4f), Is.True);
        }

        [Test]
        public void ATurnGoesOnPastHalfATurnWithoutAChangeOfSign()
        {
            var path = new BodyPath(At(Vector3.zero, Quaternion.identity));
            for (int i = 1; i <= 24; i++) path.TryAdd(i, At(Vector3.zero, Quaternion.Euler(0f, 30f * i, 0f)));

            for (int i = 1; i < path.Poses.Count; i++)
            {
                Assert.That(Quaternion.Dot(path.Poses[i - 1].Rotation, path.Poses[i].Rotation),
                    Is.EqualTo(Mathf.Cos(15f * Mathf.Deg2Rad)).Within(1e-4f), $"pose {i}");
            }
        }

        [Test]
        public void AChangeOfSizeIsNoPath()
        {
            var path = new BodyPath(At(Vector3.zero, Quaternion.identity));

            Assert.That(path.TryAdd(0.1, At(Vector3.zero, Quaternion.identity, 1.01f)), Is.False);
            Assert.That(path.Poses.Count, Is.EqualTo(1));
        }

        [Test]
        public void StayingRepeatsTheLastPose()
        {
            var path = new BodyPath(At(Vector3.zero, Quaternion.identity));
            path.TryAdd(0.1, At(Vector3.up, Quaternion.identity));
            path.Stay(0.2);

            Assert.That(path.Poses[2].Position, Is.EqualTo(Vector3.up));
            Assert.That(path.Poses[2].Time, Is.EqualTo(0.2));
        }
    }
}
