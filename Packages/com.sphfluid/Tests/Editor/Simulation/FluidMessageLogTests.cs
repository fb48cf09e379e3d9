using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>What a simulation has said: each message once, and what was said before a restore that failed.</summary>
    public sealed class FluidMessageLogTests
    {
        [Test]
        public void AMessageIsTakenOnce()
        {
            var log = new FluidMessageLog();
            Assert.That(log.TryAdd(Message("One.")), Is.True);
            Assert.That(log.TryAdd(Message("Two.")), Is.True);
            Assert.That(log.TryAdd(Message("One.")), Is.False);
            Assert.That(Texts(log), Is.EqualTo(new[] { "One.", "Two." }));
        }

        [Test]
        public void AMessageStaysOneLineWhateverIsInIt()
        {
            string line = new FluidMessage(FluidSeverity.Info, FluidIssue.NoLiquid, null, "Two\nlines and " + new string('x', 1_000_000),
                "A\tcure.").ToString();
            Assert.That(line,
                Does.StartWith("[SPH Fluid] 'SPH Fluid': Two lines and xx").And.EndsWith("x… A cure.").And.Length.LessThan(4000));
        }

        [Test]
        public void AClearedLogTakesAMessageAgain()
        {
            var log = new FluidMessageLog();
            log.TryAdd(Message("One."));
            Assert.That(log.Clear().Single().Text, Is.EqualTo("One."));
            Assert.That(log.All, Is.Empty);
            Assert.That(log.TryAdd(Message("One.")), Is.True);
        }

        [Test]
        public void WhatIsPutBackStandsBeforeWhatCameSinceAndNotTwice()
        {
            var log = new FluidMessageLog();
            foreach (string text in new[] { "One.", "Two.", "Three." }) log.TryAdd(Message(text));
            var earlier = log.Clear();
            log.TryAdd(Message("Two."));
            log.TryAdd(Message("Four."));
            log.PutBack(earlier);
            Assert.That(Texts(log), Is.EqualTo(new[] { "One.", "Three.", "Two.", "Four." }));
        }

        private static string[] Texts(FluidMessageLog log) => log.All.Select(m => m.Text).ToArray();

        private static FluidMessage Message(string text) => new FluidMessage(FluidSeverity.Info, FluidIssue.MethodChoice, null, text, "");
    }
}
