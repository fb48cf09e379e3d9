using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class SessionWorkTests
    {
        private readonly List<string> events = new List<string>();

        [SetUp]
        public void SetUp() => events.Clear();

        [Test]
        public void InnerWorkComesBeforeWhatFollows()
        {
            var work = new SessionWork(Outer());
            int frames = 0;
            while (work.Step()) frames++;

            Assert.That(frames, Is.EqualTo(2), "one of the outer, one of the inner");
            Assert.That(events, Is.EqualTo(new[] { "begin", "inner", "freed", "end" }));
            Assert.That(work.IsDone, Is.True);
        }

        [Test]
        public void GivenUpWorkFreesWhatItHolds()
        {
            var work = new SessionWork(Outer());
            work.Step();
            work.Step();
            work.Clear();

            Assert.That(events, Is.EqualTo(new[] { "begin", "inner", "freed" }));
            Assert.That(work.Step(), Is.False);
        }

        private IEnumerator Outer()
        {
            events.Add("begin");
            yield return null;
            yield return Inner();
            events.Add("end");
        }

        private IEnumerator Inner()
        {
            try
            {
                events.Add("inner");
                yield return null;
            }
            finally
            {
                events.Add("freed");
            }
        }
    }
}
