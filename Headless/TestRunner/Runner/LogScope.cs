using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Collects the log of one test and checks it. Expectations are fulfilled in the order in which they were stated.</summary>
sealed class LogScope : IDisposable
{
    static readonly Stack<LogScope> s_Scopes = new();

    readonly object m_Lock = new();
    readonly List<ReceivedLog> m_Logs = new();
    readonly Queue<ExpectedLog> m_Expected = new();

    public LogScope()
    {
        s_Scopes.Push(this);
        Application.logMessageReceivedThreaded += Receive;
    }

    public static LogScope Current => s_Scopes.Count > 0
        ? s_Scopes.Peek()
        : throw new InvalidOperationException("LogAssert can be used while a test is running only.");

    public bool IgnoreFailingMessages { get; set; }
    public bool MustExpectAll { get; set; }

    public void Expect(ExpectedLog expected)
    {
        lock (m_Lock) m_Expected.Enqueue(expected);
    }

    void Receive(string message, string stackTrace, LogType type)
    {
        bool failing = type is LogType.Error or LogType.Exception or LogType.Assert && !IgnoreFailingMessages;
        lock (m_Lock) m_Logs.Add(new ReceivedLog(type, message, stackTrace) { IsFailing = failing });
    }

    void MatchExpectations()
    {
        foreach (ReceivedLog log in m_Logs)
        {
            if (m_Expected.Count == 0) return;
            if (log.IsHandled || !m_Expected.Peek().Matches(log)) continue;
            m_Expected.Dequeue();
            log.IsHandled = true;
        }
    }

    /// <summary>Throws for an unhandled failing line; at the end of the test also for an expectation that was not met.</summary>
    public void Evaluate(bool atEnd)
    {
        lock (m_Lock)
        {
            MatchExpectations();
            foreach (ReceivedLog log in m_Logs)
                if (!log.IsHandled && (log.IsFailing || (atEnd && MustExpectAll)))
                    throw new AssertionException($"Unhandled log message: '{log}'. Use UnityEngine.TestTools.LogAssert.Expect\n{log.StackTrace}".TrimEnd());
            if (atEnd && m_Expected.Count > 0) throw new AssertionException($"Expected log did not appear: {m_Expected.Peek()}");
        }
    }

    public void RequireAllHandled()
    {
        lock (m_Lock)
        {
            MatchExpectations();
            foreach (ReceivedLog log in m_Logs)
                if (!log.IsHandled) throw new AssertionException($"Unhandled log message: '{log}'. Use UnityEngine.TestTools.LogAssert.Expect");
        }
    }

    public void Dispose()
    {
        Application.logMessageReceivedThreaded -= Receive;
        s_Scopes.Pop();
    }
}
