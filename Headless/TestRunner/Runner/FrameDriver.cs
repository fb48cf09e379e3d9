using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Debug = UnityEngine.Debug;

namespace Headless.Engine;

/// <summary>Runs a test's IEnumerator over frames: as a coroutine in play mode, one step a frame in edit mode.</summary>
sealed class FrameDriver(double timeoutSeconds)
{
    Exception? m_Failure;
    bool m_Done;
    bool m_EditMode;

    public void Run(IEnumerator routine, Action checkEachFrame)
    {
        m_Failure = null;
        m_Done = false;
        m_EditMode = !EngineState.IsPlaying;
        IEnumerator steps = Steps(routine);
        var clock = Stopwatch.StartNew();
        TestHost? host = m_EditMode ? null : TestHost.Get();
        if (host is not null) host.StartCoroutine(steps);
        else if (!steps.MoveNext()) m_Done = true;
        while (!m_Done)
        {
            checkEachFrame();
            if (clock.Elapsed.TotalSeconds > timeoutSeconds)
            {
                if (host is not null) host.StopAllCoroutines();
                throw new AssertionException($"Test exceeded Timeout value of {timeoutSeconds * 1000:0}ms. If this is intentional, please change the value with the [Timeout] attribute.");
            }
            PlayerLoop.RunFrame();
            if (host is null && !m_Done && !steps.MoveNext()) m_Done = true;
        }
        if (m_Failure is not null) System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(m_Failure).Throw();
    }

    // Plain IEnumerators are run in place, so that an assertion inside one fails the test.
    IEnumerator Steps(IEnumerator routine)
    {
        var stack = new Stack<IEnumerator>();
        stack.Push(routine);
        while (stack.Count > 0)
        {
            object? yielded;
            try
            {
                if (!stack.Peek().MoveNext())
                {
                    (stack.Pop() as IDisposable)?.Dispose();
                    continue;
                }
                yielded = stack.Peek().Current;
                if (m_EditMode) yielded = ForEditMode(yielded);
            }
            catch (Exception exception)
            {
                m_Failure = exception;
                foreach (IEnumerator open in stack) (open as IDisposable)?.Dispose();
                break;
            }
            if (yielded is IEnumerator nested and not CustomYieldInstruction) stack.Push(nested);
            else yield return yielded;
        }
        m_Done = true;
    }

    static object? ForEditMode(object? yielded) => yielded switch
    {
        IEditModeTestYieldInstruction instruction => instruction.Perform(),
        CustomYieldInstruction custom => Wait(custom),
        null or IEnumerator => yielded,
        _ => throw new InvalidOperationException($"EditMode test can only yield null, but not <{yielded.GetType().Name}>"),
    };

    static IEnumerator Wait(CustomYieldInstruction custom)
    {
        while (custom.keepWaiting) yield return null;
    }
}
