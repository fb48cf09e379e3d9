using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>How steps are cut into blocks of one neighbour setup each.</summary>
    public sealed class StepBlocksTests
    {
        [Test]
        public void BlocksAreTheFewestAndAsEqualAsTheyCome([Values(1, 2, 3, 7, 8, 13, 64, 1009)] int steps,
            [Values(1, 2, 3, 4, 8)] int most)
        {
            var blocks = new StepBlocks(steps, most);
            var lengths = new List<int>();
            int length = 0;
            for (int i = 0; i < steps; i++)
            {
                length++;
                if (!blocks.IsLast(i)) continue;
                lengths.Add(length);
                length = 0;
            }
            Assert.That(length, Is.Zero, "the last step of all ends a block");
            Assert.That(lengths.Sum(), Is.EqualTo(steps));
            Assert.That(lengths.Count, Is.EqualTo((steps + most - 1) / most));
            Assert.That(lengths.Max(), Is.EqualTo(blocks.LongestBlock).And.LessThanOrEqualTo(most));
            Assert.That(lengths.Max() - lengths.Min(), Is.LessThanOrEqualTo(1));
        }
    }
}
