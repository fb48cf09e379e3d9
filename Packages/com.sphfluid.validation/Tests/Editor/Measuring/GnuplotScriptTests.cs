using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Script and pictures of one name, written in any case and drawn where there is gnuplot.</summary>
    public sealed class GnuplotScriptTests : FolderTests
    {
        [Test]
        public void TheFirstLineSaysWhatItDrawsAndHow()
        {
            Assert.That(new LineScript("fall", "plot x", "svg", "png").Lines().ToArray(),
                Is.EqualTo(new[] { "# Draws fall.svg and fall.png: gnuplot fall.gp", "plot x" }));
            Assert.That(new LineScript("fall", "plot x", "png").Lines().First(), Is.EqualTo("# Draws fall.png: gnuplot fall.gp"));
        }

        [Test]
        public void ItsFilesAreKnownBeforeItIsWritten()
        {
            ResultFile[] files = LineScript.Claimed("fall", "svg", "png").ToArray();

            Assert.That(files.Select(f => f.Name), Is.EqualTo(new[] { "fall.gp", "fall.svg", "fall.png" }));
            Assert.That(files[0].FirstLine, Is.EqualTo(new LineScript("fall", "", "svg", "png").Lines().First()));
            Assert.That(files.Skip(1).Select(f => f.Script), Is.All.EqualTo("fall.gp"));
        }

        [Test]
        public void ScriptsBehindOneThatCannotBeDrawnAreWrittenToo()
        {
            string problem =
                GnuplotScript.Draw(folder, new[] { new LineScript("broken", "plott x", "png"), new LineScript("whole", "print 1", "png") });

            Assert.That(problem, Does.Contain("broken.gp"));
            Assert.That(File.ReadAllLines(Path.Combine(folder, "whole.gp")).Last(), Is.EqualTo("print 1"));
        }

        private sealed class LineScript : GnuplotScript
        {
            private readonly string line;

            public LineScript(string stem, string line, params string[] formats) : base(stem, formats) => this.line = line;

            public static IEnumerable<ResultFile> Claimed(string stem, params string[] formats) => Files(stem, formats);

            private protected override IEnumerable<string> Body() => new[] { line };
        }
    }
}
