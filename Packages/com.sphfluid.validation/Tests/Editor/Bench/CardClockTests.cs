using System.IO;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Clocks of cards that are not in this machine, as their drivers tell them.</summary>
    public sealed class CardClockTests
    {
        private const string Smi = "NVIDIA H200, 1980\nNVIDIA A2, 1770\nNVIDIA T4, [N/A]\n";

        [TestCase("NVIDIA H200", 1980.0)]
        [TestCase("NVIDIA A2", 1770.0)]
        [TestCase("NVIDIA T4", double.NaN)]
        [TestCase("llvmpipe (LLVM 15.0.6, 256 bits)", double.NaN)]
        public void NvidiasLineOfTheCard(string card, double clock) => Assert.That(CardClock.OfNvidia(Smi, card), Is.EqualTo(clock));

        [Test]
        public void AmdsFileOfTheCard()
        {
            string folder = TestFolder.Fresh();
            try
            {
                Card(folder, "card0", "0x744c", "0: 500Mhz\n1: 2475Mhz *\n");
                Card(folder, "card1", "0x73bf", "0: 500Mhz *\n1: 2105Mhz\n");
                Card(folder, "card2", "0x1638", "0: 500Mhz\n");
                Directory.CreateDirectory(Path.Combine(folder, "renderD128"));
                Assert.That(CardClock.OfLinux(folder, 0x1002, 0x744c), Is.EqualTo(2475.0));
                Assert.That(CardClock.OfLinux(folder, 0x1002, 0x73bf), Is.EqualTo(500.0));
                Assert.That(CardClock.OfLinux(folder, 0x1002, 0x1638), Is.NaN);
                Assert.That(CardClock.OfLinux(folder, 0x8086, 0x744c), Is.NaN);
                Assert.That(CardClock.OfLinux(Path.Combine(folder, "none"), 0x1002, 0x744c), Is.NaN);
            }
            finally
            {
                TestFolder.Delete(folder);
            }
        }

        private static void Card(string folder, string name, string device, string clocks)
        {
            string card = Path.Combine(folder, name, "device");
            Directory.CreateDirectory(card);
            File.WriteAllText(Path.Combine(card, "vendor"), "0x1002\n");
            File.WriteAllText(Path.Combine(card, "device"), device + "\n");
            File.WriteAllText(Path.Combine(card, "pp_dpm_sclk"), clocks);
        }
    }
}
