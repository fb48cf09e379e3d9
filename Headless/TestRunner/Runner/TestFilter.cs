using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Headless.Engine;

/// <summary>Terms separated by ';': a full name or a regular expression found in it; "category:X" for a category; "!" before a term excludes.</summary>
sealed class TestFilter
{
    const string CategoryPrefix = "category:";

    readonly string? m_Exact;
    readonly List<string> m_Wanted = new();
    readonly List<string> m_Unwanted = new();
    TestFilter? m_And;

    public TestFilter(string? text)
    {
        foreach (string term in (text ?? "").Split(';', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
        {
            if (term[0] == '!') m_Unwanted.Add(term[1..]);
            else m_Wanted.Add(term);
        }
    }

    TestFilter(string fullName, bool _) => m_Exact = fullName;

    /// <summary>One test by its whole name.</summary>
    public static TestFilter Exactly(string fullName) => new(fullName, true);

    /// <summary>Lets through only what another filter does too.</summary>
    public TestFilter And(string text)
    {
        m_And = new TestFilter(text);
        return this;
    }

    public bool Selects(Test test)
    {
        if (!(test is TestMethod || !test.HasChildren)) return ((TestSuite)test).Tests.Any(child => Selects((Test)child));
        if (m_And?.Selects(test) == false) return false;
        if (m_Exact is not null) return test.FullName == m_Exact;
        if (m_Unwanted.Any(term => Matches(test, term))) return false;
        if (m_Wanted.Count > 0) return m_Wanted.Any(term => Matches(test, term));
        return !IsExplicit(test);
    }

    static bool Matches(Test test, string term)
    {
        if (term.StartsWith(CategoryPrefix, StringComparison.OrdinalIgnoreCase)) return Categories(test).Contains(term[CategoryPrefix.Length..]);
        if (test.FullName.Contains(term, StringComparison.OrdinalIgnoreCase)) return true;
        try
        {
            return Regex.IsMatch(test.FullName, term, RegexOptions.IgnoreCase);
        }
        catch (ArgumentException)
        {
            return false;
        }
    }

    static IEnumerable<string> Categories(ITest test)
    {
        for (ITest? t = test; t is not null; t = t.Parent)
            foreach (object category in t.Properties[PropertyNames.Category]) yield return (string)category;
    }

    static bool IsExplicit(ITest test)
    {
        for (ITest? t = test; t is not null; t = t.Parent)
            if (t.RunState == RunState.Explicit) return true;
        return false;
    }
}
