using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method | AttributeTargets.Assembly)]
public class UnityPlatformAttribute : NUnitAttribute, IApplyToTest
{
    public UnityPlatformAttribute() { }
    public UnityPlatformAttribute(params RuntimePlatform[] include) => this.include = include;

    public RuntimePlatform[] include { get; set; } = Array.Empty<RuntimePlatform>();
    public RuntimePlatform[] exclude { get; set; } = Array.Empty<RuntimePlatform>();

    public void ApplyToTest(Test test)
    {
        if (test.RunState is RunState.NotRunnable or RunState.Ignored) return;
        bool included = include.Length == 0 || Array.IndexOf(include, Application.platform) >= 0;
        if (included && Array.IndexOf(exclude, Application.platform) < 0) return;
        test.RunState = RunState.Skipped;
        test.Properties.Set(PropertyNames.SkipReason, $"Not for {Application.platform}.");
    }
}
