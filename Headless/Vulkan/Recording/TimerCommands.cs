namespace Headless.Vulkan;

/// <summary>Nested timer scopes; they may span submissions.</summary>
internal sealed class TimerCommands(CommandStream stream)
{
    private readonly List<TimerScope> open = [];
    private readonly Queue<TimerScope> pending = new();
    private int lastId;

    public int Begin(string name)
    {
        TimerScope scope = new(++lastId, name, open.Count) { Skipped = !stream.Context.Limits.Timestamps };
        open.Add(scope);
        pending.Enqueue(scope);
        Mark(scope, isEnd: false);
        return scope.Id;
    }

    public void End(int id)
    {
        if (open.Count == 0 || open[^1].Id != id)
        {
            string innermost = open.Count == 0 ? "none is open" : $"the innermost open one is {open[^1].Id}";
            throw new InvalidOperationException($"Timer {id} cannot end here: {innermost}. Timers close in reverse order.");
        }

        TimerScope scope = open[^1];
        open.RemoveAt(open.Count - 1);
        Mark(scope, isEnd: true);
    }

    /// <summary>Finished scopes in the order they began; an unfinished one holds back those after it.</summary>
    public IReadOnlyList<TimerResult> Collect()
    {
        List<TimerResult> results = [];
        while (pending.TryPeek(out TimerScope? scope) && scope.IsDone)
        {
            results.Add(pending.Dequeue().Result(stream.Context.TimestampPeriod));
        }

        return results;
    }

    private void Mark(TimerScope scope, bool isEnd)
    {
        if (scope.Skipped)
        {
            return;
        }

        if (stream.Current.Timestamps.IsFull)
        {
            stream.Submit();
        }

        Submission submission = stream.Current;
        submission.Timestamps.Write(submission.Commands, submission.CommandCount, scope, isEnd);
    }
}
