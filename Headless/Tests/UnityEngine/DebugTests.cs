using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class DebugTests : EngineFixture
{
    [Test]
    public void LinesCarryTypeMessageAndObject()
    {
        var a = new GameObject("Tank");
        Debug.Log("hello");
        Debug.LogWarning("careful", a);
        Debug.LogError("wrong", a);
        Debug.LogErrorFormat("{0} of {1}", 1.5f, 2);
        Assert.That(Console, Is.EqualTo(new[] { "[Log] hello", "[Warning] careful (Tank)", "[Error] wrong (Tank)", "[Error] 1.5 of 2" }));
    }

    [Test]
    public void ListenersGetEveryMessage()
    {
        var received = new List<string>();
        void Listen(string condition, string stack, LogType type) => received.Add($"{type}:{condition}");
        Application.logMessageReceived += Listen;
        Debug.Log(null!);
        Debug.LogException(new InvalidOperationException("no"));
        Application.logMessageReceived -= Listen;
        Assert.That(received, Is.EqualTo(new[] { "Log:Null", "Exception:InvalidOperationException: no" }));
    }

    [Test]
    public void TheLoggerFilters()
    {
        Debug.unityLogger.filterLogType = LogType.Warning;
        Debug.Log("dropped");
        Debug.LogWarning("kept");
        Debug.unityLogger.filterLogType = LogType.Log;
        Assert.That(Console, Is.EqualTo(new[] { "[Warning] kept" }));
    }
}
