using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>PySPH where it is installed, and what is said where it is not.</summary>
    public sealed class PySphTests
    {
        [TestCase("/no/such/python", "'/no/such/python' cannot be started")]
        [TestCase("/bin/false", "'/bin/false' gives no version of PySPH")]
        public void WhereItIsMissingTheCureIsSaid(string python, string problem)
        {
            if (python == "/bin/false" && !File.Exists(python))
            {
                Assert.Ignore("There is no /bin/false here: nothing that starts and fails.");
            }
            Assert.That(() => PySph.Find(python), Throws.TypeOf<CommandLineException>()
                .With.Message.Contains("--python").And.Message.Contains(problem).And.Message.Contains("apt-get install python3-pysph"));
        }

        [Test]
        public void ASmallColumnAtRestStaysAtRest()
        {
            PySph program = FindOrIgnore();
            PeerPoint point = PeerRig.Point("hydrostatic", 10);
            CaseSetup setup = point.Setup;
            (setup.Duration, setup.SampleInterval) = (0.025, 0.01);
            using (var folder = new PeerFolder())
            {
                folder.Write(point);
                new SessionWork(program.Run(folder.Name)).Finish();
                PeerFacts facts = folder.ReadFacts();
                PeerSample[] samples = folder.ReadSamples(setup).ToArray();
                TestContext.WriteLine($"{facts.Version}, {facts.Steps} steps, set up in {facts.SetUpSeconds:F1} s");

                Assert.That(facts.Version, Does.StartWith("PySPH "));
                Assert.That(facts.End, Is.EqualTo(setup.Duration).Within(1e-6));
                Assert.That(facts.Steps, Is.GreaterThan(10));
                Assert.That(facts.BoundaryParticles, Is.EqualTo(2 * 6 * 8 * 8), "six layers below and above");
                Assert.That(samples.Select(s => s.Time), Is.EqualTo(new[] { 0.0, 0.01, 0.02, 0.025 }).Within(facts.TimeStep));
                FluidSnapshot first = samples[0].State, last = samples[3].State;
                Assert.That(first.LocalPositions, Is.EqualTo(setup.Particles.Select(p => p.Position)), "the case's own particles, by id");
                Assert.That(last.LocalPositions, Is.Not.EqualTo(first.LocalPositions));
                float fastest = last.Velocities.Max(v => v.magnitude), fall = 9.81f * 0.025f;
                Assert.That(fastest, Is.LessThan(0.5f * fall), "the floor bears it");
                float[] lowest = last.LocalPositions.Zip(last.Pressures, (p, pressure) => (p.y, pressure)).OrderBy(p => p.y).Take(64)
                    .Select(p => p.pressure).ToArray();
                Assert.That(lowest.Average(), Is.EqualTo(9810.0 * 0.95).Within(200.0),
                    "pressure of the lowest layer, half a spacing above the floor");
            }
        }

        [Test]
        public void WhatItCannotRunIsTold()
        {
            PySph program = FindOrIgnore();
            using (var folder = new PeerFolder())
            {
                File.WriteAllText(folder.PathOf("case.json"), "{}");
                Assert.That(() => new SessionWork(program.Run(folder.Name)).Finish(),
                    Throws.TypeOf<IOException>().With.Message.StartsWith("PySPH failed with exit code 1:").And.Message
                        .Contains("KeyError"));
            }
        }

        private static PySph FindOrIgnore()
        {
            try
            {
                return PySph.Find(PySph.DefaultPython);
            }
            catch (CommandLineException exception)
            {
                Assert.Ignore(exception.Message);
                throw;
            }
        }
    }
}
