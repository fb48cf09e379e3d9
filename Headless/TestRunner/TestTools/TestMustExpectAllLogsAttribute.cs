namespace UnityEngine.TestTools;

/// <summary>Every log of the test must be expected, not errors only.</summary>
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Class | AttributeTargets.Assembly)]
public class TestMustExpectAllLogsAttribute : Attribute
{
    public TestMustExpectAllLogsAttribute(bool mustExpect = true) => MustExpect = mustExpect;

    public bool MustExpect { get; }
}
