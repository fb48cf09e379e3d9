using System;
using System.IO;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Tests that write to a folder of their own, which is not there at first and goes with the test.</summary>
    public abstract class FolderTests
    {
        private protected string folder;

        [SetUp]
        public void NameFolder() => folder = Path.Combine(Path.GetTempPath(), "sphfluid-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void DeleteFolder()
        {
            if (Directory.Exists(folder))
                Directory.Delete(folder, true);
        }
    }
}
