using Headless.Mutation;
using NUnit.Framework;

namespace Headless.Tests.Mutation;

public class MutationTableTests
{
    [Test]
    public void RowsAreReadAsTheyWereWritten()
    {
        string file = Path.Combine(Path.GetTempPath(), $"mutants-{Guid.NewGuid():N}.csv");
        try
        {
            Mutant mutant = Mutant.Create("Shaders/A.hlsl", "void F()\n{\n    f(\"a\", b);\n}\n", "statement", 15, 10, ";");
            var row = new Row(mutant, 7, 3, Row.Survived, Row.Caught, "T.Test(1,\"x\")", "expected 1, was 2");
            Table.Write(file, [row]);
            Row read = Table.Read(file).Single();
            Assert.That(read.Mutant.Key, Is.EqualTo(mutant.Key));
            Assert.That((read.Mutant.Line, read.Covering, read.Run, read.First, read.Verdict, read.By, read.Detail),
                Is.EqualTo((3, 7, 3, Row.Survived, Row.Caught, row.By, row.Detail)));
        }
        finally
        {
            File.Delete(file);
        }
    }

    [TestCase("1", "2")]
    [TestCase("0.0", "1.0")]
    [TestCase("0.5f", "0.55f")]
    [TestCase("1f", "1.1f")]
    [TestCase("1e-6f", "0.0f")]
    [TestCase("0x0F", "0xe")]
    public void ConstantsChangeButKeepTheirSpelling(string text, string expected) => Assert.That(Constants.Other(text), Is.EqualTo(expected));
}
