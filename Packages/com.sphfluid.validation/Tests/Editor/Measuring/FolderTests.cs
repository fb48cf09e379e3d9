using System.IO;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Tests that write to a folder of their own, which is not there at first and goes with the test.</summary>
    public abstract class FolderTests
    {
        private protected string folder;

        [SetUp]
        public void NameFolder() => folder = TestFolder.Fresh();

        [TearDown]
        public void DeleteFolder() => TestFolder.Delete(folder);
    }
}
