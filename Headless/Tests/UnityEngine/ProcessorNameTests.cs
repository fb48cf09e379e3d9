using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>The name of the processor, from the text of /proc/cpuinfo.</summary>
public sealed class ProcessorNameTests
{
    [Test]
    public void TheProcessorsOwnNameIsTheFirstCores() =>
        Assert.That(ProcessorName.Find("processor\t: 0\nmodel\t\t: 106\nmodel name\t: Maker Model: 8 @ 2.1GHz\n\nprocessor\t: 1\nmodel name\t: other\n"), Is.EqualTo("Maker Model: 8 @ 2.1GHz"));

    [TestCase("")]
    [TestCase("processor\t: 0\nBogoMIPS\t: 50.00\nFeatures\t: fp asimd\n")]
    public void WithoutANameTheArchitectureStands(string cpus)
    {
        Assert.That(ProcessorName.Find(cpus), Is.Null);
        Assert.That(SystemInfo.processorType, Is.Not.Empty);
    }
}
