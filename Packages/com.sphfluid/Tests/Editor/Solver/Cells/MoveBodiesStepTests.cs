using System;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// One step of MoveBodies and JoinBodies with impulses that the test writes into the sums, against the same step in C#.
    /// </summary>
    public sealed class MoveBodiesStepTests
    {
        private const int Words = 12;

        private static readonly FluidParticle[] FarParticle = { new FluidParticle(new Vector3(0.95f, 0.95f, 0.95f), Vector3.zero, 0u) };

        private static T Field<T>(object owner, string name) =>
            (T)owner.GetType().GetField(name, BindingFlags.Instance | BindingFlags.NonPublic).GetValue(owner);

        // Of every third body the liquid's impulses are bounded, as it is small; some of these are stopped, some thrown back, some made
        // fast.
        private static FloatingRig Bodies(int count, int stack, System.Random random, out FloatingBody[] bodies)
        {
            FluidSolverSettings settings = BodyRig.Water(2f * Vector3.one, 0.04f, 0.4f, 3f);
            var rig = new FloatingRig(settings, FarParticle);
            Vector3 Any(float size) => size * ParticleSets.RandomVector(random);
            bodies = new FloatingBody[count];
            for (int i = 0; i < count; i++)
            {
                Vector3 box = (i % 3 == 0 ? 0.05f : 0.2f) * Vector3.one +
                    0.1f * new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble());
                FloatingBody body = bodies[i] = rig.AddBox(box, i % 3 == 0 ? 5f : 300f, Any(1f), Quaternion.Euler(Any(200f)));
                FloatingMass mass = body.Mass;
                (mass.Damping, mass.AngularDamping) = (20f + i, 40f + i);
                if (i % 5 == 4) (mass.FreeY, mass.Inertia.x) = (Vector3.zero, float.PositiveInfinity);
                body.Mass = mass;
                body.Velocity = i % 7 == 6 ? Vector3.zero : Any(2f);
                body.AngularVelocity = i % 7 == 6 ? Vector3.zero : Any(4f);
                if (i < stack) body.Stack = 1;
            }
            rig.Frame(1);
            foreach (FloatingBody body in bodies) body.Push(Any(0.3f), Any(0.5f), Any(0.02f), Any(0.03f));
            rig.Begin();
            return rig;
        }

        // Sums of two words; one of exactly -2^32 units, whose low word is 0.
        private static (Vector3 impulse, Vector3 angular)[] Strike(FloatingRig rig, FloatingInput[] inputs, FloatingState[] states,
            System.Random random)
        {
            float unit = Field<float>(rig.Floating, "impulseUnit"), angularUnit = Field<float>(rig.Floating, "angularUnit");
            var words = new uint[Words * inputs.Length];
            var given = new (Vector3, Vector3)[inputs.Length];
            for (int i = 0; i < inputs.Length; i++)
            {
                Vector3 inertia =
                    new Vector3(1f / inputs[i].InverseInertia.z, 1f / inputs[i].InverseInertia.y, 1f / inputs[i].InverseInertia.z);
                Vector3 change = (i % 2 == 0 ? -1.5f : 0.6f) * states[i].Velocity + ParticleSets.RandomVector(random);
                Vector3 spin = (i % 2 == 0 ? -1.5f : 0.6f) * states[i].AngularVelocity + 2f * ParticleSets.RandomVector(random);
                Vector3 impulse = (i % 4 == 3 ? 40f : 1f) / inputs[i].InverseMass * change;
                Vector3 angular =
                    states[i].Rotation * Vector3.Scale(inertia, Quaternion.Inverse(states[i].Rotation) * ((i % 4 == 3 ? 100f : 1f) * spin));
                if (i == 1) impulse.y = -4294967296f * unit;
                given[i] = (Write(12 * i, impulse, unit), Write(12 * i + 6, angular, angularUnit));
            }
            Field<GraphicsBuffer>(rig.Floating, "sumBuffer").SetData(words);
            return given;

            Vector3 Write(int at, Vector3 value, float one)
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    long sum = (long)Math.Round((double)value[axis] / one);
                    (words[at + 2 * axis], words[at + 2 * axis + 1]) = ((uint)sum, (uint)(sum >> 32));
                    value[axis] = (float)((double)sum * one);
                }
                return value;
            }
        }

        // Stopped, pulled by no more than that beyond it, and made no faster than most.
        private static Vector3 Taken(Vector3 velocity, Vector3 change, float mostPull, float mostSpeed)
        {
            float stopped = velocity == Vector3.zero ? 0f : Mathf.Clamp01(-Vector3.Dot(change, velocity) / velocity.sqrMagnitude);
            Vector3 after = velocity - stopped * velocity + Vector3.ClampMagnitude(change + stopped * velocity, mostPull);
            return Vector3.ClampMagnitude(after, Mathf.Max(mostSpeed, velocity.magnitude)) - velocity;
        }

        private static FloatingState Kicked(FloatingInput input, FloatingState state, (Vector3 impulse, Vector3 angular) given,
            float kick, float part)
        {
            Quaternion toBody = Quaternion.Inverse(state.Rotation);
            Vector3 taken = Taken(state.Velocity, input.InverseMass * given.impulse, kick * input.MostPull, input.MostSpeed);
            Vector3 velocity = (1f - kick * input.Damping) * (state.Velocity + taken + kick * input.Gravity) + part * input.PushVelocity;
            Vector3 turned = Taken(toBody * state.AngularVelocity, Vector3.Scale(input.InverseInertia, toBody * given.angular),
                kick * input.MostPull * input.TurnsPerMetre, input.MostSpeed * input.TurnsPerMetre);
            float slowed = 1f - kick * input.AngularDamping;
            Vector3 spin = toBody * (slowed * state.AngularVelocity + part * input.PushAngularVelocity) + slowed * turned;
            for (int axis = 0; axis < 3; axis++)
            {
                if (input.InverseInertia[axis] > 0f) continue;
                spin[axis] = 0f;
                turned[axis] = 0f;
            }
            state.Velocity = new Vector3(Vector3.Dot(input.FreeX, velocity), Vector3.Dot(input.FreeY, velocity),
                Vector3.Dot(input.FreeZ, velocity));
            state.AngularVelocity = state.Rotation * spin;
            state.Impulse += taken / input.InverseMass;
            Vector3 inertia = new Vector3(input.InverseInertia.x > 0f ? 1f / input.InverseInertia.x : 0f, 1f / input.InverseInertia.y,
                1f / input.InverseInertia.z);
            state.AngularImpulse += state.Rotation * Vector3.Scale(turned, inertia);
            return state;
        }

        // The kick, and what it makes of each body; the first of them rest on each other.
        private static void Step(int count, int stack, Action<FloatingInput[], FloatingState[], FloatingState[]> see)
        {
            var random = new System.Random(10 * count + stack);
            using (FloatingRig rig = Bodies(count, stack, random, out _))
            {
                float dt = rig.Solver.Settings.TimeStep, kick = 0.8f * dt;
                FloatingInput[] inputs = GpuTest.Read<FloatingInput>(Field<GraphicsBuffer>(rig.Floating, "inputBuffer"), count);
                FloatingState[] before = rig.Floating.ReadNow();
                rig.State.BeginBodyStep(1, 4, dt);
                var pass = new MoveBodiesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.RecordBegin(cmd, rig.State));
                (Vector3, Vector3)[] given = Strike(rig, inputs, before, random);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, new FluidStep(dt, 0.6f * dt, false)));
                FloatingState[] after = rig.Floating.ReadNow(), expected = new FloatingState[count];
                rig.Solver.State.EndBodySteps();
                for (int i = 0; i < count; i++)
                {
                    before[i].Impulse = before[i].AngularImpulse = Vector3.zero;
                    expected[i] = Kicked(inputs[i], before[i], given[i], kick, 0.25f);
                }
                for (int i = 0; i < count; i++)
                {
                    Assert.That(after[i].Time, Is.EqualTo(dt).Within(1e-9f));
                    Vector3 moved = dt * after[i].Velocity + 0.25f * inputs[i].PushDisplacement,
                        turned = dt * after[i].AngularVelocity + 0.25f * inputs[i].PushRotation;
                    Assert.That((after[i].Centre - before[i].Centre - moved).magnitude, Is.LessThan(1e-6f), $"place of {i}");
                    Quaternion turn = Quaternion.AngleAxis(turned.magnitude * Mathf.Rad2Deg, turned.normalized) * before[i].Rotation;
                    Assert.That((after[i].Rotation * Vector3.one - turn * Vector3.one).magnitude, Is.LessThan(2e-5f), $"turn of {i}");
                    Near(after[i].Impulse, expected[i].Impulse, $"impulse of {i}");
                    Vector3 turns = new Vector3(inputs[i].InverseInertia.x > 0f ? 1f : 0f, 1f, 1f);
                    Near(Vector3.Scale(turns, Quaternion.Inverse(before[i].Rotation) * after[i].AngularImpulse),
                        Quaternion.Inverse(before[i].Rotation) * expected[i].AngularImpulse, $"angular impulse of {i}");
                }
                Assert.That(GpuTest.Read<uint>(Field<GraphicsBuffer>(rig.Floating, "sumBuffer"), Words * count), Is.All.Zero,
                    "sums begin anew");
                see(inputs, after, expected);
            }
        }

        private static void Near(Vector3 value, Vector3 expected, string of) =>
            Assert.That((value - expected).magnitude, Is.LessThan(1e-3f * expected.magnitude + 1e-7f), $"{of}: {value} for {expected}");

        [Test]
        public void AStepIsAKickOfWhatIsGivenAndADrift([Values(1, 7, 63, 64, 65)] int count) => Step(count, 0, (inputs, after, expected) =>
        {
            for (int i = 0; i < count; i++)
            {
                Near(after[i].Velocity, expected[i].Velocity, $"velocity of {i}");
                Near(after[i].AngularVelocity, expected[i].AngularVelocity, $"turning of {i}");
            }
            if (count > 60) Assert.That(Enumerable.Range(0, count).Count(i => inputs[i].MostPull < 1e20f), Is.InRange(10, 40), "bounded");
        });

        // Three of five: they have together what they would have alone.
        [Test]
        public void BodiesThatRestOnEachOtherKeepTheirMomentumAndMoveAsOne() => Step(5, 3, (inputs, after, expected) =>
        {
            Vector3 Momentum(FloatingState[] states) =>
                Enumerable.Range(0, 3).Aggregate(Vector3.zero, (sum, i) => sum + states[i].Velocity / inputs[i].InverseMass);
            Vector3 Angular(FloatingState[] states) =>
                Enumerable.Range(0, 3)
                    .Aggregate(Vector3.zero,
                        (sum, i) => sum + Vector3.Cross(expected[i].Centre, states[i].Velocity) / inputs[i].InverseMass +
                expected[i].Rotation *
                    Vector3.Scale(new Vector3(1f / inputs[i].InverseInertia.x, 1f / inputs[i].InverseInertia.y,
                        1f / inputs[i].InverseInertia.z), Quaternion.Inverse(expected[i].Rotation) * states[i].AngularVelocity));
            Near(Momentum(after), Momentum(expected), "momentum");
            Near(Angular(after), Angular(expected), "angular momentum");
            for (int i = 1; i < 3; i++)
            {
                Near(after[i].AngularVelocity, after[0].AngularVelocity, $"turning of {i}");
                Near(after[i].Velocity - after[0].Velocity,
                    Vector3.Cross(after[0].AngularVelocity, expected[i].Centre - expected[0].Centre), $"velocity of {i}");
            }
            for (int i = 3; i < 5; i++) Near(after[i].Velocity, expected[i].Velocity, $"velocity of {i}, which moves alone");
        });

        // Two bodies of two.
        [Test]
        public void TheCollidersOfABodyGoWithIt()
        {
            var random = new System.Random(5);
            Vector3 Any(float size) => size * ParticleSets.RandomVector(random);
            using (var rig = new FloatingRig(BodyRig.Water(2f * Vector3.one, 0.04f, 0.4f, 3f), FarParticle))
            {
                var corners = new (Vector3 placed, Vector3 own)[4]; // of a collider, in the scene at first and in its body's frame
                for (int i = 0; i < 4; i += 2)
                {
                    var pose = new FloatingPose(Any(0.5f), Quaternion.Euler(Any(200f)));
                    FloatingBody body = rig.AddBox(0.2f * Vector3.one, 500f, pose.Centre, pose.Rotation);
                    (body.Velocity, body.AngularVelocity) = (Any(5f), Any(20f));
                    Matrix4x4 frame = Matrix4x4.TRS(pose.Centre, pose.Rotation, Vector3.one),
                        at = frame * Matrix4x4.TRS(Any(0.3f), Quaternion.Euler(Any(200f)), Vector3.one);
                    corners[i] = (frame.MultiplyPoint3x4(0.1f * Vector3.one), 0.1f * Vector3.one);
                    corners[i + 1].placed = at.MultiplyPoint3x4(0.05f * Vector3.one);
                    corners[i + 1].own = frame.inverse.MultiplyPoint3x4(corners[i + 1].placed);
                    rig.Obstacles.Float(rig.Obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(0.1f * Vector3.one)), at, 0f), body);
                }
                rig.Frame(1);
                rig.Begin();
                FloatingState[] before = rig.Floating.ReadNow();
                rig.State.BeginBodyStep(0, 1, rig.Solver.Settings.TimeStep);
                GpuTest.Run(cmd => new MoveBodiesPass(rig.Shaders).RecordBegin(cmd, rig.State));
                GpuTest.Run(cmd => new MoveBodiesPass(rig.Shaders).Record(cmd, rig.State,
                    new FluidStep(rig.Solver.Settings.TimeStep, rig.Solver.Settings.TimeStep, false)));
                CollisionBody[] now = GpuTest.Read<CollisionBody>(Field<GraphicsBuffer>(rig.Obstacles.Bodies, "bodyBuffer"), 4);
                FloatingState[] after = rig.Floating.ReadNow();
                rig.State.EndBodySteps();
                for (int i = 0; i < 4; i++)
                {
                    FloatingState start = before[i / 2], end = after[i / 2];
                    Assert.That(
                        (now[i].Rotation0 * corners[i].placed + now[i].Position0 - start.Centre -
                            start.Rotation * corners[i].own).magnitude, Is.LessThan(2e-6f), $"start of {i}");
                    Assert.That(
                        (now[i].Rotation1 * corners[i].placed + now[i].Position1 - end.Centre - end.Rotation * corners[i].own).magnitude,
                        Is.LessThan(2e-6f), $"end of {i}");
                }
                Assert.That((after[0].Centre - before[0].Centre).magnitude, Is.GreaterThan(1e-4f), "they move");
            }
        }
    }
}
