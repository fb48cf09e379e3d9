using System.Diagnostics;
using Headless.Files;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Only regular files are read, and none further than is allowed: a pipe is not waited for, and a device has no end.</summary>
public sealed class BoundedTextTests
{
    private const int Most = 1000;
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(1); // a test that hangs fails

    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("bounded-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    // A device or pipe holds nothing, or is refused.
    [TestCase(": > $0", false)]
    [TestCase("mkfifo $0", false)]
    [TestCase("ln -s /dev/zero $0", false)]
    [TestCase("mkfifo $0.pipe && ln -s $0.pipe $0", true)]
    [TestCase("mkdir $0", true)]
    [TestCase("ln -s . $0", true)]
    [TestCase("ln -s $0 $0", true)]
    [TestCase("ln -s /nowhere/at/all $0", true)]
    [TestCase("truncate -s 1001 $0", true)]
    [TestCase("truncate -s 1001 $0.real && ln -s $0.real $0", true)]
    public void WhatIsNoFileOrTooLongIsNotRead(string command, bool refused)
    {
        string path = Make(command);
        foreach (Func<long> read in (Func<long>[])[() => BoundedText.ReadAll(path, Most).Length, () => BoundedText.ReadBytes(path, Most).Length, () => Lines(path)])
        {
            Task<long?> task = Task.Run<long?>(() =>
            {
                try
                {
                    return read();
                }
                catch (BadFileException)
                {
                    return null;
                }
            });
            Assert.That(task.Wait(Patience), Is.True, "it waits");
            Assert.That(task.Result, Is.EqualTo(refused ? (long?)null : 0));
        }
    }

    [Test]
    public void ALinkToAFileIsFollowed()
    {
        string path = Make("printf abc > $0.real && ln -s $0.real $0");
        Assert.That(BoundedText.ReadAll(path, 3), Is.EqualTo("abc"));
        Assert.That(BoundedText.ReadBytes(path, 3), Is.EqualTo("abc"u8.ToArray()));
    }

    private static long Lines(string path)
    {
        using StreamReader reader = BoundedText.Open(path, Most);
        return reader.ReadToEnd().Length;
    }

    private string Make(string command)
    {
        string path = Path.Combine(folder, "thing");
        using Process process = Process.Start("sh", ["-c", command, path]);
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero);
        return path;
    }
}
