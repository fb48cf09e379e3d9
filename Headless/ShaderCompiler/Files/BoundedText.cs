namespace Headless.Files;

/// <summary>
/// Reads text files whose content nobody vouches for: the size of a file and the length of a line are bounded, and what the
/// disk refuses is a message about the file.
/// </summary>
public static class BoundedText
{
    private const int MebiByte = 1 << 20;

    /// <summary>Largest file that is read whole [bytes]; in memory it takes twice that and its values some times more.</summary>
    public const int LargestFile = 64 * MebiByte;

    /// <exception cref="BadFileException">The file is missing, not a plain file, not readable or too large.</exception>
    public static string ReadAll(string path, int largest = LargestFile)
    {
        using StreamReader reader = Open(path, largest);
        return Guard(path, reader.ReadToEnd);
    }

    /// <exception cref="BadFileException">As <see cref="ReadAll"/>.</exception>
    public static byte[] ReadBytes(string path, int largest = LargestFile)
    {
        using Stream stream = OpenPlain(path, largest);
        return Guard(path, () =>
        {
            byte[] bytes = new byte[stream.Length];
            stream.ReadExactly(bytes);
            return bytes;
        });
    }

    /// <summary>A reader that goes through a large file line by line; the caller disposes of it.</summary>
    /// <exception cref="BadFileException">As <see cref="ReadAll"/>.</exception>
    public static StreamReader Open(string path, long largest) => new(OpenPlain(path, largest));

    // A pipe waits for a writer and a device has no end, and neither has a length. Behind a link, whose length is its own, a pipe that is opened for both
    // directions does not wait.
    private static Stream OpenPlain(string path, long largest)
    {
        var info = new FileInfo(path);
        if (!Guard(path, () => info.Exists)) throw NotPlain(path);
        if (info.Length == 0) return Stream.Null;
        Stream stream = Guard(path, () => info.LinkTarget is null ? File.OpenRead(path) : OpenLink(path));
        if (stream.CanSeek && stream.Length > 0 && stream.Length <= largest) return stream;
        using (stream)
        {
            if (!stream.CanSeek) throw NotPlain(path);
            if (stream.Length == 0) return Stream.Null;
            throw new BadFileException(FormattableString.Invariant(
                $"{path}: the file has {stream.Length / (double)MebiByte:0.#} MiB; at most {largest / MebiByte} MiB are read. Divide it, or move large data into files of their own."));
        }
    }

    private static FileStream OpenLink(string path)
    {
        try
        {
            return new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.Read);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return File.OpenRead(path);
        }
    }

    private static BadFileException NotPlain(string path) => new($"{path}: not a file that can be read. Restore it, or remove what refers to it.");

    private static T Guard<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new BadFileException($"{path}: cannot be read: {e.Message}", e);
        }
    }
}
