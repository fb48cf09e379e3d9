using System.Collections.Generic;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method)]
public class ConditionalIgnoreAttribute : NUnitAttribute, IApplyToTest
{
    static readonly Dictionary<string, bool> s_Conditions = new();

    readonly string m_Key;
    readonly string m_Reason;

    public ConditionalIgnoreAttribute(string conditionKey, string ignoreReason)
    {
        m_Key = conditionKey;
        m_Reason = ignoreReason;
    }

    public static void AddConditionalIgnoreMapping(string key, bool value) => s_Conditions.Add(key, value);

    public void ApplyToTest(Test test)
    {
        if (!s_Conditions.TryGetValue(m_Key, out bool ignore) || !ignore) return;
        test.RunState = RunState.Ignored;
        test.Properties.Set(PropertyNames.SkipReason, m_Reason);
    }
}
