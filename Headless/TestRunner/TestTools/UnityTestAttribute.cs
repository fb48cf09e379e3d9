using System.Collections.Generic;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace UnityEngine.TestTools;

/// <summary>A test that returns IEnumerator and runs over several frames.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTestAttribute : CombiningStrategyAttribute, ISimpleTestBuilder, ITestBuilder, IImplyFixture, IApplyToTest
{
    readonly NUnitTestCaseBuilder m_Builder = new();

    public UnityTestAttribute() : base(new CoroutineStrategy(), new ParameterDataSourceProvider()) { }

    TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite)
    {
        var parameters = new TestCaseParameters(Array.Empty<object>()) { ExpectedResult = new object(), HasExpectedResult = true };
        TestMethod test = m_Builder.BuildTestMethod(method, suite, parameters);
        parameters.HasExpectedResult = false;
        // Without arguments the test carries the method's bare name, as in the Editor's test window.
        if (test.Name.EndsWith("()", StringComparison.Ordinal)) test.Name = test.Name[..^2];
        if (test.FullName.EndsWith("()", StringComparison.Ordinal)) test.FullName = test.FullName[..^2];
        return test;
    }

    // NUnit asks both builders; without parameters the combining one would make an empty suite.
    IEnumerable<TestMethod> ITestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
        method.GetParameters().Length == 0 ? [((ISimpleTestBuilder)this).BuildFrom(method, suite)] : base.BuildFrom(method, suite);

    void IApplyToTest.ApplyToTest(Test test) => test.Properties.Set("UnityTest", true);

    // NUnit asks for an expected result of a method that returns something; the runner never compares it.
    sealed class CoroutineStrategy : ICombiningStrategy
    {
        readonly CombinatorialStrategy m_Inner = new();

        public IEnumerable<ITestCaseData> GetTestCases(System.Collections.IEnumerable[] sources)
        {
            foreach (ITestCaseData data in m_Inner.GetTestCases(sources))
                yield return new TestCaseParameters(data.Arguments) { ExpectedResult = new object(), HasExpectedResult = true };
        }
    }
}
